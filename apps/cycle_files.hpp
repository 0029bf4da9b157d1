#pragma once

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/io/result_folder.hpp"
#include "bumpfoil/io/result_netcdf.hpp"
#include "bumpfoil/io/summary.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Stages summary.json, cycle.csv or strip.csv, and result.nc of a run. @throws Error (file)
void stage_cycle_files(ResultFolder& folder, const Case& input, const CycleResult& result, RunStatus status,
                       const Provenance& provenance);

}  // namespace bumpfoil
