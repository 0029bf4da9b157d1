#pragma once

#include "bumpfoil/bearing/foil_stepper.hpp"

namespace bumpfoil {

/// One increment from `from` to where the force applied to the journal is `load` (N): the journal is free in the plane,
/// the plate of a strip along its normal. Every trial is one increment from `from`.
///
/// Along a line the response to one increment is piecewise linear in its length: Newton's method with the tangent of
/// the modes that it ends with, inside a bracket that shrinks, takes a few tries. In the plane Newton's method starts
/// where the load is met along its own direction if it is new or turns round, and its steps are halved while they lead
/// away from the load. If this fails, half the load is added first.
///
/// A stepper that follows events does so here, too: the load changes proportionally from the present one, and the path
/// of the body follows. A new load starts from zero, met in one increment along its direction; a load that reverses is
/// first reduced to zero. Where the path cannot be followed, an increment as above replaces it.
/// @param load   not zero: under no load the place would not be determined
/// @param none   a load no larger than this stands for none: met along its direction, it may be as large across, N
/// @param reach  the load is not looked for beyond this displacement from the origin, m
/// @param step   receives the result; statuses load_out_of_reach, load_not_met, unstable, not_unique and those of the
///               increments
void advance_to_load(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, double none,
                     double reach, Step& step);

}  // namespace bumpfoil
