#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "case/case_json.hpp"
#include "case/key_list.hpp"
#include "case/presets.hpp"
#include "case/unit_table.hpp"

namespace bumpfoil {
namespace {

/// Column of comments, and the maximum line length.
constexpr std::size_t comment_column = 32;
constexpr std::size_t widest_line = 120;

std::string comment_on(const ListedKey& listed, const Preset& preset) {
  std::vector<std::string> parts;
  for (const auto& [path, remark] : preset.remarks) {
    if (path == listed.path) parts.emplace_back(remark);
  }
  const Key& key = listed.key;
  if (!key.text.empty()) parts.emplace_back(key.text);
  if (!key.otherwise.empty()) parts.push_back(fmt::format("default: {}", key.otherwise));
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// A line with a comment, wrapped between words; every line starts with `prefix`.
std::string commented(std::string_view prefix, const std::string& code, std::string_view comment) {
  std::string out = fmt::format("{}{}", prefix, code);
  std::size_t column = std::max(code.size() + 2, comment_column);
  std::string gap(column - code.size(), ' ');
  while (!comment.empty()) {
    const std::size_t room = widest_line - prefix.size() - column - 2;
    const std::size_t end = comment.size() <= room ? comment.size() : comment.rfind(' ', room);
    out += fmt::format("{}# {}", gap, comment.substr(0, end));
    comment.remove_prefix(std::min(end + 1, comment.size()));
    gap = fmt::format("\n{}{}", prefix, std::string(column, ' '));
  }
  return out + '\n';
}

constexpr std::string_view template_head =
    R"(# Case file of Bumpfoil. Quantities are strings with a unit ("31.8 um", "214 GPa", "150 MN/m", "30 deg") or plain
# numbers in SI (m, Pa, N/m, rad). Lines that start with # are comments; keys that are commented out show their default
# or an example. `bumpfoil init -o` and `bumpfoil schema -o` write the schema named in the first line: with it, editors
# complete and check keys.

)";

/// The value of a key that the case does not give.
std::string fallback_of(const ListedKey& reference, const ListedKey& unset) {
  const Key& key = reference.key;
  if (reference.instead) return "–";
  if (!key.otherwise.empty()) return fmt::format("that of `{}`", key.otherwise);
  if (key.presence == Presence::required) return "required";
  if (key.presence == Presence::optional) return "none";
  return fmt::format("`{}`", default_of(reference, unset));
}

constexpr std::string_view reference_head =
    R"(# Keys of the case file

A case file is TOML. Quantities are strings with a unit, such as `"31.8 um"`, or plain numbers in SI (m, N, N/m, Pa, rad).
A list of quantities may be an equally spaced range, both ends included: `speeds = { from = "10000 rpm", to =
"60000 rpm", points = 11 }`, or `step = "5000 rpm"` instead of `points`.
`bumpfoil init` writes a commented file to start from, `bumpfoil check` validates a file, and `--set table.key=value`
changes a key for one run. This page is the output of `bumpfoil init --keys`.
)";

/// The list of known units.
std::string units_text() {
  std::vector<std::string> units, prefixes;
  for (const KnownUnit& unit : known_units()) {
    const std::string_view words = unit.symbols.empty() ? unit.names : unit.symbols;
    if (unit.meaning.scale) units.push_back(fmt::format("`{}`", words.substr(0, words.find(' '))));
  }
  for (const UnitPrefix& prefix : unit_prefixes()) prefixes.push_back(fmt::format("`{}`", prefix.symbol));
  return fmt::format(
      "\nUnits are {}, by symbol or name (`inch`, `degrees`), with one of the prefixes {} or none, and their products "
      "(`Pa s`), quotients (`MN/m`) and powers (`m2`). Speeds and frequencies in `rpm`, `1/min` and `Hz` count "
      "revolutions; `1/s` is refused, as it may count radians.\n",
      fmt::join(units, ", "), fmt::join(prefixes, " "));
}

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  names.reserve(presets().size());
  for (const Preset& preset : presets()) names.emplace_back(preset.name);
  return names;
}

std::string case_template(std::string_view name) {
  const auto preset =
      std::find_if(presets().begin(), presets().end(), [&](const Preset& one) { return one.name == name; });
  if (preset == presets().end()) {
    throw Error(ErrorKind::input, {{"", 0, "preset", std::string(name), "unknown preset",
                                    fmt::format("use one of {}", fmt::join(preset_names(), ", "))}});
  }
  std::string out = fmt::format("#:schema ./{}\n{}{}", case_schema_name, preset->head, template_head);
  bool live_table = true;
  for (const ListedKey& listed : list_keys(preset->input)) {
    if (listed.is_table()) {
      live_table = listed.live;
      out += '\n' + commented(live_table ? "" : "# ", table_header(listed.path), listed.key.text);
      continue;
    }
    // In a commented-out table, contradicting alternatives are commented out twice.
    const bool out_of_table = live_table ? !listed.live : listed.instead;
    out += commented(live_table ? "" : "# ",
                     fmt::format("{}{} = {}", out_of_table ? "# " : "", listed.key.name,
                                 listed.live ? authored_value(listed) : example_of(listed)),
                     comment_on(listed, *preset));
  }
  return out;
}

std::string case_reference() {
  std::string out = std::string(reference_head) + units_text();
  constexpr std::string_view header = "\n| key | value | default | meaning |\n|---|---|---|---|\n";
  const std::vector<ListedKey> unset = list_keys({});
  std::size_t i = 0;
  for (const ListedKey& listed : list_keys(presets().front().input)) {
    const Key& key = listed.key;
    const std::string fallback = fallback_of(listed, unset[i++]);
    if (listed.is_table()) {
      out += fmt::format("\n## `{}`\n\n{}{}{}.{}\n{}", table_header(listed.path), key.title,
                         key.text.empty() ? "" : ": ", key.text, key.presence == Presence::required ? " Required." : "",
                         key.presence == Presence::inherited ? "" : header);
    } else {
      if (listed.table().empty()) out += header;
      out += fmt::format("| `{}` | {} | {} | {} |\n", key.name, listed.kind, fallback,
                         key.text.empty() ? key.title : key.text);
    }
  }
  return out;
}

std::vector<std::string> case_key_names() {
  std::vector<std::string> names;
  for (const ListedKey& listed : list_keys(presets().front().input)) {
    if (!listed.is_table() && without_counts(listed.path) == listed.path) names.push_back(listed.path);
  }
  return names;
}

nlohmann::ordered_json case_labels() {
  nlohmann::ordered_json labels;
  for (const ListedKey& listed : list_keys(presets().front().input)) {
    labels[listed.path]["title"] = listed.key.title;
    if (listed.kind == "list of directions") {
      labels[listed.path]["unit"] = "direction";
    } else if (listed.key.dimension) {
      labels[listed.path]["unit"] = si_unit(*listed.key.dimension);
    }
  }
  return labels;
}

}  // namespace bumpfoil
