#pragma once

#include <optional>
#include <vector>

#include "bumpfoil/experiments/sampling.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The layout of the ensemble of a case, that of its montecarlo.command.
/// @throws Error (input) if there is no such command, or it is one of running bearings or rotors, and the case makes
/// none
EnsembleLayout make_ensemble_layout(const Case& input);

/// The row of a sample, not a number where something is not known.
/// @param places  what was found; nothing of a sample that is invalid: its status alone is known
std::vector<double> make_ensemble_row(const EnsembleLayout& layout,
                                      const std::optional<std::vector<SampledPlace>>& places);

}  // namespace bumpfoil
