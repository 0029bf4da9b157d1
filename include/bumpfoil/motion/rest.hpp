#pragma once

#include "bumpfoil/bearing/film_stepper.hpp"

namespace bumpfoil {

/// Marches the film in time by implicit Euler, journal and foils without mass, from `state` until nothing moves. This
/// is one increment: friction refers to BearingState::slip_origin throughout.
/// @param state  receives the result; stays as it was unless the film comes to rest
[[nodiscard]] FilmReport march_to_rest(FilmStepper& stepper, const OperatingPoint& to, BearingState& state);

/// The same as an increment of its own: friction refers to `state` as it was handed over.
[[nodiscard]] FilmReport settle(FilmStepper& stepper, const OperatingPoint& to, BearingState& state);

/// Gas at rest, and foils as they lie in the sleeve without a journal: unstressed, or where top foils are formed
/// otherwise than their circles, after an increment of its own, their assembly.
BearingState assembled(FilmStepper& stepper, const Eigen::Vector2d& position, double speed,
                       double clearance_offset = 0.0);

/// settle() with the journal at `position`, where it must not touch the assembled foils, and at `speed`, from
/// assembled(). Friction refers to the foils there. With a `clearance_offset` (m) in a clearance wider by that, which
/// follow() closes.
[[nodiscard]] FilmReport start_from_ambient(FilmStepper& stepper, const Eigen::Vector2d& position, double speed,
                                            BearingState& state, double clearance_offset = 0.0);

}  // namespace bumpfoil
