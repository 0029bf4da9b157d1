#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/film/film_mesh.hpp"

namespace bumpfoil {

/// Rates s (1/s) minus the shift, a real fraction of their largest magnitude: both in units of 1 / T0.
struct ShiftedRates {
  ShiftedRates(const std::vector<std::complex<double>>& rates, double squeeze_time);

  double shift{};
  std::vector<std::complex<double>> excess;
};

/// Residuals of a film due to storage rates in its volumes. @param rates  at the nodes of unknown pressure
Matrix storage_residual(const FilmMesh& mesh, const Eigen::Ref<const Vector>& rates);

/// Response of a linearised film to motion of the journal, or to storage in its volumes.
struct FilmAnswer {
  Vector content;       ///< change of P H at the nodes of unknown pressure
  JournalVector force;  ///< change of the force on the journal
};

/// Forces on a journal that moves by q e^{s t} about a state, at any number of rates s, from one factorisation at a
/// real rate, the shift.
///
/// With J the derivatives of the steady equations by all unknowns X and S those of what the film stores, r and a the
/// same by the displacement q of the journal, the motion is
///
///     (J + s S) X = -(r + s a) q
///
/// Let X_0 solve it at the shift. What remains is an equation for what is stored alone, w = S X + a q:
///
///     w - (s - shift) C w = S X_0 + a q,      C w = -S (J + shift S)^-1 w
///
/// C is real, and its Krylov space on the right-hand side is the same for all s: Arnoldi's method [Saad2011] builds a
/// basis of it until the residual of the Galerkin solution is small at every s requested. The spaces of all motions
/// grow together: answers at once cost less than one by one.
///
/// @param moved   of X_0, for a unit displacement in each motion of the journal
/// @param stored  C: the answers to rates of storage at the nodes whose pressure is unknown, to as many as there are
///                motions at most
/// @param excess  s - shift, for all s
/// @return what answers to each motion at all s; nothing if a space does not grow to hold the solution
std::optional<std::vector<ReducedForces>> reduce_forces(
    const std::vector<FilmAnswer>& moved,
    const std::function<std::vector<FilmAnswer>(const std::vector<Vector>& rates)>& stored,
    const std::vector<std::complex<double>>& excess);

}  // namespace bumpfoil
