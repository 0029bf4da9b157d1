#include "bumpfoil/experiments/cycle/cycle_files.hpp"

#include <fmt/format.h>

#include <new>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/cycle_csv.hpp"
#include "bumpfoil/experiments/cycle/cycle_summary.hpp"
#include "bumpfoil/experiments/cycle/result_names.hpp"
#include "bumpfoil/experiments/cycle/result_netcdf.hpp"
#include "results/manifest.hpp"

namespace bumpfoil {
std::vector<std::string> cycle_file_names(std::string_view command) {
  return {"summary.json", fmt::format("{}.csv", command), "result.nc"};
}

std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance) try {
  const std::string run_id = make_run_id();
  std::vector<ResultFile> files;
  files.push_back({fmt::format("{}.csv", name_of(result.experiment)), cycle_csv(result)});
  files.push_back({"result.nc", result_netcdf(input, result, status, provenance, run_id)});
  files.push_back({"summary.json", summary_json(input, result, status, make_manifest(run_id, files))});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file, {{"summary.json", 0, "", "", "cannot be built: the memory does not suffice",
                                 "fewer steps or directions take less"}});
}

}  // namespace bumpfoil
