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
        target(ContactState::unstressed(contact_problem)),
        next(target) {
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    mode.reserve(contacts);
    changes.reserve(contacts);
    candidates.reserve(3 * contacts);  // a contact may open or leave its cone on either side
  }

  void find_changes(const ContactState& state);
  bool settle_modes(const ContactLoading& end, const ContactState& state, SolveReport& report);
  double next_event(const ContactState& state);
  void flip_at(double fraction);

  ContactProblem problem;
  FollowOptions options;
  std::shared_ptr<ModeSystem> modes;
  std::vector<ContactMode> mode;  ///< of the piece that begins
  ContactState target;            ///< where the piece would lead if nothing happened before the end of the path
  ContactState next;              ///< end of the piece
  double force_tolerance{};

  struct Candidate {
    double fraction;  ///< of the way to the target
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
bool EventFollower::Workspace::settle_modes(const ContactLoading& end, const ContactState& state, SolveReport& report) {
  force_tolerance = options.force_tolerance * std::max(1.0, state.normal_force.maxCoeff());
  PivotingRule rule(options.max_mode_updates);
  for (;;) {
    const int factorisations = modes->factorisations();
    if (!modes->set_modes(mode)) return false;
    report.factorisations += modes->factorisations() - factorisations;
    modes->solve(end, state.x, target);
    ++report.iterations;
    if (!target.x.allFinite()) return false;
    find_changes(state);
    if (changes.empty()) return true;
    if (!rule.apply(changes, mode)) return false;
  }
}

/// Fraction of the way to `target` at which the first contact reaches the limit of its mode, at most 1. Fills
/// `candidates`.
double EventFollower::Workspace::next_event(const ContactState& state) {
  candidates.clear();
  double first = 1.0;
  const auto propose = [&](Eigen::Index c, double now, double then, ContactMode to) {
    const double fraction = now <= 0.0 ? 0.0 : now / (now - then);
    candidates.push_back({fraction, c, to});
    first = std::min(first, fraction);
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

void EventFollower::Workspace::flip_at(double fraction) {
  for (const Candidate& candidate : candidates) {
    if (candidate.fraction <= fraction) mode[static_cast<std::size_t>(candidate.contact)] = candidate.to;
  }
}

FollowReport EventFollower::follow(const ContactLoading& end, ContactState& state, const PartVisitor& visit,
                                   std::vector<ContactEvent>* events, const std::vector<ContactMode>* guess) {
  Workspace& w = *workspace_;
  FollowReport report;
  report.solve.converged = true;
  w.mode = guess != nullptr ? *guess : state.mode;
  for (; report.pieces < w.options.max_pieces; ++report.pieces) {
    if (!w.settle_modes(end, state, report.solve)) return report;
    if (events != nullptr) {
      for (std::size_t c = 0; c < w.mode.size(); ++c) {
        if (w.mode[c] != state.mode[c]) {
          events->push_back({report.fraction, static_cast<int>(c), state.mode[c], w.mode[c]});
        }
      }
    }
    state.mode = w.mode;

    const double part = w.next_event(state);
    ContactState& next = w.next;
    next = w.target;
    const double fraction = part < 1.0 ? report.fraction + part * (1.0 - report.fraction) : 1.0;
    if (part < 1.0) {
      next.x = state.x + part * (w.target.x - state.x);
      next.gap = state.gap + part * (w.target.gap - state.gap);
      next.normal_force = state.normal_force + part * (w.target.normal_force - state.normal_force);
      next.friction_force = state.friction_force + part * (w.target.friction_force - state.friction_force);
    }
    if (visit) visit(state, next);
    std::swap(state, next);
    report.fraction = fraction;
    if (part >= 1.0) {
      report.reached_end = true;
      return report;
    }
    w.flip_at(part);
  }
  return report;
}

}  // namespace bumpfoil
