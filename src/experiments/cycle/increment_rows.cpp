#include "bumpfoil/experiments/cycle/increment_rows.hpp"

#include <vector>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"

namespace bumpfoil {

Table increment_rows(const CycleResult& result) {
  struct Row {
    std::size_t cycle;  ///< from 0
    const Increment& increment;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    for (const Increment& increment : result.cycles[i].increments) rows.push_back({i, increment});
  }
  Table table;
  if (result.experiment == Experiment::strip) {
    table.add({"cycle", "1", "", whole_number},
              each(rows, [](const Row& row) { return static_cast<double>(row.cycle + 1); }));
  } else if (result.experiment == Experiment::cycle) {
    table.add({"direction", "degree", ""},
              each(rows, [&](const Row& row) { return to_degrees(result.cycles[row.cycle].direction); }));
  }
  table.add({"increment", "1", "", whole_number},
            each(rows, [](const Row& row) { return static_cast<double>(row.increment.index); }));
  for (const IncrementQuantity& quantity : increment_quantities(result.experiment, result.over_width)) {
    if (!quantity.is(tag::csv)) continue;
    table.add(quantity.meaning(), each(rows, [&quantity](const Row& row) { return quantity.value(row.increment); }));
  }
  return table;
}

}  // namespace bumpfoil
