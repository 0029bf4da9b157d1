#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/path_follower.hpp"
#include "contact/event_follower.hpp"

namespace bumpfoil {

/// See make_event_stepper.
class EventStepper final : public PathFollower {
 public:
  explicit EventStepper(const SharedProblem& problem);
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
