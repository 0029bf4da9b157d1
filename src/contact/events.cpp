#include "bumpfoil/contact/events.hpp"

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Part of the path that is taken to see which modes follow an event: short enough for no other event to fall into it,
/// long enough for its slips and forces to stand clear of roundings. Grows by a factor where it does not help.
constexpr double smallest_probe = 1e-4;
constexpr double probe_growth = 4.0;
/// Probes of one step before it is given up: many more than any response needs.
constexpr int most_probes = 1000;

/// What happened in the last part of a path, on the scale of the whole path.
void append_events(const std::vector<ContactEvent>& part, double begin, std::vector<ContactEvent>& events) {
  for (ContactEvent event : part) {
    event.fraction = begin + event.fraction * (1.0 - begin);
    events.push_back(event);
  }
}

}  // namespace

EventStepper::EventStepper(const ContactProblem& problem)
    : follower_(problem, make_mode_system(problem)), newton_(problem) {
  BUMPFOIL_ASSERT(!problem.law);  // between two events the response would not be linear
}

IncrementReport EventStepper::advance(const ContactLoading& from, const ContactLoading& to, ContactState& state,
                                      const PartVisitor& visit, std::vector<ContactEvent>& events) {
  IncrementReport report;
  double fraction = 0.0;
  double probe = smallest_probe;
  std::vector<ContactEvent> part;
  ContactState probed;
  const auto follow = [&](const std::vector<ContactMode>* guess) {
    part.clear();
    const FollowReport followed = follower_.follow(to, state, visit, &part, guess);
    append_events(part, fraction, events);
    report.solve += followed.solve;
    if (followed.fraction > 0.0) probe = smallest_probe;
    fraction += followed.fraction * (1.0 - fraction);
    return followed.reached_end;
  };

  for (int probes = 0; !follow(nullptr); ++probes) {
    report.solve.converged = false;
    if (probes == most_probes) return report;
    const double before = fraction;
    const double end = std::min(1.0, fraction + probe);
    report.solve += newton_.solve(interpolate(from, to, end), state, probed);
    if (!report.solve.converged) return report;
    if (follow(&probed.mode)) break;
    if (fraction > before) continue;

    // The modes do not lead on from here: take the small increment itself.
    if (visit) visit(state, probed);
    for (std::size_t c = 0; c < probed.mode.size(); ++c) {
      if (state.mode[c] != probed.mode[c]) {
        events.push_back({end, static_cast<int>(c), state.mode[c], probed.mode[c]});
      }
    }
    std::swap(state, probed);
    fraction = end;
    probe *= probe_growth;
    ++report.substeps;
    if (fraction >= 1.0) break;
  }
  report.solve.converged = true;
  return report;
}

}  // namespace bumpfoil
