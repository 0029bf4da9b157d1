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

/// Dimensions of results per bump, foot and pad.
inline constexpr std::array<std::string_view, 3> node_dimensions{"bump", "foot", "pad"};

bool is_node(std::string_view dimension);

/// Whether a variable has values per bump or foot, which are many; pads are not.
bool is_of_nodes(const StoredVariable& variable);

/// Selection of the contents of a file.
struct GridParts {
  std::function<bool(const StoredVariable&)> has;  ///< whether a variable is selected
  /// Selected entries in increasing order, by name of the first dimension: variables over it are read at these entries
  /// only.
  std::map<std::string, std::vector<std::size_t>> rows{};
};

/// Contents of a report for results that are numbers over some dimensions, such as those of a sweep over its keys:
/// `dimensions` (sizes by name, as read), `variables` and `left_out`, see report_json.
/// | @param most_values  total count of numbers above which the largest variables are omitted
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_grid(const NetcdfImage& file, std::size_t most_values, const GridParts& parts);

}  // namespace bumpfoil
