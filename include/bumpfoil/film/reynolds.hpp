#pragma once

#include "bumpfoil/film/film_mesh.hpp"

namespace bumpfoil {

/// The compressible Reynolds equation on a mesh, without dimension (see FilmScales):
///
///     d/dtheta ( G dP/dtheta - Lam P H ) + d/dzeta ( G dP/dzeta ) = T0 d(P H)/dt,      G = H^3 P + 6 Kn H^2
///
/// [Burgdorfer1959] for the slip flow term. A time step puts ((P H) - (P H)_ref) / span in place of the
/// derivative (BackwardDifference). A plain value.
struct ReynoldsEquation {
  FilmMesh mesh;
  double bearing_number{};    ///< Lam; its sign is that of the surface speed along theta
  double knudsen{};           ///< Kn >= 0
  double squeeze_rate{};      ///< T0 / span; 0: steady
  Matrix previous_content{};  ///< (P H)_ref at all nodes; read only where squeeze_rate > 0
};

/// State of a film: a plain value. P at nodes on the edges is given, at all others unknown; P > 0, H > 0.
struct FilmState {
  Matrix pressure;   ///< P at all nodes
  Matrix thickness;  ///< H at all nodes
};

/// Residuals of all volumes, by finite volumes around the nodes: what leaves a volume through the faces to its
/// neighbours plus what it stores. With psi = P H and face means H_f, P_f in G, the flux along theta between columns k
/// and k + 1 is
///
///     Q = Lam (psi_k + psi_{k+1}) / 2 - |Lam| l(X) (psi_{k+1} - psi_k) / 2 - G (P_{k+1} - P_k) / dtheta
///     l(X) = X^4 / (1 + X + X^2 + X^3 + X^4),      X = |Lam| H_downstream dtheta / (2 G)
///
/// and across the rows - G (P_{j+1} - P_j) / dzeta. The weight l of upwinding is the least smooth one known to us that
/// is nowhere below 1 - 1/X: the matrix for given coefficients is then an M-matrix, and every solution has P > 0. It is
/// of the order dtheta^4 on fine meshes, so that the scheme is exactly of second order. psi is upwinded and not P:
/// where Lam tends to infinity, P H = const is met without numerical diffusion.
///
/// The equations are the residuals of nodes with unknown pressure. Those of nodes at open edges are what flows out
/// there, with the sign reversed.
/// @param residual  result; its storage is reused
void reynolds_residual(const ReynoldsEquation& equation, const FilmState& film, Matrix& residual);

/// Derivatives of the residual of every node with respect to P or H at itself and its neighbours.
struct FilmStencil {
  Matrix own;
  Matrix before;   ///< with respect to the node of the column before
  Matrix after;    ///< ... of the column after
  Matrix inside;   ///< ... of row j - 1
  Matrix outside;  ///< ... of row j + 1
};

struct FilmJacobian {
  FilmStencil by_pressure;
  FilmStencil by_thickness;
};

/// The same with all derivatives.
void linearise_reynolds(const ReynoldsEquation& equation, const FilmState& film, Matrix& residual,
                        FilmJacobian& jacobian);

/// Change of the residuals under changes of P or H at all nodes.
Matrix stencil_product(const FilmMesh& mesh, const FilmStencil& stencil, const Matrix& change);

/// P H at all nodes: the start of a time step.
Matrix film_content(const FilmState& film);

}  // namespace bumpfoil
