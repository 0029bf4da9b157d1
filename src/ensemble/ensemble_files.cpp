#include "bumpfoil/ensemble/ensemble_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bumpfoil/ensemble/ensemble_table.hpp"
#include "ensemble/ensemble_dataset.hpp"
#include "ensemble/ensemble_summary.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

constexpr const char* netcdf_name = "ensemble.nc";
/// Number of failed samples that are named.
constexpr std::size_t most_named_samples = 5;

/// How many samples failed, and the first of them.
std::vector<std::string> failures_of(const EnsembleLayout& layout, const EnsembleStatistics& statistics) {
  if (statistics.failures.empty()) return {};
  std::vector<std::string> lines = failure_lines(layout, statistics);
  lines.resize(std::min(lines.size(), most_named_samples));
  return {fmt::format("{} {} failed: {}", statistics.failures.size(), layout.plural, fmt::join(lines, "; "))};
}

}  // namespace

std::vector<std::string> ensemble_file_names() {
  return {"summary.json", netcdf_name};
}

RunStatus status_of(const EnsembleStatistics& statistics, bool stopped) {
  if (stopped) return RunStatus::interrupted;
  return statistics.failures.empty() ? RunStatus::complete : RunStatus::failed;
}

void stage_ensemble(const Case& input, const EnsembleLayout& layout, const RowLog& log,
                    const EnsembleStatistics& statistics, const EnsembleYields& yields, RunStatus status,
                    const Provenance& provenance, ResultFolder& folder) {
  const std::vector<std::string> failures = failures_of(layout, statistics);
  std::vector<std::string> message = failures;
  if (status == RunStatus::interrupted) {
    message.push_back(fmt::format("{} of {} samples are there", statistics.samples, input.montecarlo->samples));
  }
  stage_result_files({.input = input,
                      .command = "montecarlo",
                      .status = status,
                      .failures = failures,
                      .warnings = warning_lines(input, layout, statistics),
                      .provenance = provenance,
                      .message = fmt::format("{}", fmt::join(message, "; "))},
                     netcdf_name, "use fewer samples", ensemble_dataset(input, layout, log),
                     ensemble_lists(input, layout, statistics, yields), folder);
}

}  // namespace bumpfoil
