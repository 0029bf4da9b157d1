#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// File name in messages about `--set` options.
inline constexpr std::string_view command_line = "--set";

/// Whether a value comes from `--set`.
inline bool is_override(const toml::node& node) {
  return node.source().path && *node.source().path == command_line;
}

/// Parses TOML text. Every node has its position: `node.source()` has line and `name`.
/// @throws Error (input) at the first syntax error.
toml::table parse_toml(std::string_view text, const std::string& name);

/// Replaces or adds values given as "table.key=value", or "table[2].key=value" in the second of several tables. The
/// value is TOML, else a bare string. Their nodes carry `command_line` as the file.
/// @return an error for every override that cannot be applied
std::vector<InputError> apply_overrides(toml::table& root, const std::vector<std::string>& overrides);

}  // namespace bumpfoil
