#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/status.hpp"
#include "bumpfoil/results/quantity.hpp"

/// What results over the speeds of a rotor say alike.
namespace bumpfoil {

/// How a search for equilibria ended.
inline constexpr Form search_status{Form::flag, enum_names<Status>};

/// How the search at one speed ended.
struct SpeedStatus {
  double speed{};  ///< Omega, rad/s
  Status status{};
};

/// "12000 rpm"
std::string rotor_speed_text(double speed);

/// A line for each speed without an equilibrium, and one for those behind that were not looked for.
std::vector<std::string> missing_equilibria(const std::vector<SpeedStatus>& speeds);

}  // namespace bumpfoil
