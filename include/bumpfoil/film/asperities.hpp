#pragma once

namespace bumpfoil {

/// The statistical integral of Greenwood and Tripp for Gaussian heights [GreenwoodTripp1970],
///
///     F_5/2(u) = (2 pi)^(-1/2) int_u^inf (s - u)^(5/2) exp(-s^2/2) ds,     dF_5/2/du = -5/2 F_3/2(u)
struct GreenwoodTripp {
  double value{};  ///< F_5/2(u)
  double slope{};  ///< dF_5/2/du
};

/// @param u  distance of the mean planes over the roughness, >= 0; relative error below 1e-12
GreenwoodTripp greenwood_tripp(double u);

/// Rough surfaces whose peaks touch where a film is thin: the contact pressure in addition to the film. A plain value,
/// with or without dimensions:
///
///     p_c(h) = K' F_5/2(h / sigma),     K' = (16 sqrt(2) / 15) pi (eta beta sigma)^2 sqrt(sigma / beta) E*
struct Asperities {
  double pressure_factor{};  ///< K', Pa, or in units of pa
  double roughness{};        ///< sigma, of both surfaces together, m, or in units of c
  double friction{};         ///< coefficient of the peaks that rub

  /// p_c where the mean planes are h apart, in the unit of K'.
  [[nodiscard]] double pressure(double h) const;
  /// dp_c/dh.
  [[nodiscard]] double slope(double h) const;
  /// int p_c dh from h to infinity: 2/7 K' sigma F_7/2(h / sigma), F_7/2(u) = 5/2 F_3/2(u) - u F_5/2(u).
  [[nodiscard]] double energy(double h) const;
};

/// K', Pa.
/// @param density  eta, peaks per area, 1/m^2
/// @param radius   beta, of the peaks, m
/// @param modulus  E* of both surfaces together, Pa
double asperity_pressure_factor(double roughness, double density, double radius, double modulus);

}  // namespace bumpfoil
