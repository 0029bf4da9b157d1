#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "results/netcdf_image.hpp"

namespace bumpfoil {

/// What a report shows of a rotor in time: a grid, see read_grid, of which a part of the revolutions, spectra and steps
/// is read where there are many; `stored` (sizes of these dimensions in the file) and `orbits`, see report_json.
///
/// @param most_values  numbers in all; a part of them is for each of the three
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_revolutions(const NetcdfImage& file, std::size_t most_values);

}  // namespace bumpfoil
