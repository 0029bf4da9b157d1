#include "bumpfoil/experiments/cycle/increment_rows.hpp"

#include <utility>
#include <vector>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"

namespace bumpfoil {

Table increment_rows(const CycleResult& result) {
  Table table;
  const auto add = [&](VariableMeaning meaning, const auto& value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < result.cycles.size(); ++i) {
      for (const Increment& increment : result.cycles[i].increments) values.push_back(value(i, increment));
    }
    table.add(std::move(meaning), std::move(values));
  };
  if (result.experiment == Experiment::strip) {
    add({"cycle", "1", "cycle of the plate", whole_number},
        [](std::size_t cycle, const Increment&) { return static_cast<double>(cycle + 1); });
  } else if (result.experiment == Experiment::cycle) {
    add({"direction", "degree", "direction of the push, from X towards Y"},
        [&](std::size_t cycle, const Increment&) { return to_degrees(result.cycles[cycle].direction); });
  }
  add({"increment", "1", "increment; 0 is the start of the cycle", whole_number},
      [](std::size_t, const Increment& increment) { return static_cast<double>(increment.index); });
  for (const IncrementQuantity& quantity : increment_quantities(result.experiment, result.over_width)) {
    if (!quantity.is(tag::csv)) continue;
    add(quantity.meaning(), [&quantity](std::size_t, const Increment& increment) { return quantity.value(increment); });
  }
  return table;
}

}  // namespace bumpfoil
