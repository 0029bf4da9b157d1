#pragma once

#include <string>
#include <string_view>

namespace bumpfoil {

/// Answers a request of the page of `bumpfoil designer`. The page runs this very code, compiled to WebAssembly; nothing
/// here opens a file.
///
/// Request and answer are JSON objects. `what` of a request says what is wanted, `text` is a case file:
///
/// * `keys`: `version` and `commit`; `keys` of the case file in its order, each with `path`, `title`, `text`, `kind`
///   (empty for a table), `presence`, and where it has them `unit` (SI), `words` and `example`; `units`, for each SI
///   unit the ones that the page offers with their sizes, from the table of units; `presets`, case files by name.
/// * `cycles`: `run`, the cycles of the case as report_json describes them. `part`, two numbers, asks
///   for the cycles of one part of the directions (from 0) of so many; all else is that of the whole case.
/// * `csv`: `csv`, what `bumpfoil cycle` writes as cycle.csv.
/// * `properties`: what `bumpfoil properties --json` writes.
/// * `vibration`: `load` (N, along X and Y), `amplitudes` (m) and `steps` in the request. `directions`, for +X and +Y
///   the `stiffness` (N/m), `loss_factor` and `dissipation` (J per loop) at each amplitude, null where unknown.
/// * `equilibrium`: `speeds` (rad/s) and `loads` (N) or `positions` (m), each along X and Y, in the request; the rest
///   is as the case says, but for limits. If it is to be quick the `mesh`: the most columns per pitch, and rows; states
///   are then those of one path. `sample`, a number, asks for that bearing of the ensemble of the case. `run`, the
///   running bearing as report_json describes it, and its `states` as summary.json has them, with all digits; where one
///   was not found, with the `reason`.
/// * `stability`: `speeds` (rad/s) in the request in place of those of the case, and if it is to be quick the `mesh`.
///   `run`, free motions of the rotor as report_json describes them. The case must have a rotor.
/// * `samples`: `first` and `count` in the request, and the samples `before` that are known. `quantities` that
///   ensembles are shown by, and `samples`: for each of those before, and of the numbers from `first` on, per
///   direction, their values; `statistics` of these, per direction, by the keys of quantities. The case must have an
///   ensemble.
/// * `statistics`: of the `values`, null where unknown, what `samples` has of a quantity.
///
/// Where the case is wrong the answer has `errors` alone, each with `line` (0 where unknown), `key`, `value`, `what`,
/// `advice`, and the whole as a `message` of one line. Numerical failures are in the results.
std::string designer_answer(std::string_view request);

}  // namespace bumpfoil
