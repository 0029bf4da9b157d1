#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace bumpfoil {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Length of the given word at the start of a text, ignoring case; 0 if the text starts otherwise.
std::size_t length_of(std::string_view word, std::string_view text) {
  const bool same = text.size() >= word.size() &&
                    std::equal(word.begin(), word.end(), text.begin(),
                               [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
  return same ? word.size() : 0;
}

/// Length of the decimal number at the start of a text: digits with an optional point, and an exponent.
std::size_t decimal_length(std::string_view text) {
  std::size_t at = 0;
  std::size_t digits = 0;
  const auto pass_digits = [&] {
    while (at < text.size() && is_digit(text[at])) ++at, ++digits;
  };
  pass_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    pass_digits();
  }
  if (digits == 0) return 0;
  const std::size_t mantissa = at;
  if (at == text.size() || (text[at] != 'e' && text[at] != 'E')) return mantissa;
  ++at;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  digits = 0;
  pass_digits();
  return digits > 0 ? at : mantissa;
}

}  // namespace

std::from_chars_result read_decimal(std::string_view text, double& number) {
  const std::string_view size = text.substr(text.starts_with('-') ? 1 : 0);
  std::size_t length = 0;
  for (const std::string_view word : {"infinity", "inf", "nan"}) length = std::max(length, length_of(word, size));
  if (length == 0) length = decimal_length(size);
  if (length == 0) return {text.data(), std::errc::invalid_argument};
  const char* const end = size.data() + length;
  const int before = errno;
  errno = 0;
  const double read = std::strtod(std::string(text.data(), end).c_str(), nullptr);
  const bool beyond = errno == ERANGE && (std::isinf(read) || read == 0.0);
  errno = before;
  if (beyond) return {end, std::errc::result_out_of_range};
  number = read;
  return {end, std::errc{}};
}

std::string number_text(const std::optional<double>& number, double unit) {
  if (!number || !std::isfinite(*number)) return "-";
  const double scaled = *number / unit;
  const double size = std::abs(scaled);
  if (size == 0.0) return "0";
  if (size < 1e-3 || size >= 1e6) return fmt::format("{:.3e}", scaled);
  return fmt::format("{:.{}f}", scaled, std::max(0, 4 - static_cast<int>(std::floor(std::log10(size)))));
}

std::string_view unit_beside(std::string_view unit, const std::vector<std::string>& cells) {
  const bool known = std::any_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell != "-"; });
  return known ? unit : std::string_view();
}

}  // namespace bumpfoil
