#pragma once

#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/path_follower.hpp"
#include "bumpfoil/film/film_solver.hpp"
#include "bumpfoil/film/foil_film.hpp"

namespace bumpfoil {

/// History that a step in time passes to the next, in addition to the state: a plain value.
struct LastStep {
  double dt{};     ///< its length, s; 0: there was none, as after increments that take no time
  Matrix content;  ///< P H at its start, at all nodes
};

/// Everything that one increment passes to the next, with or without a film: a plain value that can be copied, stored
/// and restored. Its excitation is the one with which the foils are in equilibrium.
struct BearingState : Excitation {
  double time{};                   ///< s; quasi-static increments take none
  Eigen::Vector2d tilt{0.0, 0.0};  ///< of the journal under a film, see JournalVector, m
  double speed{};                  ///< Omega of it, rad/s
  double clearance_offset{};       ///< by which the clearance of a film is wider than that of the bearing, m
  ContactLoading loading;          ///< gaps and loads that the contact problem was solved for; none under a film
  ContactState contacts;           ///< displacements, forces and modes; friction refers to them
  Vector slip_origin;              ///< unknowns that the slip of the last part of the last increment is measured from
  FoilFilmState film;              ///< of all columns, without dimension, see FilmScales; no columns: no film
  LastStep last_step;              ///< of second order in time
  double work{};                   ///< of the journal since the count began, see gap_work(), J
  double dissipated_energy{};      ///< by friction since then, J

  /// Unstressed foils before their assembly.
  static BearingState unstressed(const BearingModel& foils);

  /// Friction refers to where the contacts are now.
  void begin_increment() { slip_origin = contacts.x; }
};

/// A place inside an increment where parts of the response join.
struct Waypoint {
  Eigen::Vector2d position;       ///< of the journal, m
  Eigen::Vector2d force;          ///< that holds it, N
  Eigen::Matrix2Xd pad_forces{};  ///< what each of several pads takes of it, N
};

/// A change of mode of one contact inside an increment.
struct StepEvent {
  Eigen::Vector2d position;  ///< of the journal, m
  int contact{};
  ContactMode from{};
  ContactMode to{};
};

/// A computed increment: its end state, the events during it, its cost and its status.
struct Step {
  Status status{Status::converged};
  BearingState state;               ///< new; after a failure it means nothing but where the increment was to lead
  std::vector<StepEvent> events;    ///< only where they are followed
  std::vector<Waypoint> waypoints;  ///< between its ends: forces are linear from one to the next, as far as is known
  SolveCost cost;
  int substeps{};     ///< extra solves because the increment had to be halved
  bool is_linear{};   ///< in pieces, so that W = E_end - E_begin + D holds to round-off
  FilmReport film{};  ///< how that of a running bearing was found

  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

}  // namespace bumpfoil
