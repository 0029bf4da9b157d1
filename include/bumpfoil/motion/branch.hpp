#pragma once

#include "bumpfoil/bearing/film_stepper.hpp"

namespace bumpfoil {

/// One increment of a running bearing along a straight line of speed, clearance offset and position, or load, in steps
/// of adaptive length. Under a load the states stay on their branch: each must lie near where the tangent of the one
/// before leads (FilmBearingOptions::largest_departure). Where even the smallest step fails the branch ends (at a fold,
/// or where a contact changes and the branch turns back): from the last state before the end the film is marched in
/// time at the point beyond it, and the line continues from where it comes to rest (FilmReport::jumps).
///
/// Friction refers to `state` as it was handed over, however many steps it takes.
/// @param state  receives the result; after a failure the last state that was found on the way
[[nodiscard]] FilmReport follow(FilmStepper& stepper, const OperatingPoint& to, BearingState& state);

}  // namespace bumpfoil
