#pragma once

namespace bumpfoil {

/// An angle (rad) in degrees; where roundings hide a whole number of them, that.
double to_degrees(double angle);

}  // namespace bumpfoil
