#pragma once

namespace bumpfoil {

/// Combinations of trigonometric functions whose leading terms cancel, divided by the leading power of x: even
/// functions, to full precision for all x.

/// (x - sin(x)) / x^3 = 1/6 - ...
double sine_remainder(double x);

/// (sin(x) - x cos(x)) / x^3 = 1/3 - ...
double sine_moment(double x);

/// (x/2 + sin(x)/2 - 2 (1 - cos(x)) / x) / x^5 = 1/720 - ...: second moment of an arc of angle x and unit radius about
/// the line through its centroid along the chord.
double arc_bow(double x);

}  // namespace bumpfoil
