#include "io/vibration_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bumpfoil/io/vibration_files.hpp"
#include "io/netcdf_provenance.hpp"
#include "io/netcdf_writer.hpp"
#include "io/vibration_grid.hpp"
#include "io/vibration_quantities.hpp"

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
