#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// `number` in a unit whose SI value is `unit`, for tables: five significant digits, without exponent for usual sizes;
/// a dash if missing.
std::string number_text(const std::optional<double>& number, double unit);

/// The unit of a row or a column of such texts: empty if all are dashes.
std::string_view unit_beside(std::string_view unit, const std::vector<std::string>& cells);

/// std::from_chars for double, for standard libraries that lack it, such as that of Emscripten.
std::from_chars_result read_decimal(std::string_view text, double& number);

/// std::from_chars that also accepts one leading plus sign.
template <typename Number>
std::from_chars_result read_number(std::string_view text, Number& number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  if constexpr (requires { std::from_chars(end, end, number); }) {
    return std::from_chars(text.data(), end, number);
  } else {
    return read_decimal(text, number);
  }
}

}  // namespace bumpfoil
