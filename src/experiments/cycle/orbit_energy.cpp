#include "experiments/cycle/orbit_energy.hpp"

#include <cmath>
#include <cstddef>

namespace bumpfoil {

double orbit_energy(double work, double dissipated, std::span<const OrbitPoint> orbit) {
  if (dissipated > 0.0) return work;
  double error = 0.0;
  const std::size_t count = orbit.size();
  for (std::size_t i = 0; i < count; ++i) {
    const OrbitPoint& before = orbit[(i + count - 1) % count];
    const OrbitPoint& here = orbit[i];
    const OrbitPoint& after = orbit[(i + 1) % count];
    const double ways = (here.position - before.position).norm() + (after.position - here.position).norm();
    error += 0.125 * ways * (after.force - 2.0 * here.force + before.force).norm();
  }
  return std::abs(work) <= error ? 0.0 : work;
}

}  // namespace bumpfoil
