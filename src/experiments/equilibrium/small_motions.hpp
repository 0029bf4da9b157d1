#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/critical_mass.hpp"
#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Requested frequencies of coefficients, rad/s; by default that of the rotation.
std::vector<double> frequencies_of(const EquilibriumSettings& settings, double speed);

/// Rates i nu, 1/s, at which the accuracy of an impedance is ensured for the search of critical masses.
std::vector<std::complex<double>> whirling_rates(double speed);

/// The smallest critical mass with a whirl frequency in this range. None: a rotor of any mass is stable.
std::optional<CriticalMass> least_critical_mass(const FilmImpedance& impedance, double speed);

}  // namespace bumpfoil
