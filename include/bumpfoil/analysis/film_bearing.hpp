#pragma once

#include <Eigen/Core>

#include "bumpfoil/contact/problem.hpp"
#include "bumpfoil/film/film_integrals.hpp"
#include "bumpfoil/film/foil_film.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/structure/foil_structure.hpp"

namespace bumpfoil {

/// The gas of a case.
Gas gas_of(const GasSettings& settings);

/// The film knows one foil all around, and a journal that looks the same however it has turned.
/// @throws Error (input) if a case has others
void require_film_geometry(const Case& input);

/// c of a bearing, m: the size of its clearance, or 10 um where it has none.
double film_thickness_scale(double clearance);

/// Mesh of the film over the foil of a bearing.
struct FilmResolution {
  int columns_per_pitch{6};  ///< even, 4 or more: every crest is a column
  int rows{16};              ///< intervals on half the width
};

/// A bearing that runs: gas film, top foil, bump foil, and the contacts top foil/bump and bump/sleeve. The film takes
/// the place of the contact between journal and top foil. A plain value.
///
/// Unknowns come in blocks, one for each bump and a last one for the free end. The block of a bump has the places of
/// `dofs`, with the top foil over the crest among them, and after them the pressures of the column over the crest,
/// c (P_j - 1) (m). The block of the free end keeps the displacement of the top foil in the place of its first
/// pressure; all else there stays zero.
struct FilmBearing {
  FilmScales scales;  ///< c is the size of the clearance
  FoilFilm foil;
  BumpDofs dofs;
  ContactProblem problem;    ///< K of the bump foil alone, which holds what means nothing in the last block
  Vector initial_gap;        ///< of each contact, m
  double clearance{};        ///< C_r, m
  double weld_angle{};       ///< rad
  double wrap_sign{};        ///< sigma: +1 where theta runs from X to Y
  Eigen::Matrix2Xd normals;  ///< outward at all columns
  Vector sleeve;             ///< how much larger than nominal its radius is at all columns, m

  /// sigma Omega R, m/s: speed of the surface of the journal along theta; `speed` (rad/s) turns X to Y.
  [[nodiscard]] double surface_speed(double speed) const { return wrap_sign * speed * scales.radius; }
  /// H of the undeformed foil with the journal at `position` (m), at all nodes.
  [[nodiscard]] Matrix undeformed_thickness(const Eigen::Vector2d& position) const;
};

/// The bearing of a case, in gas.
/// @throws Error (input) if the case cannot be built.
FilmBearing make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution);

/// The same in the gas and on the mesh of the case.
FilmBearing make_film_bearing(const Case& input);

/// What is known of a bearing that runs: a plain value, all that a next state needs.
struct FilmBearingState {
  Eigen::Vector2d position{Eigen::Vector2d::Zero()};  ///< of the journal, m
  double speed{};                                     ///< Omega, rad/s
  FoilFilmState foil;                                 ///< without dimension, see FilmScales
  ContactState contact;                               ///< of the unknowns of the blocks
};

/// P = 1, unstressed foils; H is positive where the journal leaves room.
FilmBearingState resting(const FilmBearing& bearing, const Eigen::Vector2d& position, double speed);

/// What a state is good for.
struct FilmBearingOutcome {
  Eigen::Vector2d force{Eigen::Vector2d::Zero()};  ///< to be applied to the journal, N
  double eccentricity{};                           ///< |(x, y)| / |C_r|; infinite without a clearance
  double
      attitude_angle{};  ///< from the force to the displacement, positive in the sense of rotation, in (-pi, pi], rad
  double torque{};       ///< against rotation for Omega > 0, N m
  double couette_torque{};       ///< of which the moving surface alone makes this much, N m; the rest is the pressure's
  double torque_of_moments{};    ///< the same torque by the balance of moments: equal but for the discretisation
  double power{};                ///< torque times Omega, W
  double couette_dissipation{};  ///< of the moving surface, W
  double dissipation{};          ///< of it and of the pressure flow, W: equal to the power but for the discretisation
  FilmFlows flows;               ///< m^3/s at ambient pressure; `start` is the weld
  ThinnestPlace thinnest;        ///< without dimension
  double thinnest_crest{};       ///< least H over a crest
  double max_pressure{}, min_pressure{};  ///< P
  int loaded_bumps{};                     ///< bumps that the top foil presses
  int first_loaded{-1}, last_loaded{-1};  ///< of them, from 0; -1 where there is none
};

/// Force that must be applied to the journal under the pressure P at all nodes: the integral of (p - pa) n, N.
Eigen::Vector2d film_force(const FilmBearing& bearing, const Matrix& pressure);

FilmBearingOutcome film_bearing_outcome(const FilmBearing& bearing, const FilmBearingState& state);

/// The Reynolds equation at a speed, steady.
ReynoldsEquation film_equation(const FilmBearing& bearing, double speed);

}  // namespace bumpfoil
