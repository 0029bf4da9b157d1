#pragma once

#include <string>

#include "bumpfoil/model/case.hpp"
#include "model/checks.hpp"

namespace bumpfoil {

/// Checks the waves of a sleeve. @param radius of the bearing, m; 0 if unknown
void check_waves(Checks& checks, const std::string& table, int harmonic, double amplitude, double radius);

/// Checks the settings of an ensemble; invalid samples are only found on drawing. @param radius as above
void check_montecarlo(Checks& checks, const MonteCarloSettings& ensemble, double radius);

}  // namespace bumpfoil
