#include "bumpfoil/ensemble/ensemble_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bumpfoil/ensemble/ensemble_table.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "ensemble/ensemble_dataset.hpp"
#include "ensemble/ensemble_summary.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

constexpr const char* netcdf_name = "ensemble.nc";
/// Number of failures listed in the message of ensemble.nc.
constexpr std::size_t most_ensemble_messages = 5;

std::string message_of(const EnsembleLayout& layout, const EnsembleStatistics& statistics, bool interrupted,
                       std::size_t due) {
  std::vector<std::string> parts;
  if (!statistics.failures.empty()) {
    std::vector<std::string> lines = failure_lines(layout, statistics);
    lines.resize(std::min(lines.size(), most_ensemble_messages));
    parts.push_back(fmt::format("{} {} failed: {}", statistics.failures.size(), layout.plural, fmt::join(lines, "; ")));
  }
  if (interrupted) parts.push_back(fmt::format("{} of {} samples are there", statistics.samples, due));
  return fmt::format("{}", fmt::join(parts, "; "));
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
  const auto due = static_cast<std::size_t>(input.montecarlo->samples);
  stage_result_files({.input = input,
                      .command = "montecarlo",
                      .status = status,
                      .message = message_of(layout, statistics, status == RunStatus::interrupted, due),
                      .warnings = case_warnings(input),
                      .provenance = provenance},
                     netcdf_name, "use fewer samples", ensemble_dataset(input, layout, log),
                     ensemble_lists(input, layout, statistics, yields), folder);
}

}  // namespace bumpfoil
