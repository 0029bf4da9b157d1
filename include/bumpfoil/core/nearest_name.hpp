#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// The candidate that `name` most likely is a slip of: the one fewest edits away, case apart, if these are few for its
/// length.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace bumpfoil
