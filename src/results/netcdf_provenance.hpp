#pragma once

#include <netcdf>
#include <string_view>

#include "bumpfoil/core/error.hpp"
#include "results/netcdf_writer.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {

/// Adds the attributes that all files of results have.
void add_provenance(NewNetcdf& file, const RunRecord& run, std::string_view run_id);

/// The Error of a file that netCDF could not build, which is for want of memory. @param advice  what takes less
Error unbuilt(std::string_view name, const netCDF::exceptions::NcException& error, std::string_view advice);

}  // namespace bumpfoil
