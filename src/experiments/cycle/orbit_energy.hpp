#pragma once

#include <Eigen/Core>
#include <span>

namespace bumpfoil {

/// State of the foils at a point of an orbit.
struct OrbitPoint {
  Eigen::Vector2d position;  ///< m
  Eigen::Vector2d force;     ///< applied force on the journal, N
};

/// Loop energy of an orbit, J: the work, or 0 if nothing was dissipated and the work is within the error of the
/// trapezoidal rule. The error over a distance h is h^2 |F''| h / 12 for a smooth force F, and at most k h^2 / 8 at a
/// kink with a slope change k. The second differences of F at both ends, h^2 F'' and together k h, times h / 8 bound
/// both.
/// @param work        by the trapezoidal rule, J
/// @param dissipated  J
/// @param orbit       its points, without repeating the first at the end
double orbit_energy(double work, double dissipated, std::span<const OrbitPoint> orbit);

}  // namespace bumpfoil
