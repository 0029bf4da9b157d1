#include "experiments/rotor_speeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace bumpfoil {

void add_speeds(std::vector<double> speeds, Dataset& data) {
  data.add_dimension({"speed", "rad/s", "speed of the rotor, positive from X to Y", {}, "speed", shown::revolutions},
                     std::move(speeds));
}

void add_bearing_numbers(std::size_t count, Dataset& data) {
  data.add_dimension({"bearing", "1", "bearing, in the order of the case", {Form::whole}}, numbers_from(1.0, count));
}

std::vector<JournalQuantity> journal_quantities(const Machine& machine) {
  std::vector<JournalQuantity> all;
  const bool tilts = std::any_of(machine.bearings.begin(), machine.bearings.end(),
                                 [](const auto& bearing) { return bearing->film->tilts(); });
  for (const int axis : {0, 1}) {
    const char letter = axis == 0 ? 'x' : 'y';
    const char direction = axis == 0 ? 'X' : 'Y';
    all.push_back({{std::string(1, letter), "m", fmt::format("journal centre in equilibrium, {}", direction)},
                   [axis](const BearingModel&, const BearingState& state) { return state.position[axis]; }});
    if (!tilts) continue;
    all.push_back({{fmt::format("tilt_{}", letter), "rad",
                    fmt::format("slope of the axis of the journal in equilibrium towards {}", direction)},
                   [axis](const BearingModel& bearing, const BearingState& state) {
                     return bearing.film->tilts() ? state.tilt[axis] / bearing.film->half_width() : absent;
                   }});
    all.push_back({{fmt::format("moment_{}", letter), "N m",
                    fmt::format("moment on the journal in equilibrium along {} about the mid-plane", direction)},
                   [axis](const BearingModel& bearing, const BearingState& state) {
                     if (!bearing.film->tilts()) return absent;
                     return bearing.film->half_width() *
                            journal_force(*bearing.film, state.film, state.speed)[2 + axis];
                   }});
  }
  return all;
}

void add_stations(const std::vector<RotorStation>& stations, Dataset& data) {
  data.add_dimension({"station", "1", "place on the rotor, its bearings first", {Form::whole}},
                     numbers_from(1.0, stations.size()));
  data.coordinates.back().names = each(stations, [](const RotorStation& station) { return station.name; });
  Variable& places = data.add_coordinate({"station_z", "m", "place of the station along the axis"}, {"station"},
                                         each(stations, [](const RotorStation& station) { return station.z; }));
  std::string& names = places.attributes["stations"];
  for (const RotorStation& station : stations) names += (names.empty() ? "" : ", ") + station.name;
}

std::string rotor_speed_text(double speed) {
  return fmt::format("{:.6g} rpm", speed / shown::revolutions.size);
}

std::vector<std::string> missing_equilibria(const std::vector<SpeedStatus>& speeds) {
  std::vector<std::string> lines;
  std::size_t behind = 0;
  for (const auto& [speed, status] : speeds) {
    if (status == Status::converged || status == Status::interrupted) continue;
    if (status == Status::not_reached) {
      ++behind;
      continue;
    }
    lines.push_back(fmt::format("{}: no equilibrium found: {}", rotor_speed_text(speed), explanation(status)));
  }
  if (behind > 0) lines.push_back(fmt::format("the {} speeds after it were not computed", behind));
  return lines;
}

}  // namespace bumpfoil
