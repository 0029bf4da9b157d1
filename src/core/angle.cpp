#include "bumpfoil/core/angle.hpp"

#include <cmath>
#include <numbers>

namespace bumpfoil {

double to_degrees(double angle) {
  const double degrees = angle * (180.0 / std::numbers::pi);
  const double whole = std::round(degrees);
  return std::abs(degrees - whole) < 1e-12 * (1.0 + std::abs(whole)) ? whole : degrees;
}

}  // namespace bumpfoil
