#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"

namespace bumpfoil {

/// How a journal vibrates.
enum class Motion {
  line,   ///< along a direction alone
  orbit,  ///< round a circle
};

template <>
inline constexpr auto enum_names<Motion> = std::to_array<std::string_view>({"line", "orbit"});

/// Vibrations of the journal about static loads: about each load in each direction, or round a circle in either sense,
/// with each amplitude, until the loop has settled.
struct VibrationSettings {
  static constexpr std::string_view table = "vibration";

  std::vector<Eigen::Vector2d> loads;  ///< N
  Motion motion{Motion::line};
  std::vector<double> directions;   ///< rad, from the X axis towards Y; one, or two at right angles; none for orbits
  std::vector<double> amplitudes;   ///< from the middle to a turning point, m
  std::vector<double> frequencies;  ///< at which the damping is evaluated, rad/s
  int steps{100};                   ///< equal increments up to a load, and from the middle to a turning point

  bool operator==(const VibrationSettings&) const = default;

  [[nodiscard]] bool orbits() const { return motion == Motion::orbit; }
  /// Vibrations about one load with one amplitude: one for each direction, or sense.
  [[nodiscard]] std::size_t motions() const { return orbits() ? 2 : directions.size(); }
};

}  // namespace bumpfoil
