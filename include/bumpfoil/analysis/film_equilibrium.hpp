#pragma once

#include "bumpfoil/analysis/film_bearing_solver.hpp"

namespace bumpfoil {

/// The position where the bearing carries `load` (N) at `speed` (rad/s), for frictionless foils: `state` is followed to
/// the speed, then the load grows from the force there in equal steps, each found by Newton's method on the position
/// with the consistent stiffness, the state followed along.
/// @param solver  of the bearing
/// @param steps   1 or more
/// @param state   receives the result, or the last step that was found
[[nodiscard]] FilmReport find_equilibrium(FilmBearingSolver& solver, const FilmBearing& bearing,
                                          const Eigen::Vector2d& load, double speed, int steps,
                                          FilmBearingState& state);

}  // namespace bumpfoil
