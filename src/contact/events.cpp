#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/path_follower.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/extremes.hpp"
#include "contact/event_follower.hpp"
#include "contact/piece_energy.hpp"

namespace bumpfoil {
namespace {

/// Fraction of the requested path that is probed for the modes after an event: short enough to contain no other event,
/// long enough for its slips and forces to exceed round-off. Grows by a factor if it does not help.
constexpr double first_probe = 1e-4;
constexpr double probe_growth = 4.0;
/// Probes of one call before it is given up: many more than any response needs.
constexpr int most_probes = 1000;
/// Fraction of the path that counts as a point: a response that is not linear within it is a jump.
constexpr double shortest_probe = 1e-10;
/// Forces on a piece are exact to 1e-11 of the largest of them, results are to be to 1e-9: how many times less than the
/// largest so far forces may be without a second look.
constexpr double most_fallen = 30.0;
/// The same where errors of rates have added up.
constexpr double most_fallen_by_tableau = 3.0;
/// Energy that a jump may seem to gain, in units of what is negligible: states at its ends are not exact.
constexpr double most_gained = 100.0;

/// Writes down which contacts have another mode in `to` than in `from`.
void add_events(const ContactState& from, const ContactState& to, double fraction, std::vector<ContactEvent>& events) {
  for (std::size_t c = 0; c < to.mode.size(); ++c) {
    if (from.mode[c] != to.mode[c]) events.push_back({fraction, static_cast<int>(c), from.mode[c], to.mode[c]});
  }
}

class EventStepper final : public PathFollower {
 public:
  EventStepper(const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes, Rates rates);

  [[nodiscard]] SolverBounds bounds() const override { return newton_.bounds(); }
  [[nodiscard]] bool follows_events() const override { return true; }
  [[nodiscard]] SolveReport assemble(const ContactLoading& loading, const ContactState& unstressed,
                                     ContactState& state) override;
  void set_out(const LoadingPath& path, const ContactState& state) override;
  [[nodiscard]] const LoadingPath& path() const override { return path_; }
  [[nodiscard]] FollowReport follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                       std::vector<ContactEvent>& events) override;

 private:
  void go_to(double fraction, ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events,
             FollowReport& report);
  bool follow_events(double fraction, ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events,
                     FollowReport& report);
  void settle(ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events, FollowReport& report);
  [[nodiscard]] bool stands(const ContactState& state, const ContactState& end, bool is_place,
                            FollowReport& report) const;

  SharedProblem problem_;
  EventFollower follower_;
  NewtonSolver newton_;
  double most_fallen_;
  LoadingPath path_;
  double fraction_{};       ///< of the path that lies behind
  Vector slip_origin_;      ///< unknowns where the last part of the response began
  double largest_force_{};  ///< since the assembly, N
};

EventStepper::EventStepper(const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes, Rates rates)
    : problem_(problem),
      follower_(problem, modes, {.rates = rates}),
      newton_(problem, modes, {.max_events = 0}),  // used where following fails
      most_fallen_(rates == Rates::by_tableau ? most_fallen_by_tableau : most_fallen) {
  BUMPFOIL_ASSERT(!problem->law);  // between two events the response would not be linear
}

SolveReport EventStepper::assemble(const ContactLoading& loading, const ContactState& unstressed, ContactState& state) {
  largest_force_ = 0.0;
  follower_.forget();
  return newton_.solve(loading, unstressed, state);
}

void EventStepper::set_out(const LoadingPath& path, const ContactState& state) {
  path_ = path;
  fraction_ = 0.0;
  follower_.set_out(path_, state.mode);
}

bool EventStepper::follow_events(double fraction, ContactState& state, const PartVisitor& visit,
                                 std::vector<ContactEvent>& events, FollowReport& report) {
  const EventProgress followed = follower_.follow_to(fraction, state, visit, &events);
  fraction_ = followed.fraction;
  report.cost += followed.cost;
  report.jump_dissipation += followed.jump_dissipation;
  return followed.arrived;
}

/// Whether the small increment from `state` to `end` may stand in the response: it is straight, or a jump.
/// @param is_place  nothing is looked for within it
bool EventStepper::stands(const ContactState& state, const ContactState& end, bool is_place,
                          FollowReport& report) const {
  const PieceEnergy energy = piece_energy(*problem_, state, end);
  const double negligible = negligible_energy(*problem_, state, end);
  if (std::abs(energy.defect()) <= negligible) return true;
  if (!is_place || energy.given_off < -most_gained * negligible) return false;
  report.jump_dissipation += energy.defect();
  return true;
}

/// Makes a state exact that is not within the bounds. Forces on a piece have the tolerances and the round-off of the
/// largest of them, which may be too coarse for the small forces at its end.
void EventStepper::settle(ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events,
                          FollowReport& report) {
  const double left = std::max(1.0, extremes_of(state.normal_force).most);  // N, as in ContactResiduals
  if (largest_force_ <= most_fallen_ * left) return;
  const ContactLoading loading = path_.at(fraction_);
  const SolverBounds bound = bounds();
  const auto is_exact = [&] {
    return contact_residuals(*problem_, problem_->K.multiply(state.x), loading, slip_origin_, state)
        .within(bound.force, bound.displacement);
  };
  if (is_exact()) return;
  ContactState settled;
  const SolveReport solve = newton_.solve(loading, state, settled);
  report.cost += solve.cost;
  report.status = solve.status;
  if (!solve.converged()) return;
  if (visit) visit({.begin = state, .end = settled, .fraction = fraction_, .linear = true});
  add_events(state, settled, fraction_, events);
  slip_origin_ = state.x;
  state = std::move(settled);
  follower_.set_out(path_, state.mode, fraction_);
  if (!is_exact()) report.status = Status::residual_above_bound;
}

FollowReport EventStepper::follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                     std::vector<ContactEvent>& events) {
  FollowReport report;
  const PartVisitor note = [&](const ResponsePart& part) {
    slip_origin_ = part.begin.x;
    largest_force_ = std::max(largest_force_, extremes_of(part.begin.normal_force).most);
    if (visit) visit(part);
  };
  go_to(fraction, state, note, events, report);
  if (report.converged()) settle(state, visit, events, report);
  return report;
}

void EventStepper::go_to(double fraction, ContactState& state, const PartVisitor& visit,
                         std::vector<ContactEvent>& events, FollowReport& report) {
  const double first = first_probe * (fraction - fraction_);
  double probe = first;
  double shortest = shortest_probe;
  double bent_until = fraction_;  // the last rejected small increment ended here
  ContactState probed;
  Vector probed_from;
  bool jumped = false;  // the follower would jump again
  bool arrived = follow_events(fraction, state, visit, events, report);
  for (int probes = 0; !arrived; ++probes) {
    report.status = Status::no_modes;
    if (probes == most_probes) return;
    const double before = fraction_;
    const double end = std::min(fraction, before + probe);
    probed_from = state.x;
    const SolveReport solve = newton_.solve(path_.at(end), state, probed);
    report.cost += solve.cost;
    if (!solve.converged()) {
      // There is no nearer state: only the next state is known, not the way to it.
      if (end >= fraction) return;
      shortest = probe = 2.0 * probe;
      continue;
    }
    if (!jumped) {
      follower_.set_out(path_, probed.mode, fraction_);
      arrived = follow_events(fraction, state, visit, events, report);
      if (arrived || fraction_ > before) {
        shortest = shortest_probe;
        probe = first;
        continue;
      }
      // If it jumps and gets no further, another small increment must start after the jump.
      jumped = state.x != probed_from;
      if (jumped) continue;
    }

    // No modes continue from here: take the small increment itself, or a smaller one.
    const bool is_place = probe <= shortest;
    if (!stands(state, probed, is_place, report)) {
      if (is_place) {
        report.status = Status::energy_defect;
        return;
      }
      bent_until = end;
      probe = std::max(shortest, 0.5 * (end - before));
      continue;
    }
    visit({.begin = state, .end = probed, .fraction = end, .linear = true});
    add_events(state, probed, end, events);
    std::swap(state, probed);
    fraction_ = end;
    shortest = shortest_probe;
    probe = bent_until > end ? std::max(shortest, 0.5 * (bent_until - end)) : probe * probe_growth;
    ++report.substeps;
    jumped = false;
    follower_.set_out(path_, state.mode, fraction_);
    arrived = end >= fraction;
  }
  report.status = Status::converged;
}

}  // namespace

std::unique_ptr<PathFollower> make_event_stepper(const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes,
                                                 Rates rates) {
  return std::make_unique<EventStepper>(problem, modes, rates);
}

}  // namespace bumpfoil
