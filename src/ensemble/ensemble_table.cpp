#include "bumpfoil/ensemble/ensemble_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/case_warnings.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t quantity_width = 30;
constexpr std::size_t quantity_unit_width = 7;
constexpr std::size_t cell_width = 11;

/// Number of samples for which something is true.
std::string lines_of_truths(const EnsembleLayout& layout, const PlaceStatistics& statistics) {
  std::string out;
  for (std::size_t column = 0; column < layout.columns.size(); ++column) {
    const VariableMeaning& meaning = layout.columns[column].meaning;
    if (meaning.label.empty() || meaning.form.kind != Form::truth) continue;
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
    out += fmt::format("{:<{}}", layout.places[place].name, quantity_width + quantity_unit_width);
    for (const std::string_view head : {"mean", "+-", "std", "5 %", "50 %", "95 %"}) {
      out += fmt::format("{:>{}}", head, cell_width);
    }
    out += fmt::format("\n{:-<{}}\n", "", quantity_width + quantity_unit_width + 6 * cell_width);
    for (std::size_t k = 0; k < layout.columns.size(); ++k) {
      const EnsembleColumn& column = layout.columns[k];
      if (column.meaning.label.empty() || column.meaning.form.kind != Form::real) continue;
      const Statistics& found = statistics.places[place].columns[k];
      const double unit = column.meaning.shown.size;
      std::vector<std::string> cells;
      for (const double value : {found.mean, found.standard_error, found.deviation, found.percentile[1],
                                 found.percentile[3], found.percentile[5]}) {
        cells.push_back(number_text(value, unit));
      }
      out += fmt::format("{:<{}}{:<{}}", column.meaning.label, quantity_width,
                         unit_beside(column.meaning.shown.name, cells), quantity_unit_width);
      for (const std::string& text : cells) out += fmt::format("{:>{}}", text, cell_width);
      out += '\n';
    }
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
