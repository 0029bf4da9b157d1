#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "results/netcdf_image.hpp"

namespace bumpfoil {

/// Contents of a report on a rotor in time: a grid, see read_grid, with a selection of the revolutions, spectra and
/// steps if there are many; `stored` (sizes of these dimensions in the file) and `orbits`, see report_json.
/// | @param most_values  count of all numbers; each of the three gets a fraction
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_revolutions(const NetcdfImage& file, std::size_t most_values);

}  // namespace bumpfoil
