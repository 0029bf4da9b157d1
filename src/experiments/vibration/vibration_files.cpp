#include "bumpfoil/experiments/vibration/vibration_files.hpp"

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/case_warnings.hpp"
#include "experiments/vibration/ross_toml.hpp"
#include "experiments/vibration/vibration_dataset.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "experiments/vibration/vibration_summary.hpp"
#include "experiments/vibration/vibration_tables.hpp"
#include "results/result_files.hpp"

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
                                        const Provenance& provenance) {
  const VibrationSettings& settings = *input.vibration;
  const std::vector<LinearFoils> all = linear_foils(settings, result);
  return make_result_files({.input = input,
                            .command = "vibration",
                            .status = status,
                            .message = message_of(failure_lines(settings, result), status),
                            .warnings = warning_lines(input, result),
                            .provenance = provenance},
                           "result.nc", "use fewer steps, loads or amplitudes", [&](const std::string& run_id) {
                             const Dataset totals = vibration_dataset(input, result, all, false);
                             return ResultContents{.tables = {{"vibration.csv", loop_table(totals, settings)},
                                                              {"coefficients.csv", coefficient_table(totals)}},
                                                   .texts = {{"coefficients.toml", ross_toml(settings, all, run_id)}},
                                                   .dataset = vibration_dataset(input, result, all),
                                                   .lists = [&, totals] {
                                                     nlohmann::ordered_json json{
                                                         {"failures", failure_lines(settings, result)},
                                                         {"warnings", warning_lines(input, result)}};
                                                     json.update(vibration_lists(input, result, totals));
                                                     return json;
                                                   }};
                           });
}

std::vector<std::string> failure_lines(const Case& input, const VibrationResult& result) {
  return failure_lines(*input.vibration, result);
}

std::vector<std::string> warning_lines(const Case& input, const VibrationResult& result) {
  std::vector<std::string> lines = case_warnings(input);
  const std::vector<std::string> more = warning_lines(*input.vibration, result);
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

}  // namespace bumpfoil
