#include "experiments/unbalance/unbalance_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/motion/unbalance_response.hpp"

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): the table below is made of them

/// Orbits larger than this part of the minimum film thickness are no small motions.
constexpr double small_part_of_film = 0.3;
/// Part by which an orbit is larger at a peak than beside it.
constexpr double least_fall_from_peak = 0.05;

template <int axis>
double amplitude(const StationResponse& response) {
  return std::abs((*response.motion)[axis]);
}
template <int axis>
double phase(const StationResponse& response) {
  return to_degrees(std::arg((*response.motion)[axis]));
}
template <double EllipticOrbit::*semi_axis>
double orbit_axis(const StationResponse& response) {
  return elliptic_orbit(*response.motion, response.point.speed).*semi_axis;
}

constexpr auto response_quantity_table = std::to_array<ResponseQuantity>({
    {"amplitude_x", "m", "amplitude along X at the frequency of rotation", amplitude<0>, csv, "amplitude, X",
     shown::micrometres},
    {"phase_x", "degree", "phase of X in x = Re(X exp(i |Omega| t))", phase<0>, csv, "phase, X", shown::degrees},
    {"amplitude_y", "m", "amplitude along Y at the frequency of rotation", amplitude<1>, csv, "amplitude, Y",
     shown::micrometres},
    {"phase_y", "degree", "phase of Y in y = Re(Y exp(i |Omega| t))", phase<1>, csv, "phase, Y", shown::degrees},
    {"semi_major", "m", "larger semi-axis of the orbit", orbit_axis<&EllipticOrbit::major>, csv | shown_first | leading,
     "semi-major axis", shown::micrometres},
    {"semi_minor", "m", "smaller semi-axis of the orbit, negative where it is gone round against the rotation",
     orbit_axis<&EllipticOrbit::minor>, csv, "semi-minor axis", shown::micrometres},
});

std::string rpm_text(double speed) {
  return fmt::format("{:.6g} rpm", speed / shown::revolutions.size);
}

/// Largest semi-major axis of all stations, m; not a number where there is no response.
double largest_orbit(const UnbalancePoint& point, ResponseKind kind, const std::vector<RotorStation>& stations,
                     const RotorStation*& where) {
  double largest = absent;
  for (const RotorStation& station : stations) {
    const StationResponse response = response_at(point, kind, station);
    if (!response.motion) continue;
    const double major = elliptic_orbit(*response.motion, point.speed).major;
    if (std::isnan(largest) || major > largest) {
      largest = major;
      where = &station;
    }
  }
  return largest;
}

/// Whether a maximum is more than the wiggles where contacts change: on both sides the values fall by some part of it
/// before they are larger.
bool stands_out(const std::vector<double>& values, std::size_t place) {
  const auto falls = [&](auto first, auto last) {
    for (auto at = first; at != last; ++at) {
      if (*at > values[place]) return false;
      if (*at < (1.0 - least_fall_from_peak) * values[place]) return true;
    }
    return false;
  };
  const auto behind = values.begin() + static_cast<std::ptrdiff_t>(place);
  return falls(std::make_reverse_iterator(behind), values.rend()) && falls(behind + 1, values.end());
}

}  // namespace

std::span<const ResponseQuantity> response_quantities() {
  return response_quantity_table;
}

std::vector<RotorStation> stations_of(const Rotor& rotor) {
  std::vector<RotorStation> stations = rotor.bearings;
  stations.insert(stations.end(), rotor.stations.begin(), rotor.stations.end());
  return stations;
}

StationResponse response_at(const UnbalancePoint& point, ResponseKind kind, const RotorStation& station) {
  StationResponse response{.point = point, .kind = kind};
  const auto& y = kind == ResponseKind::linear_stuck ? point.stuck : point.sliding;
  if (y) response.motion = station.motion * *y;
  return response;
}

std::vector<ResponsePeak> peaks_of(const UnbalanceResult& result) {
  const std::vector<RotorStation> stations = stations_of(result.machine.rotor);
  const std::size_t count = result.points.size();
  std::vector<ResponsePeak> peaks;
  for (const ResponseKind kind : {ResponseKind::linear_sliding, ResponseKind::linear_stuck}) {
    std::vector<double> orbits(count);
    std::vector<const RotorStation*> where(count);
    for (std::size_t i = 0; i < count; ++i) orbits[i] = largest_orbit(result.points[i], kind, stations, where[i]);
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (!(orbits[i] > orbits[i - 1] && orbits[i] >= orbits[i + 1]) || !stands_out(orbits, i)) continue;
      const std::array speed{result.points[i - 1].speed, result.points[i].speed, result.points[i + 1].speed};
      const double before = (orbits[i] - orbits[i - 1]) / (speed[1] - speed[0]);
      const double after = (orbits[i + 1] - orbits[i]) / (speed[2] - speed[1]);
      const double curvature = (after - before) / (speed[2] - speed[0]);
      const double way = 0.5 * (speed[0] - speed[1] - before / curvature);  // from the middle to the vertex
      peaks.push_back({.kind = kind,
                       .station = where[i]->name,
                       .speed = speed[1] + way,
                       .amplitude = orbits[i] - curvature * way * way});
    }
  }
  return peaks;
}

std::vector<std::string> failure_lines(const UnbalanceResult& result) {
  std::vector<std::string> lines;
  std::size_t behind = 0;
  for (const UnbalancePoint& point : result.points) {
    if (point.status == Status::converged || point.status == Status::interrupted) continue;
    if (point.status == Status::not_reached) {
      ++behind;
      continue;
    }
    lines.push_back(fmt::format("{}: no equilibrium found: {}", rpm_text(point.speed), explanation(point.status)));
  }
  if (behind > 0) lines.push_back(fmt::format("the {} speeds behind it were not looked for", behind));
  return lines;
}

std::vector<std::string> warning_lines(const Case& input, const UnbalanceResult& result) {
  std::vector<std::string> lines = case_warnings(input);
  std::size_t large = 0;
  std::size_t unknown = 0;
  const UnbalancePoint* worst = nullptr;
  double worst_part = small_part_of_film;
  for (const UnbalancePoint& point : result.points) {
    if (point.status != Status::converged) continue;
    if (!point.sliding || !point.stuck) ++unknown;
    double part = 0.0;
    for (std::size_t i = 0; i < point.states.size(); ++i) {
      const double film = point.states[i].film.thickness.minCoeff() * result.machine.bearing->scales.thickness;
      for (const ResponseKind kind : {ResponseKind::linear_sliding, ResponseKind::linear_stuck}) {
        const StationResponse response = response_at(point, kind, result.machine.rotor.bearings[i]);
        if (response.motion) part = std::max(part, elliptic_orbit(*response.motion, point.speed).major / film);
      }
    }
    if (part > small_part_of_film) ++large;
    if (part > worst_part) {
      worst_part = part;
      worst = &point;
    }
  }
  if (large > 0) {
    lines.push_back(fmt::format(
        "at {} of {} speeds the orbit of a journal is larger than {:.0f} % of the minimum film "
        "thickness (most at {}: {:.0f} %): it is no small motion, and the linear response is rough",
        large, result.points.size(), 100.0 * small_part_of_film, rpm_text(worst->speed), 100.0 * worst_part));
  }
  if (unknown > 0) {
    lines.push_back(
        fmt::format("there is no response at {} of {} speeds: the modes of the contacts leave a singular "
                    "system",
                    unknown, result.points.size()));
  }
  return lines;
}

}  // namespace bumpfoil
