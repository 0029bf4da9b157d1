#pragma once

#include <memory>

#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

class ModeSystem;

/// Settings of the exact solver. The defaults suit foils of metal in the size range of turbomachinery.
struct NewtonOptions {
  /// A gap may be below zero, or a slip against its direction, by this much: gap >= -displacement_tolerance. m.
  double displacement_tolerance{1e-13};
  /// A compression may be below zero, or friction above its bound, by this part of the largest contact force, or of
  /// ContactProblem::least_reference_force().
  double force_tolerance{1e-11};
  /// Rounds of changing contacts that contradict their mode before the next method is tried.
  int max_mode_updates{2};
  /// Limit of events on the path, and of contacts that contradict the modes of the last increment, for the path to be
  /// tried: as many as the factorisations of an interior-point solve.
  int max_events{20};
  /// Steps of the interior-point method from each of its starts before the increment is given up. 10 to 30 do nearly
  /// always, whatever the number of contacts.
  int max_interior_steps{60};
  /// Tangents of an elastic law before the increment is given up: a few suffice, but if the foil snaps to another
  /// position it takes up to a hundred.
  int max_tangents{300};
  /// With a law: bound on the ContactResiduals of the result, forces normalised; a tenth of the bound that a state must
  /// meet.
  double law_tolerance{1e-10};
};

/// Exact unilateral contact and Coulomb friction; no penalty in the result. Three methods in turn, each from the state
/// of the last increment; all end with the same exact solve and the same test of every inequality:
///
/// 1. Semismooth Newton on the contact modes: solve exactly for the modes of the last increment, change the contacts
///    whose inequalities fail, all at once, repeat. Ends in one to a few solves nearly always, but may cycle; only with
///    some more rounds than by default does the safeguard of single changes set in.
/// 2. The modes at the end of the path from event to event (contact/event_follower.hpp), then as 1. Left out where many
///    contacts contradict the modes of the last increment, as at first touch or at the turning point of a long foil.
/// 3. Primal-dual interior-point method [Mehrotra1992], [Wright1997]: of every gap and its compression, every slip and
///    its distance from the friction bound, both stay positive, and Newton's method drives their products to zero. The
///    number of steps hardly depends on the number of contacts. Modes are read off the iterates; once they rest, they
///    are tried as in 1, changing only the worst of neighbouring contacts.
///
/// An elastic law is met by Newton's method around all of this: at the iterate x_k the problem is solved exactly with
/// the tangent K_k of the law and the constant load K_k x_k - e(x_k), friction referring to the last increment
/// throughout, until e(x) itself balances the contact forces. Where no solution is found with K_k (a foil under
/// compression may buckle), that step is taken with the stable tangent of the law.
///
/// The problem must have contacts.
class NewtonSolver final : public ContactSolver {
 public:
  explicit NewtonSolver(const SharedProblem& problem, const NewtonOptions& options = NewtonOptions());
  /// @param modes linear system of the problem; may be shared with others that are idle meanwhile
  NewtonSolver(const SharedProblem& problem, std::shared_ptr<ModeSystem> modes,
               const NewtonOptions& options = NewtonOptions());
  ~NewtonSolver() override;

  /// Takes another K of the same form, symmetric or not. Not for problems with a law, whose tangents take its place.
  void set_elasticity(const BlockTridiagonal& K);

  [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                  ContactState& state) override;

 private:
  struct Task;
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
