#include "bumpfoil/io/cycle_files.hpp"

#include <fmt/format.h>

#include <random>

#include "bumpfoil/io/checksum.hpp"
#include "bumpfoil/io/cycle_csv.hpp"

namespace bumpfoil {
namespace {

/// 128 bits from the system.
std::string make_run_id() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

}  // namespace

std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance) {
  const std::string run_id = make_run_id();
  std::vector<ResultFile> files;
  files.push_back({result.experiment == Experiment::strip ? "strip.csv" : "cycle.csv", cycle_csv(result)});
  files.push_back({"result.nc", result_netcdf(input, result, status, provenance, run_id)});
  Manifest manifest{run_id, {}};
  for (const ResultFile& file : files) {
    manifest.files.push_back({file.name, file.contents.size(), xxh3_128(file.contents)});
  }
  files.push_back({"summary.json", summary_json(input, result, status, manifest)});
  return files;
}

}  // namespace bumpfoil
