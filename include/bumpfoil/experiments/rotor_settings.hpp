#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/rotor/matrices.hpp"
#include "bumpfoil/rotor/rotor.hpp"
#include "bumpfoil/rotor/shaft.hpp"

namespace bumpfoil {

/// Entry of [[rotor.unbalance]]: an amount, or the largest one that a balance quality grade allows.
struct RotorUnbalance {
  std::optional<double> amount{};       ///< kg m
  std::optional<double> grade{};        ///< G, m/s
  std::optional<double> grade_speed{};  ///< |Omega| that the grade is for, rad/s
  double at{};                          ///< z of its plane, m, measured as those of the bearings
  double phase{};                       ///< of the heavy place, from X towards Y, rad

  bool operator==(const RotorUnbalance&) const = default;
};

/// Table [rotor] of a case: half of a mass on each of two equal bearings; with places of the bearings and inertias, a
/// rigid rotor on them; with pieces of a shaft, a flexible one; or any rotor by its matrices.
struct RotorSettings {
  static constexpr std::string_view table = "rotor";

  std::optional<double> mass{};                ///< of the whole rotor, kg; that of a shaft follows from its pieces
  std::vector<double> gravity{0.0, -9.81};     ///< along X and Y, m/s^2
  std::optional<double> transverse_inertia{};  ///< kg m^2
  std::optional<double> polar_inertia{};       ///< kg m^2
  /// z of the bearings, m: from the centre of mass of a rigid rotor, from the start of a shaft.
  std::vector<double> bearings{};
  std::vector<ShaftSection> shaft{};
  std::vector<ShaftDisc> disks{};
  std::optional<RotorMatrices> matrices{};
  std::vector<RotorUnbalance> unbalances{};

  bool operator==(const RotorSettings&) const = default;
  [[nodiscard]] bool is_flexible() const { return !shaft.empty(); }
  [[nodiscard]] bool tilts() const { return is_flexible() || matrices || !bearings.empty(); }
  [[nodiscard]] std::size_t bearing_count() const { return matrices ? matrices->bearings.size() : bearings.size(); }
  [[nodiscard]] Eigen::Vector2d gravity_vector() const { return {gravity[0], gravity[1]}; }
};

/// The rotor of a case, with a station in the plane of each unbalance; a flexible one reduced to the modes that count
/// up to some frequency.
/// @param range        rad/s
/// @param half_widths  RotorStation::half_width of the bearings; empty: none resists inclinations
ReducedRotor rotor_of(const RotorSettings& settings, double range, const std::vector<double>& half_widths = {});

/// Force of the unbalances on the rotor of a case, see unbalance_force(); on half a rotor that does not tilt, half of
/// it.
/// @param rotor  as rotor_of() makes it
/// @param speed  Omega, rad/s
Eigen::VectorXcd unbalance_force(const RotorSettings& settings, const Rotor& rotor, double speed);

/// All forces on the rotor of a case while it turns: its weight and its unbalances.
RotorForces forces_on(const RotorSettings& settings, const Rotor& rotor);

/// A rotor and the bearings that carry it.
struct Machine {
  std::vector<SharedBearing> bearings;   ///< in the order of Rotor::bearings; those that are alike are one
  std::vector<double> thickness_floors;  ///< of each: h below which its surfaces count as touching, m
  Rotor rotor;                           ///< as it was reduced
  double reduction_error{};              ///< see ReducedRotor
  std::vector<Eigen::Vector2d> loads;    ///< on the bearings by its weight, N

  /// Places of the rotor that results describe: its bearings, then its stations.
  [[nodiscard]] std::vector<RotorStation> places() const;
  /// Minimum film thickness of a bearing, m.
  [[nodiscard]] double thinnest_film(std::size_t bearing, const BearingState& state) const;
  /// The same of all bearings; not a number where there are no states.
  [[nodiscard]] double thinnest_film(const std::vector<BearingState>& states) const;
  /// A stepper for each bearing of the rotor. @param keep_going  FilmBearingOptions::keep_going
  [[nodiscard]] std::deque<FilmStepper> make_steppers(const std::function<bool()>& keep_going = {}) const;
};

/// Where they are.
std::vector<FilmStepper*> pointers_to(std::deque<FilmStepper>& steppers);

/// The machine of a case.
/// @param speeds   that it is to run at, rad/s
/// @param command  that is to run it
/// @throws Error (input) if the case cannot be built or run by the command, or has no rotor
Machine make_machine(const Case& input, const std::vector<double>& speeds, const std::string& command);

}  // namespace bumpfoil
