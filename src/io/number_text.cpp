#include "io/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bumpfoil {

std::string number_text(const std::optional<double>& number, double unit) {
  if (!number || !std::isfinite(*number)) return "-";
  const double scaled = *number / unit;
  const double size = std::abs(scaled);
  if (size == 0.0) return "0";
  if (size < 1e-3 || size >= 1e6) return fmt::format("{:.3e}", scaled);
  return fmt::format("{:.{}f}", scaled, std::max(0, 4 - static_cast<int>(std::floor(std::log10(size)))));
}

}  // namespace bumpfoil
