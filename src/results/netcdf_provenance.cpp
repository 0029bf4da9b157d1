#include "results/netcdf_provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ctime>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"

namespace bumpfoil {

void add_provenance(NewNetcdf& file, const RunRecord& run, std::string_view run_id) {
  const std::string date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  file.add_text("Conventions", "CF-1.8");
  file.add_text("schema", "bumpfoil-result/2");
  file.add_text("title", run.input.title);
  file.add_text("source", fmt::format("bumpfoil {} ({})", version(), commit()));
  file.add_text("history", fmt::format("{}: {}", date, run.provenance.command_line));
  file.add_text("date_created", date);
  file.add_text("run_id", run_id);
  file.add_text("command_line", run.provenance.command_line);
  file.add_text("bumpfoil_command", run.command);
  file.add_text("solver", name_of(run.input.solver.chosen()));
  file.add_text("status", run.status == RunStatus::complete ? "complete" : "partial");
  file.add_text("status_message", run.message);
  file.add_text("warnings", fmt::format("{}", fmt::join(run.warnings, "\n")));
  file.add_text("case_text", run.provenance.case_text);
  file.add_text("case_understood", case_to_toml(run.input));
}

Error unbuilt(std::string_view name, const netCDF::exceptions::NcException& error, std::string_view advice) {
  // The first line says what went wrong, the second where in the library.
  const std::string_view reason = error.what();
  return {ErrorKind::file,
          {{std::string(name), 0, "", "", fmt::format("cannot be built: {}", reason.substr(0, reason.find('\n'))),
            fmt::format("possibly not enough memory: {}", advice)}}};
}

}  // namespace bumpfoil
