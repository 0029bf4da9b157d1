#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Cycles of the first samples of an ensemble, run again so that a report can show their loops and bearings: as
/// described by report_json, with names "Sample 0", "Sample 1", ..., and their number as `sample`.
/// | Numerical failures are in the results, as in those of `bumpfoil cycle`; invalid samples are omitted.
/// @param input  the case of the ensemble   @param count  samples
/// @param most_values  total count of numbers above which increments are omitted
nlohmann::ordered_json run_shown_samples(const Case& input, std::size_t count, std::size_t most_values);

}  // namespace bumpfoil
