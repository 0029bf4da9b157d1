#pragma once

#include <Eigen/Core>
#include <span>

namespace bumpfoil {

/// Where the foils are at a point of an orbit.
struct OrbitPoint {
  Eigen::Vector2d position;  ///< m
  Eigen::Vector2d force;     ///< that holds the journal, N
};

/// Loop energy of an orbit, J: the work, or 0 where nothing was dissipated and the work is no more than the trapezoidal
/// rule is off. Over a way of length h it is off by h^2 |F''| h / 12 where the force F is smooth, and where its slope
/// changes by k at a kink, by k h^2 / 8 at most; the second differences of F at both ends, h^2 F'' and together k h,
/// times h / 8 bound both.
/// @param work        by the trapezoidal rule, J
/// @param dissipated  J
/// @param orbit       its points, the first not again at the end
double orbit_energy(double work, double dissipated, std::span<const OrbitPoint> orbit);

}  // namespace bumpfoil
