#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

class ModeSystem;

/// A straight piece of loading.
struct LoadingPath {
  ContactLoading begin, end;

  /// (1 - fraction) begin + fraction end.
  [[nodiscard]] ContactLoading at(double fraction) const;
  /// The same into `loading`, whose storage is reused.
  void at(double fraction, ContactLoading& loading) const;
};

/// A change of mode of one contact.
struct ContactEvent {
  double fraction{};  ///< of the path, 0 at its start and 1 at its end
  int contact{};
  ContactMode from{};
  ContactMode to{};
};

/// A part of the response to a path; parts join.
struct ResponsePart {
  const ContactState& begin;
  const ContactState& end;
  double fraction;  ///< of the path at its end; a jump takes none of it
  /// Forces and displacements vary linearly from begin to end, and the energies of all parts balance; otherwise the
  /// part is an increment, and the friction of its end acts throughout.
  bool linear;
};

using PartVisitor = std::function<void(const ResponsePart&)>;

/// How following a path ended.
struct FollowReport {
  Status status{Status::converged};
  SolveCost cost;
  int substeps{};             ///< solves in addition to those of the requested increments
  double jump_dissipation{};  ///< released in jumps, beyond friction, J; only where events are resolved

  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// How rates between two events are found.
enum class Rates {
  by_solves,  ///< states are exact to 1e-11 of the largest force
  /// In a matrix of all contacts, some times faster for short foils. Errors of rates, some 1e-11, add up from piece to
  /// piece. By solves all the same for long foils, and on processors without wide vectors, where it does not pay. Parts
  /// of the response contain of x the tangential unknowns alone; states that are returned are exact solutions for their
  /// modes.
  by_tableau,
};

/// Follows the response along straight paths of loading.
class PathFollower {
 public:
  virtual ~PathFollower() = default;

  /// What converged states meet.
  [[nodiscard]] virtual SolverBounds bounds() const = 0;

  /// Whether it goes from one change of contact to the next.
  [[nodiscard]] virtual bool follows_events() const { return false; }

  /// One step from the unstressed foils to the first loading.
  [[nodiscard]] virtual SolveReport assemble(const ContactLoading& loading, const ContactState& unstressed,
                                             ContactState& state) = 0;

  /// Starts a path; `state` is the response to its start.
  virtual void set_out(const LoadingPath& path, const ContactState& state) = 0;

  /// The path that was started last.
  [[nodiscard]] virtual const LoadingPath& path() const = 0;

  /// Continues to `fraction` of the path, beyond the last. A failure ends the path.
  /// @param state   where the last call ended, or the path began; on failure the last part that was found
  /// @param visit   receives the parts of the response; may be empty
  /// @param events  receives the changes of mode where the follower sees them
  [[nodiscard]] virtual FollowReport follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                               std::vector<ContactEvent>& events) = 0;
};

/// Takes each increment by one solve of `solver`. Where that fails, the state is restored, the increment is halved and
/// both halves are taken in turn, up to `max_halvings` times over.
std::unique_ptr<PathFollower> make_increment_follower(std::unique_ptr<ContactSolver> solver, int max_halvings = 8);

/// Goes along straight loading paths from event to event, exactly; if the next modes cannot be determined, a small
/// increment of the exact solver gives them. If even these do not lead on, the increment becomes part of the response
/// if that is linear there, W = E_end - E_begin + D; if not, it is halved until it is, or until it is a mere point:
/// there the response jumps, and the energy released counts as dissipated. The shortest increment that the exact solver
/// can solve is such a point, too. `substeps` counts the small increments in the response; an exact one has none.
///
/// The elastic forces must be linear, and the problem must have contacts.
/// @param modes linear system of the problem; may be shared with others that are idle meanwhile
std::unique_ptr<PathFollower> make_event_stepper(const SharedProblem& problem, const std::shared_ptr<ModeSystem>& modes,
                                                 Rates rates = Rates::by_solves);

}  // namespace bumpfoil
