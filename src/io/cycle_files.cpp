#include "bumpfoil/io/cycle_files.hpp"

#include <fmt/format.h>

#include <new>
#include <random>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/checksum.hpp"
#include "bumpfoil/io/cycle_csv.hpp"
#include "bumpfoil/io/result_names.hpp"

namespace bumpfoil {
namespace {

/// 128 bits from the system.
std::string make_run_id() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

}  // namespace

std::vector<std::string> cycle_file_names(std::string_view command) {
  return {fmt::format("{}.csv", command), "result.nc", "summary.json"};
}

std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance) try {
  const std::string run_id = make_run_id();
  std::vector<ResultFile> files;
  files.push_back({fmt::format("{}.csv", name_of(result.experiment)), cycle_csv(result)});
  files.push_back({"result.nc", result_netcdf(input, result, status, provenance, run_id)});
  Manifest manifest{run_id, {}};
  for (const ResultFile& file : files) {
    manifest.files.push_back({file.name, file.contents.size(), xxh3_128(file.contents)});
  }
  files.push_back({"summary.json", summary_json(input, result, status, manifest)});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file, {{"summary.json", 0, "", "", "cannot be built: the memory does not suffice",
                                 "fewer steps or directions take less"}});
}

}  // namespace bumpfoil
