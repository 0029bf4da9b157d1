#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/linear_systems.hpp"
#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

/// A change of mode of one contact.
struct ContactEvent {
  double fraction{};  ///< where on the path it happened, 0 at its start and 1 at its end
  int contact{};
  ContactMode from{};
  ContactMode to{};
};

/// How far a path was followed.
struct FollowReport {
  bool reached_end{};  ///< false where the modes after an event could not be found
  double fraction{};   ///< how far the path was followed, 0..1
  int pieces{};        ///< linear pieces between events
  SolveReport solve;
};

/// Tolerances of following: what counts as touching, resting or zero.
struct FollowOptions {
  double displacement_tolerance{1e-13};  ///< m
  double force_tolerance{1e-11};         ///< of max(largest contact force, 1 N)
  int max_mode_updates{10};              ///< rounds of settling the modes after one event
  int max_pieces{100000};                ///< pieces of one path
};

/// Follows the response to a straight loading path from event to event. Unilateral contact and Coulomb friction in the
/// plane are piecewise linear, so that between two events (a contact closes, opens, begins or ceases to slip) one
/// linear solve describes everything; the result does not depend on any increment.
///
/// After an event the rates decide: a contact at its friction bound goes on slipping where its velocity agrees with its
/// friction force and sticks otherwise; one that touches without force closes or opens. All contacts that may choose
/// are settled together, starting from their last modes.
class EventFollower {
 public:
  /// @param modes  linear system of the problem; may be shared with other solvers that are not at work meanwhile
  EventFollower(const ContactProblem& problem, std::shared_ptr<ModeSystem> modes,
                const FollowOptions& options = FollowOptions());
  ~EventFollower();

  /// Follows the response from `state` to the loading `end`, which it approaches linearly.
  /// @param state   start of the path; on return its end, or the last event that was reached
  /// @param visit   receives the linear pieces, both ends with the modes of the piece; may be empty
  /// @param events  receives the changes of mode in their order; may be null
  /// @param guess   modes to begin with instead of those of `state`; may be null
  [[nodiscard]] FollowReport follow(const ContactLoading& end, ContactState& state, const PartVisitor& visit = {},
                                    std::vector<ContactEvent>* events = nullptr,
                                    const std::vector<ContactMode>* guess = nullptr);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
