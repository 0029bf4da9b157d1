#include "bumpfoil/contact/newton.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/core/assert.hpp"
#include "contact/event_follower.hpp"
#include "contact/interior_point.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {
namespace {

/// Rounds of mode changes during the interior-point iteration and after it. In a long foil, fronts of wrong modes
/// remain then, with forces of 1e-11 of the largest, that move contact by contact to the next loaded one: across up to
/// 500 of them in frames of 10,000 bumps.
constexpr int rounds_on_the_way = 3;
constexpr int rounds_at_the_end = 30;
constexpr int blocks_per_round_at_the_end = 20;
/// Number of contacts per accepted contradiction of the interior-point modes: with more contradictions, these modes are
/// not final.
constexpr int contacts_per_contradiction = 10;

/// Start of the interior point and its fraction to the boundary, see InteriorPoint::start(). For friction coefficients
/// below 0.5 the first entry has always sufficed; above, steps may oscillate, and shorter steps from another start
/// nearly always converge.
struct InteriorStart {
  double spread, reach;
};
constexpr InteriorStart interior_starts[] = {{1.0, 0.995}, {0.1, 0.5}, {10.0, 0.5}};

}  // namespace

/// The solution of one increment.
struct NewtonSolver::Task {
  const ContactLoading& loading;
  const ContactState& previous;  ///< reference of friction
  ContactState& state;           ///< the last iterate
  SolveCost& cost;
};

struct NewtonSolver::Workspace {
  Workspace(const SharedProblem& contact_problem, std::shared_ptr<ModeSystem> mode_system,
            const NewtonOptions& newton_options)
      : shared_problem(contact_problem),
        problem(*shared_problem),
        options(newton_options),
        modes(std::move(mode_system)),
        follower(contact_problem, modes, {.max_events = newton_options.max_events}),
        interior(contact_problem),
        worst_of_runs(problem.sites),
        path{ContactLoading::none(problem), ContactLoading::none(problem)},
        path_end(ContactState::unstressed(problem)) {
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    trial.reserve(contacts);
    changes.reserve(contacts);
  }

  bool solve_linear(const Task& task);
  Status solve_law(const Task& task);
  void find_changes(const ContactState& previous, const ContactState& state);
  bool try_modes(const Task& task);
  bool iterate_modes(const Task& task);
  bool settle_runs(const Task& task, int rounds, std::ptrdiff_t most_contradictions);
  bool follow_events(const Task& task);
  bool interior_point(const Task& task, const InteriorStart& start);

  SharedProblem shared_problem;
  const ContactProblem& problem;  ///< the shared one
  NewtonOptions options;
  std::shared_ptr<ModeSystem> modes;  ///< shared with the follower, whose last factors are often reusable
  EventFollower follower;
  InteriorPoint interior;
  WorstOfRuns worst_of_runs;

  std::vector<ContactMode> trial;
  std::vector<ModeChange> changes;
  std::ptrdiff_t first_contradictions{};  ///< contradictions of the first modes tried; infinite if those failed
  LoadingPath path;
  ContactState path_end;
};

NewtonSolver::NewtonSolver(const SharedProblem& problem, const NewtonOptions& options)
    : NewtonSolver(problem, make_mode_system(*problem), options) {}

NewtonSolver::NewtonSolver(const SharedProblem& problem, std::shared_ptr<ModeSystem> modes,
                           const NewtonOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, std::move(modes), options)) {
  BUMPFOIL_ASSERT(problem->contacts() > 0);
}

NewtonSolver::~NewtonSolver() = default;

void NewtonSolver::set_elasticity(const BlockTridiagonal& K) {
  workspace_->modes->set_elasticity(K);
  workspace_->interior.set_elasticity(K);
}

SolveReport NewtonSolver::solve(const ContactLoading& loading, const ContactState& previous, ContactState& state) {
  BUMPFOIL_ASSERT(&state != &previous);  // reference of friction throughout
  Workspace& w = *workspace_;
  SolveReport report;
  const Task task{loading, previous, state, report.cost};
  if (w.problem.law) {
    report.status = w.solve_law(task);
  } else {
    report.status = w.solve_linear(task) ? Status::converged : Status::no_modes;
  }
  return report;
}

bool NewtonSolver::Workspace::solve_linear(const Task& task) {
  task.state = task.previous;
  trial = task.previous.mode;
  if (iterate_modes(task)) return true;
  if (follow_events(task)) return true;
  for (const InteriorStart& start : interior_starts) {
    if (interior_point(task, start)) return true;
  }
  return false;
}

/// Newton's method on the elastic law, each step with exact contacts. The modes of an iterate are the first guess of
/// the next: they rarely change after the first.
Status NewtonSolver::Workspace::solve_law(const Task& task) {
  const ElasticLaw& law = *problem.law;
  ContactState begin = task.previous;
  Vector iterate = task.previous.x;
  Vector forces = law.forces(iterate);
  ContactLoading linearised = task.loading;
  const Task linear{linearised, begin, task.state, task.cost};
  const auto linearise = [&](const BlockTridiagonal& K) {
    modes->set_elasticity(K);
    interior.set_elasticity(K);
    linearised.load = task.loading.load + K.multiply(iterate) - forces;
  };
  for (int i = 0; i < options.max_tangents; ++i) {
    linearise(law.tangent(iterate));
    if (!solve_linear(linear)) {
      linearise(law.stable_tangent(iterate));
      if (!solve_linear(linear)) return Status::no_modes;
    }
    iterate = task.state.x;
    forces = law.forces(iterate);
    if (contact_residuals(problem, forces, task.loading, task.previous.x, task.state).within(options.law_tolerance)) {
      return Status::converged;
    }
    begin.mode = task.state.mode;
  }
  return Status::no_tangent;
}

/// Collects the contacts whose inequalities are violated by `state`, the solution for its modes.
void NewtonSolver::Workspace::find_changes(const ContactState& previous, const ContactState& state) {
  const double largest = std::max(problem.least_reference_force(), state.normal_force.maxCoeff());
  const double force_tolerance = options.force_tolerance * largest;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const ContactMode m = state.mode[static_cast<std::size_t>(c)];
    const ModeChange change = check_mode(c, m, contact.f, trial_of(contact, state, previous.x),
                                         options.displacement_tolerance, force_tolerance);
    if (change.to != m) changes.push_back(change);
  });
}

/// Exact solve for the modes in `trial`; collects the contacts that contradict them.
/// @return false if no such state exists
bool NewtonSolver::Workspace::try_modes(const Task& task) {
  changes.clear();
  if (!solve_modes(*modes, trial, task.loading, task.previous.x, task.state, task.cost)) return false;
  find_changes(task.previous, task.state);
  return true;
}

/// Exact solves from the modes in `trial`, until no contact contradicts its mode or the rounds are used up.
bool NewtonSolver::Workspace::iterate_modes(const Task& task) {
  PivotingRule rule(options.max_mode_updates);
  first_contradictions = std::numeric_limits<std::ptrdiff_t>::max();
  for (bool first = true; try_modes(task); first = false) {
    if (changes.empty()) return true;
    if (first) first_contradictions = std::ssize(changes);
    if (!rule.apply(changes, trial)) return false;
  }
  return false;
}

/// The same with fewer changes per round, for modes that are correct except for round-off and small forces.
/// @param most_contradictions  it gives up with more contradictions
bool NewtonSolver::Workspace::settle_runs(const Task& task, int rounds, std::ptrdiff_t most_contradictions) {
  while (try_modes(task)) {
    if (changes.empty()) return true;
    if (rounds-- == 0 || std::ssize(changes) > most_contradictions) return false;
    worst_of_runs.apply(changes, trial);
  }
  return false;
}

/// Guesses the modes at the end of the event-by-event path: the increment differs from the path only if a contact
/// reverses its slip on the way. Used only if few contacts contradict the modes of the last increment, as each event
/// changes one.
bool NewtonSolver::Workspace::follow_events(const Task& task) {
  if (first_contradictions > options.max_events) return false;
  path_end = task.previous;
  modes->loading_of(task.previous, path.begin);
  path.end = task.loading;
  follower.set_out(path, task.previous.mode);
  const EventProgress followed = follower.follow_to(1.0, path_end);
  task.cost += followed.cost;
  if (!followed.arrived) return false;
  trial = path_end.mode;
  return iterate_modes(task);
}

/// Modes shown by the iterates of the interior-point method, tried whenever they have settled.
bool NewtonSolver::Workspace::interior_point(const Task& task, const InteriorStart& start) {
  interior.start(task.loading, task.previous, start.spread, start.reach);
  bool tried = true;  // the modes of the last increment, with which the interior point starts
  bool moves = true;
  for (int i = 0; i < options.max_interior_steps && moves; ++i) {
    moves = interior.step();
    ++task.cost.outer_iterations;
    ++task.cost.factorisations;
    task.cost.iterations += interior.solves();
    if (interior.changed_modes() > 0) tried = false;
    if (interior.changed_modes() > 0 || tried) continue;
    trial = interior.modes();
    if (settle_runs(task, rounds_on_the_way, std::max(1, problem.contacts() / contacts_per_contradiction))) return true;
    tried = true;
  }
  trial = interior.modes();
  const int rounds = std::max(rounds_at_the_end, problem.K.blocks() / blocks_per_round_at_the_end);
  return options.max_interior_steps > 0 && settle_runs(task, rounds, problem.contacts());
}

}  // namespace bumpfoil
