#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// "+X", "37.5 deg". @param direction  rad
std::string direction_name(double direction);

/// The name of a cycle in a result: "-X", "37.5 deg" or, of a strip, "cycle 2".
std::string cycle_name(const CycleResult& result, std::size_t cycle);

/// Where and why a cycle ended before its time.
struct Failure {
  std::optional<int> increment;  ///< that failed; absent where the run was interrupted between two
  double displacement{};         ///< where that was to lead, m
  std::string reason;            ///< completes "increment 37: ..."
};

/// Absent if the cycle converged.
std::optional<Failure> failure_of(const Case& input, const CycleResult& result, std::size_t cycle);

/// How a run of cycles ended.
RunStatus status_of(const CycleResult& result);

/// A line for each cycle with an increment that failed: "-X, increment 37 of 200, 29.4 um: " and the reason.
std::vector<std::string> failure_lines(const Case& input, const CycleResult& result);

}  // namespace bumpfoil
