#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "bearing/film_newton.hpp"

namespace bumpfoil {

/// Target of a solve.
struct NewtonAim {
  double tolerance{};  ///< largest change of P, H and position over c in a full step at convergence
  /// Number of steps allowed in which at most 1/64 reduces the residuals. Newton's method gives up at the next one.
  int most_vain_steps{std::numeric_limits<int>::max()};
};

/// Newton's method for the films, foils and contacts of any number of bearings and the law of their journals, in one
/// system: only the rows of the law couple the bearings. Call FilmNewton::set_out on all of them first.
/// @param films  each bearing once
/// @param y      first guess of the law's unknowns, from which the journals of the guesses are displaced; receives the
///               result if the status is converged
FilmReport solve_jointly(const std::vector<FilmNewton*>& films, const JointLaw& law, const NewtonAim& aim,
                         int max_iterations, Eigen::VectorXd& y);

}  // namespace bumpfoil
