#pragma once

#include <complex>
#include <vector>

#include "bumpfoil/motion/march.hpp"

namespace bumpfoil {

/// Rate at which a free motion e^{s t} goes on in steps of BDF2: ln z / dt, where z is the root near one of
/// (3/2 - s dt) z^2 - 2 z + 1/2 = 0.
std::complex<double> bdf2_rate(std::complex<double> s, double dt);

/// A cold start at 0.1 C_r along the load, and the film marched on by implicit Euler until it rests under the load.
BearingState state_under(FilmStepper& stepper, const Eigen::Vector2d& load, double speed);

/// Its journal held where it is.
OperatingPoint held_there(const BearingState& state);

/// A state whose gauge pressure is more by a part of itself, and the rest as it was.
BearingState pressed(const BearingState& state, double part);

/// Takes a bearing through a program of steps in time, all of which must converge. @return the last state
BearingState march_on(FilmStepper& stepper, const Program& program, const BearingState& from);

/// Where a bearing is after a quarter of a revolution, in as many steps each time. It starts at rest under 50 N at
/// -45,000 rpm: the load grows and turns in equal rates, or the gauge pressure is more by a thousandth and the journal
/// held.
/// @param uneven  lengths of steps alternate 2 - uneven : uneven
std::vector<BearingState> refined_ends(FilmStepper& stepper, bool loaded, double uneven, const std::vector<int>& steps);

/// Rate, 1/s, at which the free motion of P goes on that is left after all others have died out. Three changes in turn,
/// over a quarter of a revolution each, of a motion Z^n obey d_2 - 2 Re(Z) d_1 + |Z|^2 d_0 = 0, whatever its shape. The
/// journal is held where it is.
/// @param part   of the gauge pressure, that the motion starts with
/// @param turns  revolutions that it takes the others to die out
std::complex<double> marched_rate(FilmStepper& stepper, const BearingState& rest, double part, double turns,
                                  int steps_per_revolution);

}  // namespace bumpfoil
