#include "bumpfoil/experiments/vibration/vibration_table.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/model/pads.hpp"
#include "experiments/vibration/vibration_dataset.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "experiments/vibration/vibration_tables.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {

RunStatus status_of(const VibrationResult& result) {
  std::vector<Status> vibrations;
  for (const Vibration& vibration : result.vibrations) vibrations.push_back(vibration.cycle.status);
  return run_status(vibrations, vibrations.size());
}

std::vector<std::string> failure_lines(const Case& input, const VibrationResult& result) {
  return failure_lines(input.settings.get<VibrationSettings>(), result);
}

std::vector<std::string> warning_lines(const Case& input, const VibrationResult& result) {
  std::vector<std::string> lines = case_warnings(input);
  const std::vector<std::string> more = warning_lines(input.settings.get<VibrationSettings>(), result);
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

std::string vibration_table(const Case& input, const VibrationResult& result) {
  const VibrationSettings& settings = input.settings.get<VibrationSettings>();
  Table table = loop_table(vibration_dataset(input, result, linear_foils(settings, result), false), settings);
  std::erase_if(table.columns, [](const TableColumn& column) { return column.meaning.shown.size == 0.0; });
  const std::size_t pads = count_pads(input) > 1 ? count_pads(input) : 0;
  for (std::size_t k = 0; k < pads; ++k) {
    table.add(shown_column(fmt::format("pad {}, max", k + 1), shown::newtons),
              each(result.vibrations, [k](const Vibration& vibration) {
                const Vector forces = largest_pad_forces(vibration);
                const auto pad = static_cast<Eigen::Index>(k);
                return pad < forces.size() ? forces[pad] : absent;
              }));
  }
  return table_lines(table);
}

}  // namespace bumpfoil
