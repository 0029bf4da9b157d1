#include "cycle_files.hpp"

#include "bumpfoil/io/cycle_csv.hpp"

namespace bumpfoil {

void stage_cycle_files(ResultFolder& folder, const Case& input, const CycleResult& result, RunStatus status,
                       const Provenance& provenance) {
  folder.stage("summary.json", summary_json(input, result, status));
  folder.stage(result.experiment == Experiment::strip ? "strip.csv" : "cycle.csv", cycle_csv(result));
  write_result_netcdf(folder.stage("result.nc"), input, result, status, provenance);
}

}  // namespace bumpfoil
