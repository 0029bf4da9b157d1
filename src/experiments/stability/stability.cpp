#include "bumpfoil/experiments/stability/stability.hpp"

#include <cstddef>
#include <deque>
#include <memory>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/build.hpp"

namespace bumpfoil {

Rotor rotor_of(const RotorSettings& settings) {
  if (!settings.tilts()) return make_point_mass(0.5 * settings.mass);
  return make_rigid_rotor({.mass = settings.mass,
                           .transverse_inertia = settings.transverse_inertia.value_or(0.0),
                           .polar_inertia = settings.polar_inertia.value_or(0.0),
                           .bearings = settings.bearings});
}

SpeedMap run_stability(const Case& input, const std::function<bool(double)>& progress) {
  const RotorSettings* const rotor_settings = input.settings.find<RotorSettings>();
  const StabilitySettings* const settings = input.settings.find<StabilitySettings>();
  BUMPFOIL_ASSERT(rotor_settings != nullptr && settings != nullptr);
  const Rotor rotor = rotor_of(*rotor_settings);
  const auto bearing = std::make_shared<const FilmBearing>(make_film_bearing(input));
  FilmBearingOptions options;
  options.newton.thickness_floor = input.film.h_floor / bearing->scales.thickness;
  std::deque<FilmStepper> steppers;
  std::vector<FilmStepper*> pointers;
  for (std::size_t i = 0; i < rotor.bearings.size(); ++i) pointers.push_back(&steppers.emplace_back(bearing, options));
  std::size_t done = 0;
  return map_speeds(rotor, pointers, {rotor_settings->gravity[0], rotor_settings->gravity[1]}, settings->speeds, [&] {
    return !progress || progress(static_cast<double>(done++) / static_cast<double>(settings->speeds.size()));
  });
}

}  // namespace bumpfoil
