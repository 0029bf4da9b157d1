#pragma once

#include <optional>

#include "bumpfoil/model/gas_preset.hpp"

namespace bumpfoil {

/// The gas of a film: isothermal, ideal.
struct GasSettings {
  GasPreset preset{GasPreset::air};   ///< whose viscosity it has at `temperature`, unless that is given
  double temperature{293.0};          ///< K
  std::optional<double> viscosity{};  ///< Pa s, in place of the preset's
  double ambient_pressure{101325.0};  ///< Pa
  double mean_free_path{};            ///< at ambient pressure, m; 0: no slip at the walls

  bool operator==(const GasSettings&) const = default;
};

/// Rough surfaces of journal and top foil that touch where the film is thin. The pressure of their peaks is that of
/// Asperities in film/, by its factor or by what that is made of.
struct AsperitySettings {
  double sigma{};                           ///< roughness of both surfaces together, standard deviation, m
  std::optional<double> pressure_factor{};  ///< K', Pa
  std::optional<double> density{};          ///< eta, peaks per area, 1/m^2
  std::optional<double> radius{};           ///< beta, of the peaks, m
  std::optional<double> modulus{};          ///< E* of both surfaces together, Pa; absent: both are of the top foil's
  double friction{};                        ///< coefficient of rubbing peaks, as of a coating

  bool operator==(const AsperitySettings&) const = default;
};

}  // namespace bumpfoil
