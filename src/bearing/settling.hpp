#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace bumpfoil {

/// Loop energies that differ by less, relative to the larger, belong to the same loop.
inline constexpr double settled_loop = 1e-6;

/// Whether the last loop equals the previous one.
inline bool is_settled(const std::vector<double>& loop_energies) {
  if (loop_energies.size() < 2) return false;
  const double last = loop_energies.back();
  const double before = *(loop_energies.end() - 2);
  return std::abs(last - before) <= settled_loop * std::max(std::abs(last), std::abs(before));
}

}  // namespace bumpfoil
