#pragma once

#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The reference bearing with given truss constants, in air, f at both interfaces.
Case film_reference_case(const FilmResolution& resolution, double friction_coefficient = 0.0);
BearingModel film_reference_bearing(const FilmResolution& resolution, double friction_coefficient = 0.0);

/// rad/s
double speed_of_rpm(double rpm);
std::vector<double> speeds_of_rpm(const std::vector<double>& rpm);

/// The reference bearing without friction under half of a rotor of 2 kg, whose weight is along +X.
Case film_rotor_case(const FilmResolution& resolution);

/// States of tests/data/film_bearing.json.
struct ReferenceRun {
  struct Level {
    FilmResolution resolution;
    Eigen::Vector2d force{Eigen::Vector2d::Zero()};
    double thinnest{};  ///< m
    double max_pressure{}, min_pressure{}, torque{}, power{}, dissipation{};
    FilmFlows flows;
    int loaded_bumps{};
  };
  Eigen::Vector2d position{Eigen::Vector2d::Zero()};  ///< in C_r
  double speed{};
  std::vector<Level> levels{};
};
const std::vector<ReferenceRun>& reference_runs();

/// An increment of the friction path of the same file.
struct ReferenceIncrement {
  double eccentricity{};
  Eigen::Vector2d force{Eigen::Vector2d::Zero()};
  double thinnest{}, power{}, dissipated{};
  int loaded_bumps{};
};
struct ReferencePath {
  FilmResolution resolution;
  double speed{};
  std::vector<ReferenceIncrement> increments{};
  std::vector<double> last_bump_loads{};
};
const ReferencePath& reference_friction_path();

/// Equilibria under a load of the same file.
struct ReferenceEquilibrium {
  FilmResolution resolution;
  Eigen::Vector2d load{Eigen::Vector2d::Zero()};  ///< N
  double speed{};
  Eigen::Vector2d position{Eigen::Vector2d::Zero()};     ///< in C_r
  Eigen::Matrix2d stiffness{Eigen::Matrix2d::Zero()};    ///< N/m
  Eigen::Matrix2cd impedance{Eigen::Matrix2cd::Zero()};  ///< to a whirl at the speed, N/m
};
const std::vector<ReferenceEquilibrium>& reference_equilibria();

/// Impedance after the increment of the friction path at 0.8 C_r, of the same file.
struct ReferenceWhirl {
  bool stuck{};
  double frequency{};  ///< rad/s
  Eigen::Matrix2cd impedance{Eigen::Matrix2cd::Zero()};
};
const std::vector<ReferenceWhirl>& reference_friction_whirls();

}  // namespace bumpfoil
