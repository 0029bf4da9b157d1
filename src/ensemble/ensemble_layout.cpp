#include "bumpfoil/ensemble/ensemble_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/pads.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

/// Numbers, and what is true of some samples.
bool is_on_the_terminal(const VariableMeaning& meaning) {
  const bool has_place = meaning.form.kind == Form::real || meaning.form.kind == Form::truth;
  return has_place && meaning.shown.size > 0.0 && (meaning.tags & tag::of_solver) == 0;
}

const Sampling& sampling_of(const std::string& command) {
  const CaseTable* const table = case_table_of(command);
  if (table == nullptr || !table->sampled_by) {
    throw Error(ErrorKind::input, {{"", 0, "montecarlo.command", command, "is not a command that ensembles run",
                                    fmt::format("give one of {}", fmt::join(sampled_experiments(), ", "))}});
  }
  return *experiment_named(command).sampling;
}

}  // namespace

EnsembleLayout make_ensemble_layout(const Case& input) {
  EnsembleLayout layout = sampling_of(input.montecarlo->command).layout(input);
  layout.bumps = static_cast<std::size_t>(total_bumps(input));
  for (EnsembleColumn& column : layout.columns) {
    if (!is_on_the_terminal(column.meaning)) column.meaning.shown = shown::in_files;
  }
  VariableMeaning& status = layout.columns.front().meaning;
  BUMPFOIL_ASSERT(status.name == "status" && layout.column(layout.target) < layout.columns.size());
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
