#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "case/case_keys.hpp"

namespace bumpfoil {

/// A key of the case file, or a table, with its value in a case.
struct ListedKey {
  std::string path;  ///< dotted, such as "bump_foil.truss.k1"
  Key key;
  std::string kind;              ///< what it holds, such as "length" or "list of lengths"; empty for a table
  nlohmann::ordered_json value;  ///< in SI, as in JSON; null for a table, and where there is none
  bool held{};                   ///< the case has it: it is written
  bool live{};                   ///< an author of the case would give it, rather than leave it at its default
  bool instead{};                ///< in place of another key, which is given

  [[nodiscard]] bool is_table() const { return kind.empty(); }
  /// A length or a force, as its unit tells.
  [[nodiscard]] bool is_either() const { return kind == "length or force"; }
  /// One number, or one for all bumps though they may have one each.
  [[nodiscard]] bool holds_number() const;
  [[nodiscard]] bool is_of_list() const { return path.ends_with(']'); }
  [[nodiscard]] std::string table() const {
    return path.substr(0, path.size() - std::min(path.size(), key.name.size() + 1));
  }
};

/// All keys of the case file, in its order; those of tables that the case has not with their defaults.
std::vector<ListedKey> list_keys(const Case& input);

/// Those of a case that holds nothing.
std::vector<ListedKey> list_keys();

/// A key by its path; of a table that the case has not, the key of the first table of its list. Null if there is none.
const ListedKey* find_key(const std::vector<ListedKey>& keys, std::string_view path);

/// Advice for a path that is not a key, where a number is expected.
std::string advice_on_number(const std::vector<ListedKey>& keys, const std::string& path);

/// "bump_foil.shim.to" of "bump_foil.shim[2].to": what all tables of a list have.
std::string without_counts(std::string_view path);

/// The line of a case file that begins a table: "[bump_foil.truss]" and "[[bump_foil.shim]]" of the tables
/// "bump_foil.truss" and "bump_foil.shim[2]".
std::string table_header(std::string_view table);

/// The value in TOML.
std::string toml_of(const nlohmann::ordered_json& value);

/// A value that the key might have, as an author would write it in a case file.
std::string example_of(const ListedKey& listed);

/// The value of a key with a default that a case does not give. @param reference, unset  the key in the reference case,
/// and in a case that gives none
std::string default_of(const ListedKey& reference, const ListedKey& unset);

/// The value that it has, as an author would write it: in the unit of the example.
std::string authored_value(const ListedKey& listed);

}  // namespace bumpfoil
