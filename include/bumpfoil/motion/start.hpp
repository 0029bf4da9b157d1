#pragma once

#include <functional>

#include "bumpfoil/bearing/film_stepper.hpp"

namespace bumpfoil {

/// Reaches a first state from rest. It begins in a clearance that is wider by `clearance_offset` (m), and closes it.
/// @param state  receives the result; after a failure the last state that was found, if there was one
using Beginning = std::function<FilmReport(FilmStepper& stepper, double clearance_offset, BearingState& state)>;

/// By how much the clearance is opened, m, for a running bearing to start: where foils leave too little room for a
/// film, until they leave c.
/// @param floor  film thickness that counts as contact, m
double clearance_offset_to_start(const BearingModel& bearing, double floor);

/// Closes a clearance in equal increments.
/// @param to  where it is closed, by the same position or load
FilmReport close_clearance(FilmStepper& stepper, const OperatingPoint& to, int steps, BearingState& state);

/// From rest to a first state of a running bearing whose foils may leave no space for a film: the run starts in a
/// clearance that is opened until there is space. If formed foils leave none, it starts with foils that are formed to
/// the bearing, and their forming is applied step by step.
/// @param to     the point that `begin` leads to
/// @param steps  increments of the forming
/// @param state  as of Beginning
FilmReport start_from_rest(FilmStepper& stepper, const OperatingPoint& to, int steps, const Beginning& begin,
                           BearingState& state);

}  // namespace bumpfoil
