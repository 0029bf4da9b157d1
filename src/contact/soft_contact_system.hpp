#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// A contact with a linear compliance: between fully open, closed, stuck and slipping. With increments dp, dt of its
/// forces, dg of its gap and dw of its slip:
///
///     normal_force * dp + gap * dg = right-hand side
///     friction_force * dt + coupling * dp + slip * dw = right-hand side        (not for frictionless contacts)
///
/// The modes of ModeSystem are limits: open is normal_force = friction_force = 1; closed is `gap` alone in the first
/// condition, with `slip` alone in the second where it sticks and friction_force = 1, coupling = +-f where it slips
/// forward or backward. N/m-sized coefficients belong to `gap` and `slip`.
struct SoftContact {
  double normal_force{1.0}, gap{0.0};
  double friction_force{1.0}, coupling{0.0}, slip{0.0};
};

/// The linear system of a step of an interior-point method: the balance of the unknowns and two linear conditions for
/// each contact. Forces are eliminated inside the blocks, as in ModeSystem, not replaced by springs: a nearly closed
/// contact does not degrade the accuracy of the foil stiffness.
class SoftContactSystem {
 public:
  virtual ~SoftContactSystem() = default;

  /// Replaces K by one of the same form. set_contacts must follow before the next solve.
  virtual void set_elasticity(const BlockTridiagonal& K) = 0;

  /// Factors the system.
  /// @return false if it is singular; then no solve may follow.
  [[nodiscard]] virtual bool set_contacts(const std::vector<SoftContact>& contacts) = 0;

  /// Solves K dx = x + contact forces of (dp, dt) with the conditions of the contacts.
  /// @param x  load (N); receives dx (m)
  /// @param p  right-hand sides of the first conditions; receives dp (N)
  /// @param t  right-hand sides of the second conditions; receives dt (N), zero for frictionless contacts
  virtual void solve_in_place(Vector& x, Vector& p, Vector& t) = 0;

  /// K x.
  [[nodiscard]] virtual const Vector& multiply(const Vector& x) = 0;
};

std::unique_ptr<SoftContactSystem> make_soft_contact_system(const ContactProblem& problem);

}  // namespace bumpfoil
