#pragma once

#include <memory>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// K plus springs at the contacts: the Jacobian of penalty and augmented Lagrangian methods.
class PenaltySystem {
 public:
  virtual ~PenaltySystem() = default;

  /// Takes another K of the same form. set_stiffness must follow before the next solve.
  virtual void set_elasticity(const BlockTridiagonal& K) = 0;

  /// Factors K + sum over contacts of normal_stiffness * n n' + tangential_stiffness * s s' (N/m, one per contact).
  /// @return false if the matrix is singular.
  [[nodiscard]] virtual bool set_stiffness(const Vector& normal_stiffness, const Vector& tangential_stiffness) = 0;

  /// Overwrites the right-hand side by the solution.
  virtual void solve_in_place(Vector& x) = 0;

  /// K x.
  [[nodiscard]] virtual const Vector& multiply(const Vector& x) = 0;
};

std::unique_ptr<PenaltySystem> make_penalty_system(const ContactProblem& problem);

}  // namespace bumpfoil
