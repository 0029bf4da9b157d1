#pragma once

#include <complex>
#include <vector>

#include "bumpfoil/motion/march.hpp"

namespace bumpfoil {

/// Growth rate of a free motion e^{s t} in steps of BDF2: ln z / dt, where z is the root near one of (3/2 - s dt) z^2 -
/// 2 z + 1/2 = 0.
std::complex<double> bdf2_rate(std::complex<double> s, double dt);

/// Starts from ambient pressure at 0.1 C_r along the load, and marches by implicit Euler to rest under the load.
BearingState state_under(FilmStepper& stepper, const Eigen::Vector2d& load, double speed);

/// Holds the journal of a state at its position.
OperatingPoint held_there(const BearingState& state);

/// A state whose gauge pressure is increased by a fraction, all else unchanged.
BearingState pressed(const BearingState& state, double part);

/// Takes a bearing through a program of steps in time, all of which must converge. @return the last state
BearingState march_on(FilmStepper& stepper, const Program& program, const BearingState& from);

/// States after a quarter of a revolution, for several numbers of steps. The bearing starts at rest under 50 N at
/// -45,000 rpm: either the load grows and turns at constant rates, or the gauge pressure starts 0.1 % higher and the
/// journal is held.
/// @param uneven  lengths of steps alternate 2 - uneven : uneven
std::vector<BearingState> refined_ends(FilmStepper& stepper, bool loaded, double uneven, const std::vector<int>& steps);

/// Rate, 1/s, of the slowest free motion of P, after all others have decayed. Three successive changes of a motion Z^n,
/// over a quarter of a revolution each, satisfy d_2 - 2 Re(Z) d_1 + |Z|^2 d_0 = 0 for any shape. The journal is held.
/// @param part   initial disturbance as fraction of the gauge pressure
/// @param turns  revolutions for the others to decay
std::complex<double> marched_rate(FilmStepper& stepper, const BearingState& rest, double part, double turns,
                                  int steps_per_revolution);

}  // namespace bumpfoil
