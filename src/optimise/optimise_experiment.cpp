#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/optimise/optimise.hpp"
#include "optimise/optimise_output.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

ResultContents optimise_contents(const OptimiseResult& result) {
  ResultContents contents{.tables = {{"points.csv", point_table(result)}}, .lists = optimise_lists(result)};
  if (result.best) contents.texts.push_back({"case.toml", optimised_case_text(result)});
  return contents;
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
          .advice = "use fewer evaluations",
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
                               .contents = [=](const std::string& /*run_id*/) { return optimise_contents(*result); }};
              },
          .check = optimise_errors,
          .small_runs = {{"optimise.command=cycle", "optimise.maximise=[\"loss_factor\"]",
                          "optimise.minimise=[\"max_force\"]", "optimise.limits=[\"max_force > 1 N\"]",
                          "optimise.evaluations=40", "optimise.tolerance=0.05", "optimise.starts=1", "optimise.front=1",
                          "cycle.steps=4", "optimise.key=[{key=\"friction.coefficient\", lower=0.05, upper=0.3}]"}}};
}

}  // namespace bumpfoil
