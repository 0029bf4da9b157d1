#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/program.hpp"

namespace bumpfoil {

/// A prescribed path of the journal from the centre of the bearing: through given points, or around an ellipse.
struct PathSettings {
  PathPoints points;  ///< where there are any, there is no orbit

  PlaneTarget centre;     ///< of the ellipse
  PlaneTarget semi_axes;  ///< along its own axes
  double tilt{};          ///< of the first axis, from X towards Y, rad
  Sense sense{Sense::counterclockwise};
  int orbits{5};
  int steps{200};  ///< equal parameter steps of an orbit, and increments of the straight approach to its first point

  bool operator==(const PathSettings&) const = default;

  [[nodiscard]] bool is_orbit() const { return points.values.empty(); }
  [[nodiscard]] Control control() const { return is_orbit() ? centre.control : points.control; }
};

/// The legs of the path, an increment each. An orbit begins with a straight way of as many increments as an
/// orbit has to its first point, centre + R(tilt) (a, 0), and goes on along centre + R(tilt) (a cos(t), b sin(t));
/// where it begins at the origin there is no way to it. A first point at the origin is the assembly.
Program path_program(const PathSettings& path);

/// Takes the journal of a case along its path, from the unstressed foils. The result has one `Cycle`, whose increments
/// are those of the path: 0 is the assembly at the centre of the bearing, displacement and direct force count from
/// there towards the journal, and both tangents are known at each. Under load control the journal is free in the plane.
/// @throws Error (input) if the case cannot be built, or has no path.
CycleResult run_path(const Case& input, const ProgressCallback& progress = {});

}  // namespace bumpfoil
