#include "bumpfoil/io/cycle_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "bumpfoil/io/summary.hpp"
#include "io/result_columns.hpp"

namespace bumpfoil {

std::string cycle_csv(const CycleResult& result) {
  const bool is_strip = result.experiment == Experiment::strip;
  std::string out = is_strip ? "cycle,increment,branch" : "direction_deg,increment,branch";
  for (const IncrementColumn& column : increment_columns(result.experiment))
    out += ',' + name_with_unit(column.name, column.unit);
  out += ",iterations,substeps\n";
  const auto append = [&out](double value) {
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(out), "{:.17g}", value);
    out += ',';
  };
  double number = 0.0;
  for (const Cycle& cycle : result.cycles) {
    number += 1.0;
    for (const Increment& increment : cycle.increments) {
      append(is_strip ? number : to_degrees(cycle.direction));
      fmt::format_to(std::back_inserter(out), "{},{},", increment.index,
                     increment.branch == Branch::loading ? "loading" : "unloading");
      for (const IncrementColumn& column : increment_columns(result.experiment)) append(column.value(increment));
      fmt::format_to(std::back_inserter(out), "{},{}\n", increment.solve.iterations, increment.substeps);
    }
  }
  return out;
}

}  // namespace bumpfoil
