#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "experiments/stability/stability_dataset.hpp"
#include "experiments/stability/stability_quantities.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_speeds_shown = 40;

std::string onset_lines(const StabilityResult& result) {
  std::string out;
  for (const bool by_coefficients : {false, true}) {
    for (const bool stuck : {false, true}) {
      std::string line;
      for (const WhirlOnset& found : result.map.onsets) {
        if (found.stuck != stuck || found.by_coefficients != by_coefficients) continue;
        line += (line.empty() ? "" : "; ") + onset_text(found);
      }
      if (line.empty()) line = "none between these speeds";
      out += fmt::format("{}, {}: {}\n", by_coefficients ? "by synchronous coefficients" : "onset of whirl",
                         stuck ? "full stick" : "contacts sliding", line);
    }
  }
  return out;
}

}  // namespace

std::string stability_table(const StabilityResult& result) {
  const std::size_t all = result.map.points.size();
  const std::size_t shown = std::min(all, most_speeds_shown);
  std::vector<std::string> columns{"speed"};
  for (const SpeedQuantity& quantity : speed_quantities()) {
    if (quantity.is(tag::shown_first)) columns.emplace_back(quantity.name);
  }
  columns.emplace_back("speed_status");
  const Table table = table_of(stability_dataset(result, false),
                               {.over = {"speed"}, .columns = std::move(columns), .rows = first_rows(shown)});
  return table_lines(table) + left_out("speeds", shown, all) + '\n' + onset_lines(result);
}

}  // namespace bumpfoil
