#pragma once

#include <memory>
#include <vector>

#include "contact/soft_contact_system.hpp"

namespace bumpfoil {

/// A force and a length, both kept positive, one of which tends to zero.
struct ComplementaryPair {
  double force{1.0};     ///< N
  double length{1.0};    ///< m
  double force_step{};   ///< N
  double length_step{};  ///< m
  double deficit{};      ///< J; the step obeys force * length_step + length * force_step = deficit

  [[nodiscard]] double product(double fraction) const {
    return (force + fraction * force_step) * (length + fraction * length_step);
  }
  /// Prepares a step to the product `target`; `correct` subtracts the second-order part of the last step.
  void aim(double target, bool correct) {
    deficit = target - force * length - (correct ? force_step * length_step : 0.0);
  }
  void take_force_from_length() { force_step = (deficit - force * length_step) / length; }
  void take_length_from_force() { length_step = (deficit - length * force_step) / force; }
  /// Largest fraction of the step, up to `fraction`, that keeps both positive.
  [[nodiscard]] double longest(double fraction) const;
  void take(double fraction);
  /// Whether a step to the product 0 removes the force (> 0) or the length (< 0); 0 if both, as for a contact that
  /// touches without force. The relative changes add up to -1 [ElBakry1994].
  [[nodiscard]] int trend() const;
};

/// Primal-dual interior-point method for one increment of a contact problem [Mehrotra1992], [Wright1997]. The
/// conditions of every contact, with friction in the plane written as two more complementary pairs,
///
///     0 <= g  _|_  p >= 0,    0 <= f p + t  _|_  w+ >= 0,    0 <= f p - t  _|_  w- >= 0,    du = w+ - w-,
///
/// are replaced by products equal to mu > 0, which Newton's method with predictor and corrector drives to zero. The
/// friction bound f p is part of the linearisation, not lagged: the steps take Coulomb's law as it stands, and the
/// number of steps hardly depends on the number of contacts. Friction makes the problem non-monotone, so that success
/// is not guaranteed.
///
/// It serves to find modes: its iterates approach a solution, its caller solves exactly for the modes they show. No
/// iterate of x is kept, only the positive quantities, each with full relative accuracy, and what is left of the
/// residuals of the linear equations, which every step of length a multiplies by 1 - a.
class InteriorPoint {
 public:
  explicit InteriorPoint(const SharedProblem& problem);

  /// Replaces K by one of the same form. start must follow.
  void set_elasticity(const BlockTridiagonal& K) { system_->set_elasticity(K); }

  /// Starts from the state of the last increment, moved off the bounds.
  /// @param spread  distance, in units of the misfit of that state with `loading`: 1, a tenth of that or ten times
  /// @param reach   fraction to the boundary: part of the distance to the first bound that a step may take, < 1
  void start(const ContactLoading& loading, const ContactState& previous, double spread, double reach);

  /// Takes one step: one factorisation, two solves; none if the system is singular.
  /// @return false if there is no further progress, or the system was singular
  [[nodiscard]] bool step();

  /// Modes indicated by the last step.
  [[nodiscard]] const std::vector<ContactMode>& modes() const { return modes_; }
  /// How many of them the last step changed; 0 before the first.
  [[nodiscard]] int changed_modes() const { return changed_modes_; }
  /// Linear solves of the last step.
  [[nodiscard]] int solves() const { return solves_; }

 private:
  struct Contact {
    ComplementaryPair closing;   ///< p, g
    ComplementaryPair forward;   ///< f p + t, w+; unused without friction
    ComplementaryPair backward;  ///< f p - t, w-
    double f{};
    double gap_residual{};  ///< g0 + gap of x - g at the start, m
  };

  template <typename Visitor>
  static void for_each_pair(Contact& contact, Visitor&& visit);
  [[nodiscard]] double misfit(const ContactLoading& loading, const ContactState& previous);
  [[nodiscard]] bool factor();
  void find_step(double target, bool correct);
  void read_friction_step(Contact& c, double slip_step, double friction_step) const;
  void read_modes();
  [[nodiscard]] static ContactMode closed_mode(const Contact& contact, ContactMode before);
  [[nodiscard]] double mean_product(double fraction);
  [[nodiscard]] double longest_step(double fraction);
  void take(double fraction);

  SharedProblem problem_;
  std::unique_ptr<SoftContactSystem> system_;
  double stiffness_{0.0};  ///< N/m, scales contact conditions to the size of the balance, so that pivots compare
  std::vector<Contact> contacts_;
  std::vector<SoftContact> soft_;
  std::vector<ContactMode> previous_modes_;  ///< of the last increment
  std::vector<ContactMode> modes_;
  int changed_modes_{};
  int solves_{};
  Vector imbalance_;        ///< contact forces + load - K x at the start, N
  double remaining_{};      ///< fraction of the initial residuals that remains
  double reach_{};          ///< see start()
  double first_product_{};  ///< mean product at the start, J
  Vector dx_, dp_, dt_;
};

}  // namespace bumpfoil
