#pragma once

#include <Eigen/Core>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/bearing/bearing_state.hpp"
#include "bumpfoil/film/film_integrals.hpp"

/// Bearings that run: those with a film (BearingModel::film), which all functions here but make_film_bearing() require.
namespace bumpfoil {

/// The bearing of these foils with a film; a film that it already has is replaced.
BearingModel make_film_bearing(const BearingModel& foils, const Gas& gas, const FilmResolution& resolution,
                               const FilmSurroundings& surroundings = {});

/// The same with top foils that are formed by a part of what they are: 0, not at all. With a sleeve and bumps of its
/// own a state of the one is a first guess of the other.
BearingModel formed_by(const BearingModel& bearing, double part);

/// H of the undeformed foils with the journal at a place (m; of two entries: not tilted), at all nodes, where the foils
/// stand farther out than they do by `clearance_offset` (m).
Matrix undeformed_thickness(const BearingModel& bearing, const JournalVector& journal, double clearance_offset = 0.0);

/// Gas at rest, unstressed foils; H is positive where the journal leaves room.
BearingState resting(const BearingModel& bearing, const JournalVector& journal, double speed,
                     double clearance_offset = 0.0);

/// What a state is good for.
struct FilmBearingOutcome {
  Eigen::Vector2d force{Eigen::Vector2d::Zero()};   ///< to be applied to the journal, N
  Eigen::Vector2d moment{Eigen::Vector2d::Zero()};  ///< int z dF of it about the mid-plane, N m; zero on half the width
  double eccentricity{};                            ///< |(x, y)| / |C_r|; infinite without a clearance
  double
      attitude_angle{};  ///< from the force to the displacement, positive in the sense of rotation, in (-pi, pi], rad
  double torque{};       ///< against rotation for Omega > 0, N m
  double couette_torque{};       ///< Couette part of it, N m
  double asperity_torque{};      ///< part of asperities that rub, N m; the rest is the Poiseuille part
  double torque_of_moments{};    ///< the same torque by the balance of moments: equal but for the discretisation
  double power{};                ///< torque times Omega, W
  double couette_dissipation{};  ///< of the moving surface, W
  double dissipation{};          ///< of it and of the pressure flow, W: equal to the power but for the discretisation
  FilmFlows flows;               ///< of all pads, m^3/s at ambient pressure; `start` is the weld, `sides` are all edges
                                 ///< of strips, too, and `right_side` is that of the bearing
  double slit_flow{};            ///< part of `sides` at the slits of a split top foil
  ThinnestPlace thinnest;        ///< without dimension; column and angle from the weld of its pad
  int thinnest_pad{};            ///< from 0
  double thinnest_crest{};       ///< least H over a crest
  double max_pressure{}, min_pressure{};                    ///< P
  Eigen::Vector2d asperity_force{Eigen::Vector2d::Zero()};  ///< part of the force that asperities carry, N
  double max_asperity_pressure{};                           ///< P_c
  int loaded_bumps{};                                       ///< bumps loaded by the top foil
  int first_loaded{-1}, last_loaded{-1};  ///< of them, from 0 through all pads; -1 where there is none
  Eigen::Matrix2Xd pad_forces;            ///< part of the force that each of several pads takes, N; one has no column
};

/// Compressions between top foils and crests, N, one per bump, pad after pad.
Vector bump_loads(const BearingModel& bearing, const BearingState& state);

FilmBearingOutcome film_bearing_outcome(const BearingModel& bearing, const BearingState& state);

}  // namespace bumpfoil
