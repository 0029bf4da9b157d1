#include "model/case_table.hpp"

#include <algorithm>

namespace bumpfoil {
namespace {

/// Names of the experiments for which a condition holds.
template <typename Condition>
std::vector<std::string_view> experiments_where(const Condition& condition) {
  std::vector<std::string_view> names;
  for (const CaseTable& table : case_tables()) {
    if (condition(table)) names.push_back(table.experiment);
  }
  return names;
}

}  // namespace

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
  static const std::vector<std::string_view> names =
      experiments_where([](const CaseTable& table) { return table.swept; });
  return names;
}

SolverName ensemble_solver(const Case& input) {
  const CaseTable* const sampled = input.montecarlo ? case_table_of(input.montecarlo->command) : nullptr;
  const bool linear = input.bump_foil.geometry == Geometry::linear;
  return sampled != nullptr && linear ? sampled->sampled_by.value_or(SolverName::newton) : SolverName::newton;
}

}  // namespace bumpfoil
