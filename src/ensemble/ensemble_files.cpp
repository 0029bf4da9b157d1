#include "bumpfoil/ensemble/ensemble_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/ensemble_table.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "ensemble/ensemble_netcdf.hpp"
#include "ensemble/ensemble_summary.hpp"
#include "results/manifest.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

constexpr const char* netcdf_name = "ensemble.nc";
/// Failures that the message in ensemble.nc tells.
constexpr std::size_t most_ensemble_messages = 5;

std::string message_of(const EnsembleLayout& layout, const EnsembleStatistics& statistics, bool interrupted,
                       std::size_t due) {
  std::vector<std::string> parts;
  if (!statistics.failures.empty()) {
    std::vector<std::string> lines = failure_lines(layout, statistics);
    lines.resize(std::min(lines.size(), most_ensemble_messages));
    parts.push_back(fmt::format("{} {} failed: {}", statistics.failures.size(),
                                layout.command == EnsembleCommand::cycle ? "cycles" : "states",
                                fmt::join(lines, "; ")));
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

void stage_ensemble(const Case& input, const EnsembleLayout& layout, const EnsembleLog& log,
                    const EnsembleStatistics& statistics, const EnsembleYields& yields, RunStatus status,
                    const Provenance& provenance, ResultFolder& folder) {
  Manifest manifest{make_run_id(), {}};
  const fs::path path = folder.stage(netcdf_name);
  const auto due = static_cast<std::size_t>(input.montecarlo->samples);
  write_ensemble_netcdf(path, input, layout, log, status,
                        message_of(layout, statistics, status == RunStatus::interrupted, due), provenance,
                        manifest.run_id);
  manifest.files.push_back({netcdf_name, static_cast<std::size_t>(fs::file_size(path)), xxh3_128_of_file(path)});
  folder.stage("summary.json", ensemble_summary(input, layout, statistics, yields, status, manifest));
}

}  // namespace bumpfoil
