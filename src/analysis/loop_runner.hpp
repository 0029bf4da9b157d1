#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/analysis/path_runner.hpp"

namespace bumpfoil {

/// A straight part of a loop, in equal increments.
struct Leg {
  Branch branch{};
  double end{};  ///< displacement along the direction of the loop, m, or load along it, N
  int steps{};   ///< increments
};

/// What a loop is made of.
struct LoopPlan {
  Eigen::Vector2d normal{1.0, 0.0};
  std::vector<Leg> legs;  ///< the first ends at the turning point
  bool by_load{};         ///< legs end at loads
  double reach{};         ///< loads are not looked for beyond this displacement, m
  /// Brings the path to the start of the loop. @return what legs are counted from; absent after a failure
  std::function<std::optional<double>(PathRunner&)> begin;
  bool assembles{};  ///< the start is the assembly of the foils
};

/// Push in `steps` and back in as many.
std::vector<Leg> push_and_pull(double amplitude, int steps);

/// From the middle up in `steps`, down through the middle as far in twice as many, and back to the middle.
std::vector<Leg> swing(double amplitude, int steps);

/// One loop, increment by increment.
class LoopRunner {
 public:
  /// @param path    must outlive the runner
  /// @param cycle   direction, amplitude and steps to the turning point filled in
  LoopRunner(PathRunner& path, LoopPlan plan, Cycle cycle);

  [[nodiscard]] int due() const { return cycle_.due; }
  /// Takes the next increment. @return false if it failed: the loop ends with the increment before
  bool take_increment();
  /// The loop with the quantities that follow from its increments.
  Cycle finish();

 private:
  bool begin();
  bool advance(double value);
  [[nodiscard]] double next_step();
  void note_events(const Increment& last, const Increment& next);

  PathRunner& path_;
  LoopPlan plan_;
  Cycle cycle_;
  double origin_{};
  std::size_t leg_{};   ///< that the last increment belongs to
  int steps_of_leg_{};  ///< taken
  std::optional<TangentStiffnesses> tangents_;
};

}  // namespace bumpfoil
