#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "bearing/krylov_space.hpp"
#include "bearing/schur_form.hpp"
#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/film/film_mesh.hpp"

namespace bumpfoil {

/// Rates s (1/s) less the shift, a real part of the largest of their sizes: both in units of 1 / T0.
struct ShiftedRates {
  ShiftedRates(const std::vector<std::complex<double>>& rates, double T0);

  double squeeze_time;  ///< T0, s
  double shift{};
  std::vector<std::complex<double>> excess;
};

/// Residuals of a film whose volumes store something at these rates. @param rates  at the nodes of unknown pressure
Matrix storage_residual(const FilmMesh& mesh, const Eigen::Ref<const Vector>& rates);

/// What a linearised film does where the journal moves, or where something is stored in its volumes.
struct FilmAnswer {
  Vector content;       ///< change of P H at the nodes whose pressure is unknown
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
/// C is real, and its Krylov space on the right-hand sides of all motions is the same for all s: Arnoldi's method
/// [Saad2011] builds a basis of it until the residual of the Galerkin solution is small at every s asked for. All
/// motions share it: each makes the others' directions fewer, and answers at once cost less than one by one. In the
/// end H, which is what C is in that basis, is brought to Schur's form, in which a solution takes m^2 / 2 operations.
struct FilmReduction {
  FilmImpedance impedance;
  Matrix U{};  ///< the w of `impedance` in the directions of the space
  KrylovSpace space;
};

/// C: the answers to rates of storage at the nodes whose pressure is unknown, to as many as there are motions at most.
using StoredAnswers = std::function<std::vector<FilmAnswer>(const std::vector<Vector>& rates)>;

/// @param moved   of X_0, for a unit displacement in each motion of the journal
/// @param at      all s
/// @return what answers to each motion at all s; nothing if the space does not grow to hold the solution
std::optional<FilmReduction> reduce_forces(const std::vector<FilmAnswer>& moved, const StoredAnswers& stored,
                                           const ShiftedRates& at);

}  // namespace bumpfoil
