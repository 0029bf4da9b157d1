#pragma once

#include "bumpfoil/bearing/film_stepper.hpp"

namespace bumpfoil {

/// One increment of a running bearing in a straight line of speed, opening and position, or load, by steps of adapted
/// length. Under a load the states stay on their branch: each must lie near where the tangent of the one before leads
/// (FilmBearingOptions::largest_departure). Where even the smallest step fails the branch ends (at a fold, or where a
/// contact changes and the branch turns back): from the last state before that the film is marched in time at the
/// point behind it, and the line followed on from where that comes to rest (FilmReport::jumps).
///
/// Friction refers to `state` as it was handed over, however many steps it takes.
/// @param state  receives the result; after a failure the last state that was found on the way
[[nodiscard]] FilmReport follow(FilmStepper& stepper, const OperatingPoint& to, BearingState& state);

}  // namespace bumpfoil
