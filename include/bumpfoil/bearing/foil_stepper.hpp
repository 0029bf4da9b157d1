#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/bearing_state.hpp"
#include "bumpfoil/bearing/energy.hpp"
#include "bumpfoil/bearing/tangents.hpp"

namespace bumpfoil {

class ModeSystem;

/// Makes what follows the contacts of a problem, on a linear system of it that it shares with its caller.
using FollowerMaker =
    std::function<std::unique_ptr<PathFollower>(const SharedProblem&, const std::shared_ptr<ModeSystem>&)>;

/// Advances foils from state to state. It holds a solver and its workspace but no states: they belong to the caller,
/// who keeps the new one or the old one. One thread at a time; as many steppers as threads share the foils.
///
/// In all functions `step` receives the result, its storage is reused, and it must not hold the state to start from.
class FoilStepper {
 public:
  /// @throws Error (input) if the bearing has a film
  FoilStepper(SharedBearing foils, const FollowerMaker& make_follower);

  /// Switches to other foils with the same stiffness and contacts; only their gaps may differ. An assembly must follow.
  /// @return false if these are others; then it keeps those it has
  [[nodiscard]] bool set_foils(const SharedBearing& foils);

  /// From the unstressed foils in one step. Work starts at zero; the dissipation is that of the assembly.
  void assemble(const Excitation& excitation, Step& step);

  /// One increment from `from` straight to the excitation `to`.
  void advance(const BearingState& from, const Excitation& to, Step& step);

  /// Begins the straight path from `from` to the excitation `end`. Increments of one path cost the event-driven solver
  /// less than paths of one increment.
  void set_out(const BearingState& from, const Excitation& end);

  /// One increment, on to `fraction` of the path that was set out on.
  /// @param from      where the last increment ended, or the path began; to leave the path, set out again
  /// @param fraction  beyond the last
  void advance_to(double fraction, const BearingState& from, Step& step);

  /// From the contact modes of `state` and the tangent of the foils.
  [[nodiscard]] TangentMatrices tangents(const BearingState& state);

  [[nodiscard]] const BearingModel& foils() const { return *foils_; }
  /// Whether increments are followed from one change of contact to the next.
  [[nodiscard]] bool follows_events() const { return follower_->follows_events(); }
  /// What converged states meet.
  [[nodiscard]] SolverBounds bounds() const { return follower_->bounds(); }

 private:
  SharedBearing foils_;
  std::shared_ptr<ModeSystem> modes_;  ///< shared with the follower: no other is made for tangents
  std::unique_ptr<PathFollower> follower_;
  FrictionDissipation dissipation_;
  Excitation path_begin_, path_end_;
  std::vector<ContactEvent> events_;
  ContactState rate_;
  Vector gap_change_;  ///< of the initial gaps, along the whole path
  double followed_{};  ///< fraction of the path that lies behind
  Vector mean_force_;  ///< of a part of the response
};

}  // namespace bumpfoil
