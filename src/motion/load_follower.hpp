#pragma once

#include "bumpfoil/bearing/foil_stepper.hpp"

namespace bumpfoil {

/// Appends `part`, which starts at the end of `whole`. The last waypoint is then its end.
void append(const BearingModel& foils, const Step& part, Step& whole);

/// Follows foils exactly under a load that grows proportionally from the current one, from one contact change to the
/// next; the journal is free in the plane. The response is linear in between: the journal moves by K^-1 dL with the
/// tangent K of the modes. The modes depend on the direction of motion, and both are determined together.
/// | Use with a stepper that follows events.
/// @param load       N
/// @param tolerance  N
/// @param reach      largest displacement from the origin in the search, m
/// @param step       initial state and previous history; receives the further history
/// @return false if the path ends: the tangent is singular, the position unstable, it jumps, or it leaves the reach.
///   `step` is then at this end.
bool follow_load(FoilStepper& stepper, const Eigen::Vector2d& load, double tolerance, double reach, Step& step);

}  // namespace bumpfoil
