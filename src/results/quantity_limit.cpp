#include "results/quantity_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/nearest_name.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "case/csv_lines.hpp"
#include "case/units.hpp"

namespace bumpfoil {
namespace {

[[noreturn]] void refuse_limit(const std::string& text, const LimitWords& words, std::string what, std::string advice) {
  throw Error(ErrorKind::input, {{"", 0, words.key, text, std::move(what), std::move(advice)}});
}

/// The dimension of a quantity in this unit; absent if it has none, or one that cases do not use.
std::optional<Dimension> dimension_in(std::string_view unit) {
  for (const Dimension dimension :
       {Dimension::length, Dimension::force, Dimension::stiffness, Dimension::pressure, Dimension::frequency,
        Dimension::moment, Dimension::damping, Dimension::mass, Dimension::duration}) {
    if (si_unit(dimension) == unit) return dimension;
  }
  return std::nullopt;
}

/// The text without this trailing unit, such as that of a power, which cases do not use.
std::string_view without_unit(std::string_view value, std::string_view unit) {
  return trimmed(unit != "1" && value.ends_with(unit) ? value.substr(0, value.size() - unit.size()) : value);
}

std::size_t number_of_quantity(const std::string& name, const std::string& text,
                               const std::vector<LimitedQuantity>& quantities, const LimitWords& words) {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&name](const LimitedQuantity& one) { return one.name == name; });
  if (found != quantities.end()) return static_cast<std::size_t>(found - quantities.begin());
  const auto nearest = nearest_name(name, each(quantities, [](const LimitedQuantity& one) { return one.name; }));
  refuse_limit(text, words, fmt::format("does not name a quantity of {}", words.whole),
               nearest ? fmt::format("did you mean \"{}\"?", *nearest) : words.listing);
}

}  // namespace

std::size_t parse_quantity_name(const std::string& name, const std::vector<LimitedQuantity>& quantities,
                                const LimitWords& words) {
  return number_of_quantity(std::string(trimmed(name)), name, quantities, words);
}

QuantityLimit parse_quantity_limit(const std::string& text, const std::vector<LimitedQuantity>& quantities,
                                   const LimitWords& words) {
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos) {
    refuse_limit(text, words, "has no < and no >", fmt::format("write a limit such as \"{}\"", words.example));
  }
  const std::string name(trimmed(std::string_view(text).substr(0, sign)));
  const std::string value(trimmed(std::string_view(text).substr(sign + 1)));
  QuantityLimit limit{number_of_quantity(name, text, quantities, words), text[sign] == '>', 0.0};
  const std::string& unit = quantities[limit.quantity].unit;
  if (const std::optional<double> number = parse<double>(without_unit(value, unit))) {
    limit.bound = *number;
  } else if (const std::optional<Dimension> dimension = dimension_in(unit)) {
    const auto quantity = parse_quantity(value, *dimension);
    if (const auto* error = std::get_if<QuantityError>(&quantity))
      refuse_limit(text, words, error->what, error->advice);
    limit.bound = std::get<double>(quantity);
  } else {
    refuse_limit(text, words, "does not end with a number",
                 unit == "1" ? "write a number without a unit" : fmt::format("write a number in {}", unit));
  }
  if (!std::isfinite(limit.bound)) refuse_limit(text, words, "is not finite", "give a finite number");
  return limit;
}

}  // namespace bumpfoil
