#include "bumpfoil/io/cycle_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "bumpfoil/io/result_quantities.hpp"
#include "bumpfoil/io/summary.hpp"

namespace bumpfoil {
namespace {

void append(std::string& out, double value, const Form& form) {
  if (!std::isfinite(value)) return;
  if (!form.words.empty()) {
    out += form.words[static_cast<std::size_t>(value)];
  } else {
    fmt::format_to(std::back_inserter(out), "{:.17g}", value);
  }
}

}  // namespace

std::string cycle_csv(const CycleResult& result) {
  const bool is_strip = result.experiment == Experiment::strip;
  std::vector<IncrementQuantity> columns = increment_quantities(result.experiment);
  std::erase_if(columns, [](const IncrementQuantity& column) { return !column.in_csv; });
  const bool is_path = result.experiment == Experiment::path;
  std::string out = is_path ? "increment" : is_strip ? "cycle,increment" : "direction_deg,increment";
  for (const IncrementQuantity& column : columns) out += ',' + key_of(column.name, column.unit);
  double number = 0.0;
  for (const Cycle& cycle : result.cycles) {
    number += 1.0;
    for (const Increment& increment : cycle.increments) {
      out += '\n';
      if (!is_path) {
        fmt::format_to(std::back_inserter(out), "{:.17g},", is_strip ? number : to_degrees(cycle.direction));
      }
      out += std::to_string(increment.index);
      for (const IncrementQuantity& column : columns) append(out += ',', column.value(increment), column.form);
    }
  }
  return out + '\n';
}

}  // namespace bumpfoil
