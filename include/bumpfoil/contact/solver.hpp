#pragma once

#include "bumpfoil/contact/problem.hpp"
#include "bumpfoil/core/status.hpp"

namespace bumpfoil {

/// What solving cost.
struct SolveCost {
  int iterations{};        ///< linear solves: back-substitutions
  int factorisations{};    ///< of the system, from the first block that changed on; kept factors cost none
  int outer_iterations{};  ///< multiplier updates or interior-point steps; 0 where none was needed

  SolveCost& operator+=(const SolveCost& other);
  bool operator==(const SolveCost&) const = default;
};

/// How a solve ended, and what it cost.
struct SolveReport {
  Status status{Status::converged};
  SolveCost cost;

  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// What the converged states of a solver meet.
struct SolverBounds {
  double force;         ///< ContactResiduals::within; infinite where the solver states its own bounds
  double displacement;  ///< the same, m
  double load;          ///< a prescribed load is met to this part of max(load, 1 N): well above the residual
};

/// Solves the contact problem of one increment.
class ContactSolver {
 public:
  virtual ~ContactSolver() = default;

  [[nodiscard]] virtual SolverBounds bounds() const { return {.force = 1e-9, .displacement = 1e-12, .load = 1e-9}; }

  /// Finds the state under `loading` after `previous`, which friction refers to and which is the first guess. On
  /// failure `state` holds the last iterate, flagged by the report.
  /// @param state  result; its storage is reused
  [[nodiscard]] virtual SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                          ContactState& state) = 0;
};

}  // namespace bumpfoil
