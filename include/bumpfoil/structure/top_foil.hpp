#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/structure/section.hpp"

namespace bumpfoil {

/// The top foil: a circular cantilever clamped at the weld and loaded radially at the crests; inextensible, plate
/// bending only. Angles are measured from the weld and increase; angles below pi/2 or so between neighbours.
struct TopFoilBeam {
  double radius{};             ///< R, m
  double bending_stiffness{};  ///< EI', N m^2
  Vector theta;                ///< angles of the loads, 0 < theta_1 < theta_2 < ..., rad
};

/// Top foil loaded over the crests of the bump foil. There must be one, and a radius.
TopFoilBeam make_top_foil_beam(const FoilDesign& foils);

/// Radial compliance at the crests, N x N, m/N, symmetric positive definite; for theta_j <= theta_i
///
///     S_ij = R^3 / EI' (theta_j cos(theta_i - theta_j) - cos(theta_i) sin(theta_j)) / 2
///
/// [Arghir2019, Eq. 5] prints minus this.
Matrix top_foil_compliance(const TopFoilBeam& beam);

/// K_t = S^-1 [Arghir2019, Eq. 6], N/m, by dense inversion. Loses digits as cond(S) grows with N^4: 1e5 for 26 crests.
Matrix top_foil_stiffness(const TopFoilBeam& beam);

/// The same stiffness, exactly and in O(N), from the bending moments M_0..M_{N-1} at the weld and at all crests but the
/// last, which has none. Without load between the crests M varies within span k (angle d_k, d_0 from the weld to crest
/// 1) as A sin + B cos. The complementary energy is then 1/2 M' T M with T tridiagonal, and equilibrium gives P = D M:
///
///     T_kk    = sum over both spans of R / (EI' sin^2 d) (d/2 - sin(2 d)/4)
///     T_k,k+1 = R / (EI' sin^2 d_k) (sin d_k - d_k cos d_k) / 2
///     R P_j   = (M_{j-1} - M_j) / sin d_{j-1} + (M_{j+1} - M_j) / sin d_j + M_j (tan(d_{j-1}/2) + tan(d_j/2))
///
/// so that T M = D' u and K_t = D T^-1 D'. Derived here from the beam behind [Arghir2019, Eq. 5].
struct TopFoilMoments {
  Vector compliance_diagonal;  ///< T_kk, N entries, 1/(N m)
  Vector compliance_off;       ///< T_k,k+1, N - 1 entries, 1/(N m)
  Vector inverse_sine;         ///< 1 / (R sin d_k), N entries, 1/m
  Vector half_tangent;         ///< tan(d_k/2) / R, N entries, 1/m
  bool welded{true};           ///< false: free at its start too, M_0 = M_1 = 0; what stands for the weld has no meaning

  [[nodiscard]] Eigen::Index size() const { return compliance_diagonal.size(); }
  /// Coefficient of M_j in P_j, j = 1..N-1, 1/m. The other two of the row are inverse_sine[j-1] and inverse_sine[j].
  [[nodiscard]] double load_diagonal(Eigen::Index j) const;
};

TopFoilMoments make_top_foil_moments(const TopFoilBeam& beam);

/// The same for a flat foil, the limit R -> infinity: with spans l_k = R d_k
///
///     T_kk = sum over both spans of l / (3 EI'),   T_k,k+1 = l_k / (6 EI'),   P_j = (M_{j-1} - M_j) / l_{j-1} + ...
///
/// @param bending_stiffness  EI', N m^2
/// @param spans              from the weld to the first crest, then from crest to crest, m
/// @param welded             clamped before the first crest; else free at both ends
TopFoilMoments make_flat_top_foil_moments(double bending_stiffness, const Vector& spans, bool welded);

/// The top foil of a pair of foils, bent or flat, in its moment form. There must be one.
TopFoilMoments make_top_foil_moments(const FoilDesign& foils);

/// Unit of the moments among the unknowns of a foil structure, EI' / reference_length()^2 of the top foil, N.
double top_moment_scale(const FoilDesign& foils);

/// Moments M_0..M_{N-1} (N m) of the welded foil whose crests are displaced by `u` (N entries, m, outward): T M = D' u.
Vector top_foil_moments(const TopFoilMoments& form, const Vector& u);

/// Loads K_t u on the crests of the welded foil (N entries, N, outward) that hold the displacements `u` (m).
Vector top_foil_loads(const TopFoilMoments& form, const Vector& u);

/// Loads D M on the crests (N entries, N, outward) that moments M_0..M_{N-1} (N m) balance.
Vector loads_of_moments(const TopFoilMoments& form, const Vector& moment);

/// Solves the symmetric positive definite tridiagonal system with main and side diagonal in O(n), without pivoting.
Vector solve_tridiagonal(Vector diagonal, const Vector& off, Vector right);

}  // namespace bumpfoil
