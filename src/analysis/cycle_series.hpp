#pragma once

#include <optional>

#include "analysis/cycle_recorder.hpp"

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

/// Takes foils through one cycle after the other, all of one course, with the friction of the last. The first begins
/// with the assembly in one step from the unstressed foils and the way to the preload, `steps` increments which are not
/// recorded; the others where the last ended. Work and dissipation count from the start of each.
class CycleSeries {
 public:
  /// @param stepper, step  outlive the series; `step` is where the foils are
  /// @param centre         excitation of the assembly
  CycleSeries(FoilStepper& stepper, const CycleCourse& course, Excitation centre, Step& step)
      : stepper_(stepper), course_(course), centre_(std::move(centre)), step_(step) {}

  /// The next cycle. Must not be called after one that failed.
  Cycle next(Recording recording, const ProgressCallback& progress, std::vector<Clearance> clearances = {});

 private:
  double assemble_and_approach();
  void start_anew();
  [[nodiscard]] Program program() const;

  FoilStepper& stepper_;
  CycleCourse course_;
  Excitation centre_;
  Step& step_;
  Program program_{};
};

}  // namespace bumpfoil
