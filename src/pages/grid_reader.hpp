#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "results/netcdf_image.hpp"

namespace bumpfoil {

/// Dimensions of what single bumps, feet and pads do.
inline constexpr std::array<std::string_view, 3> node_dimensions{"bump", "foot", "pad"};

bool is_node(std::string_view dimension);

/// Whether a variable is of bumps or feet, which are many; pads are not.
bool is_of_nodes(const StoredVariable& variable);

/// What of a file is read.
struct GridParts {
  std::function<bool(const StoredVariable&)> has;  ///< whether a variable is
  /// By names of first dimensions, entries in rising order: of variables over these no others are.
  std::map<std::string, std::vector<std::size_t>> rows{};
};

/// What a report shows of results that are numbers over some dimensions, such as those of a sweep over its keys:
/// `dimensions` (sizes by name, of what is read), `variables` and `left_out`, see report_json.
///
/// @param most_values  numbers in all; the largest variables are left out where they are more
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_grid(const NetcdfImage& file, std::size_t most_values, const GridParts& parts);

}  // namespace bumpfoil
