#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "results/netcdf_image.hpp"

namespace bumpfoil {

/// Number of first samples of an ensemble that reports run again, to show their loops and bearings.
inline constexpr std::size_t most_shown_samples = 20;

/// Contents of a report from ensemble.nc: `directions` and `states` (numbers; one of them is empty), `sample_count` and
/// `distributions`, see report_json. One variable is in memory at a time.
/// @throws Error (file) naming file and variable if it is damaged
nlohmann::ordered_json read_distributions(const NetcdfImage& file);

}  // namespace bumpfoil
