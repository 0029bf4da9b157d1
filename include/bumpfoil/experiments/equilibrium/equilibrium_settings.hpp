#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"

namespace bumpfoil {

/// Path along which a running bearing reaches its states: there may be several at one speed and load, and the path
/// decides.
enum class FilmPath {
  load_ramp,     ///< one load after the other, restarted at every speed
  speed_ramp,    ///< one speed after the other, restarted for every load or position
  position_ray,  ///< one position after the other, restarted at every speed
  cold_start,    ///< every state by itself, from ambient pressure
};

template <>
inline constexpr auto enum_names<FilmPath> = std::to_array<std::string_view>({"load_ramp", "speed_ramp", "position_ray",
                                                                              "cold_start"});

/// Number of paths by which the command `equilibrium` reaches its states.
enum class ComparedPaths {
  one,  ///< its own alone
  two,  ///< also a second one, whose states are compared but not kept
  all,  ///< every path that leads to the states; all states are kept
};

template <>
inline constexpr auto enum_names<ComparedPaths> = std::to_array<std::string_view>({"one", "two", "all"});

/// States of a running bearing: all speeds with all loads or with all positions.
struct EquilibriumSettings {
  static constexpr std::string_view table = "equilibrium";

  std::vector<double> speeds{};              ///< Omega, rad/s; positive turns X to Y
  std::vector<Eigen::Vector2d> loads{};      ///< on the journal, N; empty with positions
  std::vector<Eigen::Vector2d> positions{};  ///< of the journal, m; empty with loads
  FilmPath path{FilmPath::load_ramp};
  ComparedPaths paths{ComparedPaths::two};  ///< of one run; sweeps and ensembles take one path
  bool prefer_stable{};                     ///< look for another state by other paths where one is unstable
  int steps{10};                            ///< equal increments of the ramp to the first state of a path
  std::vector<double> frequencies{};  ///< of motions for which coefficients are computed, rad/s; none: that of the
                                      ///< rotation
  int ross_version{3};                ///< that coefficients.toml is for, 2 or 3
  bool limits{};  ///< find lift-off speeds and load capacities, too; ensembles go by MonteCarloSettings::limits

  bool operator==(const EquilibriumSettings&) const = default;
};

}  // namespace bumpfoil
