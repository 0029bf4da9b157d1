#include "experiments/vibration/vibration_tables.hpp"

#include <string>
#include <utility>
#include <vector>

#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {

Table loop_table(const Dataset& data, const VibrationSettings& settings) {
  const std::string motion = motion_dimension(settings);
  return table_of(data, {.over = {"load", motion, "amplitude"},
                         .columns = names_of(vibration_quantities(), {"load_x", "load_y", motion, "amplitude"})});
}

Table coefficient_table(const Dataset& data) {
  std::vector<std::string> columns{"load_x", "load_y", "amplitude", "frequency"};
  for (const char letter : {'k', 'c'}) {
    for (const MatrixEntry& entry : matrix_entries) columns.push_back(letter + std::string(entry.axes));
  }
  return table_of(
      data, {.over = {"load", "amplitude", "frequency"}, .columns = names_of(linear_quantities(), std::move(columns))});
}

}  // namespace bumpfoil
