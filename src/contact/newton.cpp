#include "bumpfoil/contact/newton.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/event_follower.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/core/assert.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {
namespace {

/// Events within an increment, per contact, beyond which following them is no longer the cheaper method.
constexpr int most_events_per_contact = 2;

/// Rounds of mode changes after each update of the multipliers, which will show better modes next time.
constexpr int rounds_per_multiplier_update = 2;

/// The part -weight * clamp(centre - slope * a, low, high) of the derivative of the energy along a search direction.
struct ClampedTerm {
  double weight, centre, slope, low, high;

  [[nodiscard]] double value(double a) const { return -weight * std::clamp(centre - slope * a, low, high); }
};

/// Zero of the increasing piecewise-linear function linear_part(a) + sum of terms on a > 0.
double exact_step(double constant, double rate, const std::vector<ClampedTerm>& terms, std::vector<double>& kinks) {
  kinks.clear();
  for (const ClampedTerm& term : terms) {
    if (term.slope == 0.0) continue;
    for (const double bound : {term.low, term.high}) {
      const double kink = (term.centre - bound) / term.slope;
      if (std::isfinite(kink) && kink > 0.0) kinks.push_back(kink);
    }
  }
  std::sort(kinks.begin(), kinks.end());
  const auto derivative = [&](double a) {
    double sum = constant + rate * a;
    for (const ClampedTerm& term : terms) sum += term.value(a);
    return sum;
  };
  const auto above = std::partition_point(kinks.begin(), kinks.end(), [&](double a) { return derivative(a) < 0.0; });
  const double left = above == kinks.begin() ? 0.0 : *(above - 1);
  const double at_left = derivative(left);
  if (at_left >= 0.0) return left;
  const double right = above == kinks.end() ? std::max(2.0 * left, 1.0) : *above;
  const double slope = (derivative(right) - at_left) / (right - left);
  return slope > 0.0 ? left - at_left / slope : right;
}

}  // namespace

struct NewtonSolver::Workspace {
  Workspace(const ContactProblem& contact_problem, const NewtonOptions& newton_options)
      : problem(contact_problem),
        options(newton_options),
        modes(make_mode_system(contact_problem)),
        penalties(make_penalty_system(contact_problem)),
        follower(contact_problem, modes, {.max_events = most_events_per_contact * contact_problem.contacts()}),
        path_begin(ContactLoading::none(contact_problem)),
        path_end(ContactState::unstressed(contact_problem)),
        x(contact_problem.K.rows()),
        gradient(x),
        step(x) {
    for (Vector* each : {&lambda, &mu, &bound, &p, &t, &normal_stiffness, &tangential_stiffness, &last_normal_stiffness,
                         &last_tangential_stiffness}) {
      each->setZero(problem.contacts());
    }
    for (const Matrix& block : problem.K.diagonal) {
      penalty = std::max(penalty, options.penalty * block.diagonal().cwiseAbs().maxCoeff());
    }
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    trial.reserve(contacts);
    changes.reserve(contacts);
    terms.reserve(2 * contacts);
    kinks.reserve(4 * contacts);
  }

  bool solve_linear(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                    SolveReport& report);
  bool pivot(const ContactLoading& loading, const ContactState& previous, ContactState& state, SolveReport& report);
  bool solve_law(const ContactLoading& loading, const ContactState& previous, ContactState& state, SolveReport& report);
  void find_changes(const ContactState& previous, const ContactState& state);
  bool iterate_modes(const ContactLoading& loading, const ContactState& previous, int rounds, ContactState& state,
                     SolveReport& report);
  bool augmented_lagrangian(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                            SolveReport& report);
  bool follow_events(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                     SolveReport& report);
  void minimise(const ContactLoading& loading, const ContactState& previous, SolveReport& report);
  double line_search(const ContactLoading& loading, const ContactState& previous);
  void evaluate(const ContactLoading& loading, const ContactState& previous);

  ContactProblem problem;
  NewtonOptions options;
  double penalty{0.0};                ///< N/m
  std::shared_ptr<ModeSystem> modes;  ///< shared with the follower, whose last factors are often the ones needed
  std::unique_ptr<PenaltySystem> penalties;
  EventFollower follower;

  std::vector<ContactMode> trial;
  ContactLoading path_begin;
  ContactState path_end;
  // Augmented Lagrangian: unknowns, multipliers, bounds, forces at the current unknowns, search direction.
  Vector x, lambda, mu, bound, p, t, gradient, step;
  Vector normal_stiffness, tangential_stiffness, last_normal_stiffness, last_tangential_stiffness;
  std::vector<ClampedTerm> terms;
  std::vector<double> kinks;
  std::vector<ModeChange> changes;
};

NewtonSolver::NewtonSolver(const ContactProblem& problem, const NewtonOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, options)) {}

NewtonSolver::~NewtonSolver() = default;

SolveReport NewtonSolver::solve(const ContactLoading& loading, const ContactState& previous, ContactState& state) {
  BUMPFOIL_ASSERT(&state != &previous);  // friction refers to `previous` throughout
  Workspace& w = *workspace_;
  SolveReport report;
  report.converged =
      w.problem.law ? w.solve_law(loading, previous, state, report) : w.solve_linear(loading, previous, state, report);
  return report;
}

bool NewtonSolver::Workspace::solve_linear(const ContactLoading& loading, const ContactState& previous,
                                           ContactState& state, SolveReport& report) {
  return pivot(loading, previous, state, report) || augmented_lagrangian(loading, previous, state, report);
}

/// The first two methods.
bool NewtonSolver::Workspace::pivot(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                                    SolveReport& report) {
  state = previous;
  trial = previous.mode;
  return iterate_modes(loading, previous, options.max_mode_updates, state, report) ||
         follow_events(loading, previous, state, report);
}

/// Newton's method on the elastic law, each step with exact contacts. The modes of an iterate are the first guess of
/// the next: they rarely change after the first.
bool NewtonSolver::Workspace::solve_law(const ContactLoading& loading, const ContactState& previous,
                                        ContactState& state, SolveReport& report) {
  const ElasticLaw& law = *problem.law;
  ContactState begin = previous;
  Vector iterate = previous.x;
  Vector forces = law.forces(iterate);
  ContactLoading linearised = loading;
  const auto linearise = [&](const BlockTridiagonal& K) {
    modes->set_elasticity(K);
    penalties->set_elasticity(K);
    linearised.load = loading.load + K.multiply(iterate) - forces;
  };
  for (int i = 0; i < options.max_tangents; ++i) {
    linearise(law.tangent(iterate));
    if (!pivot(linearised, begin, state, report)) {
      linearise(law.stable_tangent(iterate));
      if (!solve_linear(linearised, begin, state, report)) return false;
    }
    iterate = state.x;
    forces = law.forces(iterate);
    if (contact_residuals(problem, forces, loading, previous.x, state).within(options.law_tolerance)) return true;
    begin.mode = state.mode;
  }
  return false;
}

/// Collects the contacts whose inequalities `state`, solved for its modes, does not obey.
void NewtonSolver::Workspace::find_changes(const ContactState& previous, const ContactState& state) {
  const double largest = std::max(1.0, state.normal_force.maxCoeff());
  const double force_tolerance = options.force_tolerance * largest;
  changes.clear();
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const ContactMode m = state.mode[static_cast<std::size_t>(c)];
    const ContactTrial judged{.gap = state.gap[c],
                              .normal = state.normal_force[c],
                              .friction = state.friction_force[c],
                              .slip = contact.tangential(state.x) - contact.tangential(previous.x)};
    const ContactMode to = next_mode(m, contact.f, judged, options.displacement_tolerance, force_tolerance);
    if (to != m) changes.push_back({c, to});
  });
}

/// Exact solves from the modes in `trial`, until no contact contradicts its mode or the rounds are spent.
bool NewtonSolver::Workspace::iterate_modes(const ContactLoading& loading, const ContactState& previous, int rounds,
                                            ContactState& state, SolveReport& report) {
  PivotingRule rule(rounds);
  for (;;) {
    const int factorisations = modes->factorisations();
    if (!modes->set_modes(trial)) return false;
    report.factorisations += modes->factorisations() - factorisations;
    modes->solve(loading, previous.x, state);
    ++report.iterations;
    if (!state.x.allFinite()) return false;
    find_changes(previous, state);
    if (changes.empty()) return true;
    if (!rule.apply(changes, trial)) return false;
  }
}

/// Modes at the end of the event-by-event path as a guess: the increment differs from the path only where a contact
/// slips to and fro on the way.
bool NewtonSolver::Workspace::follow_events(const ContactLoading& loading, const ContactState& previous,
                                            ContactState& state, SolveReport& report) {
  path_end = previous;
  modes->loading_of(previous, path_begin);
  follower.set_out(path_begin, loading, previous.mode);
  const FollowReport followed = follower.follow_to(1.0, path_end);
  report += followed.solve;
  if (!followed.arrived) return false;
  trial = path_end.mode;
  return iterate_modes(loading, previous, options.max_mode_updates, state, report);
}

/// Forces p, t at x for the current multipliers and bounds, and the gradient of the energy there.
void NewtonSolver::Workspace::evaluate(const ContactLoading& loading, const ContactState& previous) {
  gradient = penalties->multiply(x) - loading.load;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double gap = loading.initial_gap[c] + contact.gap(x);
    const double trial_normal = lambda[c] - penalty * gap;
    p[c] = std::max(0.0, trial_normal);
    normal_stiffness[c] = trial_normal > 0.0 ? penalty : 0.0;
    t[c] = 0.0;
    tangential_stiffness[c] = 0.0;
    if (contact.f > 0.0) {
      const double slip = contact.tangential(x) - contact.tangential(previous.x);
      const double trial_friction = mu[c] - penalty * slip;
      t[c] = std::clamp(trial_friction, -bound[c], bound[c]);
      tangential_stiffness[c] = std::abs(trial_friction) < bound[c] ? penalty : 0.0;
    }
    contact.add_forces(p[c], t[c], -1.0, gradient);
  });
}

/// Exact minimum of the energy along `step`.
double NewtonSolver::Workspace::line_search(const ContactLoading& loading, const ContactState& previous) {
  const double constant = step.dot(penalties->multiply(x) - loading.load);
  const double rate = step.dot(penalties->multiply(step));
  terms.clear();
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double gap = loading.initial_gap[c] + contact.gap(x);
    const double gap_rate = contact.gap(step);
    terms.push_back({gap_rate, lambda[c] - penalty * gap, penalty * gap_rate, 0.0, HUGE_VAL});
    if (contact.f > 0.0) {
      const double slip = contact.tangential(x) - contact.tangential(previous.x);
      const double slip_rate = contact.tangential(step);
      terms.push_back({slip_rate, mu[c] - penalty * slip, penalty * slip_rate, -bound[c], bound[c]});
    }
  });
  return exact_step(constant, rate, terms, kinks);
}

/// Minimum of the energy for the current multipliers and bounds: x, p and t.
void NewtonSolver::Workspace::minimise(const ContactLoading& loading, const ContactState& previous,
                                       SolveReport& report) {
  last_normal_stiffness.setConstant(-1.0);
  for (int i = 0; i < options.max_inner_iterations; ++i) {
    evaluate(loading, previous);
    // The energy is piecewise quadratic: a full step that stays in its piece lands on the minimum.
    if (normal_stiffness == last_normal_stiffness && tangential_stiffness == last_tangential_stiffness) return;
    if (!penalties->set_stiffness(normal_stiffness, tangential_stiffness)) return;
    ++report.factorisations;
    last_normal_stiffness = normal_stiffness;
    last_tangential_stiffness = tangential_stiffness;
    step = -gradient;
    penalties->solve_in_place(step);
    ++report.iterations;
    const double a = line_search(loading, previous);
    x += a * step;
    if (std::abs(a - 1.0) > 1e-6) last_normal_stiffness.setConstant(-1.0);  // the piece was left, or not crossed yet
  }
  evaluate(loading, previous);
}

bool NewtonSolver::Workspace::augmented_lagrangian(const ContactLoading& loading, const ContactState& previous,
                                                   ContactState& state, SolveReport& report) {
  x = previous.x;
  lambda = previous.normal_force.cwiseMax(0.0);
  mu = previous.friction_force;
  bound.setZero();
  p = lambda;
  t = mu;
  for_each_contact(problem,
                   [&](const CoulombContact& contact) { bound[contact.index] = contact.f * lambda[contact.index]; });

  for (int outer = 0; outer < options.max_outer_iterations; ++outer) {
    minimise(loading, previous, report);
    ++report.outer_iterations;
    if (!x.allFinite()) return false;
    lambda = p;
    mu = t;
    for_each_contact(problem, [&](const CoulombContact& contact) {
      const Eigen::Index c = contact.index;
      ContactMode& m = trial[static_cast<std::size_t>(c)];
      if (p[c] <= 0.0) {
        m = ContactMode::open;
      } else if (contact.f == 0.0 || std::abs(t[c]) < bound[c]) {
        m = ContactMode::stick;
      } else {
        m = t[c] < 0.0 ? ContactMode::slip_forward : ContactMode::slip_backward;
      }
      bound[c] = contact.f * lambda[c];
      mu[c] = std::clamp(mu[c], -bound[c], bound[c]);
    });
    if (iterate_modes(loading, previous, rounds_per_multiplier_update, state, report)) return true;
  }
  return false;
}

}  // namespace bumpfoil
