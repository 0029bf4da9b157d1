#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bumpfoil/ensemble/ensemble_statistics.hpp"
#include "bumpfoil/ensemble/ensemble_yield.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Names of the files that an ensemble writes.
std::vector<std::string> ensemble_file_names();

/// How the run of an ensemble ended: interrupted if samples are missing, else failed if any failed, else complete.
/// @param stopped  it was interrupted
RunStatus status_of(const EnsembleStatistics& statistics, bool stopped);

/// Stages ensemble.nc and summary.json, as docs/results.md describes them, with one run id.
/// @throws Error (file)
void stage_ensemble(const Case& input, const EnsembleLayout& layout, const RowLog& log,
                    const EnsembleStatistics& statistics, const EnsembleYields& yields, RunStatus status,
                    const Provenance& provenance, ResultFolder& folder);

}  // namespace bumpfoil
