#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/path_follower.hpp"

namespace bumpfoil {

/// How far a path was followed.
struct EventProgress {
  bool arrived{};             ///< false if the modes after an event were not found
  double fraction{};          ///< completed fraction of the path, 0..1
  int events{};               ///< number of points with mode changes on the way
  double jump_dissipation{};  ///< see FollowReport
  SolveCost cost;
};

/// Settings of following.
struct FollowOptions {
  int max_events{100000};  ///< number of points with mode changes on one path
  Rates rates{Rates::by_solves};
};

/// Follows the response to a straight loading path from event to event. Unilateral contact and Coulomb friction in the
/// plane are piecewise linear, so that between two events (a contact closes, opens, begins or ceases to slip) one
/// linear solve describes everything: where the piece would lead by the end of the path. States on the way are
/// interpolated, and the result does not depend on where the path is halted.
///
/// After an event the rates decide: a contact at its friction bound keeps sliding if its velocity agrees with its
/// friction force and sticks otherwise; one that touches without force closes or opens. All contacts that may change
/// are settled together, starting from their last modes. At first touch of unloaded foils most contacts touch without
/// force and may change: they start closed, since compressed foils rest on more contacts than they open.
class EventFollower {
 public:
  /// @param modes linear system of the problem; may be shared with other solvers that are idle meanwhile
  EventFollower(const SharedProblem& problem, std::shared_ptr<ModeSystem> modes,
                const FollowOptions& options = FollowOptions());
  ~EventFollower();

  /// Forgets all previous paths: subsequent results are bit-identical to those after construction.
  void forget();

  /// Starts a path, or continues along it with other modes.
  /// @param mode initial modes: those of the state at `start`, or a better guess
  /// @param start  completed fraction of the path
  void set_out(const LoadingPath& path, const std::vector<ContactMode>& mode, double start = 0.0);

  /// Continues along the path. If it does not arrive, the path must be restarted with better modes.
  /// @param fraction  of the whole path where to halt; not before the last
  /// @param state     what the last call left, or the start of the path; on return the state at `fraction`, or at the
  ///   last event that was reached
  /// @param visit     receives the linear pieces, both ends with the modes of the piece (by_tableau: of x the
  /// tangential
  ///   unknowns alone); may be empty
  /// @param events    receives the changes of mode in their order; may be null
  [[nodiscard]] EventProgress follow_to(double fraction, ContactState& state, const PartVisitor& visit = {},
                                        std::vector<ContactEvent>* events = nullptr);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
