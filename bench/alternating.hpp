#pragma once

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// How a film and foils that are solved in turn got on.
struct AlternatingReport {
  enum class End { converged, no_room, no_film, no_contact, spent } end{End::spent};
  int iterations{};  ///< films solved, and foils as often
  double change{};   ///< of H by the last
};

struct AlternatingOptions {
  double relaxation{1.0};  ///< part of the way to the foils' answer that H goes
  double tolerance{1e-6};  ///< change of H at rest
  int most{2000};          ///< iterations
};

/// What others do: the film over a wall that stands still, then the foils under the pressure that this makes, and so
/// on. Film, foils, mesh and contacts are those of FilmStepper, frictionless or with friction referring to
/// unstressed foils; where this comes to rest, it does so in a state of that.
/// @param position  of the journal, m
/// @param speed     rad/s
/// @param state     first guess; receives the last iterate
AlternatingReport alternate(const FilmBearing& bearing, const Eigen::Vector2d& position, double speed,
                            const AlternatingOptions& options, BearingState& state);

}  // namespace bumpfoil
