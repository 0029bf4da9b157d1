#include "experiments/rotor_speeds.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace bumpfoil {

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
  if (behind > 0) lines.push_back(fmt::format("the {} speeds behind it were not looked for", behind));
  return lines;
}

}  // namespace bumpfoil
