#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// A linearised film and its foils, reduced to a Krylov space of what they store: forces on a journal that moves by
/// q e^{s t} in one direction. See src/bearing/film_impedance.hpp for its making.
///
///     F = moved + e forces w,   (1 - e H) w = start e_1,   e = s - shift
struct ReducedForces {
  Eigen::Vector2d moved{Eigen::Vector2d::Zero()};  ///< per displacement, at the shift
  double start{};                                  ///< norm of what is stored there
  Matrix hessenberg;                               ///< H
  Eigen::Matrix2Xd forces;                         ///< of each direction of the space

  /// Force per displacement. @param excess  e
  [[nodiscard]] Eigen::Vector2cd at(std::complex<double> excess) const;
};

/// Z(s) = dF/d(x, y) of a state of a running bearing, N/m, at any rate s for which it was made. A plain value.
struct FilmImpedance {
  double shift{};                      ///< in units of 1 / T0
  double squeeze_time{};               ///< T0, s
  std::array<ReducedForces, 2> along;  ///< motions along X and Y

  /// @param rate  s, 1/s
  [[nodiscard]] Eigen::Matrix2cd at(std::complex<double> rate) const;
};

/// Springs and dampers in place of a film: Z(s) = K + s C.
/// @param stiffness  K, N/m
/// @param damping    C, N s/m
/// @param unit       a usual size of |s|, 1/s
FilmImpedance linear_impedance(const Eigen::Matrix2d& stiffness, const Eigen::Matrix2d& damping, double unit);

}  // namespace bumpfoil
