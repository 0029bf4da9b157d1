#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/io/result_names.hpp"
#include "bumpfoil/io/summary.hpp"
#include "bumpfoil/io/swept_key.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// What is run over a grid of cases.
struct SweepRequest {
  Experiment experiment{Experiment::cycle};
  std::vector<std::string> over;       ///< "KEY=FROM:TO:STEP" or "KEY=[a, b]" each, see parse_swept_key()
  std::vector<std::string> overrides;  ///< of all points, see CaseRequest
};

/// A key that is swept.
struct SweepAxis {
  SweptKey swept;              ///< key and values as they were written
  std::string name;            ///< of its variable in sweep.nc: the key with underscores for its dots
  std::string title;           ///< of the table and the key: "Cycle: Amplitude"
  std::string unit;            ///< SI, as UDUNITS spells it; "1" where there is none
  std::vector<double> values;  ///< SI, one for each of those that were written
};

/// A grid of cases: one for every combination of the values of the keys. The last key runs fastest.
struct Sweep {
  Experiment experiment{Experiment::cycle};
  std::vector<SweepAxis> axes;
  std::vector<Case> cases;
};

/// Makes the grid of a sweep. Every case is that of `bumpfoil <experiment> --set KEY=VALUE ...`, to the last bit, and
/// every fault of every one is listed, once, with the first point that has it.
/// @param text  of the case file   @param name  stands for the file in messages, see parse_case()
/// @throws Error (input) if a key is swept twice, is no number, is set besides, takes a value twice, if the grid has
/// more than most_sweep_points, or if a case is wrong; Error (file) if a file that a case names cannot be read
Sweep parse_sweep(std::string_view text, const std::string& name, const SweepRequest& request);

/// Which value each axis has at a point.
std::vector<std::size_t> indices_of(const Sweep& sweep, std::size_t point);

/// "friction.coefficient=0.15, cycle.amplitude=60 um"
std::string point_name(const Sweep& sweep, std::size_t point);

/// Force over displacement of one cycle, per increment.
struct Loop {
  std::vector<double> displacement;  ///< m
  std::vector<double> force_direct;  ///< N
};

/// What is kept of a point: quantities, no fields and no events, and of the increments the last one.
struct SweepPoint {
  CycleResult result;
  RunStatus status{RunStatus::interrupted};  ///< as it stays where the point was not begun
  std::vector<Loop> loops;                   ///< one per cycle that was begun; none where they are not kept
};

/// What is kept of the result of a point, whose case this is.
SweepPoint sweep_point(CycleResult result, bool with_loops);

/// Numbers of each of displacement and force that sweeps keep of their loops at most.
inline constexpr std::size_t most_loop_values = 4'000'000;

/// Whether the loops of a sweep are not too many to be kept.
bool keeps_loops(const Sweep& sweep);

/// Interrupted if any point was, else failed if any point was, else complete.
RunStatus status_of(const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
