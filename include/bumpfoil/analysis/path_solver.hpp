#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/events.hpp"
#include "bumpfoil/contact/solver.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The solver that a case names, made for a problem: increment by increment, or from event to event.
class PathSolver {
 public:
  PathSolver(const SolverSettings& settings, const ContactProblem& problem);

  /// True if the parts of an increment are linear pieces between events.
  [[nodiscard]] bool follows_events() const { return events_ != nullptr; }

  /// True if every state must meet the bounds of contact/residual.hpp; false if the solver states bounds of its own.
  [[nodiscard]] bool is_exact() const { return exact_; }

  /// One step from the unstressed foils to the first loading.
  [[nodiscard]] SolveReport assemble(const ContactLoading& loading, const ContactState& unstressed,
                                     ContactState& state);

  /// Begins the straight path from the loading `from`, which `state` is the response to, to the loading `to`.
  void set_out(const ContactLoading& from, const ContactLoading& to, const ContactState& state);

  /// One increment: goes on to `fraction` of the whole path, beyond the last; a failure ends the path. Increments are
  /// halved where the solver fails, see advance() and EventStepper.
  /// @param state   where the last increment ended, or the path began
  /// @param visit   receives the parts of the increment
  /// @param events  receives the changes of mode if events are followed, with the fractions of the whole path
  [[nodiscard]] IncrementReport advance_to(double fraction, ContactState& state, const PartVisitor& visit,
                                           std::vector<ContactEvent>& events);

 private:
  bool exact_;
  std::unique_ptr<ContactSolver> increments_;
  std::unique_ptr<EventStepper> events_;
  ContactLoading from_, to_, reached_;
};

}  // namespace bumpfoil
