#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "bumpfoil/bearing/journal_law.hpp"
#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// The same of complex amplitudes.
using JournalVectorC = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, 0, 4, 1>;
using JournalMatrixC = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

/// A linearised film and its foils, reduced to a Krylov space of what they store: forces on a journal that moves by
/// q e^{s t} in one of its motions (JournalVector). See src/bearing/film_impedance.hpp for its making.
///
///     F = moved + e forces w,   (1 - e H) w = start e_1,   e = s - shift
struct ReducedForces {
  JournalVector moved{};  ///< per displacement, at the shift
  double start{};         ///< norm of what is stored there
  Matrix hessenberg;      ///< H
  Matrix forces;          ///< of each direction of the space

  /// Force per displacement. @param excess  e
  [[nodiscard]] JournalVectorC at(std::complex<double> excess) const;
  /// Its derivative by e: forces (1 - e H)^-2 start e_1.
  [[nodiscard]] JournalVectorC slope(std::complex<double> excess) const;
};

/// Z(s) = dF/dq of a state of a running bearing, N/m, at any rate s for which it was made. A plain value.
struct FilmImpedance {
  double shift{};                      ///< in units of 1 / T0
  double squeeze_time{};               ///< T0, s
  std::vector<ReducedForces> along{};  ///< each motion of the journal

  /// @param rate  s, 1/s
  [[nodiscard]] JournalMatrixC at(std::complex<double> rate) const;
  /// dZ/ds, N s/m. @param rate  s, 1/s
  [[nodiscard]] JournalMatrixC slope(std::complex<double> rate) const;
};

/// Springs and dampers in place of a film: Z(s) = K + s C.
/// @param stiffness  K, N/m
/// @param damping    C, N s/m
/// @param unit       a usual size of |s|, 1/s
FilmImpedance linear_impedance(const JournalMatrix& stiffness, const JournalMatrix& damping, double unit);

}  // namespace bumpfoil
