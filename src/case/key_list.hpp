#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "case/case_keys.hpp"

namespace bumpfoil {

/// A key of the case file, or a table, with its value in a case.
struct ListedKey {
  std::string path;  ///< dotted path, such as "bump_foil.truss.k1"
  Key key;
  std::string kind;              ///< kind of value, such as "length" or "list of lengths"; empty for a table
  nlohmann::ordered_json value;  ///< in SI, as in JSON; null for a table, and if absent
  bool held{};                   ///< whether the case has it and writes it
  bool live{};                   ///< whether an author would write it, rather than keep its default
  bool instead{};                ///< alternative to another key, which is given

  [[nodiscard]] bool is_table() const { return kind.empty(); }
  /// A length or a force, distinguished by its unit.
  [[nodiscard]] bool is_either() const { return kind == "length or force"; }
  /// A number, or one for all bumps that could also be given per bump.
  [[nodiscard]] bool holds_number() const;
  [[nodiscard]] bool is_of_list() const { return path.ends_with(']'); }
  [[nodiscard]] std::string table() const {
    return path.substr(0, path.size() - std::min(path.size(), key.name.size() + 1));
  }
};

/// All keys of the case file, in order; tables absent from the case have their defaults.
std::vector<ListedKey> list_keys(const Case& input);

/// The keys of an empty case.
std::vector<ListedKey> list_keys();

/// A key by its path; in a list of tables absent from the case, that of the first table. Null if unknown.
const ListedKey* find_key(const std::vector<ListedKey>& keys, std::string_view path);

/// Advice for a path that is not a key, if a number is expected.
std::string advice_on_number(const std::vector<ListedKey>& keys, const std::string& path);

/// "bump_foil.shim.to" for "bump_foil.shim[2].to": common to all tables of a list.
std::string without_counts(std::string_view path);

/// The line of a case file that starts a table: "[bump_foil.truss]" and "[[bump_foil.shim]]" for the tables
/// "bump_foil.truss" and "bump_foil.shim[2]".
std::string table_header(std::string_view table);

/// The value in TOML.
std::string toml_of(const nlohmann::ordered_json& value);

/// An example value of the key, as an author would write it in a case file.
std::string example_of(const ListedKey& listed);

/// The default value of a key. @param reference, unset  the key in the reference case, and in a case that does not give
/// it
std::string default_of(const ListedKey& reference, const ListedKey& unset);

/// The current value, as an author would write it: in the unit of the example.
std::string authored_value(const ListedKey& listed);

}  // namespace bumpfoil
