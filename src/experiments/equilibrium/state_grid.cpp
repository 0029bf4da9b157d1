#include "experiments/equilibrium/state_grid.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

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
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::vector<double> node_values(const Vector& numbers) {
  return {numbers.begin(), numbers.end()};
}

class StateGrid {
 public:
  StateGrid(const Case& input, const EquilibriumResult& result)
      : input_(input),
        result_(result),
        rows_(result.bearing->pads.front().foil.mesh.rows),
        layout_(make_result_layout(input, Experiment::cycle)),
        wording_(wording_of(input, Experiment::cycle)) {
    grid_.dims = {{"state", result.states.size()},
                  {"row", static_cast<std::size_t>(rows_) + 1},
                  {"column", static_cast<std::size_t>(result.bearing->columns())},
                  {"bump", layout_.bumps},
                  {"foot", layout_.feet}};
    if (layout_.pads > 1) grid_.dims.push_back({"pad", layout_.pads});
  }

  void add_geometry() {
    const auto count = [&](const std::string& name, const std::string& meaning, std::size_t size) {
      put({name, "1", meaning, {Form::whole}}, {name}, numbers_from(1.0, size));
    };
    count("state", "state of the running bearing, in the order in which they were looked for", result_.states.size());
    const bool several = layout_.pads > 1;
    count("bump", several ? "bump, counted from the weld, pad after pad" : "bump, counted from the weld",
          layout_.bumps);
    count("foot", "foot of the bump foil on the sleeve, counted from the weld", layout_.feet);
    if (several) count("pad", "pad, in the order of the case", layout_.pads);
    add_columns();
    put({"z", "m", "distance of the row from the mid-plane of the bearing; the last row is its side"}, {"row"},
        node_values(Vector::LinSpaced(rows_ + 1, 0.0, 0.5 * input_.bearing.axial_length)));
    for (const NamedNumbers& scalar : layout_.scalars) put(scalar, {});
    for (const NamedNumbers& numbers : layout_.at_bumps) put(numbers, {"bump"});
    for (const NamedNumbers& numbers : layout_.at_feet) put(numbers, {"foot"});
    for (const NamedNumbers& numbers : layout_.at_pads) put(numbers, {"pad"});
    const Gas& gas = result_.bearing->scales.gas;
    put({"gas_viscosity", "Pa s", "viscosity of the gas", {gas.viscosity}}, {});
    put({"ambient_pressure", "Pa", "pressure at the edges of the film and behind the foils", {gas.ambient_pressure}},
        {});
  }

  void add_quantities() {
    const auto of_all = [&](auto&& value) {
      std::vector<double> values;
      std::transform(result_.states.begin(), result_.states.end(), std::back_inserter(values), value);
      return values;
    };
    for (const RunningQuantity& quantity : running_quantities(*result_.bearing, !result_.limits.empty())) {
      add(meaning(quantity, quantity.form), {"state"},
          of_all([&](const RunningState& state) { return value_of(quantity, *result_.bearing, state); }));
    }
    const auto asked = [&](int axis) {
      return of_all([axis](const RunningState& state) {
        return state.asked.control == Control::displacement ? state.asked.journal[axis] : absent;
      });
    };
    add({"position_x", "m", "position of the journal that was asked for, X"}, {"state"}, asked(0));
    add({"position_y", "m", "position of the journal that was asked for, Y"}, {"state"}, asked(1));
  }

  void add_motions() {
    std::vector<std::size_t> places(result_.states.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    add_whirls(*input_.equilibrium, result_, {"state"}, places, grid_);
  }

  /// What each of several pads takes of the force.
  void add_pads() {
    if (layout_.pads == 1) return;
    for (const int axis : {0, 1}) {
      std::vector<double> forces(result_.states.size() * layout_.pads, absent);
      for_each_found([&](std::size_t i, const BearingState&) {
        const auto row = result_.states[i].outcome->pad_forces.row(axis);
        std::copy(row.begin(), row.end(), forces.begin() + static_cast<std::ptrdiff_t>(i * layout_.pads));
      });
      const std::string letter(1, axis == 0 ? 'x' : 'y');
      add({"pad_force_" + letter, "N", "part of force_" + letter + " that the pad takes"}, {"state", "pad"},
          std::move(forces));
    }
  }

  void add_film() {
    add_nodes({"pressure", "Pa", "pressure of the film"}, film_pressure);
    if (!result_.bearing->has_foils()) return add_thickness();
    for (const ColumnQuantity& quantity : column_quantities()) {
      GridVariable& variable =
          add(meaning(quantity), {"state", "column"},
              of_states([&](const BearingState& state) { return quantity.values(*result_.bearing, state); }));
      variable.coordinates = "column_theta column_phi";
      variable.compressed = true;
    }
  }

  /// What is known of the foils without a film, too, but for the contact with the journal, which there is none of.
  void add_foils() {
    const Foils& foils = *result_.bearing;
    FoilFields fields = make_fields(foils, static_cast<int>(result_.states.size()));
    for_each_found(
        [&](std::size_t i, const BearingState& state) { record(foils, state, static_cast<Eigen::Index>(i), fields); });
    for (const FieldQuantity& quantity : field_quantities()) {
      if (quantity.name.ends_with("journal_top") || quantity.node == Node::pad) continue;
      const FieldMatrix values = quantity.values(fields);
      if (values.cols() == 0) continue;
      Dims dims{"state"};
      const bool of_all = quantity.node == Node::foil || quantity.node == Node::weld;
      if (quantity.node == Node::weld && layout_.pads > 1) dims.emplace_back("pad");
      if (!of_all) dims.emplace_back(quantity.node == Node::foot ? "foot" : "bump");
      std::vector<double> found(static_cast<std::size_t>(values.size()), absent);
      for_each_found([&](std::size_t i, const BearingState&) {
        const auto row = values.row(static_cast<Eigen::Index>(i));
        std::copy(row.begin(), row.end(), found.begin() + static_cast<Eigen::Index>(i) * values.cols());
      });
      GridVariable& variable = add({std::string(quantity.name), std::string(quantity.unit),
                                    spelled(quantity.long_name, wording_), quantity.form},
                                   std::move(dims), std::move(found));
      if (of_all) continue;
      variable.coordinates = quantity.node == Node::foot ? layout_.foot_coordinates : layout_.bump_coordinates;
    }
  }

  ResultGrid take() { return std::move(grid_); }

 private:
  /// Where the columns are, and whose.
  void add_columns() {
    const FilmBearing& bearing = *result_.bearing;
    const std::vector<PlacedPad> placed = place_pads(input_);
    Vector theta(bearing.columns());
    Vector phi(bearing.columns());
    Vector number(bearing.columns());
    for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
      const FilmPad& pad = bearing.pads[k];
      const Vector angles = pad.foil.mesh.angles();
      theta(pad.columns()) = angles;
      phi(pad.columns()) = polar_angles(placed[k].alone.bearing, angles);
      number(pad.columns()).setConstant(static_cast<double>(k + 1));
    }
    put({"column_theta", "rad", "angle of the column from the weld along the foil"}, {"column"}, node_values(theta));
    put({"column_phi", "rad", "polar angle of the column from X towards Y"}, {"column"}, node_values(phi));
    if (layout_.pads > 1) put({"column_pad", "1", "pad that the column belongs to"}, {"column"}, node_values(number));
  }

  template <typename Quantity>
  [[nodiscard]] static VariableMeaning meaning(const Quantity& quantity, const Form& form = {}) {
    return {std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name), form};
  }

  /// Over a wall that yields it is not the same over the width.
  void add_thickness() {
    add_nodes({"film_thickness", "m", "film thickness"},
              [](const FilmBearing& bearing, const BearingState& state) -> Matrix {
                return bearing.scales.thickness * state.film.thickness;
              });
  }

  /// Values at all nodes of every state.
  template <typename Values>
  void add_nodes(const VariableMeaning& nodes, Values&& values_of) {
    add(nodes, {"state", "row", "column"},
        of_states([&](const BearingState& state) { return values_of(*result_.bearing, state); }))
        .compressed = true;
  }

  /// The values of every state, one after the other; of those that were not found as many that are absent.
  template <typename Values>
  [[nodiscard]] std::vector<double> of_states(Values&& values_of) const {
    std::vector<double> all;
    for_each_found([&](std::size_t i, const BearingState& state) {
      const RowMajor values = values_of(state);
      all.resize(result_.states.size() * static_cast<std::size_t>(values.size()), absent);
      std::copy(values.data(), values.data() + values.size(),
                all.begin() + static_cast<Eigen::Index>(i) * values.size());
    });
    return all;
  }

  template <typename Visitor>
  void for_each_found(Visitor&& visit) const {
    for (std::size_t i = 0; i < result_.states.size(); ++i) {
      if (result_.states[i].found()) visit(i, *result_.states[i].last);
    }
  }

  void put(const NamedNumbers& numbers, Dims dims) {
    put({numbers.name, numbers.unit, numbers.long_name}, std::move(dims), numbers.values);
  }

  void put(VariableMeaning meaning, Dims dims, std::vector<double> values) {
    grid_.coordinates.push_back({std::move(meaning), std::move(dims), std::move(values)});
  }

  GridVariable& add(VariableMeaning meaning, Dims dims, std::vector<double> values) {
    return grid_.variables.emplace_back(GridVariable{std::move(meaning), std::move(dims), std::move(values)});
  }

  const Case& input_;
  const EquilibriumResult& result_;
  int rows_;
  ResultLayout layout_;
  Wording wording_;
  ResultGrid grid_;
};

}  // namespace

ResultGrid state_grid(const Case& input, const EquilibriumResult& result) {
  StateGrid grid(input, result);
  grid.add_geometry();
  grid.add_quantities();
  grid.add_motions();
  grid.add_pads();
  grid.add_film();
  if (result.bearing->has_foils()) grid.add_foils();
  return grid.take();
}

}  // namespace bumpfoil
