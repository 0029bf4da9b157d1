#pragma once

#include <string_view>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {

/// Advice to reduce memory.
inline constexpr std::string_view cycle_advice = "use fewer steps or directions";

/// The record of a run of cycles that all of its files share.
RunRecord cycle_record(const Case& input, const CycleResult& result, RunStatus status, const Provenance& provenance);

}  // namespace bumpfoil
