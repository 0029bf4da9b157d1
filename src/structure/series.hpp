#pragma once

namespace bumpfoil {

/// Combinations of trigonometric functions whose leading terms cancel for small arguments, to full relative precision
/// for all x: power series below 1, closed form above.

/// x - sin(x) = x^3/6 - ...
double x_minus_sin(double x);

/// sin(x) - x cos(x) = x^3/3 - ...
double sin_minus_x_cos(double x);

}  // namespace bumpfoil
