#pragma once

#include <string>

#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// The run over the dimensions speed, contacts, mode, bearing and station; without motions, over speed only, as stored
/// in sweeps. The result must outlive it.
Dataset stability_dataset(const StabilityResult& result, bool with_motions = true);

/// Contents of stability.csv: one line for each motion at each speed, and one for each speed without motions.
std::string stability_csv(const StabilityResult& result);

}  // namespace bumpfoil
