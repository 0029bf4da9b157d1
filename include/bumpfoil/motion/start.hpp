#pragma once

#include <functional>

#include "bumpfoil/bearing/film_stepper.hpp"

namespace bumpfoil {

/// Reaches a first state from rest, in a clearance that is wider by `opening` (m).
using Beginning = std::function<FilmReport(FilmStepper& stepper, double opening, BearingState& state)>;

/// By how much the clearance is opened, m, for a running bearing to start: where foils leave too little room for a
/// film, until they leave c.
/// @param floor  film thickness that counts as contact, m
double opening_to_start(const FilmBearing& bearing, double floor);

/// From rest to a first state of a running bearing whose foils may leave a journal no room: it begins in a clearance
/// that is opened until they do, which closes then in equal increments. Where formed foils leave no room, foils that
/// are formed to the bearing begin, and are formed step by step to what they are.
/// @param to     the point that `begin` leads to, but for the opening
/// @param steps  increments of the closing, and of the forming
/// @param state  receives the result; after a failure the last state that was found, if there was one
FilmReport start_from_rest(FilmStepper& stepper, const OperatingPoint& to, int steps, const Beginning& begin,
                           BearingState& state);

}  // namespace bumpfoil
