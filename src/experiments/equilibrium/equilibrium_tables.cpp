#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"

#include <algorithm>

#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"

namespace bumpfoil {

Table state_table(const EquilibriumResult& result) {
  Table table;
  for (const RunningQuantity& quantity : running_quantities(*result.bearing, result.with_limits)) {
    if (!quantity.is(tag::csv)) continue;
    table.add(quantity.meaning(), each(result.states, [&](const RunningState& state) {
                return value_of(quantity, *result.bearing, state);
              }));
  }
  return table;
}

Table film_coefficient_table(const EquilibriumResult& result) {
  struct Row {
    const RunningState& state;
    const FilmWhirl& whirl;
  };
  std::vector<Row> rows;
  for (const RunningState& state : result.states) {
    if (!state.found()) continue;
    for (const FilmWhirl& whirl : state.whirls) rows.push_back({state, whirl});
  }
  Table table;
  table.add({"speed", "rad/s", ""}, each(rows, [](const Row& row) { return row.state.requested.speed; }));
  for (const int axis : {0, 1}) {
    table.add({axis == 0 ? "load_x" : "load_y", "N", ""}, each(rows, [axis](const Row& row) {
                return row.state.requested.by_load() ? row.state.requested.journal[axis] : absent;
              }));
  }
  for (const int axis : {0, 1}) {
    table.add({axis == 0 ? "x" : "y", "m", ""},
              each(rows, [axis](const Row& row) { return row.state.last->position[axis]; }));
  }
  table.add({"path", "", ""}, each(rows, [](const Row& row) { return std::string(name_of(row.state.path)); }));
  table.add({"frequency", "rad/s", ""}, each(rows, [](const Row& row) { return row.whirl.frequency; }));
  for (const WhirlQuantity& quantity : whirl_quantities(result.bearing->film->motions())) {
    table.add({quantity.name(), quantity.unit, quantity.long_name},
              each(rows, [&quantity](const Row& row) { return quantity.value(row.whirl); }));
  }
  return table;
}

std::vector<PathSpread> path_spreads(const EquilibriumResult& result) {
  std::vector<PathSpread> spreads;
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    const RunningState& state = result.states[i];
    if (!state.found()) continue;
    const auto same = std::find_if(spreads.begin(), spreads.end(), [&](const PathSpread& spread) {
      const RunningState& first = result.states[spread.states.front()];
      return first.requested == state.requested && first.path != state.path;
    });
    if (same == spreads.end()) {
      spreads.push_back({{i}});
    } else {
      same->states.push_back(i);
    }
  }
  std::erase_if(spreads, [](const PathSpread& spread) { return spread.states.size() < 2; });
  return spreads;
}

}  // namespace bumpfoil
