#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bumpfoil/core/status.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Random bearing as a function of its number: three trusses to one frame, with 4 to 40 bumps of any rise, thickness,
/// width and elasticity; clearance 0 to 60 um; friction 0 to 0.5 at each interface, equal at both in every third;
/// normal height scatter with a standard deviation of 0 to 40 um; a push in any direction up to 50 um into the foils
/// and back, in 8 to 25 increments each way.
Case drawn_bearing(std::uint64_t number);

/// Outcome of one solver on one bearing, and of solver-independent checks: the residual function at every converged
/// increment, and the energy balance over it.
struct SolverVerdict {
  Status status{Status::converged};  ///< reported by the solver
  int substeps{};
  std::string wrong;  ///< failed check of a result reported as converged; empty if there is none
};

struct BearingVerdict {
  SolverVerdict newton, events;
  /// Largest difference of their forces, as part of the largest force; absent unless they are compared and converged.
  std::optional<double> apart;
  /// The same with increments of `newton` refined until they agree, or to the finest tried; absent if they agree
  /// immediately, or `newton` fails then.
  std::optional<double> apart_refined;
};

/// Solvers agree if they differ by less than this fraction of the largest force.
inline constexpr double agreement = 1e-2;

/// Runs a drawn bearing with both solvers.
/// @param compared  whether their forces are compared, too
BearingVerdict check_bearing(const Case& input, bool compared);

}  // namespace bumpfoil
