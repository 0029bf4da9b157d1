#include "bumpfoil/contact/event_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/piece_energy.hpp"
#include "bumpfoil/core/assert.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {
namespace {

/// A gap or a slip below this is none, m.
constexpr double displacement_tolerance = 1e-13;

/// A force below this part of the largest is none; the largest of where the piece begins and where it leads, or
/// ContactProblem::least_reference_force().
constexpr double relative_force_tolerance = 1e-11;

/// Rounds of settling the modes after one event, and where foils that carried nothing are touched.
constexpr int most_rounds = 10;
constexpr int most_rounds_at_first_touch = 30;

/// What is left of large forces has their roundings, some 1e-13 of them: how many times larger the forces may be that a
/// piece leads to than those it begins with. States stay exact to 1e-11 then.
constexpr double most_cancellation = 100.0;

double largest_force(const ContactState& state) {
  return state.normal_force.cwiseAbs().maxCoeff();
}

}  // namespace

struct EventFollower::Workspace {
  Workspace(const SharedProblem& contact_problem, std::shared_ptr<ModeSystem> mode_system,
            const FollowOptions& follow_options)
      : shared_problem(contact_problem),
        problem(*shared_problem),
        options(follow_options),
        modes(std::move(mode_system)),
        path{ContactLoading::none(problem), ContactLoading::none(problem)},
        here(path.begin),
        begin(ContactState::unstressed(problem)),
        target(begin),
        next(begin) {
    BUMPFOIL_ASSERT(problem.contacts() > 0);
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    mode.reserve(contacts);
    changes.reserve(contacts);
    flipped.reserve(contacts);
    candidates.reserve(3 * contacts);  // a contact may open or leave its cone on either side
  }

  void find_changes(const ContactState& state);
  bool settle_modes(const ContactState& state, SolveCost& cost);
  bool begin_piece(ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>* events,
                   EventProgress& report);
  [[nodiscard]] bool solve_here(const ContactState& state, SolveCost& cost);
  [[nodiscard]] bool jump(const ContactState& state, EventProgress& report);
  [[nodiscard]] bool obeys_modes(const ContactState& state) const;
  double next_event(const ContactState& state);
  void keep_changes_nearby();
  void flip_at_event(const ContactState& state);
  void interpolate_piece(double part);

  SharedProblem shared_problem;
  const ContactProblem& problem;  ///< the shared one
  FollowOptions options;
  std::shared_ptr<ModeSystem> modes;
  LoadingPath path;
  ContactLoading here;  ///< at `reached`
  double reached{};     ///< fraction of the path that lies behind
  int events_passed{};  ///< on this path
  bool inside_piece{};  ///< the piece below leads on from `reached`
  bool first_touch{};   ///< at `reached` foils that carried nothing are touched: all that touches is tried closed
  std::vector<ContactMode> mode;  ///< of the piece
  ContactState begin;             ///< of the piece
  double begin_fraction{};        ///< of the path
  double event{};                 ///< part of the way from `begin` to `target` after which the piece ends, at most 1
  ContactState target;            ///< where the piece would lead if nothing happened before the end of the path
  ContactState next;              ///< where the path is halted
  double force_tolerance{};

  struct Candidate {
    double part;  ///< of the way to the target
    Eigen::Index contact;
    ContactMode to;
  };
  std::vector<Candidate> candidates;
  std::vector<Eigen::Index> flipped;  ///< contacts of the last event, until the modes after it have been looked at
  std::vector<ModeChange> changes;
};

EventFollower::EventFollower(const SharedProblem& problem, std::shared_ptr<ModeSystem> modes,
                             const FollowOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, std::move(modes), options)) {}

EventFollower::~EventFollower() = default;

/// Collects the contacts that may choose their mode at `state` and contradict it on the way to `target`.
void EventFollower::Workspace::find_changes(const ContactState& state) {
  changes.clear();
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double f = contact.f;
    const ContactMode m = mode[static_cast<std::size_t>(c)];
    const bool loaded = state.normal_force[c] > force_tolerance;
    if (m == ContactMode::open && state.gap[c] > displacement_tolerance) return;
    ContactTrial trial = trial_of(contact, target, state.x);
    if (loaded) {
      trial.normal = std::max(0.0, trial.normal);  // will open later on the way, if at all
      if (m == ContactMode::stick) {
        // Free to choose only at its bound, and only if it would leave the cone on that side: the normal force may
        // fall faster than the friction force.
        const double side = std::copysign(1.0, state.friction_force[c]);
        const bool on_bound = f * state.normal_force[c] - side * state.friction_force[c] <= force_tolerance;
        const bool leaves = f * target.normal_force[c] - side * target.friction_force[c] < -force_tolerance;
        if (f > 0.0 && on_bound && leaves) changes.push_back({c, slip_mode(-side)});
        return;
      }
    }
    const ContactMode to = next_mode(m, f, trial, displacement_tolerance, force_tolerance);
    if (to != m) changes.push_back({c, to});
  });
}

/// One contact that changes its mode may turn round a whole row of others, which turn back once its neighbours have
/// changed theirs. Drops the changes far from the event, unless there are no others.
void EventFollower::Workspace::keep_changes_nearby() {
  const auto pairs = static_cast<Eigen::Index>(problem.pairs.size());
  const auto is_far = [&](const ModeChange& change) {
    return std::none_of(flipped.begin(), flipped.end(),
                        [&](Eigen::Index c) { return std::abs(change.contact / pairs - c / pairs) <= 1; });
  };
  const auto far = std::remove_if(changes.begin(), changes.end(), is_far);
  if (far != changes.begin()) changes.erase(far, changes.end());
}

/// Finds the modes of the piece that begins at `state`, and where it leads.
bool EventFollower::Workspace::settle_modes(const ContactState& state, SolveCost& cost) {
  PivotingRule rule(first_touch ? most_rounds_at_first_touch : most_rounds);
  for (;;) {
    if (!solve_modes(*modes, mode, path.end, state.x, target, cost)) return false;
    force_tolerance =
        relative_force_tolerance *
        std::max({problem.least_reference_force(), state.normal_force.maxCoeff(), target.normal_force.maxCoeff()});
    find_changes(state);
    if (changes.empty()) return true;
    if (!flipped.empty()) {
      keep_changes_nearby();
      flipped.clear();
      for (const ModeChange& change : changes) mode[static_cast<std::size_t>(change.contact)] = change.to;
    } else if (!rule.apply(changes, mode)) {
      return false;
    }
  }
}

/// Whether the forces and gaps of `state` are such as the modes of the piece ask for.
bool EventFollower::Workspace::obeys_modes(const ContactState& state) const {
  bool obeys = true;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double p = state.normal_force[c];
    const double t = state.friction_force[c];
    const ContactMode m = mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open) {
      obeys = obeys && std::abs(p) <= force_tolerance && std::abs(t) <= force_tolerance;
      return;
    }
    obeys = obeys && std::abs(state.gap[c]) <= displacement_tolerance;
    if (slips(m) && contact.f > 0.0) {
      obeys = obeys && std::abs(t - friction_sign(m) * contact.f * p) <= force_tolerance;
    }
  });
  return obeys;
}

/// Fills `begin` with the exact state of the settled modes where the piece begins. It differs from `state` where the
/// response jumps (foils snap), where contacts that lose their last force together did so one rounding apart, and by
/// the roundings of what was interpolated.
/// @return false where that state contradicts its modes: then it was no jump that these contacts could make
bool EventFollower::Workspace::solve_here(const ContactState& state, SolveCost& cost) {
  path.at(reached, here);
  modes->solve(here, state.x, begin);
  ++cost.iterations;
  bool obeys = begin.x.allFinite();
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const ContactMode m = mode[static_cast<std::size_t>(contact.index)];
    const ContactTrial trial = trial_of(contact, begin, state.x);
    obeys = obeys && next_mode(m, contact.f, trial, displacement_tolerance, force_tolerance) == m;
  });
  return obeys;
}

/// Notes what the jump from `state` to `begin` dissipates.
/// @return false where it gains energy, as no jump does, or where other modes lead on behind it: contacts may have
/// slipped
///   further than the piece leads
bool EventFollower::Workspace::jump(const ContactState& state, EventProgress& report) {
  find_changes(begin);
  if (!changes.empty()) return false;
  const PieceEnergy energy = piece_energy(problem, state, begin);
  const double negligible = negligible_energy(problem, state, begin);
  if (std::abs(energy.defect()) > negligible) report.jump_dissipation += energy.defect();
  return energy.given_off >= -negligible;
}

/// Settles what comes next at `state`.
bool EventFollower::Workspace::begin_piece(ContactState& state, const PartVisitor& visit,
                                           std::vector<ContactEvent>* events, EventProgress& report) {
  if (!settle_modes(state, report.cost)) return false;
  // A state that the modes fit is kept unless a better one fits them, too.
  const bool fits = obeys_modes(state);
  const bool cancels =
      largest_force(target) > most_cancellation * std::max(problem.least_reference_force(), largest_force(state));
  const bool solved = (!fits || cancels) && solve_here(state, report.cost);
  if (!fits && !(solved && jump(state, report))) return false;
  if (events != nullptr) {
    for (std::size_t c = 0; c < mode.size(); ++c) {
      if (mode[c] != state.mode[c]) events->push_back({reached, static_cast<int>(c), state.mode[c], mode[c]});
    }
  }
  state.mode = mode;
  if (solved) {
    if (visit) visit({.begin = state, .end = begin, .linear = true});
    state = begin;
  } else {
    begin = state;
  }
  begin_fraction = reached;
  event = next_event(state);
  inside_piece = true;
  return true;
}

/// Part of the way to `target` at which the first contact reaches the limit of its mode, at most 1. Fills
/// `candidates`.
double EventFollower::Workspace::next_event(const ContactState& state) {
  candidates.clear();
  double first = 1.0;
  const auto propose = [&](Eigen::Index c, double now, double then, ContactMode to) {
    const double part = now <= 0.0 ? 0.0 : now / (now - then);
    candidates.push_back({part, c, to});
    first = std::min(first, part);
  };
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double f = contact.f;
    const ContactMode m = mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open) {
      const ContactMode to =
          next_mode(m, f, trial_of(contact, target, state.x), displacement_tolerance, force_tolerance);
      if (to != m) propose(c, state.gap[c], target.gap[c], to);
      return;
    }
    if (target.normal_force[c] < -force_tolerance) {
      propose(c, state.normal_force[c], target.normal_force[c], ContactMode::open);
    }
    if (m == ContactMode::stick && f > 0.0) {
      for (const double side : {1.0, -1.0}) {
        const double margin = f * target.normal_force[c] - side * target.friction_force[c];
        if (margin < -force_tolerance) {
          propose(c, f * state.normal_force[c] - side * state.friction_force[c], margin, slip_mode(-side));
        }
      }
    }
  });
  return first;
}

/// Guesses the modes of the next piece, which begins at `state`.
void EventFollower::Workspace::flip_at_event(const ContactState& state) {
  flipped.clear();
  for (const Candidate& candidate : candidates) {
    if (candidate.part > event) continue;
    mode[static_cast<std::size_t>(candidate.contact)] = candidate.to;
    flipped.push_back(candidate.contact);
  }
  first_touch = state.normal_force.maxCoeff() <= force_tolerance;
  if (!first_touch) return;
  flipped.clear();  // all may have to change
  for_each_contact(problem, [&](const CoulombContact& contact) {
    ContactMode& m = mode[static_cast<std::size_t>(contact.index)];
    if (m == ContactMode::open && state.gap[contact.index] <= displacement_tolerance) m = ContactMode::stick;
  });
}

/// Fills `next` with the state at `part` of the way from `begin` to `target`.
void EventFollower::Workspace::interpolate_piece(double part) {
  next.mode = target.mode;
  for (Vector ContactState::*field :
       {&ContactState::x, &ContactState::gap, &ContactState::normal_force, &ContactState::friction_force}) {
    next.*field = (1.0 - part) * (begin.*field) + part * (target.*field);
  }
}

void EventFollower::set_out(const LoadingPath& path, const std::vector<ContactMode>& mode, double start) {
  Workspace& w = *workspace_;
  w.path = path;
  w.mode = mode;
  w.reached = start;
  w.events_passed = 0;
  w.inside_piece = false;
  w.first_touch = false;
  w.flipped.clear();
}

EventProgress EventFollower::follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                       std::vector<ContactEvent>* events) {
  Workspace& w = *workspace_;
  BUMPFOIL_ASSERT(fraction >= w.reached);
  const int events_before = w.events_passed;
  EventProgress report;
  int events_here = 0;
  for (;;) {
    if (!w.inside_piece && !w.begin_piece(state, visit, events, report)) break;
    const double length = 1.0 - w.begin_fraction;
    const double event = w.event < 1.0 ? w.begin_fraction + w.event * length : 1.0;
    report.arrived = fraction <= event;
    w.interpolate_piece(report.arrived ? (fraction - w.begin_fraction) / length : w.event);
    if (visit) visit({.begin = state, .end = w.next, .linear = true});
    std::swap(state, w.next);
    events_here = event > w.reached ? 0 : events_here + 1;
    w.reached = report.arrived ? fraction : event;
    // Contacts that go on changing at one place would do so for ever.
    if (report.arrived || w.events_passed == w.options.max_events || events_here > w.problem.contacts()) break;
    w.flip_at_event(state);
    w.inside_piece = false;
    ++w.events_passed;
  }
  report.fraction = w.reached;
  report.events = w.events_passed - events_before;
  return report;
}

}  // namespace bumpfoil
