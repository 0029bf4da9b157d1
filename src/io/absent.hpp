#pragma once

#include <limits>

namespace bumpfoil {

/// Stands among numbers for one that is not known or does not exist. Files show it in their own way, never as a number.
inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();

}  // namespace bumpfoil
