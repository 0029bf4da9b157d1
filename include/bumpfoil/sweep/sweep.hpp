#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/case/swept_key.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Names of the experiments that can be run at every point.
std::vector<std::string> swept_commands();

/// What is run over a grid of cases.
struct SweepRequest {
  std::string command{"cycle"};
  std::vector<std::string> over;       ///< "KEY=FROM:TO:STEP" or "KEY=[a, b]" each, see parse_swept_key()
  std::vector<std::string> overrides;  ///< of all points, see CaseRequest
  bool limits{};                       ///< of running bearings: sets equilibrium.limits
};

/// A key that is swept.
struct SweepAxis {
  SweptKey swept;              ///< key and values as they were written
  bool is_list{};              ///< of the key, which holds one value at each point
  std::string name;            ///< of its variable in sweep.nc: the key with underscores for its dots
  std::string title;           ///< of the table and the key: "Cycle: Amplitude"
  std::string unit;            ///< SI, as UDUNITS spells it; "1" where there is none
  std::vector<double> values;  ///< SI, one for each of those that were written
};

/// A grid of cases: one for every combination of the values of the keys. The last key runs fastest.
struct Sweep {
  const ExperimentInfo* experiment{};  ///< that is run at every point
  std::vector<SweepAxis> axes;
  std::vector<Case> cases;
  bool with_loops{};  ///< whether their loops are not too many to be kept
};

/// Numbers of each of displacement and force that sweeps keep of their loops at most.
inline constexpr std::size_t most_loop_values = 4'000'000;

/// Makes the grid of a sweep. Every case is that of `bumpfoil <command> --set KEY=VALUE ...`, to the last bit, and
/// every error of every one is listed, once, with the first point that has it.
/// @param text  of the case file   @param name  stands for the file in messages, see parse_case()
/// @throws Error (input) if the command is not swept, a key is swept twice, is neither a number nor the speeds of
/// [equilibrium], is set besides, takes a value twice, if the grid has more than most_sweep_points, or if a case is
/// wrong; Error (file) if a file that a case names cannot be read
Sweep parse_sweep(std::string_view text, const std::string& name, const SweepRequest& request);

/// Which value each axis has at a point.
std::vector<std::size_t> indices_of(const Sweep& sweep, std::size_t point);

/// "friction.coefficient=0.15, cycle.amplitude=60 um"
std::string point_name(const Sweep& sweep, std::size_t point);

/// The stored part of a point: the numbers and words of its result.
struct SweepPoint {
  RunStatus status{RunStatus::interrupted};   ///< as it stays where the point was not begun
  std::vector<std::string> dims{};            ///< names of the dimensions of the result
  std::vector<std::size_t> extents{};         ///< of these
  std::vector<std::string> variables{};       ///< names of its quantities and loops: not all points have the same
  std::vector<std::vector<double>> values{};  ///< of these; none where all of one are absent
  std::string rows{};                         ///< of sweep.csv, under their header
  std::vector<std::string> more{};            ///< of Sweeping::more_tables, likewise
  std::string lists{};  ///< of summary.json, as text, which takes less room than what is read of it
  std::vector<std::string> failures{};
  std::vector<std::string> warnings{};
};

/// Runs the command at a point. @throws as the command does
SweepPoint run_point(const Sweep& sweep, std::size_t point, const ProgressCallback& progress = {});

/// A point as bytes, for other processes of the same program.
std::string bytes_of(const SweepPoint& point);
SweepPoint point_of_bytes(const std::string& bytes);

/// What is kept of the result of a point.
SweepPoint sweep_point(const Sweep& sweep, const Outcome& outcome);

/// Makes results for points that were not started, flagged as such.
void complete(const Sweep& sweep, std::vector<SweepPoint>& points);

/// Interrupted if any point was, else failed if any point was, else complete.
RunStatus status_of(const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
