#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/analysis/path_runner.hpp"

namespace bumpfoil {

/// Where an increment of a loop leads, counted from the origin of the loop.
struct LoopStep {
  Branch branch{};
  double value{};  ///< displacement along the direction of the loop, m, or load along it, N
};

/// What a loop is made of.
struct LoopPlan {
  Eigen::Vector2d normal{1.0, 0.0};
  std::vector<LoopStep> steps;  ///< the first is the start
  bool by_load{};               ///< steps are loads
  double reach{};               ///< loads are not looked for beyond this displacement, m
  /// Brings the path to the start of the loop. @return what its steps are counted from; absent after a failure
  std::function<std::optional<double>(PathRunner&)> begin;
  bool assembles{};  ///< the start is the assembly of the foils
};

/// Push to `steps` and back in equal steps.
std::vector<LoopStep> push_and_pull(double amplitude, int steps);

/// From the middle up in `steps`, down through the middle as far in twice as many, and back to the middle.
std::vector<LoopStep> swing(double amplitude, int steps);

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
  bool advance(std::size_t index);
  void note_events(const Increment& last, const Increment& next);

  PathRunner& path_;
  LoopPlan plan_;
  Cycle cycle_;
  double origin_{};
  std::optional<TangentStiffnesses> tangents_;
};

}  // namespace bumpfoil
