#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/readers/vtk_export.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace bumpfoil {
namespace {

struct ExportOptions {
  std::filesystem::path results;
  std::string to;
  std::filesystem::path path;
  bool force{};
};

void run_export(const ExportOptions& options, const Session& session) {
  const std::filesystem::path folder = options.path.empty() ? options.results / options.to : options.path;
  const std::size_t states =
      write_vtk_of(options.results, folder, options.force ? Existing::replace : Existing::refuse);
  if (session.quiet) return;
  print_output(fmt::format("wrote {} states: {} and unwrapped.pvd\n", states,
                           printable((folder / "cylinder.pvd").string(), longest_path)));
}

}  // namespace

void add_export_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Write results for other programs: ParaView");
  command->add_option("DIR", options->results, "Folder of results of cycle, path, equilibrium or film")->required();
  command->add_option("--to", options->to, "Format: vtk, the files of ParaView, PyVista and meshio")
      ->check(one_of({"vtk"}))
      ->required();
  command->add_option("-o,--output", options->path, "Folder to write to; default: vtk in the folder of results")
      ->type_name("FOLDER");
  command->add_flag("--force", options->force, "Replace files that exist");
  command->footer(
      "Example:\n"
      "  bumpfoil export results --to vtk\n"
      "MATLAB and Octave read result.nc (examples/plot_results.m), spreadsheets the CSV files.");
  command->callback([options, &session] { run_export(*options, session); });
}

}  // namespace bumpfoil
