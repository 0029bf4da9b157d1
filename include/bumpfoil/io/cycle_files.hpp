#pragma once

#include <string>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/io/result_netcdf.hpp"
#include "bumpfoil/io/summary.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A file of a result set, before it is written.
struct ResultFile {
  std::string name;
  std::string contents;
};

/// The files of a run, as docs/results.md describes them: cycle.csv or strip.csv, result.nc and summary.json. They
/// carry the same new run id, and summary.json the checksums of the others, so that readers can tell a whole set from a
/// damaged or mixed one.
///
/// netCDF is not thread-safe: to be called by one thread at a time.
std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance);

}  // namespace bumpfoil
