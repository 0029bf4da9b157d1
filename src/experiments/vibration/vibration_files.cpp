#include "bumpfoil/experiments/vibration/vibration_files.hpp"

#include <new>

#include "bumpfoil/core/error.hpp"
#include "experiments/vibration/ross_toml.hpp"
#include "experiments/vibration/vibration_csv.hpp"
#include "experiments/vibration/vibration_netcdf.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "experiments/vibration/vibration_summary.hpp"
#include "results/manifest.hpp"

namespace bumpfoil {

RunStatus status_of(const VibrationResult& result) {
  std::vector<Status> vibrations;
  for (const Vibration& vibration : result.vibrations) vibrations.push_back(vibration.cycle.status);
  return run_status(vibrations, vibrations.size());
}

std::vector<std::string> vibration_file_names() {
  return {"summary.json", "vibration.csv", "coefficients.csv", "coefficients.toml", "result.nc"};
}

std::vector<ResultFile> vibration_files(const Case& input, const VibrationResult& result, RunStatus status,
                                        const Provenance& provenance) try {
  const std::string run_id = make_run_id();
  const VibrationSettings& settings = *input.vibration;
  const std::vector<LinearFoils> all = linear_foils(settings, result);
  std::vector<ResultFile> files;
  files.push_back({"vibration.csv", vibration_csv(settings, result)});
  files.push_back({"coefficients.csv", coefficients_csv(settings, all)});
  files.push_back({"coefficients.toml", ross_toml(settings, all, run_id)});
  files.push_back({"result.nc", vibration_netcdf(input, result, all, status, provenance, run_id)});
  files.push_back({"summary.json", vibration_summary(input, result, all, status, make_manifest(run_id, files))});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file, {{"summary.json", 0, "", "", "cannot be built: the memory does not suffice",
                                 "fewer steps, loads or amplitudes take less"}});
}

std::vector<std::string> failure_lines(const Case& input, const VibrationResult& result) {
  return failure_lines(*input.vibration, result);
}

std::vector<std::string> warning_lines(const Case& input, const VibrationResult& result) {
  std::vector<std::string> lines = input.remarks;
  const std::vector<std::string> more = warning_lines(*input.vibration, result);
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

}  // namespace bumpfoil
