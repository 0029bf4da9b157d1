#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// A free motion y e^{s t} of a rotor with film and foils of its bearings: det D(s) = 0,
///
///     D(s) = M s^2 + (Omega G + C) s + K + sum B_i^T Z_i(s) B_i
struct Whirl {
  std::complex<double> rate;  ///< s, 1/s: real part the growth rate, imaginary part the damped frequency, not negative
  Eigen::VectorXcd shape;     ///< y of the rotor, of unit length
  double residual{};          ///< least singular value of D(s) over the largest one
  /// Part of dD/ds that inertia, gyroscopic terms and damping of the rotor have in this motion, as its left and right
  /// eigenvectors see it; the rest is that of the films. 1: rotor on springs, 0: foil and film with the rotor at rest.
  double rotor_share{};
  /// Mean of the orbits of all journals: 1, a circle in the sense of rotation (forward); -1, against it; 0, a line.
  double direction{};

  [[nodiscard]] double log_decrement() const;  ///< -2 pi Re s / Im s; infinite without an oscillation
  [[nodiscard]] double damping_ratio() const;  ///< -Re s / |s|
  /// Whether it is a motion of foils and films, in which the rotor takes little part. Where a rotor is light, motions
  /// of both mix, and this is a matter of degree: rotor_share.
  [[nodiscard]] bool is_of_foils() const { return rotor_share < 0.25; }
};

/// Motions that are looked for.
struct WhirlWindow {
  double highest_frequency{};          ///< Im s, rad/s
  double strongest_decay{};            ///< -Re s, 1/s
  double highest_growing_frequency{};  ///< of those that grow, rad/s
};

/// Up to twice the speed of rotation, and what decays within a radian; up to eight times that speed, what grows.
WhirlWindow usual_window(double speed);

/// All motions in a window, the one that grows fastest first. They are the eigenvalues of one matrix: the reduced films
/// are linear in s when what they store is among the unknowns. Newton's method on D(s) then refines each of them; what
/// films and foils have for themselves, without a force on the journals, is left out: a Whirl::rotor_share below 1e-9,
/// which is round-off.
/// @param bearings  Z_i in the order of Rotor::bearings
std::vector<Whirl> whirls_on(const Rotor& rotor, double speed, const std::vector<FilmImpedance>& bearings,
                             const WhirlWindow& window);

/// A bearing that carries a rotor, and the state in which it runs.
struct CarryingBearing {
  FilmStepper& stepper;
  const BearingState& state;
};

/// Free motions about states of bearings.
struct FreeMotions {
  std::vector<Whirl> whirls;            ///< the one that grows fastest first
  std::vector<FilmImpedance> bearings;  ///< Z_i, as they were reduced for these motions and for i |Omega|
};

/// All motions in a window about states of the bearings, which all turn at one speed. The films are reduced twice:
/// where they are likely to whirl, and then at the motions found, so that D(s) has errors of 1e-10 there.
/// @param stuck  slipping contacts stick, as under a small whirl after some revolutions
/// @return nothing if the modes of contacts leave a singular system
std::optional<FreeMotions> find_whirls(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                       const WhirlWindow& window, bool stuck = false);

/// Motions of the same rotor on synchronous coefficients, Z_i(s) = K_i + s C_i with the stiffness K_i = Re Z_i(i
/// |Omega|) and the damping C_i = Im Z_i(i |Omega|) / |Omega|. Whirl is not synchronous, so these motions may be far
/// from the true ones.
std::vector<Whirl> whirls_on_coefficients(const Rotor& rotor, double speed, const std::vector<FilmImpedance>& bearings,
                                          const WhirlWindow& window);

/// Where a rotor begins to whirl.
struct Onset {
  double speed{};        ///< Omega, rad/s
  double whirl_ratio{};  ///< frequency over |Omega|
  bool jumps{};          ///< the growth rate jumps over zero there, as where contacts change
};

/// The speed at which the growth rate changes its sign, or jumps to another one, by the secant through two speeds, and
/// halving where it lags.
/// @param rate_at  rate s of the motion that is followed, 1/s; nothing where there is no state
/// @return nothing if the growth rates at both ends have the same sign, or a state is missing
std::optional<Onset> find_onset(const std::function<std::optional<std::complex<double>>(double speed)>& rate_at,
                                double from, double to);

}  // namespace bumpfoil
