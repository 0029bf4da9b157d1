#include "bumpfoil/experiments/stability/stability.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

const StabilitySettings& settings_of(const Case& input) {
  const StabilitySettings* const settings = input.settings.find<StabilitySettings>();
  if (settings == nullptr) {
    throw Error(ErrorKind::input, {{"", 0, "stability", "", "this table is missing", "add [stability] with speeds"}});
  }
  return *settings;
}

}  // namespace

StabilityResult stability_not_begun(const Case& input) {
  const StabilitySettings& settings = settings_of(input);
  StabilityResult result{.machine = make_machine(input, settings.speeds, "stability"), .map = {}};
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
  std::size_t begun = 0;
  const auto goes_on = [&] {
    const std::size_t done = std::max<std::size_t>(begun, 1) - 1;
    return !progress || progress(static_cast<double>(done) / static_cast<double>(speeds.size()));
  };
  std::deque<FilmStepper> steppers = result.machine.make_steppers(goes_on);
  const std::vector<FilmStepper*> pointers = pointers_to(steppers);
  result.map = map_speeds(result.machine.rotor, pointers, rotor_settings_of(input).gravity_vector(), speeds, [&] {
    ++begun;
    return goes_on();
  });
  return result;
}

}  // namespace bumpfoil
