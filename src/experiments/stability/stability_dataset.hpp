#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// The run over the dimensions speed, contacts, mode, bearing and station; without motions, over speed only, as stored
/// in sweeps. The result must outlive it.
Dataset stability_dataset(const StabilityResult& result, bool with_motions = true);

/// Dimensions of a motion: speed, contacts and mode.
std::vector<std::string> motion_dimensions();

/// Entries of each motion along these, speed by speed, with the fastest growing first.
/// @param with_all_speeds  whether speeds without a motion have a row, too
std::vector<std::vector<std::size_t>> motion_rows(const StabilityResult& result, bool with_all_speeds);

/// Columns of motions in summary.json.
std::vector<std::string> motion_columns();

/// Rows of stability.csv: one for each motion at each speed, and one for each speed without motions.
Table motion_table(const StabilityResult& result);

}  // namespace bumpfoil
