#include "experiments/transient/step_row.hpp"

#include <algorithm>

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): for the tables below

constexpr std::array<double WorkBalance::*, energy_columns> terms{
    &WorkBalance::entrained,  &WorkBalance::supplied, &WorkBalance::forces,  &WorkBalance::rubbing,
    &WorkBalance::dissipated, &WorkBalance::friction, &WorkBalance::damping, &WorkBalance::stored};

template <std::size_t i>
double energy_term(const StepView& step) {
  return step.energy.*terms[i];
}

constexpr auto step_quantity_table = std::to_array<StepQuantity>({
    {"time", "s", "time at the end of the step", [](const StepView& step) { return step.state.time; }},
    {"angle", "rad", "angle through which the rotor has turned", [](const StepView& step) { return step.state.angle; }},
    {"speed", "rad/s", "speed of the rotor, positive from X to Y",
     [](const StepView& step) { return step.state.speed; }},
    {"iterations",
     "1",
     "iterations of Newton's method",
     [](const StepView& step) { return static_cast<double>(step.iterations); },
     of_solver,
     "",
     {},
     whole_number},
    {"entrained_work", "J", "work of the turning journals on the gas that they drag along, in the step",
     energy_term<0>},
    {"supplied_work", "J", "work of gas that enters at edges above ambient pressure, in the step", energy_term<1>},
    {"force_work", "J", "work of weight, unbalance, pulses and base on the rotor, in the step", energy_term<2>},
    {"rubbing_work", "J", "work of the friction of asperities on the motion of the rotor, in the step", energy_term<3>},
    {"film_dissipation", "J", "dissipated by the flow of the films under gradients of pressure, in the step",
     energy_term<4>},
    {"friction_loss", "J", "energy dissipated by friction of the foils, in the step", energy_term<5>},
    {"rotor_damping_loss", "J", "energy dissipated by damping of the rotor, in the step", energy_term<6>},
    {"stored_energy_change", "J", "change of the energy of motion, of films, foils and asperities, in the step",
     energy_term<7>},
});

constexpr auto place_quantity_table = std::to_array<PlaceQuantity>({
    {"x", "m", "displacement of the axis along X", [](const Eigen::Vector2d& place) { return place.x(); }},
    {"y", "m", "displacement of the axis along Y", [](const Eigen::Vector2d& place) { return place.y(); }},
});

/// Asperities with a smaller load do not touch, N.
constexpr double no_asperity_load = 1e-9;

double asperity_load(const BearingView& view) {
  const BearingModel& bearing = view.bearing;
  if (!bearing.film->surroundings.asperities) return 0.0;
  const Matrix pressures = asperity_pressures(*bearing.film, view.state.film.thickness);
  const double load = asperity_force(*bearing.film, pressures, 0.0).head<2>().norm();
  return load < no_asperity_load ? 0.0 : load;
}

constexpr auto bearing_quantity_table = std::to_array<BearingQuantity>({
    {"h_min", "m", "minimum film thickness",
     [](const BearingView& view) {
       return view.bearing.film->scales.thickness * view.state.film.thickness.minCoeff();
     }},
    {"power", "W", "power of the film against rotation",
     [](const BearingView& view) { return film_bearing_outcome(view.bearing, view.state).power; }},
    {"asperity_load", "N", "force that asperities carry", asperity_load},
    {"loaded_bumps",
     "1",
     "bumps loaded by the top foil",
     [](const BearingView& view) {
       const Vector loads = bump_loads(view.bearing, view.state);
       return static_cast<double>(std::count_if(loads.begin(), loads.end(), [](double load) { return load > 0.0; }));
     },
     none,
     "",
     {},
     whole_number},
});

}  // namespace

std::span<const StepQuantity> step_quantities() {
  return step_quantity_table;
}
std::span<const PlaceQuantity> place_quantities() {
  return place_quantity_table;
}
std::span<const BearingQuantity> bearing_quantities() {
  return bearing_quantity_table;
}

std::array<double WorkBalance::*, energy_columns> energy_terms() {
  return terms;
}

std::size_t StepLayout::width() const {
  return step_quantity_table.size() + places * place_quantity_table.size() + bearings * bearing_quantity_table.size();
}

std::size_t column_of(StepColumn column) {
  return static_cast<std::size_t>(column);
}

std::size_t place_column(std::size_t place, std::size_t axis) {
  return step_quantity_table.size() + place * place_quantity_table.size() + axis;
}

std::size_t bearing_column(const StepLayout& layout, std::size_t bearing, BearingColumn column) {
  return step_quantity_table.size() + layout.places * place_quantity_table.size() +
         bearing * bearing_quantity_table.size() + static_cast<std::size_t>(column);
}

std::vector<double> step_row(const StepView& step) {
  const std::vector<RotorStation> places = step.machine.places();
  std::vector<double> row;
  row.reserve(StepLayout{.places = places.size(), .bearings = step.state.bearings.size()}.width());
  for (const StepQuantity& quantity : step_quantity_table) row.push_back(quantity.value(step));
  for (const RotorStation& place : places) {
    const Eigen::Vector2d at = place.motion * step.state.rotor.y;
    for (const PlaceQuantity& quantity : place_quantity_table) row.push_back(quantity.value(at));
  }
  for (std::size_t i = 0; i < step.state.bearings.size(); ++i) {
    const BearingView view{*step.machine.bearings[i], step.state.bearings[i]};
    for (const BearingQuantity& quantity : bearing_quantity_table) row.push_back(quantity.value(view));
  }
  return row;
}

}  // namespace bumpfoil
