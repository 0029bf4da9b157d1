#include "fuzz/changed_result.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "results/dataset_netcdf.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {
namespace {

struct SmallRun {
  std::string command;
  Outcome outcome;  ///< outlives its dataset
  Dataset dataset;
};

std::vector<SmallRun> make_small_runs() {
  std::vector<SmallRun> runs;
  for (const char* const command : {"cycle", "vibration", "stability", "transient"}) {
    const ExperimentInfo& experiment = experiment_named(command);
    const Case input = parse_case(case_template("gen1"), "gen1.toml",
                                  {.overrides = experiment.small_runs.front(), .commands = {command}});
    Outcome outcome = experiment.run(input, {});
    Dataset dataset = outcome.dataset();
    runs.push_back({command, std::move(outcome), std::move(dataset)});
  }
  return runs;
}

/// Copies its values, so that they can be changed. It is written whole and uncompressed: it may have lost its
/// dimensions.
void change(Variable& variable, const Dataset& dataset, DrawsOfBytes& draws) {
  std::vector<double> values = variable.values ? variable.values() : std::vector<double>{};
  constexpr std::array numbers{std::numeric_limits<double>::quiet_NaN(), -1.0, 0.0, 0.5, 3.0, 1e300, -1e300, 127.0};
  // Flags are bytes in the file: netCDF would refuse to write larger ones.
  const auto number = [&] {
    const double drawn = numbers.at(static_cast<std::size_t>(draws.whole(0, 7)));
    return variable.meaning.form.kind == Form::real ? drawn : std::clamp(drawn, -127.0, 127.0);
  };
  switch (draws.whole(0, 4)) {
    case 0:
      values.assign(values.size(), number());
      break;
    case 1:
      if (!values.empty()) {
        values[static_cast<std::size_t>(draws.whole(0, static_cast<int>(values.size()) - 1))] = number();
      }
      break;
    case 2:
      if (!variable.dims.empty())
        variable.dims.erase(variable.dims.begin() + draws.whole(0, static_cast<int>(variable.dims.size()) - 1));
      break;
    case 3:
      std::reverse(variable.dims.begin(), variable.dims.end());
      break;
    default:
      variable.dims.push_back(
          dataset.dims[static_cast<std::size_t>(draws.whole(0, static_cast<int>(dataset.dims.size()) - 1))].name);
      break;
  }
  std::size_t size = 1;
  for (const std::string& name : variable.dims) size *= dataset.dimension(name).size;
  values.resize(size);
  variable.values = [values] { return values; };
  variable.rows = {};
  variable.compressed = false;
}

}  // namespace

std::string changed_result(DrawsOfBytes draws) {
  static const std::vector<SmallRun> runs = make_small_runs();
  const SmallRun& run = runs[static_cast<std::size_t>(draws.whole(0, static_cast<int>(runs.size()) - 1))];
  Dataset dataset = run.dataset;
  for (int changes = draws.whole(0, 4); changes > 0; --changes) {
    std::vector<Variable>& list = draws.chance(0.2) ? dataset.coordinates : dataset.variables;
    if (list.empty()) continue;
    const auto place = list.begin() + draws.whole(0, static_cast<int>(list.size()) - 1);
    if (draws.chance(0.3))
      list.erase(place);
    else
      change(*place, dataset, draws);
  }
  NewNetcdf file;
  file.add_text("schema", draws.chance(0.05) ? "bumpfoil-result/3" : "bumpfoil-result/2");
  file.add_text("bumpfoil_command",
                draws.chance(0.2) ? draws.among({"strip", "sweep", "montecarlo", "path", "x\x1b[2J"}) : run.command);
  DatasetNetcdf variables(file);
  variables.add(dataset);
  variables.append(dataset);
  return file.close();
}

}  // namespace bumpfoil
