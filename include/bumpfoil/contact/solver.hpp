#pragma once

#include <functional>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// What a solve cost and how it ended.
struct SolveReport {
  bool converged{};        ///< the state meets the solver's own bound
  int iterations{};        ///< linear solves: back-substitutions
  int factorisations{};    ///< of the system, from the first block that changed on; kept factors cost none
  int outer_iterations{};  ///< multiplier updates or interior-point steps; 0 where none was needed

  SolveReport& operator+=(const SolveReport& other);
};

/// Solves the contact problem of one increment.
class ContactSolver {
 public:
  virtual ~ContactSolver() = default;

  /// Finds the state under `loading` after `previous`, which friction refers to and which is the first guess. On
  /// failure `state` holds the last iterate, flagged by the report.
  /// @param state  result; its storage is reused
  [[nodiscard]] virtual SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                          ContactState& state) = 0;
};

/// An increment as it was taken: with how many extra solves.
struct IncrementReport {
  SolveReport solve;
  int substeps{};  ///< extra solves because the increment had to be halved
  /// Where the response jumps, all that the bodies give off is dissipated. By how much that is more than the friction
  /// f p |du| of the parts, J; told only by what follows events.
  double jump_dissipation{};
};

/// Called for every part of an increment, from the state at its begin to that at its end.
using PartVisitor = std::function<void(const ContactState& begin, const ContactState& end)>;

/// Advances `state` from `from` to `to`. Where the solver fails, the state is restored, the increment is halved (the
/// loading is interpolated) and both halves are taken in turn, up to `max_halvings` times over. On failure the state is
/// that of the last part that converged.
/// @param visit  receives the parts that converged: one where nothing had to be halved; may be empty
[[nodiscard]] IncrementReport advance(ContactSolver& solver, const ContactLoading& from, const ContactLoading& to,
                                      ContactState& state, const PartVisitor& visit = {}, int max_halvings = 8);

/// The loading at `fraction` of the way from `from` to `to`.
ContactLoading interpolate(const ContactLoading& from, const ContactLoading& to, double fraction);

}  // namespace bumpfoil
