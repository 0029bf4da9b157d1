#pragma once

#include <cstdint>

namespace bumpfoil {

/// Gases whose viscosity is known by a law of temperature.
enum class GasPreset : std::uint8_t { air, helium, nitrogen, steam };

/// Temperatures between which the law of a gas holds, K.
struct TemperatureRange {
  double least{}, most{};
};
TemperatureRange temperature_range(GasPreset gas);

/// Viscosity of a gas at low pressure, Pa s, within 2 to 5 % [White2006, Sec. 1-3.6]:
///
///     air, nitrogen, steam:  mu = mu_0 (T/T_0)^(3/2) (T_0 + S)/(T + S)      (Sutherland's law)
///     helium:                mu = mu_0 (T/T_0)^n
///
/// @param temperature  T, K, within temperature_range()
double viscosity(GasPreset gas, double temperature);

}  // namespace bumpfoil
