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

/// Z(s) = dF/dq of a state of a running bearing, N/m, at any rate s for which it was made: the forces on a journal that
/// moves by q e^{s t}. Its film and foils are reduced to a Krylov space of what they store, w (src/bearing/
/// film_impedance.hpp):
///
///     F = moved q + e forces w,   (1 - e T) w = start q,   e = T0 s - shift
///
/// A plain value.
struct FilmImpedance {
  double shift{};         ///< in units of 1 / T0
  double squeeze_time{};  ///< T0, s
  JournalMatrix moved{};  ///< force per displacement in each motion of the journal, at the shift
  Matrix start{};         ///< what a displacement in each motion stores there
  Matrix schur{};         ///< T: zero below its diagonal but for pairs of rows
  Matrix forces{};        ///< of each w

  /// w per displacement in each motion. @param excess  e
  [[nodiscard]] Eigen::MatrixXcd stored(std::complex<double> excess) const;
  /// @param rate  s, 1/s
  [[nodiscard]] JournalMatrixC at(std::complex<double> rate) const;
};

/// Springs and dampers in place of a film: Z(s) = K + s C.
/// @param stiffness  K, N/m
/// @param damping    C, N s/m
/// @param unit       a usual size of |s|, 1/s
FilmImpedance linear_impedance(const JournalMatrix& stiffness, const JournalMatrix& damping, double unit);

}  // namespace bumpfoil
