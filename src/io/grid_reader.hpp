#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "io/netcdf_image.hpp"

namespace bumpfoil {

/// Whether what single bumps and feet do is read.
enum class Nodes { left_out, read };

/// What a report shows of results that are numbers over some dimensions, such as those of a sweep over its keys:
/// `dimensions` (sizes by name), `variables` and `left_out`, see report_json.
///
/// @param most_values  numbers in all; the largest variables are left out where they are more
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_grid(const NetcdfImage& file, std::size_t most_values, Nodes nodes);

}  // namespace bumpfoil
