#pragma once

#include <vector>

#include "bumpfoil/contact/event_follower.hpp"
#include "bumpfoil/contact/newton.hpp"

namespace bumpfoil {

/// Advances along straight loading paths from event to event, exactly; where the follower cannot tell the next modes,
/// a small increment of the exact solver shows them. Where even these do not lead on, the increment stands in the
/// response if that is straight there, W = E_end - E_begin + D; if not, it is halved until it is, or until it is no
/// more than a place: there the response jumps, and what it gives off counts as dissipated. Shorter increments that the
/// exact solver cannot take make the shortest that it can such a place.
class EventStepper {
 public:
  explicit EventStepper(const ContactProblem& problem);

  /// Begins the path from the loading `from`, which `state` is the response to, to the loading `to`.
  void set_out(const ContactLoading& from, const ContactLoading& to, const ContactState& state);

  /// Goes on to `fraction` of the whole path, beyond the last; a failure ends the path.
  /// @param state   where the last call ended, or the path began; on failure the last event that was reached
  /// @param visit   receives the linear pieces of the response; may be empty
  /// @param events  receives the changes of mode, with the fractions of the whole path where they happened
  /// @return `substeps` counts the small increments that stand in the response because even the modes they show could
  ///   not be followed; none in an exact response
  [[nodiscard]] IncrementReport advance_to(double fraction, ContactState& state, const PartVisitor& visit,
                                           std::vector<ContactEvent>& events);

 private:
  bool follow_to(double fraction, ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events,
                 IncrementReport& report);
  void set_out_again(const std::vector<ContactMode>& mode);
  [[nodiscard]] bool stands(const ContactState& state, const ContactState& end, bool is_place,
                            IncrementReport& report) const;

  ContactProblem problem_;
  EventFollower follower_;
  NewtonSolver newton_;
  ContactLoading from_, to_;
  double start_{};     ///< fraction of the path where the follower set out
  double fraction_{};  ///< of the path that lies behind
};

}  // namespace bumpfoil
