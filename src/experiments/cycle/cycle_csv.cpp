#include "bumpfoil/experiments/cycle/cycle_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "results/csv_value.hpp"

namespace bumpfoil {

std::string cycle_csv(const CycleResult& result) {
  const bool is_strip = result.experiment == Experiment::strip;
  std::vector<IncrementQuantity> columns = increment_quantities(result.experiment, result.over_width);
  std::erase_if(columns, [](const IncrementQuantity& column) { return !column.is(tag::csv); });
  const bool is_path = result.experiment == Experiment::path;
  std::string out(cycle_key(result.experiment));
  out += is_path ? "increment" : ",increment";
  for (const IncrementQuantity& column : columns) out += ',' + column.key();
  double number = 0.0;
  for (const Cycle& cycle : result.cycles) {
    number += 1.0;
    for (const Increment& increment : cycle.increments) {
      out += '\n';
      if (!is_path) {
        fmt::format_to(std::back_inserter(out), "{:.17g},", is_strip ? number : to_degrees(cycle.direction));
      }
      out += std::to_string(increment.index);
      for (const IncrementQuantity& column : columns) append_csv(out += ',', column.value(increment), column.form);
    }
  }
  return out + '\n';
}

}  // namespace bumpfoil
