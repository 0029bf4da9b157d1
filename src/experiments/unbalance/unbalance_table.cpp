#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/unbalance/unbalance_quantities.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_responses_shown = 40;
/// Stations shown on the terminal: the bearings, and the first others.
constexpr std::size_t most_stations_shown = 4;

std::string_view heading_of(ResponseKind kind) {
  constexpr std::array<std::string_view, 3> headings{"Small orbits, contacts sliding", "Small orbits, full stick",
                                                     "Periodic orbits with friction, 1x"};
  return headings.at(static_cast<std::size_t>(kind));
}

/// Responses of a kind at the first speeds, of all stations side by side.
Table responses_side_by_side(const Dataset& data, ResponseKind kind, const std::vector<RotorStation>& stations,
                             std::size_t speeds) {
  const auto rows_at = [&](std::size_t station) {
    std::vector<std::vector<std::size_t>> rows = first_rows(speeds);
    for (std::vector<std::size_t>& row : rows) row.insert(row.end(), {static_cast<std::size_t>(kind), station});
    return rows;
  };
  const std::vector<std::string> over{"speed", "kind", "station"};
  Table table = table_of(data, {.over = over, .columns = {"speed"}, .rows = rows_at(0)});
  for (std::size_t i = 0; i < std::min(stations.size(), most_stations_shown); ++i) {
    Table one = table_of(
        data, {.over = over, .columns = {"amplitude_x", "phase_x", "amplitude_y", "phase_y"}, .rows = rows_at(i)});
    for (TableColumn& column : one.columns) {
      column.meaning.label = fmt::format("{}: {}", stations[i].name, column.meaning.label);
      table.columns.push_back(std::move(column));
    }
  }
  table.columns.push_back(
      table_of(data, {.over = over, .columns = {"response_status"}, .rows = rows_at(0)}).columns.front());
  return table;
}

/// Orbits at the first speeds: the thinnest film of the bearings, and the sum of their losses.
Table orbits_of_bearings(const UnbalanceResult& result, const Dataset& data, std::size_t speeds) {
  std::vector<std::vector<std::size_t>> rows = first_rows(speeds);
  for (std::vector<std::size_t>& row : rows) row.push_back(static_cast<std::size_t>(ResponseKind::orbit));
  Table table = table_of(
      data, {.over = {"speed", "kind"},
             .columns = {"speed", "response_status", "orbit_turns", "orbit_lasts", "largest_multiplier", "orbit_h_min"},
             .rows = std::move(rows)});
  const auto add_sum = [&](VariableMeaning meaning, double BearingTurn::*loss) {
    std::vector<double> sums(speeds, absent);
    for (std::size_t i = 0; i < speeds; ++i) {
      const auto& orbit = result.points[i].orbit;
      if (!orbit || orbit->turn.empty()) continue;
      sums[i] = 0.0;
      for (const BearingTurn& turn : orbit->turn) sums[i] += turn.*loss;
    }
    table.add(std::move(meaning), std::move(sums));
  };
  add_sum(shown_column("friction loss", {"uJ", 1e-6}), &BearingTurn::friction);
  add_sum(shown_column("power", shown::watts), &BearingTurn::power);
  return table;
}

}  // namespace

std::string unbalance_table(const UnbalanceResult& result) {
  const Dataset data = unbalance_dataset(result);
  const std::vector<RotorStation> stations = result.machine.places();
  const std::size_t listed = std::min(result.points.size(), most_responses_shown);
  const std::string more = left_out("speeds", listed, result.points.size());
  std::string out;
  for (const ResponseKind kind : kinds_of(result)) {
    out += fmt::format("{}\n{}{}\n", heading_of(kind),
                       table_lines(responses_side_by_side(data, kind, stations, listed)), more);
  }
  if (result.with_orbits) out += table_lines(orbits_of_bearings(result, data, listed)) + more + '\n';
  const std::vector<ResponsePeak> peaks = peaks_of(result);
  for (const ResponsePeak& peak : peaks) {
    out += fmt::format("peak, {}: orbit of {:.4g} um at {:.6g} rpm, {}\n", name_of(peak.kind), 1e6 * peak.amplitude,
                       peak.speed / shown::revolutions.size, peak.station);
  }
  if (peaks.empty()) out += "the orbits have no peak between these speeds\n";
  return out;
}

}  // namespace bumpfoil
