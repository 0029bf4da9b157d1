#include "bumpfoil/pages/report.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/ensemble_checkpoint.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace bumpfoil {

/// The page built in web/; empty if the program was built without Node.js.
std::string_view report_page();

namespace {

struct ReportOptions {
  std::vector<std::filesystem::path> folders;
  std::vector<std::string> measured;
  std::string columns;
  std::filesystem::path path;
  bool force{};
  bool unchecked{};
};

/// A file given as FILE or FILE:DIRECTION.
MeasuredFile measured_file(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::error_code code;
  if (colon == std::string::npos || std::filesystem::exists(text, code)) return {text};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

/// The page must not overwrite its own inputs, under any name.
void check_output(const std::filesystem::path& path, const ReportOptions& options,
                  const std::vector<MeasuredFile>& measured) {
  std::error_code code;
  for (const MeasuredFile& file : measured) {
    if (!std::filesystem::equivalent(path, file.path, code)) continue;
    throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is the file of measured loops that this report reads",
                                   "give the page another name, such as report.html"}});
  }
  for (const std::filesystem::path& folder : options.folders) {
    std::vector<std::string> names = result_names();
    names.insert(names.end(), {checkpoint_name, "case.toml"});
    std::erase(names, "report.html");
    for (const std::string& name : names) {
      if (!std::filesystem::equivalent(path, folder / name, code)) continue;
      throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is one of the results that this report reads",
                                     "give the page another name, such as report.html"}});
    }
  }
}

void run_report(const ReportOptions& options, const Session& session) {
  if (report_page().empty()) {
    throw Error(ErrorKind::file, {{"bumpfoil report", 0, "", "", "this program was built without the report page",
                                   "install Node.js and npm (Debian: nodejs npm), then configure and build again"}});
  }
  const std::filesystem::path path = options.path.empty() ? options.folders.front() / "report.html" : options.path;
  std::vector<MeasuredFile> measured;
  for (const std::string& file : options.measured) measured.push_back(measured_file(file));
  check_output(path, options, measured);
  const auto warn = [&session](const std::string& warning) {
    if (!session.quiet) print_message("warning: " + warning);
  };
  write_text(
      path,
      fill_report(
          report_page(),
          report_json(options.folders,
                      {.checked = !options.unchecked, .warn = warn, .measured = measured, .columns = options.columns})),
      options.force, session);
}

}  // namespace

void add_report_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand("report", "Write a report of runs: one HTML page");
  command->add_option("DIR", options->folders, "Result folders; several are compared in the same charts")->required();
  CLI::Option* measured =
      command
          ->add_option("--measured", options->measured,
                       "CSV file of measured loops to compare with the computed ones, with columns displacement_um, "
                       "force_N (or \"Load (kN)\" and the like); for several directions also a column direction, or "
                       "FILE:+X. Of several cycles the last is used")
          ->type_name("FILE")
          ->allow_extra_args(false);
  command
      ->add_option(
          "--columns", options->columns,
          "Column names in measured files, with a unit if the file has none; also direction=, for a strip cycle=")
      ->type_name("displacement=NAME,force=NAME")
      ->needs(measured);
  command->add_option("-o,--output", options->path, "File to write; default report.html in the first folder")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "Replace the file if it exists");
  command->add_flag("--unchecked", options->unchecked, "Also read damaged results: skip the checksums");
  command->footer(
      "Examples:\n"
      "  bumpfoil report results\n"
      "  bumpfoil report truss frame -o comparison.html\n"
      "  bumpfoil report results --measured loop.csv\n"
      "  bumpfoil report results --measured rig.csv:+X --columns displacement=\"s [mm]\",force=\"Channel 3 [N]\"\n"
      "The page is self-contained and needs no network: open it in a browser, print it, mail it.");
  command->callback([options, &session] { run_report(*options, session); });
}

}  // namespace bumpfoil
