#pragma once

#include "bumpfoil/bearing/foil_stepper.hpp"

namespace bumpfoil {

/// Puts `part`, which begins where `whole` ends, behind it. The last waypoint is then where it ends.
void append(const Foils& foils, const Step& part, Step& whole);

/// Takes foils along a load that grows in proportion from the one that they carry, exactly, from one change of contact
/// to the next; the journal is free in the plane. Between two changes the response is linear: it moves by
/// K^-1 dL with the tangent K of the modes there, which follow from where it moves and are found together with it.
///
/// To be used with a stepper that follows events.
/// @param load       N
/// @param tolerance  N
/// @param reach      the load is not looked for beyond this displacement from the origin, m
/// @param step       where the foils are, and what happened before; receives what happens on
/// @return false where the way does not go on like this: nothing is determined, it would not stay, it jumps, or it
/// leads out of reach. `step` is then where it ends.
bool follow_load(FoilStepper& stepper, const Eigen::Vector2d& load, double tolerance, double reach, Step& step);

}  // namespace bumpfoil
