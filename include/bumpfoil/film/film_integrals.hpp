#pragma once

#include "bumpfoil/film/reynolds.hpp"

namespace bumpfoil {

/// Integrals of a film over the whole width, dimensionless (FilmScales gives the units). Trapezoidal rule over nodes;
/// gradients are on the faces between them.
struct FilmIntegrals {
  double cosine{};       ///< integral of (P - 1) cos(theta): applied force along theta = 0
  double sine{};         ///< ... of (P - 1) sin(theta)
  double couette{};      ///< ... of 1 / (H + 2 Kn / P)
  double poiseuille{};   ///< ... of H dP/dtheta
  double dissipation{};  ///< ... of (H^3 + 6 Kn H^2 / P) |grad P|^2

  /// Torque that resists rotation, in units of mu |U| R^3 / c: couette + 3 poiseuille / Lam.
  [[nodiscard]] double torque(double bearing_number) const { return couette + 3.0 * poiseuille / bearing_number; }
};

FilmIntegrals film_integrals(const ReynoldsEquation& equation, const FilmState& film);

/// Flows of the whole width through the open edges, in volumes at ambient pressure: along +theta at the ends, outward
/// at both sides together. Each is the imbalance of the volumes at its edge, those at corners counted to the ends: the
/// four balance to round-off when the film has converged and is steady.
struct FilmFlows {
  double start{};  ///< in at theta = 0; none in a closed film
  double end{};    ///< out at the last column
  double sides{};
  double right_side{};  ///< part of it at z > 0
};

/// @param residual  of reynolds_residual
FilmFlows film_flows(const FilmMesh& mesh, const Matrix& residual);

/// Smallest film thickness: the thinnest node, and the vertex of the parabola through it and its neighbours.
struct ThinnestPlace {
  double thickness{};         ///< H of the thinnest node
  int column{};               ///< of that node
  int row{};                  ///< of it: 0 where all rows are alike
  double theta{};             ///< of it, rad
  double vertex_thickness{};  ///< H at the vertex; the node itself at an open edge
  double vertex_theta{};      ///< rad
};

ThinnestPlace thinnest_place(const FilmMesh& mesh, const Matrix& thickness);

}  // namespace bumpfoil
