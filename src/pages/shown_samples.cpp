#include "pages/shown_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "pages/result_reader.hpp"
#include "readers/summary_reader.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

const std::string& contents_of(const std::vector<ResultFile>& files, const char* name) {
  const auto found =
      std::find_if(files.begin(), files.end(), [name](const ResultFile& file) { return file.name == name; });
  BUMPFOIL_ASSERT(found != files.end());
  return found->contents;
}

/// Identical to a separate run whose files are read back.
Json run_json(const Case& sampled, const std::string& name, std::size_t most_values) {
  const ExperimentInfo& cycle = experiment_named("cycle");
  const std::vector<ResultFile> files = result_files(cycle, sampled, cycle.run(sampled, {}), {});
  const StoredSummary summary = read_summary(contents_of(files, "summary.json"), name);
  Json cycles = read_result(contents_of(files, "result.nc"), name, most_values);
  match_runs(summary, cycles, name, "result.nc");
  Json run{{"name", name}, {"summary", summary.json}};
  run.update(cycles);
  return run;
}

}  // namespace

Json run_shown_samples(const Case& input, std::size_t count, std::size_t most_values) {
  Json runs = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const Case sampled = sampled_case(input, draw_sample(input, i));
    try {
      runs.push_back(run_json(sampled, fmt::format("Sample {}", i), std::max<std::size_t>(1, most_values / count)));
      runs.back()["sample"] = i;
    } catch (const Error&) {
      // An invalid sample is reported by the ensemble.
    }
  }
  return runs;
}

}  // namespace bumpfoil
