#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Where a cycle leaves the validity range of the model, or has no result, and what to do about it: a sentence each.
///
/// - what the reader of the case chose, see Case::remarks, and what follows from the forming of top foils;
/// - bumps compressed by more than an eighth of their rise without large displacements, or by more than half;
/// - foils that the journal never touches;
/// - repeated cycles whose loops still change;
/// - a truss of one to three bumps;
/// - a foil whose bending stress exceeds the yield stress that the case gives.
std::vector<std::string> warnings_of(const Case& input, const CycleResult& result, std::size_t cycle);

/// States by how much a loop that has not settled still changes. @param loops  what they are called: "cycles"
std::string unsettled(const Cycle& cycle, std::string_view loops);

/// Those of all cycles, each behind the name of its cycle: "-X: ...".
std::vector<std::string> warning_lines(const Case& input, const CycleResult& result);

}  // namespace bumpfoil
