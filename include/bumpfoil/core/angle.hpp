#pragma once

namespace bumpfoil {

/// An angle (rad) in degrees; a value within round-off of a whole number becomes that number.
double to_degrees(double angle);

}  // namespace bumpfoil
