#include "bumpfoil/film/asperities.hpp"

#include <cmath>
#include <numbers>

namespace bumpfoil {
namespace {

/// Step of the trapezoidal rule.
constexpr double integration_step = 0.15;
/// exp(-x) for larger x vanishes beside a double's sum.
constexpr double vanishing_exponent = 45.0;
/// Separation of the mean planes over roughness above which the pressure underflows to zero.
constexpr double vanishing_height = 39.0;

}  // namespace

// With s = u + t^2 the integrand, 2 t^6 exp(-(u + t^2)^2 / 2), is even and smooth: the trapezoidal rule converges
// faster than any power of its step.
GreenwoodTripp greenwood_tripp(double u) {
  if (u > vanishing_height) return {};
  double value = 0.0;
  double slope = 0.0;
  for (int i = 1;; ++i) {
    const double t_squared = integration_step * integration_step * i * i;
    const double s = u + t_squared;
    const double exponent = 0.5 * (s * s - u * u);
    if (exponent > vanishing_exponent) break;
    const double part = t_squared * t_squared * std::exp(-exponent);
    value += t_squared * part;
    slope += part;
  }
  const double scale = 2.0 * integration_step / std::sqrt(2.0 * std::numbers::pi) * std::exp(-0.5 * u * u);
  return {.value = scale * value, .slope = -2.5 * scale * slope};
}

double Asperities::pressure(double h) const {
  return pressure_factor * greenwood_tripp(h / roughness).value;
}

double Asperities::slope(double h) const {
  return pressure_factor / roughness * greenwood_tripp(h / roughness).slope;
}

double Asperities::energy(double h) const {
  const double u = h / roughness;
  const auto [value, slope] = greenwood_tripp(u);
  return 2.0 / 7.0 * pressure_factor * roughness * (-slope - u * value);
}

double asperity_pressure_factor(double roughness, double density, double radius, double modulus) {
  const double peaks = density * radius * roughness;
  return 16.0 * std::numbers::sqrt2 / 15.0 * std::numbers::pi * peaks * peaks * std::sqrt(roughness / radius) * modulus;
}

}  // namespace bumpfoil
