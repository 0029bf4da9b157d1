#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/motion/machine.hpp"

namespace bumpfoil {

/// Motion of a station of a rotor in a turn, along X and Y: x = mean + Re(once e^{i |Omega| t} + twice e^{2 i |Omega|
/// t}) and more, t = 0 where the rotor stands at angle 0.
struct StationOrbit {
  Eigen::Vector2d mean{Eigen::Vector2d::Zero()};               ///< m
  Eigen::Vector2cd once{Eigen::Vector2cd::Zero()};             ///< m
  Eigen::Vector2cd twice{Eigen::Vector2cd::Zero()};            ///< m
  Eigen::Vector2d half_peak_to_peak{Eigen::Vector2d::Zero()};  ///< m
};

/// What a bearing does in a turn.
struct BearingTurn {
  double thinnest{};  ///< minimum film thickness at any node and step, m
  double power{};     ///< mean, W
  double friction{};  ///< work that friction between foils and sleeve takes, J
};

/// Settings of the search for periodic orbits.
struct OrbitOptions {
  int steps_per_turn{100};
  double tolerance{1e-7};              ///< change of journals over c, and of their velocities over c |Omega|, in a turn
  int max_turns{60};                   ///< and one more, which is recorded, and those after a disturbance
  std::function<bool()> keep_going{};  ///< called before every turn; false ends the search
};

/// The motion of a machine over a turn.
struct Orbit {
  Status status{Status::not_converged};  ///< not_converged: no periodic orbit was found
  int turns{};                           ///< that were marched
  int iterations{};                      ///< of Newton's method
  double change{};                       ///< in the last turn, as in OrbitOptions::tolerance
  MachineState state;                    ///< at its end; the last that was found where the march ended
  std::vector<StationOrbit> bearings{};  ///< of the journals in the last turn, periodic or not; none where it ended
  std::vector<StationOrbit> stations{};  ///< of Rotor::stations
  std::vector<BearingTurn> turn{};       ///< of the bearings
  /// Floquet multipliers found by the search, the largest first: factors by which what is left of other motions of
  /// the journals changes in a turn, as their differences from turn to turn show. An orbit lasts where all are smaller
  /// than one. None where no orbit was found and nothing had to be extrapolated.
  std::vector<std::complex<double>> multipliers{};
};

/// Adds a motion Re(Y e^{i |Omega| t}) of the rotor at t = 0 to a state: the journals go there, and films and foils
/// stay. Films are left half as thick at least: where they would not be, all of the motion is scaled.
void add_motion(const MachineStepper& stepper, const Eigen::VectorXcd& motion, MachineState& state);

/// The orbit of a speed as a guess of that of another one, at an angle of whole turns: what it differs by from the
/// linear start there is added to the linear start here. Steps in time begin anew.
/// @param linear   at rest, and moved by add_motion(), at the new speed
/// @param orbit    Orbit::state at the old one
/// @param before   the linear start there
/// @return nothing where that leaves no film
std::optional<MachineState> moved_orbit(const MachineState& linear, const MachineState& orbit,
                                        const MachineState& before);

/// Looks for the motion of a machine that repeats itself in every turn at constant speed. A turn is a map of states;
/// disturbances of film and foils decay within a part of it, those of the rotor in many turns. Reduced-rank
/// extrapolation removes the remaining other motions: after two turns the differences d_i of journals and their
/// velocities over 4 turns per bearing and two more give weights g, min |sum g_i d_i| with sum g_i = 1, by which whole
/// states are combined, and the march goes on from there. It also converges to unstable orbits, which the multipliers
/// reveal. Differences of less than ten tolerances come from creep by friction and give no multipliers; an orbit that
/// is found without larger differences is disturbed by a thousandth of the clearance, and the same number of following
/// turns gives the multipliers.
/// @param forces  repeat themselves with the angle
/// @param start   at an angle of whole turns
Orbit find_orbit(MachineStepper& stepper, const RotorForces& forces, const MachineState& start,
                 const OrbitOptions& options = OrbitOptions());

}  // namespace bumpfoil
