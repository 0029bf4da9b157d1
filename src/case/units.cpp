#include "case/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <system_error>

#include "bumpfoil/core/error.hpp"
#include "case/csv_lines.hpp"
#include "case/unit_table.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

struct DimensionText {
  Dimension dimension;
  std::string_view name;
  std::string_view si_unit;
  std::string_view example;
};

constexpr std::array dimensions{
    DimensionText{Dimension::length, "a length", "m", "\"31.8 um\""},
    DimensionText{Dimension::angle, "an angle", "rad", "\"30 deg\""},
    DimensionText{Dimension::force, "a force", "N", "\"5 N\""},
    DimensionText{Dimension::stiffness, "a stiffness", "N/m", "\"150 MN/m\""},
    DimensionText{Dimension::pressure, "a pressure", "Pa", "\"214 GPa\""},
    DimensionText{Dimension::frequency, "a frequency", "rad/s", "\"200 Hz\""},
    DimensionText{Dimension::temperature, "a temperature", "K", "\"293 K\""},
    DimensionText{Dimension::viscosity, "a viscosity", "Pa s", "\"18.5 uPa s\""},
    DimensionText{Dimension::foundation_modulus, "a stiffness per area", "Pa/m", "\"5 GPa/m\""},
    DimensionText{Dimension::per_area, "a number per area", "1/m2", "\"40000 1/mm2\""},
    DimensionText{Dimension::mass, "a mass", "kg", "\"2 kg\""},
    DimensionText{Dimension::moment_of_inertia, "a moment of inertia", "kg m2", "\"9e-3 kg m2\""},
    DimensionText{Dimension::acceleration, "an acceleration", "m/s2", "\"9.81 m/s2\""},
    DimensionText{Dimension::density, "a density", "kg/m3", "\"7800 kg/m3\""},
    DimensionText{Dimension::unbalance, "an unbalance", "kg m", "\"2 g mm\""},
    DimensionText{Dimension::velocity, "a velocity", "m/s", "\"2.5 mm/s\""},
    DimensionText{Dimension::duration, "a time", "s", "\"0.2 s\""},
    DimensionText{Dimension::moment, "a moment", "N m", "\"50 N mm\""},
    DimensionText{Dimension::damping, "a damping", "N s/m", "\"200 N s/m\""},
};

/// Longer texts are rejected: the unit grammar recurses.
constexpr std::size_t longest_quantity = 64;

const DimensionText& text_of(Dimension dimension) {
  return dimensions[static_cast<std::size_t>(dimension)];
}

/// Of UnitPowers.
constexpr std::size_t radian = 4;

UnitPowers powers_of(Dimension dimension) {
  return read_unit(text_of(dimension).si_unit).value_or(UnitMeaning{}).powers;
}

bool counts_radians(const UnitMeaning& unit) {
  return unit.powers[radian] != 0;
}

bool measures(const UnitMeaning& unit, Dimension dimension) {
  UnitPowers due = powers_of(dimension);
  // A frequency counts radians or, depending on its name, turns.
  if (dimension == Dimension::frequency && !counts_radians(unit)) due[radian] = 0;
  return unit.powers == due;
}

/// Numbers with separators ("1 000 mm", "31,8 um") and fractional exponents ("mm^1.5") get their own messages. Other
/// digits are exponents: they follow a letter, a sign or another digit.
bool has_stray_digits(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool digit = unit[i] >= '0' && unit[i] <= '9';
    if (!digit) continue;
    const char before = i == 0 ? ' ' : unit[i - 1];
    if (before == ' ' || before == '.' || before == ',' || before == '(' || before == '*' || before == '/') return true;
  }
  return false;
}

/// Whether a unit's name implies turns or parts of them: a hertz is 1/s, and units per minute count revolutions.
bool counts_turns(std::string_view unit) {
  return unit.ends_with("Hz") || unit.ends_with("hertz") || unit.find("min") != std::string_view::npos;
}

/// Division by 1e6 yields the double nearest to the decimal fraction; multiplication by 1e-6 may not.
double scaled(double number, double scale) {
  const double divisor = std::round(1.0 / scale);
  return divisor > 1.0 && std::abs(divisor * scale - 1.0) < 1e-14 ? number / divisor : number * scale;
}

}  // namespace

std::string_view si_unit(Dimension dimension) {
  return text_of(dimension).si_unit;
}

std::string_view example_quantity(Dimension dimension) {
  return text_of(dimension).example;
}

std::string_view name_of(Dimension dimension) {
  return text_of(dimension).name;
}

std::variant<double, QuantityError> parse_quantity(std::string_view text, Dimension due) {
  const std::string advice = fmt::format("write {} with its unit, for example {}", name_of(due), example_quantity(due));
  text = trimmed(text);
  if (text.empty()) return QuantityError{"is empty", advice};
  if (text.size() > longest_quantity || printable(text) != text) return QuantityError{"is not a quantity", advice};

  double number = 0.0;
  const auto [end, status] = read_number(text, number);
  if (status == std::errc::result_out_of_range) {
    return QuantityError{"has a number that double precision cannot hold", advice};
  }
  if (status != std::errc{}) return QuantityError{"does not start with a number", advice};
  if (!std::isfinite(number)) return QuantityError{"is not finite", advice};

  const std::string_view unit_text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  if (unit_text.empty()) {
    return QuantityError{"has no unit", fmt::format("{}, or a number in {} without quotes", advice, si_unit(due))};
  }
  const bool inverse = (due == Dimension::frequency || due == Dimension::per_area) && unit_text.starts_with("1/");
  if (unit_text.front() == ',' || has_stray_digits(unit_text.substr(inverse ? 1 : 0))) {
    return QuantityError{
        fmt::format("has digits instead of a unit, in \"{}\"", unit_text),
        "write one number with a decimal point, without separators, and one unit with whole exponents"};
  }
  const std::optional<UnitMeaning> unit = read_unit(unit_text);
  if (!unit) return QuantityError{fmt::format("has an unknown unit, \"{}\"", unit_text), advice};
  if (!measures(*unit, due)) {
    for (const DimensionText& other : dimensions) {
      if (measures(*unit, other.dimension)) {
        return QuantityError{fmt::format("is {}, expected {}", other.name, name_of(due)), advice};
      }
    }
    return QuantityError{fmt::format("has the unit \"{}\", expected {}", unit_text, name_of(due)), advice};
  }
  if (!unit->scale)
    return QuantityError{fmt::format("has a unit that is not a plain multiple, \"{}\"", unit_text), advice};
  double value = scaled(number, *unit->scale);
  if (due == Dimension::frequency && !counts_radians(*unit)) {
    if (!counts_turns(unit_text)) {
      return QuantityError{fmt::format("has the unit \"{}\", which may count revolutions or radians", unit_text),
                           "write \"Hz\" or \"rpm\" for revolutions, \"rad/s\" for radians"};
    }
    value *= 2.0 * std::numbers::pi;
  }
  if (!std::isfinite(value)) return QuantityError{"is not finite", advice};
  return value;
}

}  // namespace bumpfoil
