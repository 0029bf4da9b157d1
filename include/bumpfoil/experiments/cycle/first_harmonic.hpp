#pragma once

#include <Eigen/Core>
#include <span>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// The linear spring and damper equivalent of a loop: the first harmonic of its force. With the displacement x = X
/// cos(tau) along the unit vector n,
///
///     stiffness = (1/(pi X)) closed integral of F cos(tau) dtau,   loss = (1/(pi X^2)) closed integral of F dx
///
/// so that F - mean = stiffness x + (loss/omega) dx/dt + higher harmonics, at any frequency omega: Coulomb friction
/// is independent of the rate. Along n, pi X^2 loss is the loop energy.
struct FirstHarmonic {
  Eigen::Vector2d stiffness{0.0, 0.0};  ///< K n, N/m
  Eigen::Vector2d loss{0.0, 0.0};       ///< omega c n, N/m
  double residual{};  ///< norm of the higher harmonics over that of the first; not a number where there is none
};

/// Of a loop that goes to the largest displacement, to the smallest and back to its start, each once. The force is
/// taken as linear in the displacement between the points, and the integrals over tau are exact for that.
/// @pre the displacement is not the same throughout
FirstHarmonic first_harmonic(std::span<const LoopPoint> loop);

/// The same of a circle x = X (cos(tau), +-sin(tau)), where `stiffness` is the part of the force with cos(tau) over X
/// and `loss` that with -sin(tau). In either sense s of it, linear foils have
///
///     stiffness = K e_x + s H e_y,   loss = H e_x - s K e_y,   H = omega c
///
/// @param forces  at equal steps of tau, from tau = 0 on, once round; by the trapezoidal rule, which leaves an error of
///                the square of the step where forces bend sharply
FirstHarmonic orbit_harmonic(std::span<const Eigen::Vector2d> forces, double radius);

}  // namespace bumpfoil
