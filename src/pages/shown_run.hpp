#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// Description of a quantity in tables of a page: its key in summary.json, words, unit, and its name in result.nc.
/// @param meaning  with the label for the page, and its long name in words, empty if there are none
nlohmann::ordered_json shown_quantity(const VariableMeaning& meaning);

/// Name of a quantity of states or vibrations in tables of a page: its label, or words for its name if it has none.
std::string shown_label(std::string_view label, std::string_view name);

/// The quantity with that label.
VariableMeaning labelled(VariableMeaning meaning);

/// Inserts clearances at these forces among the quantities of cycles, after the other displacements. Cycles in
/// summaries have them by their keys, netCDF files in a list.
void add_clearances(const std::vector<double>& forces, nlohmann::ordered_json& quantities);

/// Fields that the page omits; gaps follow from displacements.
bool is_left_out(std::string_view field);

/// Fields of which the page shows the maximum over all nodes at every increment: stresses have no sign.
bool is_reduced(std::string_view field);

/// Cycles of a bearing as described by report_json, directly from memory: identical to writing and reading files,
/// except for attributes and the order of cycles, which is that of the case.
/// @param result  with everything recorded
nlohmann::ordered_json shown_run(const Case& input, const CycleResult& result);

}  // namespace bumpfoil
