#include "bumpfoil/io/ensemble_table.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "io/number_text.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t quantity_width = 30;
constexpr std::size_t quantity_unit_width = 7;
constexpr std::size_t cell_width = 11;

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
      if (column.label.empty()) continue;
      const Statistics& found = statistics.places[place].columns[k];
      const double unit = column.shown.size;
      std::vector<std::string> cells;
      for (const double value : {found.mean, found.standard_error, found.deviation, found.percentile[1],
                                 found.percentile[3], found.percentile[5]}) {
        cells.push_back(number_text(value, unit));
      }
      out += fmt::format("{:<{}}{:<{}}", column.label, quantity_width, unit_beside(column.shown.name, cells),
                         quantity_unit_width);
      for (const std::string& text : cells) out += fmt::format("{:>{}}", text, cell_width);
      out += '\n';
    }
  }
  return out;
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
