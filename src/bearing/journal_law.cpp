#include "bumpfoil/bearing/journal_law.hpp"

namespace bumpfoil {
namespace {

/// Longest displacement of the journal in one step, in units of c. Where it is held, the state comes along on its
/// branch in steps this short; on the way to its load the residual sees to that.
constexpr double longest_step_held = 0.00625;
constexpr double longest_step_loaded = 0.15;
/// What a journal that is not yet where it is held weighs among the residuals, per c. The film's residual grows with
/// the square of a step, and Newton's method takes it away in the next one: with a lesser weight it would keep steps
/// far below the longest.
constexpr double weight_of_distance = 30.0;
/// Displacements to a position that round-off has left, in units of c.
constexpr double least_distance = 1e-14;

}  // namespace

JournalLaw held_journal(const Eigen::Vector2d& position, const FilmScales& scales) {
  const double c = scales.thickness;
  return {.by_position = Eigen::Matrix2d::Identity(),
          .by_force = Eigen::Matrix2d::Zero(),
          .position = position,
          .force = Eigen::Vector2d::Zero(),
          .unit = c / weight_of_distance,
          .round_off = least_distance * c,
          .longest_step = longest_step_held * c};
}

JournalLaw loaded_journal(const Eigen::Vector2d& load, const FilmScales& scales) {
  return {.by_position = Eigen::Matrix2d::Zero(),
          .by_force = Eigen::Matrix2d::Identity(),
          .position = Eigen::Vector2d::Zero(),
          .force = load,
          .unit = scales.force(),
          .longest_step = longest_step_loaded * scales.thickness};
}

}  // namespace bumpfoil
