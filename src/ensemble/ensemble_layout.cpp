#include "bumpfoil/ensemble/ensemble_layout.hpp"

#include <memory>
#include <string_view>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

/// The terminal shows numbers only.
bool is_on_the_terminal(const VariableMeaning& meaning) {
  return meaning.form.kind == Form::real && meaning.shown.size > 0.0 && (meaning.tags & tag::of_solver) == 0;
}

}  // namespace

EnsembleLayout make_ensemble_layout(const Case& input) {
  EnsembleLayout layout = experiment_named(input.montecarlo->command).sampling->layout(input);
  layout.bumps = static_cast<std::size_t>(total_bumps(input));
  for (EnsembleColumn& column : layout.columns) {
    if (!is_on_the_terminal(column.meaning)) column.meaning.label.clear();
  }
  VariableMeaning& status = layout.columns.front().meaning;
  BUMPFOIL_ASSERT(status.name == "status");
  std::vector<std::string_view> words(status.form.words.begin(), status.form.words.end());
  words.emplace_back("not_physical");
  layout.statuses = std::make_shared<const std::vector<std::string_view>>(std::move(words));
  status.form.words = *layout.statuses;
  return layout;
}

std::vector<double> make_ensemble_row(const EnsembleLayout& layout,
                                      const std::optional<std::vector<SampledPlace>>& places) {
  std::vector<double> row(layout.width(), absent);
  for (std::size_t at = 0; at < layout.places.size(); ++at) {
    const auto begin = row.begin() + static_cast<std::ptrdiff_t>(layout.entry(at, 0));
    if (!places) {
      *begin = layout.no_bearing();
      continue;
    }
    BUMPFOIL_ASSERT(places->size() == layout.places.size());
    const SampledPlace& found = (*places)[at];
    BUMPFOIL_ASSERT(found.values.size() == layout.columns.size());
    BUMPFOIL_ASSERT(found.loads.empty() || found.loads.size() == layout.loads());
    std::copy(found.loads.begin(), found.loads.end(), std::copy(found.values.begin(), found.values.end(), begin));
  }
  return row;
}

}  // namespace bumpfoil
