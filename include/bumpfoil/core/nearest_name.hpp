#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// The candidate that `name` is most likely a misspelling of: the one with the fewest edits, ignoring case, if these
/// are few for its length.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace bumpfoil
