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

  /// One increment, halved where the solver fails; see advance() and EventStepper.
  /// @param visit   receives the parts of the increment
  /// @param events  receives the changes of mode if events are followed
  [[nodiscard]] IncrementReport advance(const ContactLoading& from, const ContactLoading& to, ContactState& state,
                                        const PartVisitor& visit, std::vector<ContactEvent>& events);

 private:
  bool exact_;
  std::unique_ptr<ContactSolver> increments_;
  std::unique_ptr<EventStepper> events_;
};

}  // namespace bumpfoil
