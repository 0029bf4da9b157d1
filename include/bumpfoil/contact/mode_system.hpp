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
  /// the modes; whether it obeys their inequalities is for the caller to check. Linear: given rates it returns rates.
  /// @param loading     initial gaps and loads
  /// @param previous_x  unknowns whose tangential ones are kept by sticking contacts
  /// @param state       receives x, gap and forces; its modes are set to those of the system
  virtual void solve(const ContactLoading& loading, const Vector& previous_x, ContactState& state) = 0;

  /// Responses to unit changes of all quantities that the modes prescribe, one column for each, in the order of
  /// contacts: of a contact its p if it is open, else its gap; behind it, if it has friction, its t if it is open,
  /// x[tangential] if it sticks, t beyond that of its normal force if it slips.
  /// @param x      receives all unknowns
  /// @param force  receives p and, with friction, t of all contacts, in that order
  virtual void solve_units(RowMajorMatrix& x, RowMajorMatrix& force) = 0;

  /// The loading that `state` is in balance with: g0 = g - x[plus] + x[minus], load = K x - contact forces.
  /// @param loading  result; its storage is reused
  virtual void loading_of(const ContactState& state, ContactLoading& loading) = 0;
};

std::unique_ptr<ModeSystem> make_mode_system(const ContactProblem& problem);

}  // namespace bumpfoil
