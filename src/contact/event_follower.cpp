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

/// Rounds of settling the modes after one event, and where foils that carried nothing are touched.
constexpr int most_rounds = 10;
constexpr int most_rounds_at_first_touch = 30;
/// Rounds right after an event that make_changes() may take in addition to these.
constexpr int rounds_by_solves = 1;
constexpr int rounds_by_tableau = 8;

/// Forces that decrease keep the round-off of the larger ones, about 1e-13 of them: how many times larger the forces at
/// the end of a piece may be than those at its start. States stay exact to 1e-11 then.
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
  std::unique_ptr<ContactTableau> tableau;  ///< null where rates are found by solves
  bool by_rates{};                          ///< the target was found with it, from a start that obeys the modes
  LoadingPath path;
  ContactLoading here;  ///< at `reached`
  double reached{};     ///< fraction of the path that lies behind
  int events_passed{};  ///< on this path
  StraightPiece piece;
  bool inside_piece{};            ///< the piece leads on from `reached`
  std::vector<ContactMode> mode;  ///< of the piece, or the guess for the next
  bool first_touch{};  ///< at `reached` foils that carried nothing are touched: all that touches is tried closed
  ContactState next;   ///< where the path is halted, or the state before a piece that begins with another
  ContactState whole;  ///< room for complete()
  std::vector<Eigen::Index> flipped;  ///< contacts of the last event
  std::vector<ModeChange> changes;
};

EventFollower::EventFollower(const SharedProblem& problem, std::shared_ptr<ModeSystem> modes,
                             const FollowOptions& options)
    : workspace_(std::make_unique<Workspace>(problem, std::move(modes), options)) {}

EventFollower::~EventFollower() = default;

/// One contact that changes its mode may reverse a whole row of others, which reverse again once its neighbours have
/// changed theirs. Drops the changes far from the event, unless there are no others.
void EventFollower::Workspace::keep_changes_nearby() {
  const auto block_of = [this](Eigen::Index c) { return problem.sites[static_cast<std::size_t>(c)].block; };
  const auto is_far = [&](const ModeChange& change) {
    return std::none_of(flipped.begin(), flipped.end(),
                        [&](Eigen::Index c) { return std::abs(block_of(change.contact) - block_of(c)) <= 1; });
  };
  const auto far = std::remove_if(changes.begin(), changes.end(), is_far);
  if (far != changes.begin()) changes.erase(far, changes.end());
}

/// Finds the end of the piece in its modes: by rates from a start that obeys them, by a solve from any other, which is
/// not part of the piece.
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

/// Makes all changes. With the tableau, where a change costs about as much as a round, it sticks only the slip that
/// reverses most: others often keep sliding once that one sticks.
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

/// Finds the modes of the piece, and where it leads.
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

/// Begins the piece with the exact state of its modes, and leaves the state so far in `next`. They differ where the
/// response jumps (foils snap), where contacts that lose their last force together did so within round-off, where it
/// was less than counts as a force, and by the round-off of interpolated values.
/// @return false where that state contradicts its modes: then it was no jump that these contacts could make, and
/// nothing has changed
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

/// Whether the foils are released: from this event on nothing carries a force. The residual force at the event counts
/// as none, although it can hold a long thin top foil a nanometre off its free position.
bool EventFollower::Workspace::lets_go() const {
  return !tableau && piece.target_force <= piece.force_tolerance && mode != piece.begin.mode;
}

/// Finds all unknowns of a state reached with the matrix of contacts, which describes contacts only.
/// @return false if there are none
bool EventFollower::Workspace::complete(ContactState& state, SolveCost& cost) {
  path.at(reached, here);
  if (!solve_modes(*modes, state.mode, here, state.x, whole, cost)) return false;
  std::swap(state, whole);
  return true;
}

/// Records the energy dissipated by the jump from `next` to the start of the piece.
/// @return false where it gains energy, as no jump does, or where other modes lead on behind it: contacts may have
/// slipped further than the piece leads
bool EventFollower::Workspace::jump(EventProgress& report) {
  if (!changes.empty()) return false;
  if (tableau && !complete(next, report.cost)) return false;
  const PieceEnergy energy = piece_energy(problem, next, piece.begin);
  const double negligible = negligible_energy(problem, next, piece.begin);
  if (std::abs(energy.defect()) > negligible) report.jump_dissipation += energy.defect();
  return energy.given_off >= -negligible;
}

/// Settles the modes of the next piece at its start, which is the state reached on the path.
/// @return false if they cannot be determined; the start is unchanged
bool EventFollower::Workspace::begin_piece(const PartVisitor& visit, std::vector<ContactEvent>* events,
                                           EventProgress& report) {
  piece.begin_fraction = reached;
  piece.measure_begin(problem);
  if (!settle_modes(report.cost)) return false;
  // A state that fits the modes is kept unless a better one fits them too.
  const bool fits = by_rates || piece.begin_obeys_modes();
  const bool cancels = piece.target_force > most_cancellation * piece.begin_force;
  const bool solved = (!fits || cancels || lets_go()) && solve_begin(report.cost);
  if (!solved && !fits) return false;
  if (solved) {
    bool leads_on = true;
    if (tableau) {
      leads_on = find_target(report.cost);
    } else {
      piece.take_target();  // the same, from another begin
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

/// Guesses the modes of the next piece from the limits of the last one, which ended where `piece` now starts.
void EventFollower::Workspace::flip_at_event() {
  flipped.clear();
  for (const ModeLimit& limit : piece.limits) {
    mode[static_cast<std::size_t>(limit.contact)] = limit.to;
    flipped.push_back(limit.contact);
  }
  first_touch = extremes_of(piece.begin.normal_force).most <= piece.force_tolerance;
  if (!first_touch) return;
  flipped.clear();  // all may have to change
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
  const ContactState* halted = &state;  // inside the piece, by the last call
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
    // Contacts that keep changing at one point would do so forever.
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
