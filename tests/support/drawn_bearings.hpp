#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bumpfoil/core/status.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Bearing of this number, all of it drawn at random, as a function of the number alone: three trusses to one frame, of
/// 4 to 40 bumps of any rise, thickness, width and elasticity; clearance 0 to 60 um; friction 0 to 0.5 at each
/// interface, the same at both in every third; normal height scatter, its deviation 0 to 40 um; a push in any direction
/// up to 50 um into the foils and back, in 8 to 25 increments each way.
Case drawn_bearing(std::uint64_t number);

/// What became of one solver on one bearing, and what judges that know no solver say of it: the residual function at
/// every increment that was called converged, and the balance of energies over it.
struct SolverVerdict {
  Status status{Status::converged};  ///< what the solver says
  int substeps{};
  std::string wrong;  ///< what a judge refuses although the solver calls it converged; empty if nothing
};

struct BearingVerdict {
  SolverVerdict newton, events;
  /// Largest difference of their forces, as part of the largest force; absent unless they are compared and converged.
  std::optional<double> apart;
  /// The same with increments of `newton` cut small enough for them to agree, or as small as is tried; absent where
  /// they agree at once, or `newton` fails then.
  std::optional<double> apart_refined;
};

/// Solvers agree below this part of the largest force.
inline constexpr double agreement = 1e-2;

/// Runs a drawn bearing with both solvers.
/// @param compared  whether their forces are compared, too
BearingVerdict judge_bearing(const Case& input, bool compared);

}  // namespace bumpfoil
