#include "bumpfoil/contact/events.hpp"

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Part of what is asked for that is taken to see which modes follow an event: short enough for no other event to fall
/// into it, long enough for its slips and forces to stand clear of roundings. Grows by a factor where it does not help.
constexpr double smallest_probe = 1e-4;
constexpr double probe_growth = 4.0;
/// Probes of one call before it is given up: many more than any response needs.
constexpr int most_probes = 1000;

}  // namespace

EventStepper::EventStepper(const ContactProblem& problem)
    : follower_(problem, make_mode_system(problem)), newton_(problem) {
  BUMPFOIL_ASSERT(!problem.law);  // between two events the response would not be linear
}

void EventStepper::set_out(const ContactLoading& from, const ContactLoading& to, const ContactState& state) {
  from_ = from;
  to_ = to;
  start_ = fraction_ = 0.0;
  follower_.set_out(from, to, state.mode);
}

/// What follower_ sees of the path began at start_.
FollowReport EventStepper::follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                     std::vector<ContactEvent>& events) {
  const double length = 1.0 - start_;
  const std::size_t known = events.size();
  FollowReport report = follower_.follow_to(fraction < 1.0 ? (fraction - start_) / length : 1.0, state, visit, &events);
  for (std::size_t i = known; i < events.size(); ++i) events[i].fraction = start_ + events[i].fraction * length;
  report.fraction = report.arrived ? fraction : start_ + report.fraction * length;
  fraction_ = report.fraction;
  return report;
}

IncrementReport EventStepper::advance_to(double fraction, ContactState& state, const PartVisitor& visit,
                                         std::vector<ContactEvent>& events) {
  IncrementReport report;
  const double first_probe = smallest_probe * (fraction - fraction_);
  double probe = first_probe;
  const auto follow = [&] {
    const FollowReport followed = follow_to(fraction, state, visit, events);
    report.solve += followed.solve;
    return followed.arrived;
  };
  const auto set_out_again = [&](const std::vector<ContactMode>& mode) {
    start_ = fraction_;
    follower_.set_out(interpolate(from_, to_, start_), to_, mode);
  };

  ContactState probed;
  bool arrived = follow();
  for (int probes = 0; !arrived; ++probes) {
    report.solve.converged = false;
    if (probes == most_probes) return report;
    const double before = fraction_;
    const double end = std::min(fraction, before + probe);
    report.solve += newton_.solve(interpolate(from_, to_, end), state, probed);
    if (!report.solve.converged) return report;
    set_out_again(probed.mode);
    arrived = follow();
    if (arrived || fraction_ > before) {
      probe = first_probe;
      continue;
    }

    // The modes do not lead on from here: take the small increment itself.
    if (visit) visit(state, probed);
    for (std::size_t c = 0; c < probed.mode.size(); ++c) {
      if (state.mode[c] != probed.mode[c]) {
        events.push_back({end, static_cast<int>(c), state.mode[c], probed.mode[c]});
      }
    }
    std::swap(state, probed);
    fraction_ = end;
    probe *= probe_growth;
    ++report.substeps;
    set_out_again(state.mode);
    arrived = end >= fraction || follow();
  }
  report.solve.converged = true;
  return report;
}

}  // namespace bumpfoil
