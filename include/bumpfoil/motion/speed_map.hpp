#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/core/status.hpp"
#include "bumpfoil/motion/whirl.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// Free motions of a rotor at one of its speeds.
struct SpeedMotions {
  std::vector<Whirl> whirls;  ///< the one that grows fastest first
  /// Of each: which motion it is, from 0. It keeps its number from speed to speed.
  std::vector<std::size_t> numbers;
  /// Rate of the motion that grows fastest by synchronous coefficients, see whirls_on_coefficients().
  std::optional<std::complex<double>> by_coefficients;
};

/// A rotor at a speed, in the equilibrium of its bearings under its weight.
struct SpeedPoint {
  double speed{};  ///< Omega, rad/s
  Status status{Status::not_reached};
  std::vector<BearingState> states;  ///< of the bearings; empty where they were not found
  /// Where slipping contacts slip on, and where all closed ones stick. None where the modes leave a singular system.
  std::optional<SpeedMotions> sliding, stuck;

  [[nodiscard]] const std::optional<SpeedMotions>& motions(bool of_stuck) const { return of_stuck ? stuck : sliding; }
};

/// Where the motion that grows fastest begins to grow, or ends to.
struct WhirlOnset {
  bool stuck{};
  bool by_coefficients{};  ///< by synchronous coefficients
  bool begins{};           ///< it grows at higher |Omega|
  bool of_foils{};         ///< it is a motion of foils and films
  Onset onset;
};

/// A rotor over its speeds.
struct SpeedMap {
  std::vector<SpeedPoint> points;  ///< in the order of the speeds
  /// Between neighbours, in their order; those of sliding contacts first, then of stuck ones, then by coefficients in
  /// the same way.
  std::vector<WhirlOnset> onsets;
  std::size_t motions{};  ///< their numbers are below this
  bool interrupted{};     ///< onsets may be missing, though all speeds are there
};

/// Follows the equilibria of all bearings from speed to speed, one increment each, and finds the motions at each speed
/// and the speeds of onset between them. The first speed is reached from ambient pressure. To each step of the search
/// for an onset the states go in one increment from the neighbour where the search begins. After a speed without
/// equilibrium the later ones are not computed.
/// @param steppers    of the bearings in the order of Rotor::bearings
/// @param gravity     m/s^2; each bearing must carry something
/// @param speeds      rad/s, all of one sign
/// @param keep_going  called before every speed; false ends the map
SpeedMap map_speeds(const Rotor& rotor, const std::vector<FilmStepper*>& steppers, const Eigen::Vector2d& gravity,
                    const std::vector<double>& speeds, const std::function<bool()>& keep_going = {});

}  // namespace bumpfoil
