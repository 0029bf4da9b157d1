#include "bumpfoil/contact/newton.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/event_follower.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/core/assert.hpp"
#include "contact/interior_point.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {
namespace {

/// Rounds of mode changes after the interior point, while it still moves and once it has come to its end.
constexpr int rounds_on_the_way = 3;
constexpr int rounds_at_the_end = 30;

/// Where the interior point starts and how close to the bounds its steps go, see InteriorPoint::start(). Below friction
/// coefficients of 0.5 the first has always been enough; beyond, steps may go to and fro, and shorter ones from
/// elsewhere nearly always find through.
struct InteriorStart {
  double spread, reach;
};
constexpr InteriorStart interior_starts[] = {{1.0, 0.995}, {0.1, 0.5}, {10.0, 0.5}};

}  // namespace

struct NewtonSolver::Workspace {
  Workspace(const ContactProblem& contact_problem, const NewtonOptions& newton_options)
      : problem(contact_problem),
        options(newton_options),
        modes(make_mode_system(contact_problem)),
        follower(contact_problem, modes, {.max_events = newton_options.max_events}),
        interior(contact_problem),
        worst_of_runs(contact_problem.pairs.size()),
        path_begin(ContactLoading::none(contact_problem)),
        path_end(ContactState::unstressed(contact_problem)) {
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    trial.reserve(contacts);
    changes.reserve(contacts);
  }

  bool solve_linear(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                    SolveReport& report);
  bool solve_law(const ContactLoading& loading, const ContactState& previous, ContactState& state, SolveReport& report);
  void find_changes(const ContactState& previous, const ContactState& state);
  bool try_modes(const ContactLoading& loading, const ContactState& previous, ContactState& state, SolveReport& report);
  bool iterate_modes(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                     SolveReport& report);
  bool settle_runs(const ContactLoading& loading, const ContactState& previous, int rounds, ContactState& state,
                   SolveReport& report);
  bool follow_events(const ContactLoading& loading, const ContactState& previous, ContactState& state,
                     SolveReport& report);
  bool interior_point(const ContactLoading& loading, const ContactState& previous, const InteriorStart& start,
                      ContactState& state, SolveReport& report);

  ContactProblem problem;
  NewtonOptions options;
  std::shared_ptr<ModeSystem> modes;  ///< shared with the follower, whose last factors are often the ones needed
  EventFollower follower;
  InteriorPoint interior;
  WorstOfRuns worst_of_runs;

  std::vector<ContactMode> trial;
  std::vector<ModeChange> changes;
  std::ptrdiff_t first_contradictions{};  ///< contacts that contradicted the first modes tried; no end if those failed
  ContactLoading path_begin;
  ContactState path_end;
};

NewtonSolver::NewtonSolver(const ContactProblem& problem, const NewtonOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, options)) {
  BUMPFOIL_ASSERT(problem.contacts() > 0);
}

NewtonSolver::~NewtonSolver() = default;

void NewtonSolver::set_elasticity(const BlockTridiagonal& K) {
  workspace_->modes->set_elasticity(K);
  workspace_->interior.set_elasticity(K);
}

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
  state = previous;
  trial = previous.mode;
  if (iterate_modes(loading, previous, state, report)) return true;
  if (follow_events(loading, previous, state, report)) return true;
  for (const InteriorStart& start : interior_starts) {
    if (interior_point(loading, previous, start, state, report)) return true;
  }
  return false;
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
    interior.set_elasticity(K);
    linearised.load = loading.load + K.multiply(iterate) - forces;
  };
  for (int i = 0; i < options.max_tangents; ++i) {
    linearise(law.tangent(iterate));
    if (!solve_linear(linearised, begin, state, report)) {
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
  const double largest = std::max(problem.least_reference_force(), state.normal_force.maxCoeff());
  const double force_tolerance = options.force_tolerance * largest;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const ContactMode m = state.mode[static_cast<std::size_t>(c)];
    const ModeChange change =
        judge(c, m, contact.f, trial_of(contact, state, previous.x), options.displacement_tolerance, force_tolerance);
    if (change.to != m) changes.push_back(change);
  });
}

/// Exact solve for the modes in `trial`; collects the contacts that contradict them.
/// @return false if there is no such state
bool NewtonSolver::Workspace::try_modes(const ContactLoading& loading, const ContactState& previous,
                                        ContactState& state, SolveReport& report) {
  changes.clear();
  if (!solve_modes(*modes, trial, loading, previous.x, state, report)) return false;
  find_changes(previous, state);
  return true;
}

/// Exact solves from the modes in `trial`, until no contact contradicts its mode or the rounds are spent.
bool NewtonSolver::Workspace::iterate_modes(const ContactLoading& loading, const ContactState& previous,
                                            ContactState& state, SolveReport& report) {
  PivotingRule rule(options.max_mode_updates);
  first_contradictions = std::numeric_limits<std::ptrdiff_t>::max();
  for (bool first = true; try_modes(loading, previous, state, report); first = false) {
    if (changes.empty()) return true;
    if (first) first_contradictions = std::ssize(changes);
    if (!rule.apply(changes, trial)) return false;
  }
  return false;
}

/// The same with fewer changes per round, for modes that are right but for roundings and small forces.
bool NewtonSolver::Workspace::settle_runs(const ContactLoading& loading, const ContactState& previous, int rounds,
                                          ContactState& state, SolveReport& report) {
  while (try_modes(loading, previous, state, report)) {
    if (changes.empty()) return true;
    if (rounds-- == 0) return false;
    worst_of_runs.apply(changes, trial);
  }
  return false;
}

/// Modes at the end of the event-by-event path as a guess: the increment differs from the path only where a contact
/// slips to and fro on the way. Only where few contacts contradict the modes of the last increment: an event changes
/// one of them.
bool NewtonSolver::Workspace::follow_events(const ContactLoading& loading, const ContactState& previous,
                                            ContactState& state, SolveReport& report) {
  if (first_contradictions > options.max_events) return false;
  path_end = previous;
  modes->loading_of(previous, path_begin);
  follower.set_out(path_begin, loading, previous.mode);
  const FollowReport followed = follower.follow_to(1.0, path_end);
  report += followed.solve;
  if (!followed.arrived) return false;
  trial = path_end.mode;
  return iterate_modes(loading, previous, state, report);
}

/// Modes that the iterates of the interior-point method show, tried whenever they have come to rest.
bool NewtonSolver::Workspace::interior_point(const ContactLoading& loading, const ContactState& previous,
                                             const InteriorStart& start, ContactState& state, SolveReport& report) {
  interior.start(loading, previous, start.spread, start.reach);
  bool tried = true;  // the modes of the last increment, which the interior point begins with
  bool moves = true;
  for (int i = 0; i < options.max_interior_steps && moves; ++i) {
    moves = interior.step();
    ++report.outer_iterations;
    ++report.factorisations;
    report.iterations += interior.solves();
    if (interior.changed_modes() > 0) tried = false;
    if (interior.changed_modes() > 0 || tried) continue;
    trial = interior.modes();
    if (settle_runs(loading, previous, rounds_on_the_way, state, report)) return true;
    tried = true;
  }
  trial = interior.modes();
  return options.max_interior_steps > 0 && settle_runs(loading, previous, rounds_at_the_end, state, report);
}

}  // namespace bumpfoil
