#pragma once

#include <Eigen/Core>
#include <vector>

namespace bumpfoil {

/// Quantity prescribed for the journal of a bearing, or the plate of a strip.
enum class Control {
  displacement,  ///< its displacement, m
  load,          ///< the applied force, N
};

/// A displacement (m) of the journal (or plate) from its initial position, or a load (N) on it.
struct Target {
  Control control{Control::displacement};
  double value{};

  bool operator==(const Target&) const = default;
};

/// A position (m) of the journal from the centre of the bearing, or a load (N), along X and Y.
struct PlaneTarget {
  Control control{Control::displacement};
  Eigen::Vector2d value{0.0, 0.0};

  bool operator==(const PlaneTarget&) const = default;
};

/// Points of a prescribed path, in order: positions (m) of the journal centre, or loads (N) on it.
struct PathPoints {
  Control control{Control::displacement};
  std::vector<Eigen::Vector2d> values;

  bool operator==(const PathPoints&) const = default;
};

/// Sense of an orbit, seen with X to the right and Y up.
enum class Sense { counterclockwise, clockwise };

}  // namespace bumpfoil
