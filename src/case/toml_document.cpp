#include "case/toml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "core/collect_errors.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

/// Maximum number of parts of a key: valid keys have fewer, and tables nested a hundred thousand deep would exhaust the
/// parser's stack. (It limits the nesting of arrays and inline tables itself.)
constexpr int most_key_parts = 16;

/// Line of a key with too many parts, if any. Dots outside strings and comments are counted; numbers have one.
std::optional<std::size_t> find_deep_key(std::string_view text) {
  std::size_t line = 1;
  int parts = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::string_view triple = c == '"' ? "\"\"\"" : "'''";
      const bool multiline = text.substr(i).starts_with(triple);
      const std::string_view closing = multiline ? triple : triple.substr(0, 1);
      i += closing.size();
      while (i < text.size() && !text.substr(i).starts_with(closing) && (multiline || text[i] != '\n')) {
        if (c == '"' && text[i] == '\\' && i + 1 < text.size()) ++i;
        if (text[i] == '\n') ++line;
        ++i;
      }
      i += closing.size() - 1;
      continue;
    }
    if (c == '#') {
      while (i + 1 < text.size() && text[i + 1] != '\n') ++i;
      continue;
    }
    if (c == '.') ++parts;
    if (parts > most_key_parts) return line;
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') parts = 1;
    if (c == '\n') ++line;
  }
  return std::nullopt;
}

/// Advice, by a fragment of the parser's message.
struct SyntaxAdvice {
  std::string_view fragment;
  std::string_view advice;
};

constexpr std::array syntax_advice{
    SyntaxAdvice{"cannot redefine", "give every key and every table once"},
    SyntaxAdvice{"not representable", "the number is too large"},
    SyntaxAdvice{"could not be interpreted", "the number is too large"},
    SyntaxAdvice{"exceeded maximum nested", "a case file needs no such nesting"},
    SyntaxAdvice{"control characters", "close the text with the quote that opened it, and remove what cannot be seen"},
    SyntaxAdvice{"utf-8", "save the file as UTF-8 text"},
    SyntaxAdvice{"expected value", "give a value after the equals sign"},
    SyntaxAdvice{"table header", "write a table as [name] on a line of its own"},
    SyntaxAdvice{"parsing array", "separate entries by commas and close the list with ]"},
    SyntaxAdvice{"parsing string", "close the text with the quote that opened it"},
    SyntaxAdvice{"expected a comment or whitespace",
                 "write one value per line, with a decimal point and quotes around units: radius = \"19.05 mm\""},
    SyntaxAdvice{"expected '='", "write key = value"},
    SyntaxAdvice{"end-of-file", "the line is not complete: write key = value"},
};

std::string advice_on(std::string_view description) {
  for (const SyntaxAdvice& entry : syntax_advice) {
    if (description.find(entry.fragment) != std::string_view::npos) return std::string(entry.advice);
  }
  return "write key = value, one per line, with quotes around texts and units: radius = \"19.05 mm\"";
}

InputError override_error(std::string_view argument, std::string what, std::string advice) {
  return {std::string(command_line), 0, std::string(argument), "", std::move(what), std::move(advice)};
}

bool is_bare_key(std::string_view key) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), allowed);
}

/// A part of "a.b[2].c".
struct KeyPart {
  std::string text;
  std::string name;
  std::size_t number{};  ///< in a list of tables, from 1; 0 without a number
};

std::optional<KeyPart> read_part(std::string_view text) {
  const std::size_t bracket = text.find('[');
  KeyPart part{.text = std::string(text), .name = std::string(text.substr(0, bracket))};
  if (!is_bare_key(part.name)) return std::nullopt;
  if (bracket == std::string_view::npos) return part;
  const std::string_view counted = text.substr(bracket + 1);
  const auto [end, status] = read_number(counted.substr(0, counted.find(']')), part.number);
  if (status != std::errc{} || end + 1 != text.data() + text.size() || part.number < 1) return std::nullopt;
  return part;
}

/// The parts of a key; empty if a part is not a bare key, with or without a number, or there are too many.
std::vector<KeyPart> split_key(std::string_view key) {
  std::vector<KeyPart> parts;
  while (static_cast<int>(parts.size()) < most_key_parts) {
    const std::size_t dot = key.find('.');
    std::optional<KeyPart> part = read_part(key.substr(0, dot));
    if (!part) return {};
    parts.push_back(std::move(*part));
    if (dot == std::string_view::npos) return parts.back().number == 0 ? parts : std::vector<KeyPart>{};
    key.remove_prefix(dot + 1);
  }
  return {};
}

/// The table named by a part of a key, created if necessary. A plain table is the first of its list.
/// @throws Error (input) if the part does not name a table
toml::table& table_of(toml::table& outer, const KeyPart& part, const std::string& argument) {
  toml::node* child = outer.get(part.name);
  if (child == nullptr && part.number <= 1) child = &outer.insert(part.name, toml::table{}).first->second;
  if (child != nullptr && child->is_table() && part.number <= 1) return *child->as_table();
  if (child != nullptr && !child->is_table() && !child->is_array_of_tables()) {
    throw Error(ErrorKind::input, {override_error(argument, fmt::format("\"{}\" is a value, not a table", part.text),
                                                  "give the key of a value inside a table")});
  }
  toml::array* list = child == nullptr ? nullptr : child->as_array();
  const std::size_t count = list == nullptr ? (child == nullptr ? 0 : 1) : list->size();
  if (part.number > count || (part.number == 0 && count > 1)) {
    throw Error(ErrorKind::input,
                {override_error(argument, fmt::format("\"{}\" does not exist: there are {}", part.text, count),
                                fmt::format("count from \"{}[1]\"", part.name))});
  }
  return *list->get(part.number == 0 ? 0 : part.number - 1)->as_table();
}

/// Reads "v = value"; the text might hold more than one value.
std::optional<toml::table> parse_single(const std::string& value) {
  if (find_deep_key(value)) return std::nullopt;
  try {
    toml::table table = toml::parse(std::string_view("v = " + value), command_line);
    if (table.size() == 1 && value.find('\n') == std::string::npos) return table;
  } catch (const toml::parse_error&) {
    // Not TOML: the caller treats it as a string.
  }
  return std::nullopt;
}

/// Whether the entire text is a number, but out of range for `Number`.
template <typename Number>
bool is_beyond(std::string_view text) {
  Number number{};
  const auto [end, status] = read_number(text, number);
  return status == std::errc::result_out_of_range && end == text.data() + text.size();
}

toml::table parse_override_value(const std::string& key, const std::string& value) {
  if (auto table = parse_single(value)) return std::move(*table);
  if (is_beyond<std::int64_t>(value) || is_beyond<double>(value)) {
    throw Error(ErrorKind::input, {{std::string(command_line), 0, key, value, "is out of range",
                                    "give a number that the program can hold"}});
  }
  if (!is_utf8(value)) {
    throw Error(ErrorKind::input, {{std::string(command_line), 0, key, value, "is not UTF-8 text",
                                    "use a terminal or script whose character encoding is UTF-8"}});
  }
  toml::table bare = *parse_single("''");
  *bare.get("v")->as_string() = value;
  return bare;
}

void apply_override(toml::table& root, const std::string& argument) {
  const std::size_t equals = argument.find('=');
  const std::vector<KeyPart> parts = split_key(std::string_view(argument).substr(0, equals));
  if (equals == std::string::npos || parts.empty()) {
    throw Error(ErrorKind::input, {override_error(argument, "does not assign a key of the case file",
                                                  "write table.key=value, for example friction.coefficient=0.2")});
  }
  toml::table value = parse_override_value(argument.substr(0, equals), argument.substr(equals + 1));
  toml::table* table = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) table = &table_of(*table, parts[i], argument);
  // Moved, not copied: copies of nodes lose their position.
  value.get("v")->visit([&](auto& node) { table->insert_or_assign(parts.back().name, std::move(node)); });
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& name) {
  if (const auto line = find_deep_key(text)) {
    throw Error(ErrorKind::input, {{name, *line, "", "", fmt::format("a key has more than {} parts", most_key_parts),
                                    "keys of a case file look like bump_foil.truss.k1"}});
  }
  try {
    return toml::parse(text, std::string_view(name));
  } catch (const toml::parse_error& error) {
    constexpr std::size_t longest_description = 300;
    throw Error(ErrorKind::input, {{name, error.source().begin.line, "", "",
                                    "is not TOML: " + printable(error.description(), longest_description),
                                    advice_on(error.description())}});
  }
}

std::vector<InputError> apply_overrides(toml::table& root, const std::vector<std::string>& overrides) {
  std::vector<InputError> errors;
  for (const std::string& argument : overrides) {
    collect_errors(errors, [&] { apply_override(root, argument); });
  }
  return errors;
}

}  // namespace bumpfoil
