#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "bearing/film_newton.hpp"

namespace bumpfoil {

/// Target of a solve.
struct NewtonAim {
  double tolerance{};  ///< largest change of P, H and position over c in a full step of a state that has converged
  /// Steps that it may take though no more than 1/64 of them makes the residuals smaller. It gives up at the next one.
  int most_vain_steps{std::numeric_limits<int>::max()};
};

/// Newton's method for the films, foils and contacts of any number of bearings and for what holds their journals, in
/// one system: bearings meet in the rows of the law alone. All of them must have set out on the move.
/// @param films  each of them once
/// @param y      first guess of the law's unknowns, from which the journals of the guesses are displaced; receives the
///               result if the status is converged
FilmReport solve_jointly(const std::vector<FilmNewton*>& films, const JointLaw& law, const NewtonAim& aim,
                         int max_iterations, Eigen::VectorXd& y);

}  // namespace bumpfoil
