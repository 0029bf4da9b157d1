#include "bumpfoil/analysis/film_equilibrium.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace bumpfoil {
namespace {

/// Newton's method on the position: longest step in units of c, defect of the load relative to
/// it or to 1 N, iterations.
constexpr double longest_displacement = 0.15;
constexpr double load_tolerance = 1e-8;
constexpr int max_displacements = 30;

}  // namespace

FilmReport find_equilibrium(FilmBearingSolver& solver, const FilmBearing& bearing, const Eigen::Vector2d& load,
                            double speed, int steps, FilmBearingState& state) {
  const double longest = longest_displacement * bearing.scales.thickness;
  FilmReport total = solver.follow(state.position, speed, state);
  const Eigen::Vector2d from = film_bearing_outcome(bearing, state).force;
  for (int i = 1; i <= steps && total.status == FilmStatus::converged; ++i) {
    const Eigen::Vector2d target = from + (load - from) * i / steps;
    FilmBearingState trial = state;
    for (int displacements = 0;; ++displacements) {
      const Eigen::Vector2d missing = target - film_bearing_outcome(bearing, trial).force;
      if (missing.norm() <= load_tolerance * std::max(target.norm(), 1.0)) break;
      const auto K = solver.stiffness(trial);
      if (!K || displacements == max_displacements) {
        total.status = FilmStatus::not_converged;
        return total;
      }
      Eigen::Vector2d displacement = K->partialPivLu().solve(missing);
      if (displacement.norm() > longest) displacement *= longest / displacement.norm();
      const FilmReport report = solver.follow(trial.position + displacement, speed, trial);
      total.iterations += report.iterations;
      total.factorisations += report.factorisations;
      total.status = report.status;
      if (report.status != FilmStatus::converged) return total;
    }
    state = std::move(trial);
  }
  return total;
}

}  // namespace bumpfoil
