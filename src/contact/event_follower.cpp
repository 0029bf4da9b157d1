#include "bumpfoil/contact/event_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {

struct EventFollower::Workspace {
  Workspace(const ContactProblem& contact_problem, std::shared_ptr<ModeSystem> mode_system,
            const FollowOptions& follow_options)
      : problem(contact_problem),
        options(follow_options),
        modes(std::move(mode_system)),
        begin(ContactState::unstressed(contact_problem)),
        target(begin),
        next(begin) {
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    mode.reserve(contacts);
    changes.reserve(contacts);
    candidates.reserve(3 * contacts);  // a contact may open or leave its cone on either side
  }

  void find_changes(const ContactState& state);
  bool settle_modes(const ContactState& state, SolveReport& report);
  bool begin_piece(ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>* events,
                   SolveReport& report);
  [[nodiscard]] bool obeys_modes(const ContactState& state) const;
  double next_event(const ContactState& state);
  void flip_at_event(const ContactState& state);
  void interpolate_piece(double part);

  ContactProblem problem;
  FollowOptions options;
  std::shared_ptr<ModeSystem> modes;
  ContactLoading end;   ///< of the path
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
  std::vector<ModeChange> changes;
};

EventFollower::EventFollower(const ContactProblem& problem, std::shared_ptr<ModeSystem> modes,
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
    if (m == ContactMode::open && state.gap[c] > options.displacement_tolerance) return;
    ContactTrial trial{.gap = target.gap[c],
                       .normal = target.normal_force[c],
                       .friction = target.friction_force[c],
                       .slip = contact.tangential(target.x) - contact.tangential(state.x)};
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
    const ContactMode to = next_mode(m, f, trial, options.displacement_tolerance, force_tolerance);
    if (to != m) changes.push_back({c, to});
  });
}

/// Finds the modes of the piece that begins at `state`, and where it leads.
bool EventFollower::Workspace::settle_modes(const ContactState& state, SolveReport& report) {
  PivotingRule rule(first_touch ? options.max_first_touch_updates : options.max_mode_updates);
  for (;;) {
    const int factorisations = modes->factorisations();
    if (!modes->set_modes(mode)) return false;
    report.factorisations += modes->factorisations() - factorisations;
    modes->solve(end, state.x, target);
    ++report.iterations;
    if (!target.x.allFinite()) return false;
    force_tolerance =
        options.force_tolerance * std::max({1.0, state.normal_force.maxCoeff(), target.normal_force.maxCoeff()});
    find_changes(state);
    if (changes.empty()) return true;
    if (!rule.apply(changes, mode)) return false;
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
    obeys = obeys && std::abs(state.gap[c]) <= options.displacement_tolerance;
    if (slips(m) && contact.f > 0.0) {
      const double friction = m == ContactMode::slip_forward ? -contact.f * p : contact.f * p;
      obeys = obeys && std::abs(t - friction) <= force_tolerance;
    }
  });
  return obeys;
}

/// Settles what comes next at `state`.
bool EventFollower::Workspace::begin_piece(ContactState& state, const PartVisitor& visit,
                                           std::vector<ContactEvent>* events, SolveReport& report) {
  if (!settle_modes(state, report)) return false;
  if (events != nullptr) {
    for (std::size_t c = 0; c < mode.size(); ++c) {
      if (mode[c] != state.mode[c]) events->push_back({reached, static_cast<int>(c), state.mode[c], mode[c]});
    }
  }
  state.mode = mode;
  begin = state;
  if (!obeys_modes(state)) {
    // The response jumps: foils snap, or contacts that lose their last force together do so one rounding apart.
    modes->solve(modes->loading_of(state), state.x, begin);
    ++report.iterations;
    if (visit) visit(state, begin);
    state = begin;
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
      if (target.gap[c] < -options.displacement_tolerance) propose(c, state.gap[c], target.gap[c], ContactMode::stick);
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
  for (const Candidate& candidate : candidates) {
    if (candidate.part <= event) mode[static_cast<std::size_t>(candidate.contact)] = candidate.to;
  }
  first_touch = state.normal_force.maxCoeff() <= force_tolerance;
  if (!first_touch) return;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    ContactMode& m = mode[static_cast<std::size_t>(contact.index)];
    if (m == ContactMode::open && state.gap[contact.index] <= options.displacement_tolerance) m = ContactMode::stick;
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

void EventFollower::set_out(const ContactLoading& end, const std::vector<ContactMode>& mode) {
  Workspace& w = *workspace_;
  w.end = end;
  w.mode = mode;
  w.reached = 0.0;
  w.events_passed = 0;
  w.inside_piece = false;
  w.first_touch = false;
}

FollowReport EventFollower::follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                      std::vector<ContactEvent>* events) {
  Workspace& w = *workspace_;
  const int events_before = w.events_passed;
  FollowReport report;
  report.solve.converged = true;
  for (;;) {
    if (!w.inside_piece && !w.begin_piece(state, visit, events, report.solve)) break;
    const double length = 1.0 - w.begin_fraction;
    const double event = w.event < 1.0 ? w.begin_fraction + w.event * length : 1.0;
    report.arrived = fraction <= event;
    w.interpolate_piece(report.arrived ? (fraction - w.begin_fraction) / length : w.event);
    if (visit) visit(state, w.next);
    std::swap(state, w.next);
    w.reached = report.arrived ? fraction : event;
    if (report.arrived || w.events_passed == w.options.max_events) break;
    w.flip_at_event(state);
    w.inside_piece = false;
    ++w.events_passed;
  }
  report.fraction = w.reached;
  report.events = w.events_passed - events_before;
  return report;
}

}  // namespace bumpfoil
