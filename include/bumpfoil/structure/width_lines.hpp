#pragma once

#include <cstdint>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Computed part of the width of a bearing: half of it, if both halves are equal, or all of it.
enum class WidthPart : std::uint8_t { half, whole };

/// How displacements of a foil vary over its width: zeta in [-1, 1] from side to side, P_k the polynomials of Legendre,
///
///     u(zeta) = sum_k P_k(zeta) u_k = sum_s N_s(zeta) u_s
///
/// by modes k, or by the values u_s on as many lines. A plain value.
///
/// The lines stand at the points of Gauss's rule, which integrates the product of two modes exactly. Therefore the N_s
/// are orthogonal like the P_k, and a foil that bends in slices is one beam under each line, `weight` times as stiff as
/// the whole width. In a contact at its line each displaces nothing but itself.
struct WidthLines {
  std::vector<int> orders;  ///< k of each mode, rising from 0
  Vector zeta;              ///< of each line, rising
  Vector weight;            ///< part of the width that each line stands for; together 1
  Matrix to_modes;          ///< u_k = sum_s to_modes(k, s) u_s: a row for each mode

  [[nodiscard]] Eigen::Index count() const { return weight.size(); }
  /// N_s at a place over the width, of all lines.
  [[nodiscard]] Vector shapes(double at) const;
  /// k of the modes that stretch a curved foil: 2 or more.
  [[nodiscard]] std::vector<int> stretching_orders() const;
  /// The rows of to_modes of these.
  [[nodiscard]] Matrix to_stretching_modes() const;
};

/// The modes P_0, P_1, ..., as many as there are; of those on half the width, where all is the same on both halves, the
/// even ones alone.
WidthLines make_width_lines(int modes, WidthPart width);

/// P_k(x).
double legendre(int k, double x);

}  // namespace bumpfoil
