#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/rotor_speeds.hpp"

/// Quantities of the command unbalance, described once for all files.
namespace bumpfoil {

/// How a response was found.
enum class ResponseKind : std::uint8_t {
  linear_sliding,  ///< small, slipping contacts slip on
  linear_stuck,    ///< small, all closed contacts stick
  orbit,           ///< periodic, with contacts and friction as they are
};
inline constexpr std::array all_response_kinds{ResponseKind::linear_sliding, ResponseKind::linear_stuck,
                                               ResponseKind::orbit};
template <>
inline constexpr auto enum_names<ResponseKind> = std::to_array<std::string_view>({"linear_sliding", "linear_stuck",
                                                                                  "orbit"});

namespace tag {
inline constexpr Tags of_orbits = 2 * first_of_experiment;  ///< of results that have periodic orbits
}

/// Of the whole run.
using UnbalanceQuantity = Quantity<double (*)(const UnbalanceResult&)>;
std::span<const UnbalanceQuantity> unbalance_quantities();

/// A response at one speed, at one station of the rotor.
struct StationResponse {
  const UnbalancePoint& point;
  ResponseKind kind{};
  std::optional<Eigen::Vector2cd> motion{};  ///< X and Y of x = Re(X e^{i |Omega| t}), m; of an orbit its 1x part
  const StationOrbit* orbit{};               ///< the whole of an orbit
  const BearingTurn* turn{};                 ///< what the bearing does, at one
};

using ResponseQuantity = Quantity<double (*)(const StationResponse&)>;
std::span<const ResponseQuantity> response_quantities();

/// Of the rotor at one speed.
using PointQuantity = Quantity<double (*)(const UnbalanceResult&, const UnbalancePoint&)>;
std::span<const PointQuantity> point_quantities();

/// Of an orbit as a whole.
using OrbitQuantity = Quantity<double (*)(const Orbit&)>;
std::span<const OrbitQuantity> orbit_quantities();

/// Whether the rotor stays on a periodic orbit; nothing where there is none, or no multiplier is known.
std::optional<bool> lasting(const Orbit& orbit);

/// Kinds that a result has: orbits where they were asked for.
std::span<const ResponseKind> kinds_of(const UnbalanceResult& result);

/// The response of a kind at a station, by its number in Machine::places(); without motion where there is none.
StationResponse response_at(const UnbalanceResult& result, const UnbalancePoint& point, ResponseKind kind,
                            std::size_t station);

/// How the search for the response ended: that for the equilibrium, or for the orbit.
Status status_of(const UnbalancePoint& point, ResponseKind kind);

/// A speed at which the largest semi-axis of all stations has a maximum, by a parabola through three speeds.
struct ResponsePeak {
  ResponseKind kind{};
  std::string station;
  double speed{};      ///< rad/s
  double amplitude{};  ///< semi-major axis, m
};
std::vector<ResponsePeak> peaks_of(const UnbalanceResult& result);

/// Speeds without a result, each with its reason.
std::vector<std::string> failure_lines(const UnbalanceResult& result);

/// Where an answer is less than it seems, and what to do about it.
std::vector<std::string> warning_lines(const Case& input, const UnbalanceResult& result);

/// The run as a text table: a line for each speed, and the peaks.
std::string unbalance_table(const UnbalanceResult& result);

/// The run over the dimensions speed, bearing, kind and station; without responses over speed alone, as sweeps keep it.
/// It lives as long as the result.
Dataset unbalance_dataset(const UnbalanceResult& result, bool with_responses = true);

/// Contents of unbalance.csv: a line for each station, kind and speed.
std::string unbalance_csv(const UnbalanceResult& result);

}  // namespace bumpfoil
