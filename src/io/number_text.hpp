#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace bumpfoil {

/// `number` in the unit that is `unit` in SI, for tables: five significant digits, without exponent for what is usual;
/// a dash if it is not known.
std::string number_text(const std::optional<double>& number, double unit);

/// std::from_chars, except that one plus sign may stand before the number.
template <typename Number>
std::from_chars_result read_number(std::string_view text, Number& number) {
  const bool plus = text.starts_with('+') && !text.starts_with("+-");
  return std::from_chars(text.data() + (plus ? 1 : 0), text.data() + text.size(), number);
}

}  // namespace bumpfoil
