#include "bumpfoil/model/gas_preset.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace bumpfoil {
namespace {

/// mu = mu_0 (T/T_0)^exponent (T_0 + S)/(T + S); a power law has S = 0 and an exponent larger by one.
struct ViscosityLaw {
  double mu_0;      ///< Pa s
  double T_0;       ///< K
  double exponent;  ///< excludes the factor with S
  double S;         ///< K
  TemperatureRange range;
};

/// Laws in the order of GasPreset.
constexpr std::array laws{
    ViscosityLaw{1.716e-5, 273.0, 1.5, 111.0, {170.0, 1900.0}},
    ViscosityLaw{1.870e-5, 273.0, 1.666, 0.0, {53.0, 1100.0}},
    ViscosityLaw{1.663e-5, 273.0, 1.5, 107.0, {100.0, 1500.0}},
    ViscosityLaw{1.12e-5, 350.0, 1.5, 1064.0, {360.0, 1500.0}},
};

}  // namespace

TemperatureRange temperature_range(GasPreset gas) {
  return laws[static_cast<std::size_t>(gas)].range;
}

double viscosity(GasPreset gas, double temperature) {
  const ViscosityLaw& law = laws[static_cast<std::size_t>(gas)];
  return law.mu_0 * std::pow(temperature / law.T_0, law.exponent) * (law.T_0 + law.S) / (temperature + law.S);
}

}  // namespace bumpfoil
