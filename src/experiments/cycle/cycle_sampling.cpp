#include "experiments/cycle/cycle_sampling.hpp"

#include <memory>
#include <string>
#include <utility>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/cycle/sampled_cycles.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "experiments/run_sampling.hpp"

namespace bumpfoil {
namespace {

/// A column, and its value of a cycle of a sampled case.
struct CycleColumn {
  EnsembleColumn column;
  std::function<double(const Cycle&, const Case& sampled)> value;
};

CycleColumn column_of(const CycleQuantity& quantity, const Wording& wording) {
  VariableMeaning meaning = quantity.meaning();
  meaning.long_name = spelled(quantity.long_name, wording);
  return {.column = {.meaning = std::move(meaning)}, .value = quantity.value};
}

CycleColumn clearance_column(VariableMeaning meaning, std::size_t i) {
  return {.column = {.meaning = std::move(meaning), .undefined = Undefined::largest},
          .value = [i](const Cycle& cycle, const Case&) { return clearance_of(cycle, i); }};
}

CycleColumn largest_load_column() {
  return {.column = {.meaning = {.name = "largest_bump_load",
                                 .unit = "N",
                                 .long_name = "maximum load of a bump at full displacement",
                                 .label = "maximum bump load",
                                 .shown = shown::newtons}},
          .value = [](const Cycle& cycle, const Case&) {
            return cycle.turning_point ? cycle.turning_point->bump_loads.maxCoeff() : absent;
          }};
}

std::vector<CycleColumn> cycle_columns(const Case& input) {
  const Wording wording = wording_of(input, Experiment::cycle);
  const bool over_width = input.varies_over_the_width() || strips_drawn_apart(input) > 1;
  std::vector<CycleColumn> columns =
      each(sampled_of(cycle_quantities(Experiment::cycle, over_width)),
           [&wording](const CycleQuantity& quantity) { return column_of(quantity, wording); });
  const std::vector<VariableMeaning> clearances =
      clearance_quantities(input.settings.get<CycleSettings>().clearance_forces);
  for (std::size_t i = 0; i < clearances.size(); ++i) columns.push_back(clearance_column(clearances[i], i));
  columns.push_back(largest_load_column());
  return columns;
}

EnsembleLayout cycle_layout(const Case& input) {
  return {.place = {"direction", "degree", "direction of the push, from X towards Y"},
          .plural = "cycles",
          .places = each(input.settings.get<CycleSettings>().directions,
                         [](double direction) {
                           return EnsemblePlace{direction_name(direction), to_degrees(direction)};
                         }),
          .columns = each(cycle_columns(input), [](const CycleColumn& one) { return one.column; }),
          .target = "max_force",
          .load = "load on the crest of the bump at full displacement"};
}

SampledPlace sampled_cycle(const std::vector<CycleColumn>& columns, const Cycle& cycle, const Case& sampled) {
  SampledPlace place{.values = each(columns, [&](const CycleColumn& one) { return one.value(cycle, sampled); })};
  if (cycle.turning_point) {
    const Vector& loads = cycle.turning_point->bump_loads;
    place.loads.assign(loads.begin(), loads.end());
  }
  return place;
}

}  // namespace

Sampling cycle_sampling() {
  const auto begin = [](const Case& input) -> SampleRun {
    return [columns = cycle_columns(input), runner = std::make_shared<SampledCycleRunner>()](
               const Case& sampled, const ProgressCallback& progress) {
      const CycleResult result = runner->run(sampled, progress);
      return each(result.cycles, [&](const Cycle& cycle) { return sampled_cycle(columns, cycle, sampled); });
    };
  };
  return {.layout = cycle_layout, .begin = begin};
}

}  // namespace bumpfoil
