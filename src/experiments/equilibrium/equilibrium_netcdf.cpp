#include "experiments/equilibrium/equilibrium_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/equilibrium/state_grid.hpp"
#include "results/netcdf_provenance.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {

std::string equilibrium_netcdf(const Case& input, const EquilibriumResult& result, RunStatus status,
                               const Provenance& provenance, std::string_view run_id) {
  std::vector<std::string> messages = failure_lines(result);
  if (status == RunStatus::interrupted) messages.emplace_back("the run was interrupted by the user or the system");
  try {
    NewNetcdf file;
    add_provenance(file, {.input = input,
                          .command = command_of(result),
                          .status = status,
                          .message = fmt::format("{}", fmt::join(messages, "; ")),
                          .warnings = warning_lines(input, result),
                          .provenance = provenance,
                          .run_id = run_id});
    write_grid(file, state_grid(input, result));
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("result.nc", error, "fewer states or a coarser mesh take less");
  }
}

}  // namespace bumpfoil
