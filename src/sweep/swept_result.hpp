#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep.hpp"
#include "results/result_grid.hpp"

namespace bumpfoil {

/// A part of a result that tables of sweeps show by itself: a direction, a vibration.
struct SweptPart {
  std::string name;
  std::size_t place{};  ///< among the values of the quantities with a heading
};

/// The result of a command, whichever it is, as sweeps take it.
struct SweptResult {
  RunStatus status{RunStatus::interrupted};
  ResultGrid grid;
  std::vector<SweptPart> parts;
  std::string rows;              ///< of sweep.csv, under their header
  std::string coefficients{};    ///< of coefficients.csv, likewise; of running bearings
  nlohmann::ordered_json lists;  ///< of summary.json
  std::vector<std::string> failures, warnings;
};

/// @param with_loops  whether the grid has them
SweptResult swept_result(const Case& input, const CycleResult& result, RunStatus status, bool with_loops);
SweptResult swept_result(const Case& input, const VibrationResult& result, bool with_loops);
SweptResult swept_result(const Case& input, const EquilibriumResult& result);

/// Points of all loops.
std::size_t loop_values(SweptCommand command, const Case& input);

/// That of a command that was not begun. @param for_all  it stands for all points: without the swept speed of one
SweptResult not_begun(const Sweep& sweep, Case input, bool for_all = false);

}  // namespace bumpfoil
