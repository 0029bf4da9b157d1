#pragma once

#include "bumpfoil/bearing/foil_stepper.hpp"

namespace bumpfoil {

/// One increment from `from` to where the force applied to the journal is `load` (N): it is free to go
/// there in the plane, or along the one normal that all bumps of a strip have. Every try is one increment from `from`.
///
/// Along a line the response to one increment is piecewise linear in its length: Newton's method with the tangent of
/// the modes that it ends with, inside a bracket that shrinks, takes a few tries. In the plane Newton's method starts
/// where the load is met along its own direction if it is new or turns round, and its steps are halved while they lead
/// away from the load. Where that ends nowhere, half the load is added first.
///
/// A stepper that follows events does so here, too: the load grows in proportion from the one that is carried, and the
/// body goes its own way. One that is new begins with no load, met in one increment along its direction; one that turns
/// round is taken back to that first. Where the body cannot be followed, an increment as above takes its place.
/// @param load   not zero: under no load the place would not be determined
/// @param none   a load no larger than this stands for none: met along its direction, it may be as large across, N
/// @param reach  the load is not looked for beyond this displacement from the origin, m
/// @param step   receives the result; statuses load_out_of_reach, load_not_met, unstable, not_unique and those of the
///               increments
void advance_to_load(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, double none,
                     double reach, Step& step);

}  // namespace bumpfoil
