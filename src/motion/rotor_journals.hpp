#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/bearing/joint_law.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// How a rotor moves the journals in its bearings and takes their forces: N = B and B^T, with the units of its rows and
/// the longest step; A and y* are not set. In a bearing tilted against the line through all bearing centres
/// (FilmSurroundings::tilt), the journal has this tilt before the rotor adds any.
/// @param bearings  in the order of Rotor::bearings
JointLaw law_of_rotor(const Rotor& rotor, const std::vector<FilmStepper*>& bearings);

/// y of a rotor at rest: journals are displaced to their positions in the bearings, and the shaft bends in between, K y
/// = f - sum B^T F. There are more equations than unknowns; in equilibrium all are satisfied.
/// @param states  of the bearings, at least one
/// @param forces  f
Eigen::VectorXd rotor_at_rest(const Rotor& rotor, const std::vector<FilmStepper*>& bearings,
                              const std::vector<BearingState>& states, const Eigen::VectorXd& forces);

}  // namespace bumpfoil
