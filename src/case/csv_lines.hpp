#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "core/number_text.hpp"

namespace bumpfoil {

/// Removes spaces at both ends.
inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Lower case of ASCII letters only, independent of the locale.
inline char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
inline std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return lower(c); });
  return text;
}

/// The value of a text that is entirely a number.
template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number number{};
  const auto [end, status] = read_number(text, number);
  if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The two columns of a line, trimmed; absent unless there are exactly two.
inline std::optional<std::pair<std::string_view, std::string_view>> two_columns(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || text.find(',', comma + 1) != std::string_view::npos) return std::nullopt;
  return std::pair{trimmed(text.substr(0, comma)), trimmed(text.substr(comma + 1))};
}

/// Calls visit(line number from 1, trimmed text) for every line, with any line ending.
template <typename Visit>
void for_each_line(std::string_view text, const Visit& visit) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find_first_of("\r\n");
    visit(line, trimmed(text.substr(0, end)));
    const std::size_t ending = text.substr(std::min(end, text.size())).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + ending);
  }
}

}  // namespace bumpfoil
