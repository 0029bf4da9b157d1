#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/analysis/equilibrium.hpp"
#include "bumpfoil/io/result_netcdf.hpp"

namespace bumpfoil {

/// Contents of result.nc: everything known of every state, its film, bumps and feet, the geometry, and the provenance.
/// States that were not found are the fill value of all variables but those of what was asked for.
/// @throws Error (file) if netCDF cannot build it, which is for want of memory
std::string equilibrium_netcdf(const Case& input, const EquilibriumResult& result, RunStatus status,
                               const Provenance& provenance, std::string_view run_id);

}  // namespace bumpfoil
