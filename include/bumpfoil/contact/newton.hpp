#pragma once

#include <memory>

#include "bumpfoil/contact/linear_systems.hpp"
#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

/// Settings of the exact solver. The defaults suit foils of metal in the size range of turbomachinery.
struct NewtonOptions {
  /// A gap may be below zero, or a slip against its direction, by this much: gap >= -displacement_tolerance. m.
  double displacement_tolerance{1e-13};
  /// A compression may be below zero, or friction above its bound, by this part of max(largest contact force, 1 N).
  double force_tolerance{1e-11};
  /// Rounds of changing contacts that contradict their mode before the next method is tried.
  int max_mode_updates{2};
  /// Penalty of the proximal augmented Lagrangian in units of the largest diagonal entry of K. It sets its pace, not
  /// its result: a stiffer one needs fewer updates of the multipliers, each with more Newton steps.
  double penalty{1.0};
  /// Multiplier updates of the augmented Lagrangian before the increment is given up.
  int max_outer_iterations{200};
  /// Newton steps for one set of multipliers.
  int max_inner_iterations{60};
  /// Tangents of an elastic law before the increment is given up: a handful does, but where the foil snaps to another
  /// place it takes up to a hundred.
  int max_tangents{300};
  /// With a law: ContactResiduals of the result, forces normalised, at most this; a tenth of what a state must meet.
  double law_tolerance{1e-10};
};

/// Exact unilateral contact and Coulomb friction; no penalty in the result. Three methods in turn, each from the state
/// of the last increment; all end with the same exact solve and the same test of every inequality:
///
/// 1. Semismooth Newton on the contact modes: solve exactly for the modes of the last increment, change the contacts
///    whose inequalities fail, repeat. Ends in one to a few solves nearly always, but may cycle.
/// 2. The modes at the end of the path from event to event (contact/event_follower.hpp), then as 1.
/// 3. Proximal augmented Lagrangian: with multipliers lambda, mu and friction bounds f lambda held, the state is the
///    minimum of a convex, piecewise quadratic energy, found by Newton steps with exact line search; multipliers are
///    updated, and the modes they show are tried as in 1, until these solve the problem.
///
/// An elastic law is met by Newton's method around all of this: at the iterate x_k the problem is solved exactly with
/// the tangent K_k of the law and the constant load K_k x_k - e(x_k), friction referring to the last increment
/// throughout, until e(x) itself balances the contact forces. Where methods 1 and 2 find no solution with K_k (a foil
/// under compression may buckle), that step is taken with the stable tangent of the law and all three methods.
class NewtonSolver final : public ContactSolver {
 public:
  explicit NewtonSolver(const ContactProblem& problem, const NewtonOptions& options = NewtonOptions());
  ~NewtonSolver() override;

  [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                  ContactState& state) override;

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
