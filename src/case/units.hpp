#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace bumpfoil {

/// Dimension of a quantity of a case file.
enum class Dimension {
  length,
  angle,
  force,
  stiffness,
  pressure,
  frequency,
  temperature,
  viscosity,
  foundation_modulus,
  per_area,
  mass,
  moment_of_inertia,
  acceleration,
  density,
  unbalance,
  velocity,
  duration,
  moment,
  damping,
};

/// Why a text is not the expected quantity.
struct QuantityError {
  std::string what;
  std::string advice;
};

/// Reads a number with a unit, such as "31.8 um", "214 GPa", "150 MN/m", "30 deg", "200 Hz", and converts it to SI (m,
/// rad, N, N/m, Pa, rad/s, K, Pa s, Pa/m, 1/m2). Units are those of unit_table.hpp. Errors are a missing unit, a unit
/// of another dimension, with an offset or logarithmic, and a number that is not finite. Frequencies: "Hz" counts 2 pi,
/// "rpm" and "1/min" 2 pi / 60; "1/s", which could be a hertz or rad/s, is an error.
std::variant<double, QuantityError> parse_quantity(std::string_view text, Dimension due);

/// SI unit of a dimension, such as "m", "rad" or "N/m".
std::string_view si_unit(Dimension dimension);

/// An example quantity in quotes, for messages.
std::string_view example_quantity(Dimension dimension);

/// The dimension with its article, "a length".
std::string_view name_of(Dimension dimension);

}  // namespace bumpfoil
