#pragma once

#include <optional>

#include "experiments/cycle/cycle_recorder.hpp"

namespace bumpfoil {

/// Course of the cycles of a bearing or a strip.
struct CycleCourse {
  double direction{};  ///< rad
  Target amplitude;
  std::optional<PlaneTarget> preload;  ///< mean of the cycles
  bool fully_reversed{};
  int steps{};
  double reach{};  ///< largest displacement from the origin in the search for loads, m
};

/// How foils reach the start of cycles: from the unstressed foils to the assembly in one step, then to the preload.
struct Approach {
  Excitation centre{};                   ///< of the assembly
  std::optional<PlaneTarget> preload{};  ///< none: the assembly only
  int steps{};                           ///< equal increments from assembly to preload
  double reach{};                        ///< largest displacement from the origin in the search for loads, m
};

/// Takes foils to the start of cycles. Work, dissipation and slip count from there.
/// @param step  receives the history of the start, or of the failure on the way
/// @return dissipation of the assembly, J
double approach(FoilStepper& stepper, const Approach& plan, Step& step);

/// Takes foils through successive cycles of one course, with the friction state of the last. The first starts with the
/// assembly in one step from the unstressed foils and the way to the preload, `steps` increments which are not
/// recorded; the others start at the end of the previous cycle. Work and dissipation count from the start of each.
class CycleSeries {
 public:
  /// @param stepper, step  outlive the series; `step` holds the current state
  /// @param centre         excitation of the assembly
  CycleSeries(FoilStepper& stepper, const CycleCourse& course, Excitation centre, Step& step)
      : stepper_(stepper), course_(course), centre_(std::move(centre)), step_(step) {}

  /// The first cycle starts from the current state of the foils, at the preload.
  CycleSeries(FoilStepper& stepper, const CycleCourse& course, Step& step)
      : stepper_(stepper), course_(course), step_(step) {}

  /// Runs the next cycle. Must not be called after a failed one.
  Cycle next(Recording recording, const ProgressCallback& progress, std::vector<Clearance> clearances = {});

  /// Runs cycles until the loop has settled or one fails, at most `most`. @return the last, with the cost of all
  Cycle until_settled(int most, Recording recording, const ProgressCallback& progress,
                      const std::vector<Clearance>& clearances = {});

 private:
  [[nodiscard]] Program program() const;

  FoilStepper& stepper_;
  CycleCourse course_;
  std::optional<Excitation> centre_{};  ///< none: the foils are already assembled
  Step& step_;
  Program program_{};
};

}  // namespace bumpfoil
