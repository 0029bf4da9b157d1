#pragma once

#include <limits>
#include <memory>

#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

/// Settings of the augmented Lagrangian solver. The four parameters have no defaults here: they belong to a problem,
/// see uzawa_options_for(). docs/verification/uzawa.md shows their effect on the result.
struct UzawaOptions {
  double eps_alm{};  ///< penalty of contacts with friction, N/m: affects convergence, not the result
  double eps_f{};    ///< stiffness of a sticking contact, N/m: it slips by the change of its friction force / eps_f
  double eps_r{};    ///< penalty of contacts without tangential unknown (the journal), N/m: penetration p / eps_r
  double tau_f{};    ///< slip at which the friction force has reached half its bound, m
  /// An open contact may overlap by this much, m, or by what the multipliers' tolerance leaves of a closed one. Without
  /// loads the latter is less than the round-off of the neighbours, and contacts would alternately open and close.
  double gap_tolerance{};

  /// With F = max(largest contact force, ContactProblem::least_reference_force()):
  /// equilibrium: largest unbalanced force / F, where Newton's method ends.
  double newton_tolerance{1e-7};
  /// Multipliers: largest change of one / F, where their updates end.
  double multiplier_tolerance{1e-6};
  /// A sticking contact may exceed its bound by this part of it.
  double cone_tolerance{1e-4};

  int max_contact_updates{60};      ///< of the set of closed contacts
  int max_multiplier_updates{400};  ///< for one set of closed contacts
  int max_friction_updates{40};     ///< of sticking and slipping, for one set of multipliers
  int max_newton_steps{100};        ///< for one set of sticking contacts
};

/// The four parameters, the gap tolerance and the number of contact updates that suit a problem. With k the mean
/// stiffness (diagonal of K) of what meets at a contact with friction, across it, and F = ContactProblem::force_scale,
///
///     eps_alm = 4.5 k,   eps_f = 100 eps_alm,   eps_r = 1e4 eps_alm,   tau_f = gap_tolerance = 6.5e-6 F / k
///
/// and max_contact_updates lets each contact change once more, alone: changes run along the foils, bump after bump.
/// For the truss of the reference bearing k is 22 MN/m, F / k 15 um.
UzawaOptions uzawa_options_for(const ContactProblem& problem);

/// The method of [Arghir2019, Figs. 7, 8 and 17]: three nested loops round Newton's method.
///
///     contacts:     close what penetrates, open what pulls                                  until none changes
///       normal:       lambda <- lambda - eps_alm g for closed contacts                      until none moves
///         friction:     stick where |F_trial| <= f lambda, else slip                        until none changes
///           Newton:       K x = load + contact forces, with
///                         p = lambda - eps_alm g       closed contact
///                         p = -eps_r g                 closed contact without tangential unknown
///                         t = F_trial                  stick, F_trial = F_prev - eps_f du
///                         t = -f lambda (2/pi) atan(du / tau_f)    slip
///
/// [Arghir2019, Eqs. 15, 18, 20, 24, A2-A5]. It departs from the paper where that contradicts itself or Coulomb's law:
/// friction opposes the slip; a sticking contact keeps the force of the last increment (F_prev, cut to the bound)
/// where the paper starts its spring anew and so lets it creep; multipliers of open contacts stay zero; contacts with
/// zero gap start closed; the contacts are tested inside their loop. Newton's steps are cut by a line search, since
/// atan bends, and the last increment is the first guess. Contacts that go on changing are changed one at a time
/// (open and closed) or left slipping (stick and slip): the regularised law lets a slipping contact carry any force
/// inside the cone, at the price of a slip of the order of tau_f.
///
/// What a converged state meets, with F as in UzawaOptions and e = multiplier_tolerance:
///
///     balance    (newton_tolerance + e) F
///     gaps       |g| <= e F / eps_alm of closed contacts, -g = p / eps_r where eps_r acts,
///                g >= -max(e F / eps_alm, gap_tolerance) of open
///     stick      |t| <= f p (1 + cone_tolerance) + f e F,   |du| <= 2 f p / eps_f
///     slip       t opposes du and lacks f p (1 - (2/pi) atan(|du| / tau_f)) to its bound, up to f e F
///
/// so that contact_residuals shows larger values than for the exact solver: `slip_in_stick` counts a slipping contact
/// that lacks part of its bound.
class UzawaSolver final : public ContactSolver {
 public:
  UzawaSolver(const ContactProblem& problem, const UzawaOptions& options);
  ~UzawaSolver() override;

  /// Its states are checked against the bounds above, not by ContactResiduals.
  [[nodiscard]] SolverBounds bounds() const override {
    constexpr double none = std::numeric_limits<double>::infinity();
    return {.force = none, .displacement = none, .load = 1e-5};
  }

  [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                  ContactState& state) override;

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
