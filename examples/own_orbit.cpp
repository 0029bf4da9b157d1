// Your own orbit, here a figure of eight about a point below the centre: forces, and friction loss.
#include <fmt/format.h>
#include <bumpfoil/experiments/path/path.hpp>
#include <bumpfoil/experiments/reference_case.hpp>
#include <cmath>
#include <numbers>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bumpfoil::PathSettings& orbit = bearing.settings.set(bumpfoil::PathSettings{});
  for (int point = 0; point <= 200; ++point) {  // twice round
    const double angle = 2.0 * std::numbers::pi * point / 100.0;
    orbit.points.values.emplace_back(8e-6 * std::sin(angle), -45e-6 + 4e-6 * std::sin(2.0 * angle));  // m
  }
  const bumpfoil::Cycle path = bumpfoil::run_path(bearing).cycles.front();
  if (!path.converged()) return 3;

  for (const std::size_t increment : {1U, 101U, 201U}) {  // 0 is the assembly, at the centre of the bearing
    const bumpfoil::Increment& at = path.increments[increment];
    fmt::print("{:.2f} N, {:.2f} N, dissipated {:.2f} uJ\n", at.force_x, at.force_y, 1e6 * at.dissipated_energy);
  }
}
