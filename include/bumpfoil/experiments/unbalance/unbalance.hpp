#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/orbit.hpp"

namespace bumpfoil {

/// Table [unbalance] of a case.
struct UnbalanceSettings {
  static constexpr std::string_view table = "unbalance";

  std::vector<double> speeds{};   ///< rad/s
  bool orbits{};                  ///< periodic orbits as well
  int steps_per_revolution{100};  ///< of theirs

  bool operator==(const UnbalanceSettings&) const = default;
};

/// What unbalance does to a rotor at one speed.
struct UnbalancePoint {
  double speed{};  ///< Omega, rad/s
  Status status{Status::not_reached};
  std::vector<BearingState> states;  ///< of the bearings under the weight; empty where they were not found
  /// Y of the small forced motion, see linear_response(): slipping contacts slip on, or all closed ones stick.
  std::optional<Eigen::VectorXcd> sliding, stuck;
  std::optional<Orbit> orbit{};  ///< with contacts and friction as they are, where it is requested
};

struct UnbalanceResult {
  Machine machine;
  std::vector<UnbalancePoint> points;  ///< in the order of the speeds
  bool with_orbits{};                  ///< periodic orbits were requested
};

/// A run that ended before its first speed.
/// @throws Error (input) as run_unbalance() does
UnbalanceResult unbalance_not_begun(const Case& input);

/// Response of the rotor of a case to its unbalances over its speeds: the linear one, and, where it is requested, the
/// periodic orbit that find_orbit() finds from the one of the speed before, or from the linear response where there is
/// none, or none is found from it. After a speed without equilibrium the others are not looked for.
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case cannot be built, or has no rotor, unbalances or speeds
UnbalanceResult run_unbalance(const Case& input, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
