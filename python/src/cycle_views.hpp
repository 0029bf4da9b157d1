#pragma once

#include <pybind11/pybind11.h>

namespace bumpfoil {

/// The cycles of a run as a list of dictionaries with the names of result.nc: `quantities` (numbers and words of the
/// cycle, arrays of its loads), `series` (arrays over its increments), `fields` (arrays of increments and bumps or
/// feet) and `events`. Loads and fields are read-only views of the result itself, which they keep alive; what is not
/// known is left out.
/// @param run  a Run
pybind11::list cycle_views(const pybind11::object& run);

}  // namespace bumpfoil
