#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/experiments/cycle/result_netcdf.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Contents of result.nc of vibrations: loads, vibrations with their loops, and coefficients, with their provenance. As
/// result_netcdf(), it is not thread-safe. @throws Error (file) if netCDF cannot build it
std::string vibration_netcdf(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                             RunStatus status, const Provenance& provenance, std::string_view run_id);

}  // namespace bumpfoil
