#pragma once

#include <numbers>

#include "bumpfoil/io/result_quantities.hpp"

/// Units of tables for people.
namespace bumpfoil::shown {

inline constexpr ShownUnit unitless{"", 1.0};
inline constexpr ShownUnit newtons{"N", 1.0};
inline constexpr ShownUnit micrometres{"um", 1e-6};
inline constexpr ShownUnit degrees{"deg", 1.0};
inline constexpr ShownUnit newton_millimetres{"N mm", 1e-3};
inline constexpr ShownUnit millijoules{"mJ", 1e-3};
inline constexpr ShownUnit watts{"W", 1.0};
inline constexpr ShownUnit megapascals{"MPa", 1e6};
inline constexpr ShownUnit bars{"bar", 1e5};
inline constexpr ShownUnit revolutions{"rpm", std::numbers::pi / 30.0};
inline constexpr ShownUnit stiffness{"MN/m", 1e6};
inline constexpr ShownUnit damping{"N s/m", 1.0};

}  // namespace bumpfoil::shown
