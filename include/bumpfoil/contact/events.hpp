#pragma once

#include <vector>

#include "bumpfoil/contact/event_follower.hpp"
#include "bumpfoil/contact/newton.hpp"

namespace bumpfoil {

/// Advances along straight loading paths from event to event, exactly; where the follower cannot tell the next modes,
/// a small increment of the exact solver shows them.
class EventStepper {
 public:
  explicit EventStepper(const ContactProblem& problem);

  /// Advances `state` from `from` to `to`.
  /// @param visit   receives the linear pieces of the response; may be empty
  /// @param events  receives the changes of mode, fractions from 0 at `from` to 1 at `to`
  /// @return `substeps` counts the small increments that stand in the response because even the modes they show could
  ///   not be followed; none in an exact response
  [[nodiscard]] IncrementReport advance(const ContactLoading& from, const ContactLoading& to, ContactState& state,
                                        const PartVisitor& visit, std::vector<ContactEvent>& events);

 private:
  EventFollower follower_;
  NewtonSolver newton_;
};

}  // namespace bumpfoil
