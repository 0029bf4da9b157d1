#include "bumpfoil/experiments/stability/stability.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <memory>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {
namespace {

/// Frequencies of interest end at this multiple of the highest speed, as those of usual_window() do.
constexpr double highest_whirl_ratio = 2.0;

const StabilitySettings& settings_of(const Case& input) {
  const StabilitySettings* const settings = input.settings.find<StabilitySettings>();
  if (settings == nullptr) {
    throw Error(ErrorKind::input, {{"", 0, "stability", "", "this table is missing", "add [stability] with speeds"}});
  }
  return *settings;
}

double highest(const std::vector<double>& speeds) {
  double most = 0.0;
  for (const double speed : speeds) most = std::max(most, std::abs(speed));
  return most;
}

}  // namespace

bool StabilityResult::converged() const {
  return std::all_of(map.points.begin(), map.points.end(),
                     [](const SpeedPoint& point) { return point.status == Status::converged; });
}

StabilityResult stability_not_begun(const Case& input) {
  require_valid(input, {"stability"});
  const RotorSettings& rotor = rotor_settings_of(input);
  const StabilitySettings& settings = settings_of(input);
  ReducedRotor reduced = rotor_of(rotor, highest_whirl_ratio * highest(settings.speeds));
  StabilityResult result{.bearing = std::make_shared<const FilmBearing>(make_film_bearing(input)),
                         .rotor = std::move(reduced.rotor),
                         .reduction_error = reduced.frequency_error,
                         .loads = {},
                         .map = {}};
  result.loads = weights_on_bearings(result.rotor, rotor.gravity_vector());
  for (const double speed : settings.speeds) {
    SpeedPoint& point = result.map.points.emplace_back();
    point.speed = speed;
    point.status = Status::interrupted;
  }
  return result;
}

StabilityResult run_stability(const Case& input, const std::function<bool(double)>& progress) {
  StabilityResult result = stability_not_begun(input);
  const std::vector<double>& speeds = settings_of(input).speeds;
  FilmBearingOptions options;
  options.newton.thickness_floor = thickness_floor(input) / result.bearing->scales.thickness;
  std::deque<FilmStepper> steppers;
  std::vector<FilmStepper*> pointers;
  for (std::size_t i = 0; i < result.rotor.bearings.size(); ++i) {
    pointers.push_back(&steppers.emplace_back(result.bearing, options));
  }
  std::size_t done = 0;
  result.map = map_speeds(result.rotor, pointers, rotor_settings_of(input).gravity_vector(), speeds, [&] {
    return !progress || progress(static_cast<double>(done++) / static_cast<double>(speeds.size()));
  });
  return result;
}

}  // namespace bumpfoil
