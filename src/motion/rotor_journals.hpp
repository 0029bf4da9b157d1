#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/bearing/joint_law.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// How a rotor moves the journals in its bearings and takes their forces: N = B and B^T, with units of its rows and the
/// longest step; A and y* are not given. Where a bearing is tilted against the line through the centres of all
/// (FilmSurroundings::tilt), its journal has that tilt before the rotor has any.
/// @param bearings  in the order of Rotor::bearings
JointLaw law_of_rotor(const Rotor& rotor, const std::vector<FilmStepper*>& bearings);

/// y of a rotor at rest: journals are displaced to where their bearings have them, and between these the shaft bends,
/// K y = f - sum B^T F. These are more equations than unknowns; in equilibrium all of them are met.
/// @param states  of the bearings, at least one
/// @param forces  f
Eigen::VectorXd rotor_at_rest(const Rotor& rotor, const std::vector<FilmStepper*>& bearings,
                              const std::vector<BearingState>& states, const Eigen::VectorXd& forces);

}  // namespace bumpfoil
