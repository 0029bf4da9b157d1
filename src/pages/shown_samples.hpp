#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Cycles of the first samples of an ensemble, run again for a report, which is to show their loops and bearings: as
/// report_json describes cycles, by the names "Sample 0", "Sample 1", ..., with their number as `sample`.
///
/// Numerical failures are in the results, as in those of `bumpfoil cycle`; samples whose numbers make no bearing are
/// left out.
/// @param input  the case of the ensemble   @param count  samples
/// @param most_values  numbers of all of them beyond which increments are left out
nlohmann::ordered_json run_shown_samples(const Case& input, std::size_t count, std::size_t most_values);

}  // namespace bumpfoil
