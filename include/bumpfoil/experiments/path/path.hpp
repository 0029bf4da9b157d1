#pragma once

#include <string_view>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/control.hpp"
#include "bumpfoil/motion/march.hpp"

namespace bumpfoil {

/// A prescribed path of the journal from the centre of the bearing: through given points, or around an ellipse.
struct PathSettings {
  static constexpr std::string_view table = "path";

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

/// The legs of the path, an increment each. An orbit begins with a straight approach of as many increments as an
/// orbit has to its first point, centre + R(tilt) (a, 0), and goes on along centre + R(tilt) (a cos(t), b sin(t));
/// where it begins at the origin there is no approach. A first point at the origin is the assembly.
/// Legs are made when they are due: a path may have a million.
/// @param path  outlives the schedule
Schedule path_schedule(const PathSettings& path);

/// Increments of the path, the assembly included.
int path_increments(const PathSettings& path);

/// Takes the journal of a case along its path, from the unstressed foils. The result has one `Cycle`, whose increments
/// are those of the path: 0 is the assembly at the centre of the bearing, displacement and direct force count from
/// there towards the journal, and both tangents are known at each. Under load control the journal is free in the plane.
/// @param sink  takes what is recorded as the path goes on; the result then has the last increments alone. Without one
///              all are kept.
/// @throws Error (input) if the case cannot be built, has no path, or one that is too long to be kept.
CycleResult run_path(const Case& input, const ProgressCallback& progress = {}, const RecordSink& sink = {});

}  // namespace bumpfoil
