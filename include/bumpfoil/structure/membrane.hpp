#pragma once

#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Membrane stiffness of a foil that is curved by 1/R along theta against outward displacements w_k P_k(zeta) with k >=
/// 2: they stretch it, those with k = 0, 1 do not. Its side edges are free. The forces per length in its middle
/// surface, along the foil, across it and in shear, are those of one stress function f_k(s) per mode, s along the foil,
/// a half the width:
///
///     N_s = sum f_k P_k,   N_z = sum f_k'' chi_k,   N_sz = - sum f_k' chi_k'
///     chi_k'' = P_k (in z = a zeta),   chi_k = chi_k' = 0 at the side edges
///
/// in balance among themselves, and with a foil that they press inward by sum f_k P_k / R. The energy of such forces is
///
///     1/2Et int [ g'A g + f'G f + 2 nu f'B g + 2 (1 + nu) f_s'B f_s ] ds,   g = f'',
///     A_kl = int chi_k chi_l dz,   B_kl = int chi_k' chi_l' dz,   G_k = 2 a / (2 k + 1)
///
/// and its change with f is the stretch: sum G_k w_k / R for every change of f_k.
struct StressFunctionIntegrals {
  Matrix A, B;
  Vector G;
};

/// @param orders      k >= 2 of each mode, all even or all odd: those do not couple with each other
/// @param half_width  a
StressFunctionIntegrals stress_function_integrals(const std::vector<int>& orders, double half_width);

/// The membrane of a foil by its compliances. Unknowns are F = G f / R, the line load (N/m) that presses mode k inward,
/// and g = F''. A plain value; without modes there is none.
struct Membrane {
  Matrix by_bow;    ///< R^2/(E t) G^-1 A G^-1, of g
  Matrix by_slope;  ///< the same of B, of F'
  Vector by_load;   ///< R^2/(E t) G^-1, of F
  double poisson_ratio{};

  [[nodiscard]] Eigen::Index modes() const { return by_load.size(); }
};

/// @param radius         R
/// @param stretching     E t, N/m
Membrane make_membrane(const std::vector<int>& orders, double half_width, double radius, double stretching,
                       double poisson_ratio);

/// Equations of a column of nodes in the unknowns (F, g) of itself and its neighbours, which are those of the
/// stationary point of the energy with differences in place of derivatives:
///
///     before (F, g)_{i-1} + own (F, g)_i + after (F, g)_{i+1} = (length w_i, 0)
///
/// the stretch of each mode, then g.
struct MembraneRows {
  Matrix before, own, after;
  double length{};  ///< half of both intervals next to the column
};

/// Those of all columns of nodes but the last, where the foil ends and F = 0; its g is eliminated. The first is the
/// weld: the foil is held there, w = 0, and neither slides nor turns in its own surface.
/// @param intervals  lengths between the columns, two or more
std::vector<MembraneRows> membrane_rows(const Membrane& membrane, const Vector& intervals);

}  // namespace bumpfoil
