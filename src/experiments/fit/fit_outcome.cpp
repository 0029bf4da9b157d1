#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/fit/fit.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "experiments/fit/fit_output.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

std::vector<std::string> fit_failures(const FitResult& result) {
  switch (result.status) {
    case Status::converged:
    case Status::interrupted:
      return {};
    case Status::iterations_spent:
      return {"the best minimisation ended before its sum of squares came to rest"};
    default:
      return {"no minimum was found"};
  }
}

ResultContents fit_contents(const FitResult& result) {
  ResultContents contents{.tables = {{"fit.csv", fitted_points(result)}}, .lists = fit_lists(result)};
  if (!result.parameters.empty()) contents.texts.push_back({"case.toml", fitted_case_text(result)});
  return contents;
}

/// Running bearings use Newton's method, whatever solves loops and vibrations.
std::string fit_solvers(const Case& input) {
  const std::vector<FitData>& data = input.settings.get<FitSettings>().data;
  const auto runs = [](const FitData& one) { return one.experiment == FittedExperiment::equilibrium; };
  if (std::none_of(data.begin(), data.end(), runs)) return std::string(name_of(input.solver.chosen()));
  const std::string_view newton = name_of(SolverName::newton);
  if (std::all_of(data.begin(), data.end(), runs) || input.solver.chosen() == SolverName::newton)
    return std::string(newton);
  return fmt::format("{}, {} with films", name_of(input.solver.chosen()), newton);
}

}  // namespace

ExperimentInfo fit_experiment() {
  const std::string loop =
      "fit.data=[{displacements=[0, 3e-5, 5e-5, 6e-5, 7e-5, 6.5e-5, 5e-5, 3e-5, 0], "
      "forces=[0, 0, 130, 290, 460, 360, 110, 0, 0], points=8}]";
  return {.name = "fit",
          .summary = "Find parameters of the case from measured data, as specified in [fit]",
          .examples =
              "  bumpfoil fit examples/fit.toml -o fit\n"
              "  bumpfoil fit examples/fit.toml -o robust --set fit.huber=1.345\n"
              "  bumpfoil cycle fit/case.toml -o fitted\n",
          .files = {"summary.json", "fit.csv", "fit.nc", "case.toml"},
          .advice = "use fewer points",
          .run =
              [](const Case& input, const ProgressCallback& progress) {
                const auto result = std::make_shared<const FitResult>(run_fit(input, progress));
                return Outcome{.status = run_status({result->status}, 1),
                               .warnings = fit_warnings(*result),
                               .failures = fit_failures(*result),
                               .table = [=] { return fit_table(*result); },
                               .dataset = [=] { return fit_dataset(*result); },
                               .contents = [=](const std::string& /*run_id*/) { return fit_contents(*result); }};
              },
          .solvers = fit_solvers,
          .small_runs = {{"bump_foil.bumps=8", "fit.starts=1", "fit.profile=true", loop,
                          "fit.parameter=[{key=\"friction.coefficient\", start=0.1, lower=0.0, upper=0.5}]"}}};
}

}  // namespace bumpfoil
