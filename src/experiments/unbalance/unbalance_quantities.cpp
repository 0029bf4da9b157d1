#include "experiments/unbalance/unbalance_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/motion/response.hpp"

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): for the table below

/// Orbits larger than this fraction of the minimum film thickness are not small motions.
constexpr double small_part_of_film = 0.3;
/// Minimum relative drop of the orbit on both sides of a peak.
constexpr double least_fall_from_peak = 0.05;

/// Largest semi-major axis of the journals, m; or the largest ratio to the minimum film thickness of the bearing.
template <ResponseKind kind, bool part_of_film = false>
double journal_amplitude(const UnbalanceResult& result, const UnbalancePoint& point) {
  double largest = absent;
  for (std::size_t i = 0; i < point.states.size(); ++i) {
    const StationResponse response = response_at(result, point, kind, i);
    if (!response.motion) continue;
    const double major = elliptic_orbit(*response.motion, point.speed).major;
    const double size = part_of_film ? major / result.machine.thinnest_film(i, point.states[i]) : major;
    if (!(size <= largest)) largest = size;
  }
  return largest;
}

/// Minimum film thickness of all bearings in the periodic orbit, m.
double film_in_orbit(const UnbalanceResult& /*result*/, const UnbalancePoint& point) {
  double thinnest = absent;
  if (!point.orbit) return thinnest;
  for (const BearingTurn& turn : point.orbit->turn) {
    if (!(turn.thinnest >= thinnest)) thinnest = turn.thinnest;
  }
  return thinnest;
}

/// The speed with the largest value; nothing if all are unknown.
template <typename Value>
const UnbalancePoint* largest_at(const UnbalanceResult& result, const Value& value) {
  const UnbalancePoint* found = nullptr;
  for (const UnbalancePoint& point : result.points) {
    const double number = value(result, point);
    if (!std::isnan(number) && (found == nullptr || number > value(result, *found))) found = &point;
  }
  return found;
}
template <double (*value)(const UnbalanceResult&, const UnbalancePoint&)>
double largest_over_speeds(const UnbalanceResult& result) {
  const UnbalancePoint* const found = largest_at(result, value);
  return found == nullptr ? absent : value(result, *found);
}
constexpr auto stuck_amplitude = journal_amplitude<ResponseKind::linear_stuck>;
constexpr auto stuck_part_of_film = journal_amplitude<ResponseKind::linear_stuck, true>;

double least_film_in_orbits(const UnbalanceResult& result) {
  const auto* const found = largest_at(
      result, [](const UnbalanceResult& all, const UnbalancePoint& point) { return -film_in_orbit(all, point); });
  return found == nullptr ? absent : film_in_orbit(result, *found);
}

/// Whether all periodic orbits are stable; NaN if one is missing or its stability unknown, and no other is unstable.
double all_last(const UnbalanceResult& result) {
  bool known = true;
  for (const UnbalancePoint& point : result.points) {
    const std::optional<bool> lasts = point.orbit ? lasting(*point.orbit) : std::nullopt;
    if (lasts == false) return 0.0;
    known = known && lasts;
  }
  return known ? 1.0 : absent;
}

/// Status of the first failed search, for an equilibrium or an orbit.
Status first_failure(const UnbalanceResult& result) {
  for (const UnbalancePoint& point : result.points) {
    for (const Status status : {point.status, status_of(point, ResponseKind::orbit)}) {
      if (status != Status::converged) return status;
    }
  }
  return Status::converged;
}

constexpr auto unbalance_quantity_table = std::to_array<UnbalanceQuantity>({
    {"status",
     "",
     "how the first search for an equilibrium or a periodic orbit ended that failed; converged: all were found",
     [](const UnbalanceResult& result) { return static_cast<double>(first_failure(result)); },
     sampled,
     "",
     {},
     search_status},
    {"largest_amplitude", "m", "largest semi-major axis of the orbits of the journals at all speeds, small, full stick",
     largest_over_speeds<stuck_amplitude>, headline | leading | sampled, "largest amplitude", shown::micrometres},
    {"largest_amplitude_speed", "rad/s", "magnitude of the speed of the largest amplitude",
     [](const UnbalanceResult& result) {
       const UnbalancePoint* const found = largest_at(result, stuck_amplitude);
       return found == nullptr ? absent : std::abs(found->speed);
     },
     headline | sampled, "speed of the largest amplitude", shown::revolutions},
    {"largest_amplitude_ratio", "1",
     "largest ratio at all speeds of the semi-major axis of a journal, full stick, to the minimum film thickness of "
     "its bearing",
     largest_over_speeds<stuck_part_of_film>, headline | sampled, "amplitude / film", shown::unitless},
    {"least_h_min", "m", "minimum film thickness of all bearings in the periodic orbits at all speeds",
     least_film_in_orbits, headline | sampled | of_orbits, "minimum film, orbits", shown::micrometres},
    {"orbits_last",
     "1",
     "whether the rotor stays on the periodic orbits at all speeds: no Floquet multiplier found is larger than "
     "1",
     all_last,
     sampled | of_orbits,
     "orbits last",
     {},
     yes_or_no},
});

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

template <int axis>
double half_range(const StationResponse& response) {
  return response.orbit == nullptr ? amplitude<axis>(response) : response.orbit->half_peak_to_peak[axis];
}
template <int axis>
double mean(const StationResponse& response) {
  return response.orbit == nullptr ? absent : response.orbit->mean[axis];
}
template <int axis>
double twice(const StationResponse& response) {
  return response.orbit == nullptr ? absent : std::abs(response.orbit->twice[axis]);
}
template <int axis>
double phase_twice(const StationResponse& response) {
  return response.orbit == nullptr ? absent : to_degrees(std::arg(response.orbit->twice[axis]));
}

constexpr auto response_quantity_table = std::to_array<ResponseQuantity>({
    {"amplitude_x", "m", "amplitude along X at the rotation frequency", amplitude<0>, csv | shown_first, "amplitude, X",
     shown::micrometres},
    {"phase_x", "degree", "phase of X in x = Re(X exp(i nu t)), nu the magnitude of Omega", phase<0>, csv | shown_first,
     "phase, X", shown::degrees},
    {"amplitude_y", "m", "amplitude along Y at the rotation frequency", amplitude<1>, csv | shown_first, "amplitude, Y",
     shown::micrometres},
    {"phase_y", "degree", "phase of Y in y = Re(Y exp(i nu t)), nu the magnitude of Omega", phase<1>, csv | shown_first,
     "phase, Y", shown::degrees},
    {"half_peak_to_peak_x", "m", "half of the peak-to-peak displacement along X", half_range<0>, csv,
     "half peak-to-peak, X", shown::micrometres},
    {"half_peak_to_peak_y", "m", "half of the peak-to-peak displacement along Y", half_range<1>, csv,
     "half peak-to-peak, Y", shown::micrometres},
    {"h_min", "m", "minimum film thickness of the bearing in a turn of an orbit",
     [](const StationResponse& response) { return response.turn == nullptr ? absent : response.turn->thinnest; }, csv,
     "minimum film thickness", shown::micrometres},
    {"friction_loss", "J", "work that friction of the foils of the bearing takes in a turn of an orbit",
     [](const StationResponse& response) { return response.turn == nullptr ? absent : response.turn->friction; }, csv,
     "friction loss", shown::millijoules},
    {"power", "W", "mean power of the film of the bearing in a turn of an orbit",
     [](const StationResponse& response) { return response.turn == nullptr ? absent : response.turn->power; }, csv,
     "power", shown::watts},
    {"mean_x", "m", "mean of the position along X in a turn of an orbit", mean<0>, csv, "mean position, X"},
    {"mean_y", "m", "mean of the position along Y in a turn of an orbit", mean<1>, csv, "mean position, Y"},
    {"amplitude_x_2x", "m", "amplitude along X at twice the rotation frequency, of an orbit", twice<0>, csv,
     "amplitude at twice the speed, X"},
    {"phase_x_2x", "degree", "phase of X2 in x = ... + Re(X2 exp(2 i nu t)), of an orbit", phase_twice<0>, csv,
     "phase at twice the speed, X"},
    {"amplitude_y_2x", "m", "amplitude along Y at twice the rotation frequency, of an orbit", twice<1>, csv,
     "amplitude at twice the speed, Y"},
    {"phase_y_2x", "degree", "phase of Y2 in y = ... + Re(Y2 exp(2 i nu t)), of an orbit", phase_twice<1>, csv,
     "phase at twice the speed, Y"},
    {"semi_major", "m", "larger semi-axis of the orbit", orbit_axis<&EllipticOrbit::major>, csv | shown_first | leading,
     "semi-major axis", shown::micrometres},
    {"semi_minor", "m", "smaller semi-axis of the orbit, negative where the orbit goes backward, against the rotation",
     orbit_axis<&EllipticOrbit::minor>, csv | shown_first, "semi-minor axis", shown::micrometres},
});

constexpr auto point_quantity_table = std::to_array<PointQuantity>({
    {"speed_status", "", "how the search for the equilibrium ended",
     [](const UnbalanceResult&, const UnbalancePoint& point) { return static_cast<double>(point.status); }, none,
     "status", shown::unitless, search_status},
    {"equilibrium_h_min", "m", "minimum film thickness of all bearings without unbalance",
     [](const UnbalanceResult& result, const UnbalancePoint& point) {
       return result.machine.thinnest_film(point.states);
     },
     none, "minimum film thickness, equilibrium", shown::micrometres},
    {"journal_amplitude", "m", "largest semi-major axis of the orbits of the journals, small, full stick",
     stuck_amplitude, none, "amplitude of the journals", shown::micrometres},
    {"journal_amplitude_sliding", "m",
     "largest semi-major axis of the orbits of the journals, small, sliding contacts keep sliding",
     journal_amplitude<ResponseKind::linear_sliding>, none, "amplitude of the journals, sliding", shown::micrometres},
    {"journal_amplitude_ratio", "1",
     "largest ratio of the semi-major axis of a journal, full stick, to the minimum film thickness of its bearing",
     stuck_part_of_film, none, "amplitude / film", shown::unitless},
    {"journal_amplitude_orbit", "m", "largest semi-major axis of the journals in the periodic orbit, first harmonic",
     journal_amplitude<ResponseKind::orbit>, of_orbits, "amplitude of the journals, orbit", shown::micrometres},
    {"orbit_h_min", "m", "minimum film thickness of all bearings in the periodic orbit", film_in_orbit, of_orbits,
     "minimum film thickness, orbit", shown::micrometres},
});

constexpr auto orbit_quantity_table = std::to_array<OrbitQuantity>({
    {"orbit_status", "", "how the search for the periodic orbit ended; not_converged: none was found",
     [](const Orbit& orbit) { return static_cast<double>(orbit.status); }, none, "status, orbit", shown::unitless,
     search_status},
    {"orbit_turns", "1", "turns that were marched", [](const Orbit& orbit) { return static_cast<double>(orbit.turns); },
     of_solver, "turns, orbit", shown::unitless, whole_number},
    {"orbit_change", "1",
     "change in the last turn of journal positions over c, and of their velocities over c and the speed",
     [](const Orbit& orbit) { return orbit.change; }, of_solver},
    {"largest_multiplier", "1",
     "largest Floquet multiplier found by the search: an orbit lasts where it is smaller than 1",
     [](const Orbit& orbit) { return orbit.multipliers.empty() ? absent : std::abs(orbit.multipliers.front()); }, none,
     "largest Floquet multiplier", shown::unitless},
    {"orbit_lasts",
     "1",
     "whether the rotor stays on the periodic orbit: no Floquet multiplier found by the search is larger than 1",
     [](const Orbit& orbit) {
       const std::optional<bool> lasts = lasting(orbit);
       return lasts ? static_cast<double>(*lasts) : absent;
     },
     none,
     "lasts",
     {},
     yes_or_no},
});

/// Largest semi-major axis of all stations, m; NaN if there is no response.
double largest_orbit(const UnbalanceResult& result, const UnbalancePoint& point, ResponseKind kind,
                     std::size_t stations, std::size_t& where) {
  double largest = absent;
  for (std::size_t i = 0; i < stations; ++i) {
    const StationResponse response = response_at(result, point, kind, i);
    if (!response.motion) continue;
    const double major = elliptic_orbit(*response.motion, point.speed).major;
    if (std::isnan(largest) || major > largest) {
      largest = major;
      where = i;
    }
  }
  return largest;
}

/// Whether a maximum exceeds the ripple of contact changes: on both sides the values drop by a given fraction before
/// they exceed it.
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

std::span<const UnbalanceQuantity> unbalance_quantities() {
  return unbalance_quantity_table;
}

std::span<const ResponseQuantity> response_quantities() {
  return response_quantity_table;
}

StationResponse response_at(const UnbalanceResult& result, const UnbalancePoint& point, ResponseKind kind,
                            std::size_t station) {
  StationResponse response{.point = point, .kind = kind};
  const Rotor& rotor = result.machine.rotor;
  const bool at_bearing = station < rotor.bearings.size();
  const std::size_t behind = station - (at_bearing ? 0 : rotor.bearings.size());
  if (kind != ResponseKind::orbit) {
    const auto& y = kind == ResponseKind::linear_stuck ? point.stuck : point.sliding;
    const RotorStation& place = at_bearing ? rotor.bearings[station] : rotor.stations[behind];
    if (y) response.motion = place.orbit(*y);
    return response;
  }
  if (!point.orbit || point.orbit->bearings.empty()) return response;
  response.orbit = at_bearing ? &point.orbit->bearings[station] : &point.orbit->stations[behind];
  response.motion = response.orbit->once;
  if (at_bearing) response.turn = &point.orbit->turn[station];
  return response;
}

Status status_of(const UnbalancePoint& point, ResponseKind kind) {
  return kind == ResponseKind::orbit && point.orbit ? point.orbit->status : point.status;
}

std::span<const PointQuantity> point_quantities() {
  return point_quantity_table;
}

std::span<const OrbitQuantity> orbit_quantities() {
  return orbit_quantity_table;
}

std::optional<bool> lasting(const Orbit& orbit) {
  if (orbit.status != Status::converged || orbit.multipliers.empty()) return std::nullopt;
  return std::abs(orbit.multipliers.front()) <= 1.0;
}

std::span<const ResponseKind> kinds_of(const UnbalanceResult& result) {
  return std::span(all_response_kinds).first(result.with_orbits ? 3 : 2);
}

std::vector<ResponsePeak> peaks_of(const UnbalanceResult& result) {
  const std::vector<RotorStation> stations = result.machine.places();
  const std::size_t count = result.points.size();
  std::vector<ResponsePeak> peaks;
  for (const ResponseKind kind : kinds_of(result)) {
    std::vector<double> orbits(count);
    std::vector<std::size_t> where(count);
    for (std::size_t i = 0; i < count; ++i) {
      orbits[i] = largest_orbit(result, result.points[i], kind, stations.size(), where[i]);
    }
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (!(orbits[i] > orbits[i - 1] && orbits[i] >= orbits[i + 1]) || !stands_out(orbits, i)) continue;
      const std::array speed{result.points[i - 1].speed, result.points[i].speed, result.points[i + 1].speed};
      const double before = (orbits[i] - orbits[i - 1]) / (speed[1] - speed[0]);
      const double after = (orbits[i + 1] - orbits[i]) / (speed[2] - speed[1]);
      const double curvature = (after - before) / (speed[2] - speed[0]);
      const double offset = 0.5 * (speed[0] - speed[1] - before / curvature);  // from the middle point to the vertex
      peaks.push_back({.kind = kind,
                       .station = stations[where[i]].name,
                       .speed = speed[1] + offset,
                       .amplitude = orbits[i] - curvature * offset * offset});
    }
  }
  return peaks;
}

std::vector<std::string> failure_lines(const UnbalanceResult& result) {
  std::vector<std::string> lines = missing_equilibria(each(result.points, [](const UnbalancePoint& point) {
    return SpeedStatus{point.speed, point.status};
  }));
  for (const UnbalancePoint& point : result.points) {
    if (!point.orbit || point.orbit->status == Status::converged || point.orbit->status == Status::interrupted)
      continue;
    lines.push_back(
        point.orbit->status == Status::not_converged
            ? fmt::format("{}: no periodic orbit found in {} turns: the last one changes by {:.2g} of the clearance",
                          rotor_speed_text(point.speed), point.orbit->turns, point.orbit->change)
            : fmt::format("{}: no periodic orbit: {}", rotor_speed_text(point.speed),
                          explanation(point.orbit->status)));
  }
  return lines;
}

std::vector<std::string> warning_lines(const Case& input, const UnbalanceResult& result) {
  std::vector<std::string> lines = rotor_case_warnings(input);
  std::size_t large = 0;
  std::size_t unknown = 0;
  std::size_t orbits = 0;
  std::size_t left = 0;
  const UnbalancePoint* first_left = nullptr;
  const UnbalancePoint* worst = nullptr;
  double worst_part = small_part_of_film;
  for (const UnbalancePoint& point : result.points) {
    if (point.status != Status::converged) continue;
    if (!point.sliding || !point.stuck) ++unknown;
    if (point.orbit && point.orbit->status == Status::converged) {
      ++orbits;
      if (!lasting(*point.orbit).value_or(true) && left++ == 0) first_left = &point;
    }
    const double part = std::fmax(journal_amplitude<ResponseKind::linear_sliding, true>(result, point),
                                  stuck_part_of_film(result, point));
    if (part > small_part_of_film) ++large;
    if (part > worst_part) {
      worst_part = part;
      worst = &point;
    }
  }
  if (large > 0) {
    lines.push_back(fmt::format(
        "at {} of {} speeds the orbit of a journal is larger than {:.0f} % of the minimum film "
        "thickness (most at {}: {:.0f} %): the motion is not small, and the linear response is only approximate",
        large, result.points.size(), 100.0 * small_part_of_film, rotor_speed_text(worst->speed), 100.0 * worst_part));
  }
  if (left > 0) {
    lines.push_back(fmt::format(
        "{} of {} periodic orbits do not last (first at {}, Floquet multiplier {:.3f}): the rotor leaves them and "
        "whirls",
        left, orbits, rotor_speed_text(first_left->speed), std::abs(first_left->orbit->multipliers.front())));
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
