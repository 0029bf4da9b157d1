#pragma once

#include "bumpfoil/structure/top_foil.hpp"

namespace bumpfoil {

/// How much less a top foil is curved before its assembly than the circle that it lies on, 1/m: positive where it is
/// formed flatter. psi is the angle from its free end back towards the weld.
///
///     kappa_0(psi) = uniform + graded (1 - cos psi)
///
/// The assembled foil obeys u'' + u = R^2 (M / EI' + kappa_0) and M'' + M = R^2 q, primes along theta, M zero with its
/// derivative at the free end, q the load per length, outward. Where it lies on its bumps, u = 0, a uniform part
/// presses on them with EI' kappa_0 / R^2 per length there, and with a force at the free end; the graded part presses
/// with EI' graded / R^2 per length everywhere, and with no force at the end.
struct Forming {
  double uniform{};    ///< 1/R - 1/R_f
  double graded{};     ///< R^2 p_s L / EI' for a seat pressure p_s
  double end_angle{};  ///< of the free end from the weld, rad

  [[nodiscard]] bool is_none() const { return uniform == 0.0 && graded == 0.0; }
};

/// The forming of the top foil of a pair of bent foils. There must be one.
Forming make_forming(const FoilDesign& foils);

/// Contribution of the forming to the compatibility of the foil in its moment form, T M + r = D' u, see TopFoilMoments:
/// the rotations, at the weld and at all nodes but the last, between neighbouring spans that are formed but not bent,
///
///     r_k = R times the sum over both spans of the integral of kappa_0 sin(x) / sin(d), x = d at node k
///
/// rad, in closed form: kappa_0 R (tan(d_{k-1}/2) + tan(d_k/2)) for a uniform one.
Vector forming_rotations(const TopFoilBeam& beam, const Forming& forming);

}  // namespace bumpfoil
