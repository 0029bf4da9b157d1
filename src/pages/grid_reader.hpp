#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "results/netcdf_image.hpp"

namespace bumpfoil {

/// Dimensions of what single bumps, feet and pads do.
inline constexpr std::array<std::string_view, 3> node_dimensions{"bump", "foot", "pad"};

bool is_node(std::string_view dimension);

/// Whether that is read.
enum class Nodes { left_out, read };

/// What a report shows of results that are numbers over some dimensions, such as those of a sweep over its keys:
/// `dimensions` (sizes by name), `variables` and `left_out`, see report_json.
///
/// @param most_values  numbers in all; the largest variables are left out where they are more
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_grid(const NetcdfImage& file, std::size_t most_values, Nodes nodes);

}  // namespace bumpfoil
