#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/result_netcdf.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// Contents of sweep.nc: netCDF-4 after the CF conventions. Swept keys are its dimensions, and
/// those of the results; every quantity is a variable, and so are the loops, where they are kept. See result_netcdf()
/// for what is absent, for threads and for why it is built in memory.
/// @throws Error (file) if netCDF cannot build it
std::string sweep_netcdf(const Sweep& sweep, const std::vector<SweepPoint>& points, const Provenance& provenance,
                         std::string_view run_id);

}  // namespace bumpfoil
