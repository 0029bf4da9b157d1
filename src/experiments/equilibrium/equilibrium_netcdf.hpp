#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/experiments/cycle/result_netcdf.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Contents of result.nc: everything known of every state, its film, bumps and feet, the geometry, and the provenance.
/// States that were not found are the fill value of all variables but those of what was asked for.
/// @throws Error (file) if netCDF cannot build it, which is for want of memory
std::string equilibrium_netcdf(const Case& input, const EquilibriumResult& result, RunStatus status,
                               const Provenance& provenance, std::string_view run_id);

}  // namespace bumpfoil
