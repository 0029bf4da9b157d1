#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {
namespace {

/// Multiple of the highest speed up to which frequencies matter, as in usual_window().
constexpr double highest_whirl_ratio = 2.0;

/// Film mesh of a bearing under a rotor. Foils with displacements that vary over the width, at least by strips, respond
/// to a tilting rotor, and both halves differ.
FilmResolution resolution_under(const RotorSettings& rotor, const Case& bearing) {
  FilmResolution resolution = resolution_of(bearing);
  if (rotor.tilts() && (bearing.width.modes > 1 || bearing.top_foil.split)) resolution.width = WidthPart::whole;
  return resolution;
}

}  // namespace

Machine make_machine(const Case& input, const std::vector<double>& speeds, const std::string& command) {
  require_valid(input, {command});
  const RotorSettings& settings = input.settings.get<RotorSettings>();
  double highest = 0.0;
  for (const double speed : speeds) highest = std::max(highest, std::abs(speed));
  const std::size_t places = settings.tilts() ? settings.bearing_count() : 1;
  std::vector<Case> cases;
  std::vector<double> half_widths;
  Machine machine;
  for (std::size_t i = 0; i < places; ++i) {
    cases.push_back(bearing_at(input, i));
    const auto alike = static_cast<std::size_t>(std::find(cases.begin(), cases.end(), cases.back()) - cases.begin());
    machine.bearings.push_back(
        alike < i ? machine.bearings[alike]
                  : std::make_shared<const BearingModel>(make_film_bearing(cases.back(), gas_of(cases.back().gas),
                                                                           resolution_under(settings, cases.back()))));
    machine.thickness_floors.push_back(thickness_floor(cases.back()));
    half_widths.push_back(machine.bearings.back()->film->tilts() ? machine.bearings.back()->film->half_width() : 0.0);
  }
  ReducedRotor reduced = rotor_of(settings, highest_whirl_ratio * highest, half_widths);
  machine.rotor = std::move(reduced.rotor);
  machine.reduction_error = reduced.frequency_error;
  machine.loads = weights_on_bearings(machine.rotor, settings.gravity_vector());
  return machine;
}

std::vector<RotorStation> Machine::places() const {
  std::vector<RotorStation> all = rotor.bearings;
  all.insert(all.end(), rotor.stations.begin(), rotor.stations.end());
  return all;
}

double Machine::thinnest_film(std::size_t bearing, const BearingState& state) const {
  return state.film.thickness.minCoeff() * bearings[bearing]->film->scales.thickness;
}

double Machine::thinnest_film(const std::vector<BearingState>& states) const {
  if (states.empty()) return std::numeric_limits<double>::quiet_NaN();
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < states.size(); ++i) thinnest = std::min(thinnest, thinnest_film(i, states[i]));
  return thinnest;
}

std::deque<FilmStepper> Machine::make_steppers(const std::function<bool()>& keep_going) const {
  std::deque<FilmStepper> steppers;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    FilmBearingOptions options;
    options.keep_going = keep_going;
    options.newton.thickness_floor = thickness_floors[i] / bearings[i]->film->scales.thickness;
    steppers.emplace_back(bearings[i], options);
  }
  return steppers;
}

std::vector<FilmStepper*> pointers_to(std::deque<FilmStepper>& steppers) {
  std::vector<FilmStepper*> pointers;
  pointers.reserve(steppers.size());
  for (FilmStepper& stepper : steppers) pointers.push_back(&stepper);
  return pointers;
}

}  // namespace bumpfoil
