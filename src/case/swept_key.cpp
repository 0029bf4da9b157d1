#include "bumpfoil/case/swept_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "bumpfoil/core/error.hpp"
#include "case/csv_lines.hpp"

namespace bumpfoil {
namespace {

/// Sums of numbers with this many digits are exact in 64 bits.
constexpr int most_digits = 15;
constexpr std::int64_t digits_limit = 1'000'000'000'000'000;
/// A range may miss its end by one of so many parts of a step, for steps such as thirds.
constexpr std::int64_t parts_of_step = 1'000'000;

/// digits * 10^exponent
struct Decimal {
  std::int64_t digits{};
  int exponent{};
};

struct SweptQuantity {
  Decimal number;
  std::string unit;  ///< empty for a plain number
};

/// The decimal value of a text that std::from_chars accepts entirely; absent if it has too many digits.
std::optional<Decimal> decimal_of(std::string_view text) {
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  Decimal decimal;
  int decimals = 0;
  bool behind_point = false;
  for (const char c : text.substr(0, end)) {
    if (c == '.') behind_point = true;
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
    decimal.digits = 10 * decimal.digits + (c - '0');
    if (behind_point) ++decimals;
    if (decimal.digits >= digits_limit) return std::nullopt;
  }
  if (decimal.digits == 0) return decimal;
  // A number that is neither zero nor out of range fits.
  if (end < text.size()) read_number(text.substr(end + 1), decimal.exponent);
  decimal.exponent -= decimals;
  if (text.starts_with('-')) decimal.digits = -decimal.digits;
  return decimal;
}

/// Digits of a decimal at a smaller exponent; absent if they are too many.
std::optional<std::int64_t> digits_at(const Decimal& decimal, int exponent) {
  const double size = std::abs(static_cast<double>(decimal.digits)) * std::pow(10.0, decimal.exponent - exponent);
  if (size >= static_cast<double>(digits_limit)) return std::nullopt;
  std::int64_t digits = decimal.digits;
  for (int e = exponent; e < decimal.exponent && digits != 0; ++e) digits *= 10;
  return digits;
}

/// Shortest form: 0.1, not 0.10.
std::string text_of(Decimal decimal) {
  if (decimal.digits == 0) return "0";
  while (decimal.digits % 10 == 0) {
    decimal.digits /= 10;
    ++decimal.exponent;
  }
  std::string digits = std::to_string(std::abs(decimal.digits));
  const std::string sign = decimal.digits < 0 ? "-" : "";
  const int size = static_cast<int>(digits.size());
  // Scientific notation for very large or small numbers.
  if (decimal.exponent > most_digits || decimal.exponent < -2 * most_digits) {
    return fmt::format("{}{}e{}", sign, digits, decimal.exponent);
  }
  if (decimal.exponent >= 0) return sign + digits + std::string(static_cast<std::size_t>(decimal.exponent), '0');
  const int whole = size + decimal.exponent;
  if (whole <= 0) return sign + "0." + std::string(static_cast<std::size_t>(-whole), '0') + digits;
  return sign + digits.insert(static_cast<std::size_t>(whole), 1, '.');
}

/// Reads one option and reports its errors.
class SweptKeyParser {
 public:
  explicit SweptKeyParser(std::string_view argument) : argument_(argument) {}

  SweptKey parse() {
    const std::size_t equals = argument_.find('=');
    if (equals == std::string_view::npos || trimmed(argument_.substr(0, equals)).empty()) {
      refuse("does not give a key and its values",
             "write KEY=FROM:TO:STEP or KEY=[a, b], for example friction.coefficient=0:0.5:0.05");
    }
    key_ = trimmed(argument_.substr(0, equals));
    values_ = trimmed(argument_.substr(equals + 1));
    const bool list = values_.starts_with('[');
    return {.key = key_, .values = list ? parse_list() : parse_range()};
  }

 private:
  [[noreturn]] void refuse(std::string what, std::string advice) const {
    InputError error{"--over", 0, key_, std::string(values_), std::move(what), std::move(advice)};
    if (key_.empty()) error = {"", 0, "--over", std::string(argument_), error.what, error.advice};
    throw Error(ErrorKind::input, {std::move(error)});
  }

  void require_few(double count) const {
    if (count > static_cast<double>(most_sweep_points)) {
      refuse(fmt::format("has {:.0f} values", count), fmt::format("a sweep takes at most {}", most_sweep_points));
    }
  }

  [[nodiscard]] std::vector<std::string> parse_list() const {
    if (!values_.ends_with(']')) refuse("is a list that is not closed", "close it with ]");
    std::vector<std::string> values;
    std::string_view rest = values_.substr(1, values_.size() - 2);
    require_few(static_cast<double>(std::count(rest.begin(), rest.end(), ',')) + 1.0);
    for (bool more = true; more;) {
      const std::size_t comma = rest.find(',');
      std::string_view entry = trimmed(rest.substr(0, comma));
      more = comma != std::string_view::npos;
      if (more) rest.remove_prefix(comma + 1);
      const char quote = entry.empty() ? ' ' : entry.front();
      if (entry.size() >= 2 && (quote == '"' || quote == '\'') && entry.ends_with(quote)) {
        entry = trimmed(entry.substr(1, entry.size() - 2));
      }
      if (entry.empty()) refuse("has an empty entry", "write numbers with commas between them, such as [0.1, 0.2]");
      static_cast<void>(number_in(entry));
      values.emplace_back(entry);
    }
    return values;
  }

  [[nodiscard]] std::vector<std::string> parse_range() const {
    std::vector<SweptQuantity> parts;
    for (std::string_view rest = values_;;) {
      const std::size_t colon = rest.find(':');
      parts.push_back(parse_quantity(trimmed(rest.substr(0, colon))));
      if (colon == std::string_view::npos) break;
      rest.remove_prefix(colon + 1);
    }
    if (parts.size() != 3) {
      refuse("is neither a range nor a list", "write FROM:TO:STEP, such as 0:0.5:0.05, or a list, such as [0.1, 0.2]");
    }
    const std::string& unit = parts[0].unit;
    if (parts[1].unit != unit || parts[2].unit != unit) {
      refuse(fmt::format("has the units \"{}\", \"{}\" and \"{}\"", unit, parts[1].unit, parts[2].unit),
             "write the same unit after each of the three numbers, such as 60 um:90 um:10 um");
    }
    std::vector<std::string> values = parse_numbers(parts);
    if (!unit.empty()) {
      for (std::string& value : values) value += ' ' + unit;
    }
    return values;
  }

  [[nodiscard]] std::vector<std::string> parse_numbers(const std::vector<SweptQuantity>& parts) const {
    const int exponent = std::min({parts[0].number.exponent, parts[1].number.exponent, parts[2].number.exponent});
    std::vector<std::int64_t> digits;
    for (const SweptQuantity& part : parts) {
      const std::optional<std::int64_t> aligned = digits_at(part.number, exponent);
      if (!aligned) refuse(fmt::format("spans more than {} digits", most_digits), "give the values as a list: [a, b]");
      digits.push_back(*aligned);
    }
    const std::int64_t from = digits[0];
    const std::int64_t span = digits[1] - digits[0];
    const std::int64_t step = digits[2];
    if (step == 0) refuse("has no step", "give a step that is not zero");
    if (span != 0 && (span < 0) != (step < 0)) {
      refuse("steps away from its end", fmt::format("give the step {}", text_of({-step, exponent})));
    }
    // Rounded to the nearest whole number of steps; span and step have the same sign.
    const std::int64_t steps = (span + step / 2) / step;
    if (std::abs(span - steps * step) > std::abs(step) / parts_of_step) {
      const std::int64_t below = from + span / step * step;
      refuse(fmt::format("does not end at {}", text_of({digits[1], exponent})),
             fmt::format("steps of {} lead to {} and {}: end at one of them, or give another step",
                         text_of({step, exponent}), text_of({below, exponent}), text_of({below + step, exponent})));
    }
    require_few(static_cast<double>(steps) + 1.0);
    std::vector<std::string> values;
    for (std::int64_t i = 0; i < steps; ++i) values.push_back(text_of({from + i * step, exponent}));
    values.push_back(text_of({digits[1], exponent}));
    return values;
  }

  /// The leading number of a text, as written.
  [[nodiscard]] std::string_view number_in(std::string_view text) const {
    double number = 0.0;
    const auto [end, status] = read_number(text, number);
    if (status != std::errc{} || !std::isfinite(number)) {
      refuse(fmt::format("has \"{}\", expected a number", printable(text)),
             "write numbers, with a unit where the key has one, such as 0.1 or 60 um");
    }
    return text.substr(0, static_cast<std::size_t>(end - text.data()));
  }

  [[nodiscard]] SweptQuantity parse_quantity(std::string_view text) const {
    const std::string_view number = number_in(text);
    const std::optional<Decimal> decimal = decimal_of(number);
    if (!decimal) refuse(fmt::format("has a number of more than {} digits", most_digits), "round it");
    const std::string_view unit = trimmed(text.substr(number.size()));
    if (unit.starts_with(','))
      refuse("has a decimal comma",
             "write decimal points, such as 0:0.5:0.05, or a list in brackets, such as [0.05, 0.1]");
    return {*decimal, std::string(unit)};
  }

  std::string_view argument_;
  std::string key_;
  std::string_view values_;
};

}  // namespace

SweptKey parse_swept_key(std::string_view argument) {
  return SweptKeyParser(argument).parse();
}

}  // namespace bumpfoil
