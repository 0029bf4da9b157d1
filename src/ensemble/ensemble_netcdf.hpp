#pragma once

#include <filesystem>
#include <string_view>

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/ensemble_log.hpp"
#include "bumpfoil/experiments/cycle/cycle_files.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Writes ensemble.nc: what was drawn and what came of it, with the dimensions sample and direction, in pieces that do
/// not grow with the number of samples. Not thread-safe, as netCDF is not.
/// @param message  what keeps the results from being complete
/// @throws Error (file)
void write_ensemble_netcdf(const std::filesystem::path& path, const Case& input, const EnsembleLayout& layout,
                           const EnsembleLog& log, RunStatus status, std::string_view message,
                           const Provenance& provenance, std::string_view run_id);

}  // namespace bumpfoil
