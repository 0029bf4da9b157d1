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
/// Maximum number of probes per call: many more than any response needs.
constexpr int most_probes = 1000;
/// Fraction of the path that counts as a point: a response that is not linear within it is a jump.
constexpr double shortest_probe = 1e-10;
/// Maximum ratio of the largest force so far to the current forces without another exact solve. Forces on a piece are
/// exact to 1e-11 of their largest; results are required to 1e-9.
constexpr double most_fallen = 30.0;
/// The same ratio for tableau rates, which accumulate errors.
constexpr double most_fallen_by_tableau = 3.0;
/// Apparent energy gain accepted for a jump, in units of negligible_energy(): its end states are not exact.
constexpr double most_gained = 100.0;

/// Records the contacts whose mode in `to` differs from that in `from`.
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
  double fraction_{};       ///< completed fraction of the path
  Vector slip_origin_;      ///< unknowns at the start of the last part of the response
  double largest_force_{};  ///< since the assembly, N
};

EventStepper::EventStepper(const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes, Rates rates)
    : problem_(problem),
      follower_(problem, modes, {.rates = rates}),
      newton_(problem, modes, {.max_events = 0}),  // fallback if following fails
      most_fallen_(rates == Rates::by_tableau ? most_fallen_by_tableau : most_fallen) {
  BUMPFOIL_ASSERT(!problem->law);  // otherwise the response would not be linear between events
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

/// Whether the small increment from `state` to `end` is acceptable: a straight piece, or a jump.
/// @param is_place  the increment is too short to be resolved further
bool EventStepper::stands(const ContactState& state, const ContactState& end, bool is_place,
                          FollowReport& report) const {
  const PieceEnergy energy = piece_energy(*problem_, state, end);
  const double negligible = negligible_energy(*problem_, state, end);
  if (std::abs(energy.defect()) <= negligible) return true;
  if (!is_place || energy.given_off < -most_gained * negligible) return false;
  report.jump_dissipation += energy.defect();
  return true;
}

/// Solves exactly for a state that violates the bounds. Forces on a piece carry the tolerance and round-off of the
/// largest of them, which may be too coarse for small forces at its end.
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
  double bent_until = fraction_;  // end of the last rejected small increment
  ContactState probed;
  Vector probed_from;
  bool jumped = false;  // the follower would repeat its jump
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
      // There is no nearer state: only the next state is known, not the path to it.
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
      // If it jumps and gets no further, the next small increment starts after the jump.
      jumped = state.x != probed_from;
      if (jumped) continue;
    }

    // No modes continue from here: accept this small increment or a smaller one.
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
