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
#include "bumpfoil/results/table.hpp"
#include "experiments/rotor_speeds.hpp"

/// Quantities of the command unbalance, described once for all files.
namespace bumpfoil {

/// Method by which a response was computed.
enum class ResponseKind : std::uint8_t {
  linear_sliding,  ///< small, sliding contacts keep sliding
  linear_stuck,    ///< small, full stick
  orbit,           ///< periodic, with contact changes and friction
};
inline constexpr std::array all_response_kinds{ResponseKind::linear_sliding, ResponseKind::linear_stuck,
                                               ResponseKind::orbit};
template <>
inline constexpr auto enum_names<ResponseKind> = std::to_array<std::string_view>({"linear_sliding", "linear_stuck",
                                                                                  "orbit"});

namespace tag {
inline constexpr Tags of_orbits = first_of_experiment;  ///< of results with periodic orbits
}

/// A quantity of the whole run.
using UnbalanceQuantity = Quantity<double (*)(const UnbalanceResult&)>;
std::span<const UnbalanceQuantity> unbalance_quantities();

/// A response at one speed, at one station of the rotor.
struct StationResponse {
  const UnbalancePoint& point;
  ResponseKind kind{};
  std::optional<Eigen::Vector2cd> motion{};  ///< X and Y of x = Re(X e^{i |Omega| t}), m; of an orbit its 1x component
  const StationOrbit* orbit{};               ///< the complete orbit
  const BearingTurn* turn{};                 ///< results of the bearing, at a bearing
};

using ResponseQuantity = Quantity<double (*)(const StationResponse&)>;
std::span<const ResponseQuantity> response_quantities();

/// A quantity of the rotor at one speed.
using PointQuantity = Quantity<double (*)(const UnbalanceResult&, const UnbalancePoint&)>;
std::span<const PointQuantity> point_quantities();

/// A quantity of a whole orbit.
using OrbitQuantity = Quantity<double (*)(const Orbit&)>;
std::span<const OrbitQuantity> orbit_quantities();

/// Whether the periodic orbit is stable; nothing if there is none, or no multiplier is known.
std::optional<bool> lasting(const Orbit& orbit);

/// Kinds in a result: orbits if requested.
std::span<const ResponseKind> kinds_of(const UnbalanceResult& result);

/// The response of a kind at a station, by its index in Machine::places(); without motion if there is none.
StationResponse response_at(const UnbalanceResult& result, const UnbalancePoint& point, ResponseKind kind,
                            std::size_t station);

/// Status of the search for the response, that for the equilibrium or for the orbit.
Status status_of(const UnbalancePoint& point, ResponseKind kind);

/// A speed with a maximum of the largest semi-major axis of all stations, by a parabola through three speeds.
struct ResponsePeak {
  ResponseKind kind{};
  std::string station;
  double speed{};      ///< rad/s
  double amplitude{};  ///< semi-major axis, m
};
std::vector<ResponsePeak> peaks_of(const UnbalanceResult& result);

/// Speeds without a result, each with the reason.
std::vector<std::string> failure_lines(const UnbalanceResult& result);

/// Limitations of the results, with advice.
std::vector<std::string> warning_lines(const Case& input, const UnbalanceResult& result);

/// The run as a text table: one line per speed, and the peaks.
std::string unbalance_table(const UnbalanceResult& result);

/// The run over the dimensions speed, bearing, kind and station; without responses, over speed only, as stored in
/// sweeps. The result must outlive it.
Dataset unbalance_dataset(const UnbalanceResult& result, bool with_responses = true);

/// Rows of unbalance.csv: one for each station, kind and speed.
Table response_table(const UnbalanceResult& result);

}  // namespace bumpfoil
