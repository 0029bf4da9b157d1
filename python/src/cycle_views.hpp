#pragma once

#include <pybind11/pybind11.h>

#include "bumpfoil/bearing/fields.hpp"

namespace bumpfoil {

/// The cycles of a run as a list of dictionaries with the names of result.nc: `quantities` (numbers and words of the
/// cycle, arrays of its loads), `series` (arrays over its increments), `fields` (arrays of increments and bumps or
/// feet) and `events`. Loads and fields are read-only views of the result itself, which they keep alive; what is not
/// known is left out.
/// @param run  a Run
pybind11::list cycle_views(const pybind11::object& run);

/// The fields of a single increment, one number per bump or foot, as such views.
/// @param owner  of the fields
pybind11::dict row_views(const FoilFields& fields, const pybind11::object& owner);

}  // namespace bumpfoil
