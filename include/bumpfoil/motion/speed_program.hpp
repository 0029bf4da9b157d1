#pragma once

#include <optional>
#include <vector>

#include "bumpfoil/motion/machine.hpp"

namespace bumpfoil {

/// From one speed to another in some time, evenly.
struct SpeedRamp {
  double from{};  ///< Omega, rad/s
  double to{};
  double time{};  ///< > 0, s

  bool operator==(const SpeedRamp&) const = default;
};

/// The speed of a rotor over time: ramps one after the other, each from where the one before ends, all of one sense of
/// rotation.
class SpeedProgram {
 public:
  explicit SpeedProgram(std::vector<SpeedRamp> ramps);

  [[nodiscard]] double duration() const { return ends_.back(); }  ///< s
  [[nodiscard]] double highest() const;                           ///< largest |Omega|, rad/s
  [[nodiscard]] double start() const { return ramps_.front().from; }

  /// The next step from a state; nothing at the end. `steps_per_turn` equal angles in a turn, so that turns end with a
  /// step; where a rotor is so slow that one would take longer than `longest` (s), shorter ones of equal time. Ramps
  /// end with a step too.
  [[nodiscard]] std::optional<TimeStep> next_step(const MachineState& state, int steps_per_turn, double longest) const;

 private:
  [[nodiscard]] std::size_t ramp_at(double time) const;

  std::vector<SpeedRamp> ramps_;
  std::vector<double> ends_;  ///< s
};

/// Whole turns that a rotor has turned through, a little less than one of them counted as one.
long whole_turns(double angle);

}  // namespace bumpfoil
