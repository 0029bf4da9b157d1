#include "case/unit_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "case/csv_lines.hpp"

namespace bumpfoil {
std::span<const KnownUnit> known_units() {
  constexpr UnitPowers length{0, 1}, mass{1}, duration{0, 0, 1}, temperature{0, 0, 0, 1}, angle{0, 0, 0, 0, 1};
  constexpr UnitPowers force{1, 1, -2}, pressure{1, -1, -2}, viscosity{1, -1, -1}, energy{1, 2, -2}, power{1, 2, -3};
  constexpr double inch = 0.0254, pound_force = 4.4482216152605, psi = pound_force / (inch * inch);
  constexpr double full_turn = 2.0 * std::numbers::pi;

  static constexpr auto units = std::to_array<KnownUnit>({
      {"m", "meter metre", {length, 1.0}},
      {"", "micron", {length, 1e-6}},
      {"in", "inch inches", {length, inch}},
      {"", "mil thou", {length, 1e-3 * inch}},
      {"ft", "foot feet", {length, 12.0 * inch}},
      {"rad", "radian", {angle, 1.0}},
      {"deg \u00b0", "degree", {angle, full_turn / 360.0}},
      {"rev", "revolution turn", {angle, full_turn}},
      {"s", "second sec", {duration, 1.0}},
      {"min", "minute", {duration, 60.0}},
      {"h", "hour", {duration, 3600.0}},
      {"Hz", "hertz", {{0, 0, -1}, 1.0}},
      {"rpm", "", {{0, 0, -1, 0, 1}, full_turn / 60.0}},
      {"g", "gram", {mass, 1e-3}},
      {"lb", "pound", {mass, 0.45359237}},
      {"N", "newton", {force, 1.0}},
      {"lbf", "", {force, pound_force}},
      {"", "kip", {force, 1e3 * pound_force}},
      {"kgf", "", {force, 9.80665}},
      {"Pa", "pascal", {pressure, 1.0}},
      {"", "bar", {pressure, 1e5}},
      {"psi", "", {pressure, psi}},
      {"ksi", "", {pressure, 1e3 * psi}},
      {"atm", "atmosphere", {pressure, 101325.0}},
      {"mmHg", "torr", {pressure, 133.322387415}},
      {"P", "poise", {viscosity, 0.1}},
      {"J", "joule", {energy, 1.0}},
      {"W", "watt", {power, 1.0}},
      {"K", "kelvin", {temperature, 1.0}},
      {"\u00b0C", "degc celsius", {temperature, std::nullopt}},
      {"\u00b0F", "degf fahrenheit", {temperature, std::nullopt}},
  });
  return units;
}

std::span<const UnitPrefix> unit_prefixes() {
  static constexpr auto prefixes = std::to_array<UnitPrefix>({
      {"T", "tera", 1e12},
      {"G", "giga", 1e9},
      {"M", "mega", 1e6},
      {"k", "kilo", 1e3},
      {"h", "hecto", 1e2},
      {"da", "deka", 1e1},
      {"d", "deci", 1e-1},
      {"c", "centi", 1e-2},
      {"m", "milli", 1e-3},
      {"u", "micro", 1e-6},
      {"n", "nano", 1e-9},
      {"p", "pico", 1e-12},
  });
  return prefixes;
}

namespace {

struct Spelling {
  std::string_view from;
  std::string_view to;
};

/// Non-ASCII characters with plain equivalents: micro, mu, product dots, and exponents.
constexpr auto plain_spellings = std::to_array<Spelling>({
    {"\u00b5", "u"},
    {"\u03bc", "u"},
    {"\u00b7", "."},
    {"\u207b", "-"},
    {"\u00b9", "1"},
    {"\u00b2", "2"},
    {"\u00b3", "3"},
});

std::string plainly_spelt(std::string text) {
  for (const auto& [from, to] : plain_spellings) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at))
      text.replace(at, from.size(), to);
  }
  return text;
}

/// Whether a word is in a list separated by blanks.
bool is_among(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    const std::string_view first = list.substr(0, list.find(' '));
    if (first == word) return true;
    list.remove_prefix(std::min(first.size() + 1, list.size()));
  }
  return false;
}

/// @param small  the word in lower case
const KnownUnit* find_unit(std::string_view word, std::string_view small) {
  const std::string_view one = small.ends_with('s') ? small.substr(0, small.size() - 1) : small;
  for (const KnownUnit& unit : known_units()) {
    if (is_among(unit.symbols, word) || is_among(unit.names, small) || is_among(unit.names, one)) return &unit;
  }
  return nullptr;
}

std::optional<UnitMeaning> read_word(std::string_view word) {
  const std::string small = lower(std::string(word));
  if (const KnownUnit* unit = find_unit(word, small)) return unit->meaning;
  for (const UnitPrefix& prefix : unit_prefixes()) {
    const bool named = small.starts_with(prefix.name);
    if (!named && !word.starts_with(prefix.symbol)) continue;
    const std::size_t size = named ? prefix.name.size() : prefix.symbol.size();
    const KnownUnit* const unit = find_unit(word.substr(size), std::string_view(small).substr(size));
    if (unit == nullptr || !unit->meaning.scale) continue;
    return UnitMeaning{unit->meaning.powers, prefix.value * *unit->meaning.scale};
  }
  return std::nullopt;
}

bool is_digit_of_power(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool is_done() const { return rest_.empty(); }

  std::optional<UnitMeaning> product() {
    skip_blanks();
    // No other numbers are allowed in units.
    const bool inverse = rest_.starts_with("1/") && takes("1");
    std::optional<UnitMeaning> unit = inverse ? UnitMeaning{.scale = 1.0} : factor();
    for (bool apart = skip_blanks(); unit && !rest_.empty() && rest_.front() != ')'; apart = skip_blanks()) {
      const bool divides = takes("/");
      if (!divides && !takes(".") && !takes("*") && !takes("-") && !apart) return std::nullopt;
      skip_blanks();
      const std::optional<UnitMeaning> next = factor();
      if (!next) return std::nullopt;
      multiply(*unit, *next, divides ? -1 : 1);
    }
    return unit;
  }

 private:
  /// A unit with its exponent, or a bracketed product.
  std::optional<UnitMeaning> factor() {
    if (takes("(")) {
      const std::optional<UnitMeaning> inner = product();
      return takes(")") ? inner : std::nullopt;
    }
    const auto* const end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
    const std::string_view word = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    const std::optional<UnitMeaning> unit = read_word(word);
    rest_.remove_prefix(word.size());
    if (!unit) return std::nullopt;
    const bool raised = takes("^") || takes("**");
    const bool negative = rest_.size() > 1 && is_digit_of_power(rest_[1]) && takes("-");
    if (rest_.empty() || !is_digit_of_power(rest_.front())) return raised ? std::nullopt : unit;
    UnitMeaning out{.scale = 1.0};
    multiply(out, *unit, negative ? '0' - rest_.front() : rest_.front() - '0');
    rest_.remove_prefix(1);
    return out;
  }

  static void multiply(UnitMeaning& unit, const UnitMeaning& by, int exponent) {
    for (std::size_t i = 0; i < unit.powers.size(); ++i) unit.powers[i] += exponent * by.powers[i];
    if (!by.scale) unit.scale.reset();
    if (unit.scale) *unit.scale *= std::pow(*by.scale, exponent);
  }

  bool takes(std::string_view sign) {
    const bool taken = rest_.starts_with(sign);
    if (taken) rest_.remove_prefix(sign.size());
    return taken;
  }

  bool skip_blanks() {
    const std::size_t blanks = std::min(rest_.find_first_not_of(' '), rest_.size());
    rest_.remove_prefix(blanks);
    return blanks > 0;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<UnitMeaning> read_unit(std::string_view text) {
  const std::string plain = plainly_spelt(std::string(text));
  UnitParser parser(plain);
  std::optional<UnitMeaning> unit = parser.product();
  if (!parser.is_done()) return std::nullopt;
  if (unit && unit->scale && !std::isnormal(*unit->scale)) unit->scale.reset();
  return unit;
}

}  // namespace bumpfoil
