#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bumpfoil/io/ensemble_statistics.hpp"
#include "bumpfoil/io/ensemble_yield.hpp"
#include "bumpfoil/io/result_folder.hpp"
#include "bumpfoil/io/result_netcdf.hpp"
#include "bumpfoil/io/summary.hpp"

namespace bumpfoil {

/// Names of the files that an ensemble writes.
std::vector<std::string> ensemble_file_names();

/// How the run of an ensemble ended: interrupted if samples are missing, else failed if any failed, else complete.
/// @param stopped  it was interrupted
RunStatus status_of(const EnsembleStatistics& statistics, bool stopped);

/// Stages ensemble.nc and summary.json, as docs/results.md describes them, with one run id.
/// @throws Error (file)
void stage_ensemble(const Case& input, const EnsembleLayout& layout, const EnsembleLog& log,
                    const EnsembleStatistics& statistics, const EnsembleYields& yields, RunStatus status,
                    const Provenance& provenance, ResultFolder& folder);

/// The case of a stored sample, to be run again in full. What is done to the bearing may be another than in the
/// ensemble; the bearing itself may not. Where `command` is that of the ensemble and the case names no solver, the
/// sample has that of the ensemble.
/// @param file   an ensemble.nc, summary.json beside it   @param input  the case that the ensemble was drawn for
/// @param command  what is to be run of the sample
/// @throws Error (file) if it cannot be read, or has not the checksum that summary.json lists; Error (input) if it has
/// no such sample, or is of another bearing
Case read_sampled_case(const std::filesystem::path& file, std::size_t number, const Case& input,
                       EnsembleCommand command);

}  // namespace bumpfoil
