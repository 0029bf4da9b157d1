#pragma once

#include <string_view>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {

/// Advice to reduce memory.
inline constexpr std::string_view cycle_advice = "use fewer steps or directions";

/// A run of cycles, as all of its files tell of it.
RunRecord cycle_record(const Case& input, const CycleResult& result, RunStatus status, const Provenance& provenance);

}  // namespace bumpfoil
