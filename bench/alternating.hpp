#pragma once

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// Result of solving film and foils alternately.
struct AlternatingReport {
  enum class End { converged, no_room, no_film, no_contact, spent } end{End::spent};
  int iterations{};  ///< number of film solves, and of foil solves
  double change{};   ///< of H in the last iteration
};

struct AlternatingOptions {
  double relaxation{1.0};  ///< fraction of the change of H to the foils' response
  double tolerance{1e-6};  ///< change of H at convergence
  int most{2000};          ///< maximum iterations
};

/// The common staggered scheme: solves the film over a fixed wall, then the foils under its pressure, and repeats.
/// Film, foils, mesh and contacts are those of FilmStepper, frictionless or with friction from unstressed foils; if it
/// converges, the result is a state of FilmStepper.
/// @param position  of the journal, m
/// @param speed     rad/s
/// @param state     first guess; receives the last iterate
AlternatingReport alternate(const BearingModel& bearing, const Eigen::Vector2d& position, double speed,
                            const AlternatingOptions& options, BearingState& state);

}  // namespace bumpfoil
