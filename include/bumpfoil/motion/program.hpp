#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

/// Where increments are counted from and which way they go: place(s) = base + s direction, a position or a load.
struct Line {
  Eigen::Vector2d base{0.0, 0.0};
  Eigen::Vector2d direction{1.0, 0.0};  ///< unit vector; of a ramp the whole way

  [[nodiscard]] Eigen::Vector2d place(double s) const { return base + s * direction; }
};

/// From one value to another, in proportion to the way along a leg.
struct Ramp {
  double from{};
  double to{};

  [[nodiscard]] double at(double fraction) const { return from + fraction * (to - from); }
};

/// A straight part of a program, in equal increments.
struct Leg {
  Branch branch{Branch::loading};
  Control control{Control::displacement};  ///< places are positions or loads
  Line line{};
  double begin{};  ///< s on the line, m or N: where the leg before ends
  double end{};
  int steps{};
  Ramp speed{};             ///< Omega of a bearing that runs, rad/s
  Ramp clearance_offset{};  ///< of a bearing that runs, m
  double dt{};              ///< time that each increment takes, s; 0: quasi-static
  Eigen::Vector2d tilt_from{0.0, 0.0};
  JournalTilt tilt{};  ///< at the end of the leg

  /// s where increment 0..steps leads; parts of increments lie between.
  [[nodiscard]] double target(double step) const { return (begin * (steps - step) + end * step) / steps; }
  /// The same of a bearing that runs.
  [[nodiscard]] OperatingPoint point(double step) const;
};

/// From one operating point to another in equal steps.
Leg ramp(const OperatingPoint& from, const OperatingPoint& to, int steps);

/// Stays at an operating point for some revolutions, in equal steps of time.
Leg revolutions(const OperatingPoint& at, double count, int steps_per_revolution);

/// What is done to foils, leg after leg.
using Program = std::vector<Leg>;

/// From one place to another in equal steps.
Leg straight_leg(Control control, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int steps);

/// From `origin` to `origin + amplitude` in `steps` and back in as many.
Program one_sided_cycle(Control control, const Line& line, double origin, double amplitude, int steps);

/// From `origin` up by `amplitude` in `steps`, down through `origin` as far in twice as many, and back.
Program fully_reversed_cycle(Control control, const Line& line, double origin, double amplitude, int steps);

/// Increments of a program, the one that it starts from included.
int increments_of(const Program& program);

/// The largest distance of a leg's end from zero, m or N.
double largest_place(const Program& program);

}  // namespace bumpfoil
