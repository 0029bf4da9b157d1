#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/critical_mass.hpp"
#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Those that coefficients are asked for, rad/s; by default that of the rotation.
std::vector<double> frequencies_of(const EquilibriumSettings& settings, double speed);

/// Rates i nu, 1/s, at which an impedance is made sure of so that critical masses can be looked for in it.
std::vector<std::complex<double>> whirling_rates(double speed);

/// The least critical mass that whirls at a frequency between these. None: a rotor of any mass is stable.
std::optional<CriticalMass> least_critical_mass(const FilmImpedance& impedance, double speed);

}  // namespace bumpfoil
