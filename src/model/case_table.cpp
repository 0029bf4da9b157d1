#include "model/case_table.hpp"

#include <algorithm>

namespace bumpfoil {
const CaseTable* case_table_of(std::string_view experiment) {
  const auto found = std::find_if(case_tables().begin(), case_tables().end(),
                                  [&](const CaseTable& table) { return table.experiment == experiment; });
  return found == case_tables().end() ? nullptr : &*found;
}

const std::vector<std::string_view>& sampled_experiments() {
  static const std::vector<std::string_view> names =
      experiments_where([](const CaseTable& table) { return table.sampled_by.has_value(); });
  return names;
}

const std::vector<std::string_view>& swept_experiments() {
  static const std::vector<std::string_view> names = experiments_where(&CaseTable::swept);
  return names;
}

SolverName ensemble_solver(const Case& input) {
  const CaseTable* const sampled = input.montecarlo ? case_table_of(input.montecarlo->command) : nullptr;
  const bool linear = input.bump_foil.geometry == Geometry::linear;
  return sampled != nullptr && linear ? sampled->sampled_by.value_or(SolverName::newton) : SolverName::newton;
}

}  // namespace bumpfoil
