#include "bumpfoil/io/cycle_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "bumpfoil/io/summary.hpp"
#include "io/result_columns.hpp"

namespace bumpfoil {
std::string cycle_csv(const CycleResult& result) {
  std::string out = "direction_deg,increment,branch";
  for (const IncrementColumn& column : increment_columns()) out += ',' + name_with_unit(column.name, column.unit);
  out += ",iterations,substeps\n";
  const auto append = [&out](double number) {
    if (std::isfinite(number)) fmt::format_to(std::back_inserter(out), "{:.17g}", number);
    out += ',';
  };
  for (const Cycle& cycle : result.cycles) {
    for (const Increment& increment : cycle.increments) {
      append(to_degrees(cycle.direction));
      fmt::format_to(std::back_inserter(out), "{},{},", increment.index,
                     increment.branch == Branch::loading ? "loading" : "unloading");
      for (const IncrementColumn& column : increment_columns()) append(column.value(increment));
      fmt::format_to(std::back_inserter(out), "{},{}\n", increment.solve.iterations, increment.substeps);
    }
  }
  return out;
}

}  // namespace bumpfoil
