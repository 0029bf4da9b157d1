#include "case/unit_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace bumpfoil {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool equal_but_for_capitals(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

bool begins_but_for_capitals(std::string_view text, std::string_view begin) {
  return text.size() >= begin.size() && equal_but_for_capitals(text.substr(0, begin.size()), begin);
}

UnitMeaning product(const UnitMeaning& a, const UnitMeaning& b, int sign) {
  UnitMeaning out;
  for (std::size_t i = 0; i < out.powers.size(); ++i) out.powers[i] = a.powers[i] + sign * b.powers[i];
  if (a.scale && b.scale) out.scale = sign > 0 ? *a.scale * *b.scale : *a.scale / *b.scale;
  return out;
}

UnitMeaning power(const UnitMeaning& unit, int exponent) {
  UnitMeaning out{.scale = unit.scale};
  for (std::size_t i = 0; i < out.powers.size(); ++i) out.powers[i] = unit.powers[i] * exponent;
  if (unit.scale) out.scale = std::pow(*unit.scale, exponent);
  return out;
}

/// One word: a unit with prefixes before it.
std::optional<UnitMeaning> read_word(std::string_view word, const UnitTable& table) {
  double prefix = 1.0;
  bool had_symbol = false;
  while (!word.empty()) {
    for (const bool is_symbol : {false, true}) {
      const auto unit = std::find_if(table.units.begin(), table.units.end(), [&](const TableUnit& one) {
        return one.is_symbol == is_symbol && (is_symbol ? one.name == word : equal_but_for_capitals(one.name, word));
      });
      if (unit == table.units.end()) continue;
      UnitMeaning meaning = unit->meaning;
      if (meaning.scale) meaning.scale = *meaning.scale * prefix;
      return meaning;
    }
    // The longest that fits; one symbol at most, after names.
    const TablePrefix* longest = nullptr;
    for (const bool is_symbol : {false, true}) {
      if (longest != nullptr || (is_symbol && had_symbol)) break;
      for (const TablePrefix& one : table.prefixes) {
        const bool fits = one.is_symbol == is_symbol &&
                          (is_symbol ? word.starts_with(one.name) : begins_but_for_capitals(word, one.name));
        if (fits && (longest == nullptr || one.name.size() > longest->name.size())) longest = &one;
      }
    }
    if (longest == nullptr) return std::nullopt;
    had_symbol = had_symbol || longest->is_symbol;
    prefix *= longest->value;
    word.remove_prefix(longest->name.size());
  }
  return std::nullopt;
}

struct Spelling {
  std::string_view from;
  std::string_view to;
};

/// Signs beyond ASCII that stand for others.
constexpr std::array spellings{
    Spelling{"\xc2\xb7", "."},     Spelling{"\xc2\xb9", "1"},     Spelling{"\xc2\xb2", "2"},
    Spelling{"\xc2\xb3", "3"},     Spelling{"\xe2\x81\xb0", "0"}, Spelling{"\xe2\x81\xb4", "4"},
    Spelling{"\xe2\x81\xb5", "5"}, Spelling{"\xe2\x81\xb6", "6"}, Spelling{"\xe2\x81\xb7", "7"},
    Spelling{"\xe2\x81\xb8", "8"}, Spelling{"\xe2\x81\xb9", "9"}, Spelling{"\xe2\x81\xbb", "-"},
    Spelling{"\xe2\x81\xba", "+"},
};

std::string plainly_spelt(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto* const found = std::find_if(spellings.begin(), spellings.end(),
                                           [text](const Spelling& one) { return text.starts_with(one.from); });
    if (found == spellings.end()) {
      out += text.front();
      text.remove_prefix(1);
    } else {
      out += found->to;
      text.remove_prefix(found->from.size());
    }
  }
  return out;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether a sign is part of a word, at its ends as well as inside.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

/// Signs that are units by themselves.
bool is_word(char c) {
  return c == '%' || c == '\'' || c == '"';
}

class UnitParser {
 public:
  UnitParser(std::string_view text, const UnitTable& table) : rest_(text), table_(table) {}

  std::optional<UnitMeaning> whole() {
    skip_spaces();
    std::optional<UnitMeaning> unit;
    if (rest_.starts_with('1') && rest_.find('/') == rest_.find_first_not_of("1 ")) {
      rest_.remove_prefix(1);
      unit = UnitMeaning{.scale = 1.0};
      unit = further(*unit);
    } else {
      unit = all_factors();
    }
    return rest_.empty() ? unit : std::nullopt;
  }

 private:
  std::optional<UnitMeaning> all_factors() {
    const std::optional<UnitMeaning> first = factor();
    return first ? further(*first) : std::nullopt;
  }

  /// Products and quotients, from the left.
  std::optional<UnitMeaning> further(UnitMeaning unit) {
    for (skip_spaces(); !rest_.empty() && rest_.front() != ')'; skip_spaces()) {
      const int sign = operation();
      const std::optional<UnitMeaning> next = factor();
      if (!next) return std::nullopt;
      unit = product(unit, *next, sign);
    }
    return unit;
  }

  /// Takes an operator; units side by side are multiplied.
  int operation() {
    int sign = 1;
    if (rest_.front() == '/') {
      sign = -1;
      rest_.remove_prefix(1);
    } else if (rest_.front() == '.' || rest_.front() == '*' || rest_.front() == '-') {
      rest_.remove_prefix(1);
    } else if ((rest_.starts_with("per ") || rest_.starts_with("PER "))) {
      sign = -1;
      rest_.remove_prefix(3);
    }
    skip_spaces();
    return sign;
  }

  /// A unit with its exponent.
  std::optional<UnitMeaning> factor() {
    const std::optional<UnitMeaning> unit = basic();
    if (!unit) return std::nullopt;
    const bool raised = rest_.starts_with('^') || rest_.starts_with("**");
    if (raised) rest_.remove_prefix(rest_.starts_with('^') ? 1 : 2);
    const bool negative = rest_.size() > 1 && rest_.front() == '-' && is_digit(rest_[1]);
    const bool positive = rest_.size() > 1 && rest_.front() == '+' && is_digit(rest_[1]);
    const std::string_view digits = rest_.substr(negative || positive ? 1 : 0);
    if (digits.empty() || !is_digit(digits.front())) return raised ? std::nullopt : unit;
    int exponent = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    constexpr int largest_exponent = 255;
    if (status != std::errc{} || exponent > largest_exponent) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return power(*unit, negative ? -exponent : exponent);
  }

  std::optional<UnitMeaning> basic() {
    if (rest_.starts_with('(')) {
      rest_.remove_prefix(1);
      skip_spaces();
      const std::optional<UnitMeaning> inner = all_factors();
      skip_spaces();
      if (!rest_.starts_with(')')) return std::nullopt;
      rest_.remove_prefix(1);
      return inner;
    }
    // Digits may stand inside a word ("H2O"), and are an exponent after it.
    std::size_t length = !rest_.empty() && is_word(rest_.front()) ? 1 : 0;
    for (std::size_t i = 0; i < rest_.size() && (is_letter(rest_[i]) || (i > 0 && is_digit(rest_[i]))); ++i) {
      if (is_letter(rest_[i])) length = i + 1;
    }
    const std::optional<UnitMeaning> unit = read_word(rest_.substr(0, length), table_);
    rest_.remove_prefix(length);
    return unit;
  }

  void skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  std::string_view rest_;
  const UnitTable& table_;
};

}  // namespace

std::optional<UnitMeaning> read_unit(std::string_view text, const UnitTable& table) {
  const std::string plain = plainly_spelt(text);
  std::optional<UnitMeaning> unit = UnitParser(plain, table).whole();
  if (unit && unit->scale && !std::isfinite(*unit->scale)) unit->scale.reset();
  return unit;
}

}  // namespace bumpfoil
