#include "experiments/vibration/vibration_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bumpfoil/experiments/vibration/vibration_files.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/vibration/vibration_grid.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "results/netcdf_provenance.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {

std::string vibration_netcdf(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                             RunStatus status, const Provenance& provenance, std::string_view run_id) {
  try {
    NewNetcdf file;
    std::vector<std::string> messages = failure_lines(*input.vibration, result);
    if (status == RunStatus::interrupted) messages.emplace_back("the run was interrupted by the user or the system");
    add_provenance(file, {.input = input,
                          .command = "vibration",
                          .status = status,
                          .message = fmt::format("{}", fmt::join(messages, "; ")),
                          .warnings = warning_lines(input, result),
                          .provenance = provenance,
                          .run_id = run_id});
    write_grid(file, vibration_grid(input, result, all));
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("result.nc", error, "fewer steps, loads or amplitudes take less");
  }
}

}  // namespace bumpfoil
