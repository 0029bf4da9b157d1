#include "experiments/equilibrium/small_motions.hpp"

#include <array>
#include <cmath>

namespace bumpfoil {
namespace {

/// Whirl ratios of the search for critical masses, and those at which the accuracy of the impedance is ensured.
constexpr std::array probed_whirls{0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2};

}  // namespace

std::vector<double> frequencies_of(const EquilibriumSettings& settings, double speed) {
  return settings.frequencies.empty() ? std::vector{std::abs(speed)} : settings.frequencies;
}

std::vector<std::complex<double>> whirling_rates(double speed) {
  std::vector<std::complex<double>> rates;
  rates.reserve(probed_whirls.size());
  for (const double ratio : probed_whirls) rates.emplace_back(0.0, ratio * std::abs(speed));
  return rates;
}

std::optional<CriticalMass> least_critical_mass(const FilmImpedance& impedance, double speed) {
  const auto at = [&](double frequency) -> Eigen::Matrix2cd {
    return impedance.at({0.0, frequency}).topLeftCorner<2, 2>();
  };
  const std::vector<CriticalMass> found =
      critical_masses(at, probed_whirls.front() * std::abs(speed), probed_whirls.back() * std::abs(speed));
  return found.empty() ? std::nullopt : std::optional(found.front());
}

}  // namespace bumpfoil
