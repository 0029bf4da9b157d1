#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// Description of a quantity in tables of a page: its key in summary.json, words, unit, and what result.nc calls it.
/// @param meaning  with the label that the page shows, and its long name in words, empty where there are none
nlohmann::ordered_json shown_quantity(const VariableMeaning& meaning);

/// Name of a quantity of states or vibrations in tables of a page: its label, or words for its name where it has none,
/// or one that belongs under another on the terminal, which it begins with blanks for.
std::string shown_label(std::string_view label, std::string_view name);

/// With that label.
VariableMeaning labelled(VariableMeaning meaning);

/// Fields that the page does not show; gaps follow from displacements.
bool is_left_out(std::string_view field);

/// Fields of which the page shows the largest value at every increment, wherever it is: stresses have no sign.
bool is_reduced(std::string_view field);

/// Cycles of a bearing as report_json describes them, out of memory: the same as if they had been written and read
/// back, but for attributes and the order of cycles, which is that of the case.
/// @param result  with everything recorded
nlohmann::ordered_json shown_run(const Case& input, const CycleResult& result);

}  // namespace bumpfoil
