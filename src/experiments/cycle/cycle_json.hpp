#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The quantities of a cycle, its warnings, and the reason if it ended early.
nlohmann::ordered_json cycle_json(const Case& input, const CycleResult& result, std::size_t cycle);

/// Entries of summary.json: `cycles`, each with the bump loads at full displacement.
nlohmann::ordered_json cycle_lists(const Case& input, const CycleResult& result);

}  // namespace bumpfoil
