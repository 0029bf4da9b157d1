#pragma once

#include <string>
#include <vector>

#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// Names of the files that a sweep writes.
std::vector<std::string> sweep_file_names(const Sweep& sweep);

/// The files of a sweep, as docs/results.md describes them: sweep.csv, sweep.nc and summary.json, of running
/// bearings coefficients.csv, too, with one run id and checksums, see result_files().
///
/// netCDF is not thread-safe: to be called by one thread at a time.
/// @param points  one for each case of the sweep; points and cycles that were not begun are flagged as such
/// @throws Error (file) if the memory does not suffice
std::vector<ResultFile> sweep_files(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                    const Provenance& provenance);

}  // namespace bumpfoil
