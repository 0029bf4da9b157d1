#pragma once

#include <array>
#include <complex>
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

/// What results of the command unbalance tell, described once for all files.
namespace bumpfoil {

/// How a response was found.
enum class ResponseKind : std::uint8_t {
  linear_sliding,  ///< small, slipping contacts slip on
  linear_stuck,    ///< small, all closed contacts stick
};
template <>
inline constexpr auto enum_names<ResponseKind> = std::to_array<std::string_view>({"linear_sliding", "linear_stuck"});

/// A response at one speed, at one station of the rotor.
struct StationResponse {
  const UnbalancePoint& point;
  ResponseKind kind{};
  std::optional<Eigen::Vector2cd> motion{};  ///< X and Y of x = Re(X e^{i |Omega| t}), m
};

using ResponseQuantity = Quantity<double (*)(const StationResponse&)>;
std::span<const ResponseQuantity> response_quantities();

/// Places of a rotor at which responses are told: its bearings first, and what else has a name.
std::vector<RotorStation> stations_of(const Rotor& rotor);

/// The response of a kind at a station; without motion where there is none.
StationResponse response_at(const UnbalancePoint& point, ResponseKind kind, const RotorStation& station);

/// A speed at which the largest semi-axis of all stations has a maximum, by a parabola through three speeds.
struct ResponsePeak {
  ResponseKind kind{};
  std::string station;
  double speed{};      ///< rad/s
  double amplitude{};  ///< semi-major axis, m
};
std::vector<ResponsePeak> peaks_of(const UnbalanceResult& result);

/// What keeps a speed from being found, each with its place.
std::vector<std::string> failure_lines(const UnbalanceResult& result);

/// Where an answer is less than it seems, and what to do about it.
std::vector<std::string> warning_lines(const Case& input, const UnbalanceResult& result);

/// The run as a text table: a line for each speed, and the peaks.
std::string unbalance_table(const UnbalanceResult& result);

/// The run over the dimensions speed, kind and station. It lives as long as the result.
Dataset unbalance_dataset(const UnbalanceResult& result);

/// Contents of unbalance.csv: a line for each station, kind and speed.
std::string unbalance_csv(const UnbalanceResult& result);

}  // namespace bumpfoil
