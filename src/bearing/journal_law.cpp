#include "bumpfoil/bearing/journal_law.hpp"

#include <algorithm>

namespace bumpfoil {
namespace {

/// Longest displacement of the journal in one step, in units of c. At a prescribed position, such short steps keep the
/// state on its branch; under a load, the residual does.
constexpr double longest_step_held = 0.00625;
constexpr double longest_step_loaded = 0.15;
/// Residual weight of the distance of the journal from its prescribed position, per c. The film's residual grows with
/// the square of a step, and Newton's method removes it in the next one: a smaller weight would keep steps far below
/// the longest.
constexpr double weight_of_distance = 30.0;
/// Distances to the prescribed position that are round-off, in units of c.
constexpr double least_distance = 1e-14;

}  // namespace

JournalVector JournalLaw::residual(const JournalVector& q, const JournalVector& F) const {
  return by_position * (position - q) + by_force * (force - F);
}

JournalMatrix JournalLaw::matrix(const JournalMatrix& K) const {
  return by_position + by_force * K;
}

JournalLaw held_journal(const JournalVector& position, const FilmScales& scales) {
  const Eigen::Index n = position.size();
  const double c = scales.thickness;
  return {.by_position = JournalMatrix::Identity(n, n),
          .by_force = JournalMatrix::Zero(n, n),
          .position = position,
          .force = JournalVector::Zero(n),
          .units = JournalVector::Constant(n, c / weight_of_distance),
          .round_off = least_distance * c,
          .longest_step = longest_step_held * c};
}

JournalLaw loaded_journal(const JournalVector& load, const FilmScales& scales) {
  const Eigen::Index n = load.size();
  return {.by_position = JournalMatrix::Zero(n, n),
          .by_force = JournalMatrix::Identity(n, n),
          .position = JournalVector::Zero(n),
          .force = load,
          .units = JournalVector::Constant(n, scales.force()),
          .longest_step = longest_step_loaded * scales.thickness};
}

JournalLaw with_tilt(const JournalLaw& in_mid_plane, const JournalLaw& of_tilt) {
  JournalLaw both{.by_position = JournalMatrix::Zero(4, 4),
                  .by_force = JournalMatrix::Zero(4, 4),
                  .position = JournalVector(4),
                  .force = JournalVector(4),
                  .units = JournalVector(4),
                  .round_off = std::min(in_mid_plane.round_off, of_tilt.round_off),
                  .longest_step = std::max(in_mid_plane.longest_step, of_tilt.longest_step)};
  both.by_position << in_mid_plane.by_position, Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero(), of_tilt.by_position;
  both.by_force << in_mid_plane.by_force, Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero(), of_tilt.by_force;
  both.position << in_mid_plane.position, of_tilt.position;
  both.force << in_mid_plane.force, of_tilt.force;
  both.units << in_mid_plane.units, of_tilt.units;
  return both;
}

}  // namespace bumpfoil
