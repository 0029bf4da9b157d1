#include "bumpfoil/experiments/stability/stability.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>

namespace bumpfoil {

StabilityResult stability_not_begun(const Case& input) {
  const StabilitySettings& settings = input.settings.get<StabilitySettings>();
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
  const std::vector<double>& speeds = input.settings.get<StabilitySettings>().speeds;
  std::size_t begun = 0;
  const auto goes_on = [&] {
    const std::size_t done = std::max<std::size_t>(begun, 1) - 1;
    return !progress || progress(static_cast<double>(done) / static_cast<double>(speeds.size()));
  };
  std::deque<FilmStepper> steppers = result.machine.make_steppers(goes_on);
  const std::vector<FilmStepper*> pointers = pointers_to(steppers);
  result.map =
      map_speeds(result.machine.rotor, pointers, input.settings.get<RotorSettings>().gravity_vector(), speeds, [&] {
        ++begun;
        return goes_on();
      });
  return result;
}

}  // namespace bumpfoil
