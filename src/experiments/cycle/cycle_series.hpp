#pragma once

#include <optional>

#include "experiments/cycle/cycle_recorder.hpp"

namespace bumpfoil {

/// Where the cycles of a bearing or a strip go.
struct CycleCourse {
  double direction{};  ///< rad
  Target amplitude;
  std::optional<PlaneTarget> preload;  ///< that they go about
  bool swings{};
  int steps{};
  double reach{};  ///< loads are not looked for beyond this displacement from the origin, m
};

/// How foils come to where cycles begin: from the unstressed foils by the assembly, in one step, and on to the preload.
struct Approach {
  Excitation centre{};                   ///< of the assembly
  std::optional<PlaneTarget> preload{};  ///< none: the assembly is all
  int steps{};                           ///< equal increments from one to the other
  double reach{};                        ///< loads are not looked for beyond this displacement from the origin, m
};

/// Takes foils there. Work and dissipation count from there; slip, too.
/// @param step  receives how the place was reached, or what failed on the way
/// @return what the assembly dissipated, J
double approach(FoilStepper& stepper, const Approach& way, Step& step);

/// Takes foils through one cycle after the other, all of one course, with the friction of the last. The first begins
/// with the assembly in one step from the unstressed foils and the way to the preload, `steps` increments which are not
/// recorded; the others where the last ended. Work and dissipation count from the start of each.
class CycleSeries {
 public:
  /// @param stepper, step  outlive the series; `step` is where the foils are
  /// @param centre         excitation of the assembly
  CycleSeries(FoilStepper& stepper, const CycleCourse& course, Excitation centre, Step& step)
      : stepper_(stepper), course_(course), centre_(std::move(centre)), step_(step) {}

  /// The first cycle begins where the foils are, which is at the preload.
  CycleSeries(FoilStepper& stepper, const CycleCourse& course, Step& step)
      : stepper_(stepper), course_(course), step_(step) {}

  /// The next cycle. Must not be called after one that failed.
  Cycle next(Recording recording, const ProgressCallback& progress, std::vector<Clearance> clearances = {});

  /// Cycles until the loop has settled or one fails, at most `most`. @return the last, with the costs of all
  Cycle until_settled(int most, Recording recording, const ProgressCallback& progress,
                      const std::vector<Clearance>& clearances = {});

 private:
  [[nodiscard]] Program program() const;

  FoilStepper& stepper_;
  CycleCourse course_;
  std::optional<Excitation> centre_{};  ///< none: the foils are assembled
  Step& step_;
  Program program_{};
};

}  // namespace bumpfoil
