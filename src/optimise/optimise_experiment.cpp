#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/optimise/optimise.hpp"
#include "optimise/optimise_output.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

std::vector<ResultFile> optimise_files(const Case& input, const OptimiseResult& result, RunStatus status,
                                       const Provenance& provenance) {
  const std::vector<std::string> failures = optimise_failures(result);
  const std::vector<std::string> warnings = optimise_warnings(result);
  return make_result_files(
      {.input = input,
       .command = "optimise",
       .status = status,
       .message = message_of(failures, status),
       .warnings = warnings,
       .provenance = provenance},
      "result.nc", "use fewer evaluations", [&](const std::string& /*run_id*/) {
        ResultContents contents{
            .tables = {{"points.csv", point_table(result)}}, .dataset = optimise_dataset(result), .lists = [&] {
              nlohmann::ordered_json json{{"failures", failures}, {"warnings", warnings}};
              json.update(optimise_lists(result));
              return json;
            }};
        if (result.best) contents.texts.push_back({"case.toml", optimised_case_text(result)});
        return contents;
      });
}

}  // namespace

ExperimentInfo optimise_experiment() {
  return {.name = "optimise",
          .summary = "Maximise or minimise a quantity over keys of the case under limits, as specified in [optimise]",
          .examples =
              "  bumpfoil optimise examples/optimise.toml -o optimised\n"
              "  bumpfoil optimise examples/optimise.toml -o more --set optimise.evaluations=300 optimise.starts=8\n"
              "  bumpfoil equilibrium optimised/case.toml -o running\n",
          .files = {"summary.json", "points.csv", "result.nc", "case.toml"},
          .run =
              [](const Case& input, const ProgressCallback& progress) {
                const auto result = std::make_shared<const OptimiseResult>(run_optimise(input, progress));
                const std::vector<std::string> failures = optimise_failures(*result);
                const RunStatus status = result->status == OptimiseStatus::interrupted ? RunStatus::interrupted
                                         : failures.empty()                            ? RunStatus::complete
                                                                                       : RunStatus::failed;
                return Outcome{.status = status,
                               .warnings = optimise_warnings(*result),
                               .failures = failures,
                               .table = [=] { return optimise_table(*result); },
                               .dataset = [=] { return optimise_dataset(*result); },
                               .files =
                                   [=](const Provenance& provenance) {
                                     return optimise_files(input, *result, status, provenance);
                                   }};
              },
          .check = optimise_errors,
          .small_runs = {{"optimise.command=cycle", "optimise.maximise=[\"loss_factor\"]",
                          "optimise.minimise=[\"max_force\"]", "optimise.limits=[\"max_force > 1 N\"]",
                          "optimise.evaluations=40", "optimise.tolerance=0.05", "optimise.starts=1", "optimise.front=1",
                          "cycle.steps=4", "optimise.key=[{key=\"friction.coefficient\", lower=0.05, upper=0.3}]"}}};
}

}  // namespace bumpfoil
