#include "bumpfoil/origin/uzawa.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/penalty_system.hpp"
#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// A contact that changed between stick and slip this often stays slipping.
constexpr int max_changes = 6;
/// Multiplier updates with free choice of sticking contacts. Beyond them, stick and slip may alternate with the
/// multipliers; from then on a slipping contact stays slipping.
constexpr int free_updates = 20;
/// Updates that change all closed contacts at once; later ones change one contact at a time.
constexpr int whole_updates = 12;

/// Tangential stiffness at a contact with friction, N/m: the mean over all of them. Unknowns without a diagonal entry
/// in K (a top foil in moments) take the stiffness of their partner.
double mean_contact_stiffness(const ContactProblem& problem) {
  const auto stiffness = [&problem](int block, int unknown) {
    return unknown < 0 ? 0.0 : problem.K.diagonal[static_cast<std::size_t>(block)](unknown, unknown);
  };
  double sum = 0.0;
  int contacts = 0;
  for (const ContactSite& site : problem.sites) {
    if (site.tangential < 0) continue;
    sum += std::max(stiffness(site.block, site.plus), stiffness(site.block, site.minus));
    ++contacts;
  }
  return contacts > 0 ? sum / contacts : 0.0;
}

}  // namespace

UzawaOptions uzawa_options_for(const ContactProblem& problem) {
  const double k = mean_contact_stiffness(problem);
  BUMPFOIL_ASSERT(k > 0.0);
  const double eps_alm = 4.5 * k;
  const double length = 6.5e-6 * problem.force_scale / k;
  return {.eps_alm = eps_alm,
          .eps_f = 1e2 * eps_alm,
          .eps_r = 1e4 * eps_alm,
          .tau_f = length,
          .gap_tolerance = length,
          .max_contact_updates = UzawaOptions{}.max_contact_updates + problem.contacts()};
}

struct UzawaSolver::Workspace {
  /// Friction of one contact inside the friction loop.
  struct FrictionState {
    bool sticks{};
    int changes{};  ///< between stick and slip, at the current multipliers
  };

  Workspace(const ContactProblem& contact_problem, const UzawaOptions& uzawa_options)
      : problem(contact_problem),
        options(uzawa_options),
        system(make_penalty_system(contact_problem)),
        closed(static_cast<std::size_t>(contact_problem.contacts())),
        friction(closed.size()),
        normal_stiffness(contact_problem.contacts()),
        tangential_stiffness(contact_problem.contacts()),
        p(contact_problem.contacts()),
        t(contact_problem.contacts()) {}

  void begin(const ContactLoading& loading, const ContactState& previous);
  bool update_contacts(const ContactLoading& loading, bool one_at_a_time);
  bool find_normal_forces(const ContactLoading& loading, const ContactState& previous, SolveCost& cost);
  bool find_friction(const ContactLoading& loading, const ContactState& previous, SolveCost& cost);
  int update_friction(const ContactState& previous);
  bool newton(const ContactLoading& loading, const ContactState& previous, SolveCost& cost);
  double step_length(const ContactLoading& loading, const ContactState& previous);
  void evaluate(const ContactLoading& loading, const ContactState& previous);
  void store(const ContactLoading& loading, ContactState& state) const;

  [[nodiscard]] bool is_closed(const CoulombContact& c) const { return closed[static_cast<std::size_t>(c.index)]; }
  [[nodiscard]] double bound(const CoulombContact& c) const { return c.f * std::max(0.0, lambda[c.index]); }
  /// F_prev - eps_f du, with F_prev inside the cone of the current multiplier.
  [[nodiscard]] double trial_friction(const CoulombContact& c, const ContactState& previous, double slip) const {
    const double limit = bound(c);
    return std::clamp(previous.friction_force[c.index], -limit, limit) - options.eps_f * slip;
  }
  [[nodiscard]] double slip(const CoulombContact& c, const ContactState& previous) const {
    return c.tangential(x) - c.tangential(previous.x);
  }
  [[nodiscard]] double force_scale() const {
    return std::max({problem.least_reference_force(), p.maxCoeff(), t.cwiseAbs().maxCoeff()});
  }

  ContactProblem problem;
  UzawaOptions options;
  std::unique_ptr<PenaltySystem> system;

  std::vector<bool> closed;
  std::vector<FrictionState> friction;
  Vector x, lambda;                               // unknowns, multipliers of the contacts
  Vector normal_stiffness, tangential_stiffness;  // of the contacts at x
  Vector p, t, gradient;                          // contact forces at x, and the residual of the balance
  Vector step, x_start;
};

UzawaSolver::UzawaSolver(const ContactProblem& problem, const UzawaOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, options)) {
  BUMPFOIL_ASSERT(!problem.law);  // linear elastic forces required
}

UzawaSolver::~UzawaSolver() = default;

SolveReport UzawaSolver::solve(const ContactLoading& loading, const ContactState& previous, ContactState& state) {
  Workspace& w = *workspace_;
  SolveReport report{.status = Status::iterations_spent, .cost = {}};
  w.begin(loading, previous);
  for (int update = 0; update < w.options.max_contact_updates; ++update) {
    if (!w.find_normal_forces(loading, previous, report.cost)) break;
    if (!w.update_contacts(loading, update >= whole_updates)) {
      report.status = Status::converged;
      break;
    }
  }
  w.store(loading, state);
  return report;
}

/// First guess: the last increment, with all contacts closed that the new loading closes.
void UzawaSolver::Workspace::begin(const ContactLoading& loading, const ContactState& previous) {
  x = previous.x;
  lambda = previous.normal_force;
  p = lambda;
  t = previous.friction_force;
  for_each_contact(problem, [&](const CoulombContact& c) {
    closed[static_cast<std::size_t>(c.index)] =
        previous.normal_force[c.index] > 0.0 || loading.initial_gap[c.index] + c.gap(x) <= 0.0;
  });
}

/// Opens contacts in tension and closes penetrating ones: all of them, or the worst one.
/// @return false if there are none
bool UzawaSolver::Workspace::update_contacts(const ContactLoading& loading, bool one_at_a_time) {
  const double force_tolerance = options.multiplier_tolerance * force_scale();
  const double gap_tolerance = std::max(options.gap_tolerance, force_tolerance / options.eps_alm);
  double worst = 1.0;
  Eigen::Index worst_contact = -1;
  bool changed = false;
  for_each_contact(problem, [&](const CoulombContact& c) {
    const double violation =
        is_closed(c) ? -p[c.index] / force_tolerance : -(loading.initial_gap[c.index] + c.gap(x)) / gap_tolerance;
    if (violation > worst) {
      worst = violation;
      worst_contact = c.index;
    }
    if (violation > 1.0 && !one_at_a_time) {
      closed[static_cast<std::size_t>(c.index)].flip();
      changed = true;
    }
  });
  if (one_at_a_time && worst_contact >= 0) {
    closed[static_cast<std::size_t>(worst_contact)].flip();
    changed = true;
  }
  for_each_contact(problem, [&](const CoulombContact& c) {
    if (!is_closed(c)) lambda[c.index] = 0.0;
  });
  return changed;
}

/// Updates the multipliers of closed contacts until the gaps vanish.
bool UzawaSolver::Workspace::find_normal_forces(const ContactLoading& loading, const ContactState& previous,
                                                SolveCost& cost) {
  for (int update = 0; update < options.max_multiplier_updates; ++update) {
    if (update < free_updates) {
      for (FrictionState& state : friction) state = {.sticks = true, .changes = 0};
    } else {
      for (FrictionState& state : friction) state.changes = state.sticks ? max_changes - 1 : max_changes;
    }
    if (!find_friction(loading, previous, cost)) return false;
    ++cost.outer_iterations;
    // p = lambda - eps_alm g are the forces in equilibrium at x, and the next multipliers.
    double moved = 0.0;
    for_each_contact(problem, [&](const CoulombContact& c) {
      if (c.site.tangential >= 0) moved = std::max(moved, std::abs(p[c.index] - lambda[c.index]));
    });
    lambda = p;
    if (moved <= options.multiplier_tolerance * force_scale()) return true;
  }
  return false;
}

/// Determines the sticking contacts for the current multipliers.
bool UzawaSolver::Workspace::find_friction(const ContactLoading& loading, const ContactState& previous,
                                           SolveCost& cost) {
  for (int update = 0; update < options.max_friction_updates; ++update) {
    if (!newton(loading, previous, cost)) return false;
    if (update_friction(previous) == 0) return true;
  }
  return false;
}

/// @return number of contacts that changed between stick and slip
int UzawaSolver::Workspace::update_friction(const ContactState& previous) {
  int changed = 0;
  for_each_contact(problem, [&](const CoulombContact& c) {
    if (c.f == 0.0 || !is_closed(c)) return;
    FrictionState& state = friction[static_cast<std::size_t>(c.index)];
    if (state.changes >= max_changes) return;
    const double du = slip(c, previous);
    bool sticks = std::abs(trial_friction(c, previous, du)) <= bound(c) * (1.0 + options.cone_tolerance);
    // A contact that slips against its trial force creeps inside the cone: it can carry this force only by sticking.
    if (!state.sticks && std::abs(du) < options.tau_f) sticks = bound(c) > 0.0;
    if (sticks == state.sticks) return;
    state.sticks = sticks;
    ++state.changes;
    if (state.changes == max_changes) state.sticks = false;
    ++changed;
  });
  return changed;
}

/// Displacements for the current multipliers and sticking contacts: the minimum of a convex energy.
bool UzawaSolver::Workspace::newton(const ContactLoading& loading, const ContactState& previous, SolveCost& cost) {
  evaluate(loading, previous);
  for (int i = 0; i < options.max_newton_steps; ++i) {
    if (!system->set_stiffness(normal_stiffness, tangential_stiffness)) return false;
    ++cost.factorisations;
    step = -gradient;
    system->solve_in_place(step);
    ++cost.iterations;
    if (!step.allFinite()) return false;
    x_start = x;
    x += step_length(loading, previous) * step;
    evaluate(loading, previous);
    if (gradient.cwiseAbs().maxCoeff() <= options.newton_tolerance * force_scale()) return true;
  }
  return false;
}

/// Fraction of `step` from `x_start` that reduces the slope of the energy sufficiently. Leaves x at the start.
double UzawaSolver::Workspace::step_length(const ContactLoading& loading, const ContactState& previous) {
  constexpr double enough = 0.5;  // relative to the slope at the start: Newton's next step corrects the rest
  constexpr int halvings = 40;
  const double at_start = step.dot(gradient);
  double length = 1.0;
  for (int i = 0; i < halvings; ++i) {
    x = x_start + length * step;
    evaluate(loading, previous);
    if (step.dot(gradient) <= -enough * at_start) break;
    length *= 0.5;
  }
  x = x_start;
  return length;
}

/// Contact forces, their stiffnesses and the imbalance at x.
void UzawaSolver::Workspace::evaluate(const ContactLoading& loading, const ContactState& previous) {
  gradient = system->multiply(x) - loading.load;
  for_each_contact(problem, [&](const CoulombContact& c) {
    const Eigen::Index i = c.index;
    p[i] = t[i] = normal_stiffness[i] = tangential_stiffness[i] = 0.0;
    if (!is_closed(c)) return;
    const double gap = loading.initial_gap[i] + c.gap(x);
    const bool multiplied = c.site.tangential >= 0;
    normal_stiffness[i] = multiplied ? options.eps_alm : options.eps_r;
    p[i] = (multiplied ? lambda[i] : 0.0) - normal_stiffness[i] * gap;
    if (c.f > 0.0) {
      const double du = slip(c, previous);
      if (friction[static_cast<std::size_t>(i)].sticks) {
        t[i] = trial_friction(c, previous, du);
        tangential_stiffness[i] = options.eps_f;
      } else {
        const double ratio = du / options.tau_f;
        const double slope = 2.0 / std::numbers::pi * bound(c);
        t[i] = -slope * std::atan(ratio);
        tangential_stiffness[i] = slope / (options.tau_f * (1.0 + ratio * ratio));
      }
    }
    c.add_forces(p[i], t[i], -1.0, gradient);
  });
}

void UzawaSolver::Workspace::store(const ContactLoading& loading, ContactState& state) const {
  state.x = x;
  state.gap = contact_gaps(problem, loading.initial_gap, x);
  state.normal_force = p.cwiseMax(0.0);
  state.friction_force = t;
  state.mode.assign(closed.size(), ContactMode::open);
  for_each_contact(problem, [&](const CoulombContact& c) {
    const auto i = static_cast<std::size_t>(c.index);
    if (!closed[i]) return;
    if (c.f == 0.0 || friction[i].sticks) {
      state.mode[i] = ContactMode::stick;
    } else {
      state.mode[i] = t[c.index] < 0.0 ? ContactMode::slip_forward : ContactMode::slip_backward;
    }
  });
}

}  // namespace bumpfoil
