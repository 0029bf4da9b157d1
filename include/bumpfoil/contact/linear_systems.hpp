#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// The linear system that remains of a contact problem once the mode of every contact is known: closed gaps and stuck
/// unknowns are prescribed, slipping contacts carry t = -+f p. No penalty enters: the solution is exact.
///
/// In the rows of a closed contact the compression p is the imbalance of one unknown that no other contact of the
/// block touches; its equation gives way to the constraint, and p is carried into the other rows. Everything happens
/// inside a block, so that the system stays block tridiagonal and a solve is O(blocks).
class ModeSystem {
 public:
  virtual ~ModeSystem() = default;

  /// Takes another K of the same form. set_modes must follow before the next solve.
  virtual void set_elasticity(const BlockTridiagonal& K) = 0;

  /// Factors the system for `mode`, reusing what did not change since the last call.
  /// @return false if the modes leave a mechanism or a singular system; then no solve may follow.
  [[nodiscard]] virtual bool set_modes(const std::vector<ContactMode>& mode) = 0;

  /// How many times set_modes() had to factor since construction.
  [[nodiscard]] virtual int factorisations() const = 0;

  /// Solves for the unknowns and the contact forces under the modes that were set. The result obeys the equations of
  /// the modes; whether it obeys their inequalities is for the caller to see. Linear: given rates it returns rates.
  /// @param loading     initial gaps and loads
  /// @param previous_x  unknowns whose tangential ones are kept by sticking contacts
  /// @param state       receives x, gap and forces; its modes are set to those of the system
  virtual void solve(const ContactLoading& loading, const Vector& previous_x, ContactState& state) = 0;

  /// The loading that `state` is in balance with: g0 = g - x[plus] + x[minus], load = K x - contact forces.
  /// @param loading  result; its storage is reused
  virtual void loading_of(const ContactState& state, ContactLoading& loading) = 0;
};

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

/// A contact whose force gives way linearly: between fully open, closed, stuck and slipping. With increments dp, dt of
/// its forces, dg of its gap and dw of its slip:
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
/// each contact. Forces are eliminated inside the blocks, as in ModeSystem, instead of being replaced by springs: a
/// contact that is all but closed takes no digits from the stiffness of the foils.
class SoftContactSystem {
 public:
  virtual ~SoftContactSystem() = default;

  /// Takes another K of the same form. set_contacts must follow before the next solve.
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

std::unique_ptr<ModeSystem> make_mode_system(const ContactProblem& problem);
std::unique_ptr<PenaltySystem> make_penalty_system(const ContactProblem& problem);
std::unique_ptr<SoftContactSystem> make_soft_contact_system(const ContactProblem& problem);

}  // namespace bumpfoil
