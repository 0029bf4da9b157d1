#include "experiments/equilibrium/equilibrium_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"

namespace bumpfoil {
namespace {

/// What tables of sweeps show.
constexpr std::array<std::string_view, 6> headlines{"eccentricity_ratio", "attitude_angle", "h_min", "power",
                                                    "lift_off_speed",     "load_capacity"};
/// What was asked for is the same for whole rows and columns: coordinates.
constexpr std::array<std::string_view, 3> demands{"speed", "load_x", "load_y"};

bool has(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<Eigen::Vector2d>& journals_of(const EquilibriumSettings& settings) {
  return settings.loads.empty() ? settings.positions : settings.loads;
}

std::vector<double> components(const std::vector<Eigen::Vector2d>& vectors, int axis) {
  std::vector<double> numbers;
  std::transform(vectors.begin(), vectors.end(), std::back_inserter(numbers),
                 [axis](const Eigen::Vector2d& vector) { return vector[axis]; });
  return numbers;
}

/// What each of several pads takes of the force.
void add_pads(const EquilibriumSettings& settings, const EquilibriumResult& result, const std::string& journal,
              ResultGrid& grid) {
  const std::size_t pads = result.bearing->pads.size();
  if (pads == 1) return;
  grid.dims.push_back({"pad", pads});
  grid.coordinates.push_back(
      {{"pad", "1", "pad, in the order of the case", {Form::whole}}, {"pad"}, numbers_from(1.0, pads)});
  for (const auto& [axis, name] : {std::pair{0, "x"}, std::pair{1, "y"}}) {
    std::vector<double> values(result.states.size() * pads, absent);
    for (std::size_t i = 0; i < result.states.size(); ++i) {
      if (!result.states[i].found()) continue;
      const auto row = result.states[i].outcome->pad_forces.row(axis);
      std::copy(row.begin(), row.end(), values.begin() + static_cast<std::ptrdiff_t>(place_of(settings, i) * pads));
    }
    grid.variables.push_back(
        GridVariable{{fmt::format("pad_force_{}", name), "N", fmt::format("part of force_{} that the pad takes", name)},
                     {"speed", journal, "pad"},
                     std::move(values)});
  }
}

}  // namespace

std::size_t place_of(const EquilibriumSettings& settings, std::size_t state) {
  // A ramp of speeds goes through all of them under each load, other paths through all loads at each speed.
  if (settings.path != FilmPath::speed_ramp) return state;
  const std::size_t speeds = settings.speeds.size();
  return state % speeds * journals_of(settings).size() + state / speeds;
}

ResultGrid equilibrium_grid(const EquilibriumSettings& settings, const EquilibriumResult& result) {
  const std::vector<Eigen::Vector2d>& journals = journals_of(settings);
  const bool by_load = !settings.loads.empty();
  const std::string journal = by_load ? "load" : "position";
  const std::string what = by_load ? "load on the journal" : "position of the journal";
  const std::string unit = by_load ? "N" : "m";
  ResultGrid grid;
  grid.dims = {{"speed", settings.speeds.size()}, {journal, journals.size()}};
  grid.coordinates = {{{"speed", "rad/s", "speed of the journal, positive from X to Y"}, {"speed"}, settings.speeds},
                      {{journal, "1", what + ", in the order of the case", {Form::whole}},
                       {journal},
                       numbers_from(1.0, journals.size())},
                      {{journal + "_x", unit, what + " that was asked for, X"}, {journal}, components(journals, 0)},
                      {{journal + "_y", unit, what + " that was asked for, Y"}, {journal}, components(journals, 1)}};
  for (const RunningQuantity& quantity : running_quantities(*result.bearing, !result.limits.empty())) {
    if (has(demands, quantity.name)) continue;
    std::vector<double> values(result.states.size(), absent);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[place_of(settings, i)] = value_of(quantity, *result.bearing, result.states[i]);
    }
    GridVariable& variable = grid.variables.emplace_back(GridVariable{
        {std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name), quantity.form},
        {"speed", journal},
        std::move(values)});
    if (!has(headlines, quantity.name)) continue;
    variable.heading = quantity.label;
    variable.shown = quantity.shown;
  }
  add_pads(settings, result, journal, grid);
  std::vector<std::size_t> places(result.states.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = place_of(settings, i);
  add_whirls(settings, result, {"speed", journal}, places, grid);
  return grid;
}

EquilibriumResult equilibrium_not_begun(const Case& input) {
  EquilibriumResult result;
  result.bearing = std::make_shared<const FilmBearing>(make_film_bearing(input));
  result.states = planned_states(*input.equilibrium, FilmStatus::interrupted);
  return result;
}

}  // namespace bumpfoil
