#include "contact/event_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/extremes.hpp"
#include "contact/contact_tableau.hpp"
#include "contact/piece_energy.hpp"
#include "contact/pivoting.hpp"
#include "contact/straight_piece.hpp"

namespace bumpfoil {
namespace {

/// Maximum number of rounds to settle the modes after one event, and at first touch of unloaded foils.
constexpr int most_rounds = 10;
constexpr int most_rounds_at_first_touch = 30;
/// Additional rounds in make_changes() right after an event.
constexpr int rounds_by_solves = 1;
constexpr int rounds_by_tableau = 8;

/// Maximum ratio of the forces at the end of a piece to those at its start. Decreasing forces keep the round-off of the
/// larger ones, about 1e-13 of them: states stay exact to 1e-11.
constexpr double most_cancellation = 100.0;

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
        piece(problem),
        next(piece.begin),
        whole(piece.begin) {
    BUMPFOIL_ASSERT(problem.contacts() > 0);
    const auto contacts = static_cast<std::size_t>(problem.contacts());
    mode.reserve(contacts);
    changes.reserve(contacts);
    flipped.reserve(contacts);
    if (options.rates == Rates::by_tableau && ContactTableau::pays(problem)) {
      tableau = std::make_unique<ContactTableau>(problem, modes);
    }
  }

  bool find_target(SolveCost& cost);
  bool settle_modes(SolveCost& cost);
  bool begin_piece(const PartVisitor& visit, std::vector<ContactEvent>* events, EventProgress& report);
  [[nodiscard]] bool complete(ContactState& state, SolveCost& cost);
  [[nodiscard]] bool solve_begin(SolveCost& cost);
  [[nodiscard]] bool lets_go() const;
  [[nodiscard]] bool jump(EventProgress& report);
  void keep_changes_nearby();
  void make_changes();
  void flip_at_event();

  SharedProblem shared_problem;
  const ContactProblem& problem;  ///< the shared one
  FollowOptions options;
  std::shared_ptr<ModeSystem> modes;
  std::unique_ptr<ContactTableau> tableau;  ///< null if rates are found by solves
  bool by_rates{};                          ///< whether the tableau determined the target
  LoadingPath path;
  ContactLoading here;  ///< loading at `reached`
  double reached{};     ///< completed fraction of the path
  int events_passed{};  ///< on this path
  StraightPiece piece;
  bool inside_piece{};            ///< whether the piece starts at `reached`
  std::vector<ContactMode> mode;  ///< of the piece, or the guess for the next
  bool first_touch{};             ///< unloaded foils are touched at `reached`: all touching contacts are tried closed
  ContactState next;   ///< state where the path is halted, or the state before a piece that starts from another
  ContactState whole;  ///< storage for complete()
  std::vector<Eigen::Index> flipped;  ///< contacts of the last event
  std::vector<ModeChange> changes;
};

EventFollower::EventFollower(const SharedProblem& problem, std::shared_ptr<ModeSystem> modes,
                             const FollowOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, std::move(modes), options)) {}

EventFollower::~EventFollower() = default;

/// A mode change of one contact may reverse a whole row of others, which reverse again once its neighbours have
/// changed. Drops changes far from the event, unless there are no others.
void EventFollower::Workspace::keep_changes_nearby() {
  const auto block_of = [this](Eigen::Index c) { return problem.sites[static_cast<std::size_t>(c)].block; };
  const auto is_far = [&](const ModeChange& change) {
    return std::none_of(flipped.begin(), flipped.end(),
                        [&](Eigen::Index c) { return std::abs(block_of(change.contact) - block_of(c)) <= 1; });
  };
  const auto far = std::remove_if(changes.begin(), changes.end(), is_far);
  if (far != changes.begin()) changes.erase(far, changes.end());
}

/// Computes the end of the piece in its modes: by rates if the start obeys them, else by a solve, whose start is not
/// part of the piece.
bool EventFollower::Workspace::find_target(SolveCost& cost) {
  if (tableau) {
    piece.set_modes(mode);
    by_rates = piece.begin_obeys_new_modes() && tableau->set_modes(mode);
    if (by_rates) {
      piece.lead(tableau->rates(), 1.0 - reached);
      return true;
    }
  }
  if (!solve_modes(*modes, mode, path.end, piece.begin.x, piece.target, cost)) return false;
  piece.take_target();
  return true;
}

/// Makes all changes. With the tableau, where a change costs about as much as a round, only the slip with the largest
/// reversal sticks: others often keep sliding after that.
void EventFollower::Workspace::make_changes() {
  const ModeChange* turns_most = nullptr;
  for (const ModeChange& change : changes) {
    ContactMode& m = mode[static_cast<std::size_t>(change.contact)];
    const bool turns = slips(m) && change.to == ContactMode::stick;
    if (!tableau || !turns) {
      m = change.to;
    } else if (turns_most == nullptr || change.excess > turns_most->excess) {
      turns_most = &change;
    }
  }
  if (turns_most != nullptr) mode[static_cast<std::size_t>(turns_most->contact)] = turns_most->to;
}

/// Finds the modes of the piece and its target.
bool EventFollower::Workspace::settle_modes(SolveCost& cost) {
  PivotingRule rule(first_touch ? most_rounds_at_first_touch : most_rounds);
  const int rounds_after_event = tableau ? rounds_by_tableau : rounds_by_solves;
  for (int round = 0;; ++round) {
    if (!find_target(cost)) return false;
    piece.look_ahead(changes);
    if (changes.empty()) return true;
    if (!flipped.empty() && round < rounds_after_event) {
      if (round == 0) keep_changes_nearby();
      make_changes();
    } else if (!rule.apply(changes, mode)) {
      return false;
    }
  }
}

/// Starts the piece from the exact state of its modes and keeps the previous state in `next`. They differ if the
/// response jumps (snap-through), if contacts lost their last force together within round-off, if that force was below
/// the tolerance, and by the round-off of interpolated values.
/// @return false if that state contradicts its modes: these contacts cannot jump that way; nothing is changed
bool EventFollower::Workspace::solve_begin(SolveCost& cost) {
  path.at(reached, here);
  bool obeys = solve_modes(*modes, mode, here, piece.begin.x, next, cost);
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const ContactMode m = mode[static_cast<std::size_t>(contact.index)];
    const ContactTrial trial = trial_of(contact, next, piece.begin.x);
    obeys = obeys && next_mode(m, contact.f, trial, displacement_tolerance, piece.force_tolerance) == m;
  });
  if (obeys) std::swap(piece.begin, next);
  return obeys;
}

/// Whether the foils are released: no contact carries a force after this event. The residual force at the event is
/// neglected, although it can hold a long thin top foil a nanometre off its free position.
bool EventFollower::Workspace::lets_go() const {
  return !tableau && piece.target_force <= piece.force_tolerance && mode != piece.begin.mode;
}

/// Completes a state of the contact tableau, which lacks unknowns without contact.
/// @return false if that fails
bool EventFollower::Workspace::complete(ContactState& state, SolveCost& cost) {
  path.at(reached, here);
  if (!solve_modes(*modes, state.mode, here, state.x, whole, cost)) return false;
  std::swap(state, whole);
  return true;
}

/// Records the energy dissipated by the jump from `next` to the start of the piece.
/// @return false if the jump gains energy, which is impossible, or other modes continue behind it: contacts may have
///   slipped further than at the start of the piece
bool EventFollower::Workspace::jump(EventProgress& report) {
  if (!changes.empty()) return false;
  if (tableau && !complete(next, report.cost)) return false;
  const PieceEnergy energy = piece_energy(problem, next, piece.begin);
  const double negligible = negligible_energy(problem, next, piece.begin);
  if (std::abs(energy.defect()) > negligible) report.jump_dissipation += energy.defect();
  return energy.given_off >= -negligible;
}

/// Settles the modes of the next piece at its start, the current state on the path.
/// @return false if they cannot be determined; the start is unchanged
bool EventFollower::Workspace::begin_piece(const PartVisitor& visit, std::vector<ContactEvent>* events,
                                           EventProgress& report) {
  piece.begin_fraction = reached;
  piece.measure_begin(problem);
  if (!settle_modes(report.cost)) return false;
  // Keeps a start that fits the modes unless a better one fits them too.
  const bool fits = by_rates || piece.begin_obeys_modes();
  const bool cancels = piece.target_force > most_cancellation * piece.begin_force;
  const bool solved = (!fits || cancels || lets_go()) && solve_begin(report.cost);
  if (!solved && !fits) return false;
  if (solved) {
    bool leads_on = true;
    if (tableau) {
      leads_on = find_target(report.cost);
    } else {
      piece.take_target();  // the same target from another start
    }
    if (leads_on) piece.look_ahead(changes);
    if (!fits) leads_on = leads_on && jump(report);
    if (!leads_on) {
      std::swap(piece.begin, next);
      return false;
    }
  }
  std::vector<ContactMode>& before = solved ? next.mode : piece.begin.mode;
  if (events != nullptr) {
    for_each_difference(mode, before, [&](std::size_t c) {
      events->push_back({reached, static_cast<int>(c), before[c], mode[c]});
      return true;
    });
  }
  before = mode;
  if (solved && visit) visit({.begin = next, .end = piece.begin, .fraction = reached, .linear = true});
  inside_piece = true;
  return true;
}

/// Guesses the modes of the next piece from the limits that ended the last one, at the start of `piece`.
void EventFollower::Workspace::flip_at_event() {
  flipped.clear();
  for (const ModeLimit& limit : piece.limits) {
    mode[static_cast<std::size_t>(limit.contact)] = limit.to;
    flipped.push_back(limit.contact);
  }
  first_touch = extremes_of(piece.begin.normal_force).most <= piece.force_tolerance;
  if (!first_touch) return;
  flipped.clear();  // any contact may have to change
  for_each_contact(problem, [&](const CoulombContact& contact) {
    ContactMode& m = mode[static_cast<std::size_t>(contact.index)];
    if (m == ContactMode::open && piece.begin.gap[contact.index] <= displacement_tolerance) m = ContactMode::stick;
  });
}

void EventFollower::forget() {
  if (workspace_->tableau) workspace_->tableau->forget();
}

void EventFollower::set_out(const LoadingPath& path, const std::vector<ContactMode>& mode, double start) {
  Workspace& w = *workspace_;
  w.path = path;
  if (w.tableau) w.tableau->set_path(path);
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
  const ContactState* halted = &state;  // state inside the piece at the last call
  if (!w.inside_piece) {
    w.piece.begin = state;
    halted = nullptr;
  }
  for (;;) {
    StraightPiece& piece = w.piece;
    if (!w.inside_piece && !w.begin_piece(visit, events, report)) break;
    const double event = piece.end_fraction();
    report.arrived = fraction <= event;
    const double end = report.arrived ? fraction : event;
    piece.at(report.arrived ? piece.part_at(fraction) : piece.end_part, w.next);
    if (visit) visit({.begin = halted ? *halted : piece.begin, .end = w.next, .fraction = end, .linear = true});
    halted = nullptr;
    events_here = event > w.reached ? 0 : events_here + 1;
    w.reached = end;
    if (report.arrived) break;
    std::swap(piece.begin, w.next);
    w.inside_piece = false;
    // Contacts that keep changing at one point never settle.
    if (w.events_passed == w.options.max_events || events_here > w.problem.contacts()) break;
    w.flip_at_event();
    ++w.events_passed;
  }
  std::swap(state, report.arrived ? w.next : w.piece.begin);
  if (w.tableau && !w.complete(state, report.cost)) report.arrived = false;
  report.fraction = w.reached;
  report.events = w.events_passed - events_before;
  return report;
}

}  // namespace bumpfoil
