#include "bumpfoil/motion/program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bumpfoil {

OperatingPoint Leg::point(double step) const {
  const double fraction = step / steps;
  return {.control = control,
          .journal = line.place(target(step)),
          .speed = speed.at(fraction),
          .clearance_offset = clearance_offset.at(fraction),
          .tilt = {tilt.control, tilt_from + fraction * (tilt.value - tilt_from)}};
}

Leg ramp(const OperatingPoint& from, const OperatingPoint& to, int steps) {
  return {.control = to.control,
          .line = {.base = from.journal, .direction = to.journal - from.journal},
          .begin = 0.0,
          .end = 1.0,
          .steps = steps,
          .speed = {from.speed, to.speed},
          .clearance_offset = {from.clearance_offset, to.clearance_offset},
          .tilt_from = from.tilt.value,
          .tilt = to.tilt};
}

Leg revolutions(const OperatingPoint& at, double count, int steps_per_revolution) {
  Leg leg = ramp(at, at, static_cast<int>(std::lround(count * steps_per_revolution)));
  leg.dt = 2.0 * std::numbers::pi / (std::abs(at.speed) * steps_per_revolution);
  return leg;
}

Leg straight_leg(Control control, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int steps) {
  const Eigen::Vector2d displacement = to - from;
  const double length = displacement.norm();
  return {.branch = Branch::loading,
          .control = control,
          .line = {.base = from, .direction = length > 0.0 ? Eigen::Vector2d(displacement / length) : displacement},
          .begin = 0.0,
          .end = length,
          .steps = steps};
}

Program one_sided_cycle(Control control, const Line& line, double origin, double amplitude, int steps) {
  const double top = origin + amplitude;
  return {{Branch::loading, control, line, origin, top, steps}, {Branch::unloading, control, line, top, origin, steps}};
}

Program fully_reversed_cycle(Control control, const Line& line, double origin, double amplitude, int steps) {
  const double top = origin + amplitude;
  const double bottom = origin - amplitude;
  return {{Branch::loading, control, line, origin, top, steps},
          {Branch::unloading, control, line, top, bottom, 2 * steps},
          {Branch::loading, control, line, bottom, origin, steps}};
}

double largest_place(const Program& program) {
  double largest = 0.0;
  for (const Leg& leg : program) {
    largest = std::max({largest, leg.line.place(leg.begin).norm(), leg.line.place(leg.end).norm()});
  }
  return largest;
}

int increments_of(const Program& program) {
  int increments = 1;
  for (const Leg& leg : program) increments += leg.steps;
  return increments;
}

}  // namespace bumpfoil
