#include "experiments/equilibrium/running_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"

namespace bumpfoil {
namespace {

using Dims = std::vector<std::string>;

std::vector<double> node_values(const Vector& numbers) {
  return {numbers.begin(), numbers.end()};
}

Dims operator+(Dims dims, const Dims& more) {
  dims.insert(dims.end(), more.begin(), more.end());
  return dims;
}

const std::vector<Eigen::Vector2d>& journals_of(const EquilibriumSettings& settings) {
  return settings.loads.empty() ? settings.positions : settings.loads;
}

/// Describes states of a running bearing, one variable at a time.
class StateDataset {
 public:
  /// @param dims    of a quantity of states
  /// @param places  index of each state among its values
  StateDataset(const EquilibriumResult& result, Dims dims, std::vector<std::size_t> places)
      : result_(result), dims_(std::move(dims)), places_(std::move(places)) {}

  Dataset& data() { return data_; }

  /// @param but  tags of quantities to omit
  void add_quantities(Tags but) {
    for (const RunningQuantity& quantity : running_quantities(*result_.bearing, result_.with_limits)) {
      if (quantity.is(but)) continue;
      std::vector<double> values(result_.states.size(), absent);
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[places_[i]] = value_of(quantity, *result_.bearing, result_.states[i]);
      }
      data_.add(quantity.meaning(), dims_, std::move(values));
    }
  }

  void add_motions(const EquilibriumSettings& settings) { add_whirls(settings, result_, dims_, places_, data_); }

  /// Fraction of the force on each of several pads.
  void add_pads() {
    if (result_.bearing->film->pads.size() == 1) return;
    for (const int axis : {0, 1}) {
      const char letter = axis == 0 ? 'x' : 'y';
      add({fmt::format("pad_force_{}", letter), "N", fmt::format("part of force_{} carried by the pad", letter)},
          {"pad"}, [axis](const RunningState& state) -> RowMajorMatrix { return state.outcome->pad_forces.row(axis); });
    }
  }

  /// Values of every state that was found. @param values_of  state -> numbers, all of the same count
  template <typename ValuesOf>
  Variable& add(VariableMeaning meaning, const Dims& inside, ValuesOf values_of) {
    return data_.add(std::move(meaning), dims_ + inside, [values_of, &states = result_.states, places = places_] {
      std::vector<double> all;
      for (std::size_t i = 0; i < states.size(); ++i) {
        if (!states[i].found()) continue;
        const RowMajorMatrix values = values_of(states[i]);
        all.resize(states.size() * static_cast<std::size_t>(values.size()), absent);
        std::copy(values.data(), values.data() + values.size(),
                  all.begin() + static_cast<std::ptrdiff_t>(places[i]) * values.size());
      }
      return all;
    });
  }

  Dataset take() { return std::move(data_); }

 private:
  const EquilibriumResult& result_;
  Dims dims_;
  std::vector<std::size_t> places_;
  Dataset data_;
};

/// Positions of the columns, and their pads.
void add_columns(const BearingModel& bearing, Dataset& data) {
  const FilmModel& film = *bearing.film;
  Vector theta(film.columns());
  Vector phi(film.columns());
  Vector number(film.columns());
  for (std::size_t k = 0; k < film.pads.size(); ++k) {
    const FilmPad& pad = film.pads[k];
    const Vector angles = pad.foil.mesh.angles();
    theta(pad.columns()) = angles;
    phi(pad.columns()) = bearing.placed[k].polar(angles);
    number(pad.columns()).setConstant(static_cast<double>(k + 1));
  }
  data.dims.push_back({"column", static_cast<std::size_t>(film.columns())});
  data.add_coordinate({"column_theta", "rad", "angle of the column from the weld along the foil"}, {"column"},
                      node_values(theta));
  data.add_coordinate({"column_phi", "rad", "polar angle of the column from X towards Y"}, {"column"},
                      node_values(phi));
  if (film.pads.size() == 1) return;
  data.add_coordinate({"column_pad", "1", "pad that the column belongs to"}, {"column"}, node_values(number));
}

void add_geometry(const Case& input, const EquilibriumResult& result, const ResultLayout& layout, Dataset& data) {
  const BearingModel& bearing = *result.bearing;
  const FilmModel& film = *bearing.film;
  data.add_dimension({"state", "1", "state of the running bearing, in the order of computation", {Form::whole}},
                     numbers_from(1.0, result.states.size()));
  add_foils(layout, "sleeve", data);
  add_columns(bearing, data);
  const int rows = film.pads.front().foil.mesh.rows + 1;
  data.dims.push_back({"row", static_cast<std::size_t>(rows)});
  const double side = 0.5 * input.bearing.axial_length * film.pads.front().part;
  data.add_coordinate({"z", "m",
                       film.has_slits() ? "distance of the row from the middle of its strip, at pad_z; the last row "
                                          "is the edge of the strip"
                                        : "distance of the row from the mid-plane of the bearing; the last row is "
                                          "its side"},
                      {"row"}, node_values(Vector::LinSpaced(rows, film.tilts() ? -side : 0.0, side)));
  const Gas& gas = film.scales.gas;
  data.add_coordinate({"gas_viscosity", "Pa s", "viscosity of the gas"}, {}, {gas.viscosity});
  data.add_coordinate({"ambient_pressure", "Pa", "pressure at the edges of the film and behind the foils"}, {},
                      {gas.ambient_pressure});
}

void add_requested_positions(const EquilibriumResult& result, Dataset& data) {
  for (const int axis : {0, 1}) {
    const char letter = axis == 0 ? 'x' : 'y';
    data.add({fmt::format("position_{}", letter), "m",
              fmt::format("requested position of the journal, {}", axis == 0 ? 'X' : 'Y')},
             {"state"}, each(result.states, [axis](const RunningState& state) {
               return state.requested.control == Control::displacement ? state.requested.journal[axis] : absent;
             }));
  }
}

void add_film(const EquilibriumResult& result, StateDataset& states) {
  const BearingModel& bearing = *result.bearing;
  states
      .add({"pressure", "Pa", "pressure of the film"}, {"row", "column"},
           [&bearing](const RunningState& state) { return film_pressure(bearing, *state.last); })
      .compressed = true;
  const bool uniform = bearing.has_foils() && !bearing.film->varies_over_the_width();
  if (!uniform) {
    states
        .add({"film_thickness", "m", "film thickness"}, {"row", "column"},
             [&bearing](const RunningState& state) -> Matrix {
               return bearing.film->scales.thickness * state.last->film.thickness;
             })
        .compressed = true;
    if (bearing.film->surroundings.asperities) {
      states
          .add({"asperity_pressure", "Pa", "pressure of asperities, mean over those around"}, {"row", "column"},
               [&bearing](const RunningState& state) -> Matrix {
                 return bearing.film->scales.gas.ambient_pressure *
                        asperity_pressures(*bearing.film, state.last->film.thickness);
               })
          .compressed = true;
    }
  }
  if (!bearing.has_foils()) return;
  for (const ColumnQuantity& quantity : column_quantities()) {
    if (quantity.is(tag::of_asperities) && !bearing.film->surroundings.asperities) continue;
    if (quantity.is(tag::of_slope) && !has_mode(bearing, 1)) continue;
    if (quantity.is(tag::of_parabola) && !has_mode(bearing, 2)) continue;
    if (quantity.is(tag::of_uniform_film) && !uniform) continue;
    Variable& added = states.add(quantity.meaning(), {"column"}, [&bearing, quantity](const RunningState& state) {
      return quantity.value(bearing, *state.last);
    });
    added.attributes["coordinates"] = "column_theta column_phi";
    added.compressed = true;
  }
}

/// Foil quantities, as without a film, except for the contact with the journal, which does not exist.
void add_fields(const EquilibriumResult& result, const ResultLayout& layout, const Wording& wording,
                StateDataset& states) {
  const BearingModel& foils = *result.bearing;
  const auto fields = std::make_shared<FoilFields>(make_fields(foils, static_cast<int>(result.states.size())));
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    if (!result.states[i].found()) continue;
    record(foils, *result.states[i].last, static_cast<Eigen::Index>(i), *fields);
  }
  for (const FieldQuantity& quantity : field_quantities()) {
    if (quantity.name.ends_with("journal_top") || quantity.node == Node::pad) continue;
    if (quantity.value(*fields).cols() == 0) continue;
    VariableMeaning meaning = quantity.meaning();
    meaning.long_name = spelled(quantity.long_name, wording);
    const RunningState* const first = result.states.data();
    states
        .add(std::move(meaning), layout.dims_of(quantity.node),
             [fields, quantity, first](const RunningState& state) -> RowMajorMatrix {
               return quantity.value(*fields).row(&state - first);
             })
        .attributes["coordinates"] = layout.coordinates_of(quantity.node);
  }
}

}  // namespace

Dataset state_dataset(const Case& input, const EquilibriumResult& result) {
  const ResultLayout layout = make_film_layout(input);
  std::vector<std::size_t> places(result.states.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  StateDataset states(result, {"state"}, places);
  add_geometry(input, result, layout, states.data());
  states.add_quantities(tag::none);
  add_requested_positions(result, states.data());
  states.add_motions(input.settings.get<EquilibriumSettings>());
  states.add_pads();
  add_film(result, states);
  if (result.bearing->has_foils()) add_fields(result, layout, wording_of(input, Experiment::cycle), states);
  return states.take();
}

std::size_t place_of(const EquilibriumSettings& settings, std::size_t state) {
  // A ramp of speeds runs through all speeds under each load, other paths through all loads at each speed.
  if (settings.path != FilmPath::speed_ramp) return state;
  const std::size_t speeds = settings.speeds.size();
  return state % speeds * journals_of(settings).size() + state / speeds;
}

Dataset equilibrium_dataset(const EquilibriumSettings& settings, const EquilibriumResult& result) {
  const std::vector<Eigen::Vector2d>& journals = journals_of(settings);
  const bool by_load = !settings.loads.empty();
  const std::string journal = by_load ? "load" : "position";
  const std::string what = by_load ? "load on the journal" : "position of the journal";
  const std::string unit = by_load ? "N" : "m";
  std::vector<std::size_t> places(result.states.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = place_of(settings, i);
  StateDataset states(result, {"speed", journal}, places);
  Dataset& data = states.data();
  data.add_dimension({"speed", "rad/s", "speed of the journal, positive from X to Y"}, settings.speeds);
  data.add_dimension({journal, "1", what + ", in the order of the case", {Form::whole}},
                     numbers_from(1.0, journals.size()));
  data.add_coordinate({journal + "_x", unit, "requested " + what + ", X"}, {journal},
                      each(journals, [](const Eigen::Vector2d& vector) { return vector.x(); }));
  data.add_coordinate({journal + "_y", unit, "requested " + what + ", Y"}, {journal},
                      each(journals, [](const Eigen::Vector2d& vector) { return vector.y(); }));
  // Requested values are equal over rows and columns: stored as coordinates.
  states.add_quantities(tag::demand);
  if (const std::size_t pads = result.bearing->film->pads.size(); pads > 1) {
    data.add_dimension({"pad", "1", "pad, in the order of the case", {Form::whole}}, numbers_from(1.0, pads));
  }
  states.add_pads();
  states.add_motions(settings);
  return states.take();
}

EquilibriumResult equilibrium_not_begun(const Case& input) {
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  EquilibriumResult result;
  Case bearing = input;
  bearing.settings.remove<EquilibriumSettings>();  // a layout of all speeds is not a runnable case
  result.bearing = std::make_shared<const BearingModel>(make_film_bearing(bearing));
  result.states = planned_states(equilibrium, Status::interrupted);
  result.with_limits = equilibrium.limits;
  return result;
}

}  // namespace bumpfoil
