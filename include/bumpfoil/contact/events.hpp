#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/event_follower.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/path_follower.hpp"

namespace bumpfoil {

/// Goes along straight loading paths from event to event, exactly; where the follower cannot tell the next modes, a
/// small increment of the exact solver shows them. Where even these do not lead on, the increment stands in the
/// response if that is straight there, W = E_end - E_begin + D; if not, it is halved until it is, or until it is no
/// more than a place: there the response jumps, and what it gives off counts as dissipated. Shorter increments that the
/// exact solver cannot take make the shortest that it can such a place. `substeps` counts the small increments that
/// stand in the response; none in an exact one.
class EventStepper final : public PathFollower {
 public:
  explicit EventStepper(const SharedProblem& problem);
  /// @param modes  linear system of the problem; may be shared with others that are not at work meanwhile
  EventStepper(const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes);

  [[nodiscard]] SolverBounds bounds() const override { return newton_.bounds(); }
  [[nodiscard]] SolveReport assemble(const ContactLoading& loading, const ContactState& unstressed,
                                     ContactState& state) override;
  void set_out(const LoadingPath& path, const ContactState& state) override;
  [[nodiscard]] const LoadingPath& path() const override { return path_; }
  [[nodiscard]] FollowReport follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                       std::vector<ContactEvent>& events) override;

 private:
  bool follow_events(double fraction, ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events,
                     FollowReport& report);
  [[nodiscard]] bool stands(const ContactState& state, const ContactState& end, bool is_place,
                            FollowReport& report) const;

  SharedProblem problem_;
  EventFollower follower_;
  NewtonSolver newton_;
  LoadingPath path_;
  double fraction_{};  ///< of the path that lies behind
};

}  // namespace bumpfoil
