#include "bumpfoil/motion/speed_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// Smaller fractions of a turn, or of a step, are round-off.
constexpr double rounded_part = 1e-7;
/// Smaller fractions of a time are round-off.
constexpr double rounded_time = 1e-13;

/// Time in which a rotor turns through an angle; infinite if it stops before.
/// @param speed         |Omega|
/// @param acceleration  d|Omega|/dt
double time_to_turn(double angle, double speed, double acceleration) {
  const double square = speed * speed + 2.0 * acceleration * angle;
  if (square < 0.0 || (speed == 0.0 && acceleration <= 0.0)) return std::numeric_limits<double>::infinity();
  return 2.0 * angle / (speed + std::sqrt(square));
}

/// Equal parts of a length, none longer than `part`.
double equal_parts(double length, double part) {
  return std::max(1.0, std::ceil(length / part - rounded_part));
}

}  // namespace

long whole_turns(double angle) {
  return static_cast<long>(std::floor(std::abs(angle) / turn + rounded_part));
}

SpeedProgram::SpeedProgram(std::vector<SpeedRamp> ramps) : ramps_(std::move(ramps)) {
  BUMPFOIL_ASSERT(!ramps_.empty());
  double end = 0.0;
  ends_.reserve(ramps_.size());
  for (const SpeedRamp& ramp : ramps_) ends_.push_back(end += ramp.time);
}

double SpeedProgram::highest() const {
  double highest = 0.0;
  for (const SpeedRamp& ramp : ramps_) highest = std::max({highest, std::abs(ramp.from), std::abs(ramp.to)});
  return highest;
}

std::size_t SpeedProgram::ramp_at(double time) const {
  const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, (1.0 + rounded_time) * time);
  return static_cast<std::size_t>(end - ends_.begin());
}

std::optional<TimeStep> SpeedProgram::next_step(const MachineState& state, int steps_per_turn, double longest) const {
  if (state.time >= (1.0 - rounded_time) * duration()) return std::nullopt;
  const std::size_t at = ramp_at(state.time);
  const SpeedRamp& ramp = ramps_[at];
  const double rate = (ramp.to - ramp.from) / ramp.time;
  const double speed = std::abs(state.speed);
  const double acceleration = ramp.from + ramp.to < 0.0 ? -rate : rate;
  const double step = turn / steps_per_turn;
  const double left_of_turn = turn * static_cast<double>(whole_turns(state.angle) + 1) - std::abs(state.angle);
  double dt = time_to_turn(left_of_turn / equal_parts(left_of_turn, step), speed, acceleration);
  if (dt > longest) {
    const double to_its_end = time_to_turn(left_of_turn, speed, acceleration);
    dt = std::isfinite(to_its_end) ? to_its_end / equal_parts(to_its_end, longest) : longest;
  }
  const double left_of_ramp = ends_[at] - state.time;
  if (dt > (1.0 - rounded_part) * left_of_ramp) return TimeStep{.dt = left_of_ramp, .speed = ramp.to};
  if (2.0 * dt > left_of_ramp) dt = 0.5 * left_of_ramp;  // avoids a sliver
  return TimeStep{.dt = dt, .speed = state.speed + rate * dt};
}

}  // namespace bumpfoil
