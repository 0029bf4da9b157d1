#include "bumpfoil/ensemble/ensemble_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bumpfoil/experiments/case_warnings.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

/// Number of samples for which something is true.
std::string lines_of_truths(const EnsembleLayout& layout, const PlaceStatistics& statistics) {
  std::string out;
  for (std::size_t column = 0; column < layout.columns.size(); ++column) {
    const VariableMeaning& meaning = layout.columns[column].meaning;
    if (meaning.shown.size == 0.0 || meaning.form.kind != Form::truth) continue;
    const Statistics& found = statistics.columns[column];
    if (found.count == 0) {
      out += fmt::format("{}: not known\n", meaning.label);
      continue;
    }
    const std::string unknown = found.undefined == 0 ? "" : fmt::format("; of {} it is not known", found.undefined);
    out += fmt::format("{}: {:.0f} of {} samples, {:.1f} %{}\n", meaning.label,
                       found.mean * static_cast<double>(found.count), found.count, 100.0 * found.mean, unknown);
  }
  return out;
}

}  // namespace

std::string ensemble_table(const EnsembleLayout& layout, const EnsembleStatistics& statistics) {
  std::string out;
  for (std::size_t place = 0; place < layout.places.size(); ++place) {
    if (!out.empty()) out += '\n';
    Table table;
    table.add(shown_column(layout.places[place].name),
              std::vector<std::string>{"mean", "+-", "std", "5 %", "50 %", "95 %"});
    for (std::size_t k = 0; k < layout.columns.size(); ++k) {
      const EnsembleColumn& column = layout.columns[k];
      if (column.meaning.shown.size == 0.0 || column.meaning.form.kind != Form::real) continue;
      const Statistics& found = statistics.places[place].columns[k];
      table.add(column.meaning, {found.mean, found.standard_error, found.deviation, found.percentile[1],
                                 found.percentile[3], found.percentile[5]});
    }
    out += table_blocks(table);
    out += lines_of_truths(layout, statistics.places[place]);
  }
  return out;
}

std::vector<std::string> warning_lines(const Case& input, const EnsembleLayout& layout,
                                       const EnsembleStatistics& statistics) {
  std::vector<std::string> lines = case_warnings(input);
  const std::size_t jumps = layout.column("jumps");
  const std::size_t lifted = layout.column("lifted_bumps_at_entry");
  if (jumps == layout.columns.size() || lifted == layout.columns.size()) return lines;
  for (std::size_t place = 0; place < layout.places.size(); ++place) {
    const Statistics& jumped = statistics.places[place].columns[jumps];
    const Statistics& off = statistics.places[place].columns[lifted];
    const double fewest = off.percentile.front();
    const double most = off.percentile.back();
    if (!(jumped.deviation > 0.0) && !(most - fewest > 1.0)) continue;
    lines.push_back(fmt::format(
        "{}: the samples lie on several branches of states, and the statistics mix them: {:.3g} jumps per sample, foil "
        "detached from {:.3g} to {:.3g} bumps at the inlet (1 % and 99 %); see jumps and lifted_bumps_at_entry",
        layout.places[place].name, jumped.mean, fewest, most));
  }
  return lines;
}

std::vector<std::string> failure_lines(const EnsembleLayout& layout, const EnsembleStatistics& statistics) {
  std::vector<std::string> lines;
  for (const SampleFailure& failure : statistics.failures) {
    lines.push_back(fmt::format("sample {}, {}: {}", failure.sample, layout.places[failure.place].name,
                                layout.status_reason(failure.status)));
  }
  return lines;
}

}  // namespace bumpfoil
