#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "bumpfoil/core/error.hpp"
#include "commands.hpp"

namespace bumpfoil {

/// The page built in web/, which contains the solver; empty if the program was built without Node.js or Emscripten.
std::string_view designer_page();

namespace {

struct DesignerOptions {
  std::filesystem::path path{"designer.html"};
  bool force{};
};

void run_designer(const DesignerOptions& options, const Session& session) {
  if (designer_page().empty()) {
    throw Error(
        ErrorKind::file,
        {{"bumpfoil designer", 0, "", "", "this program was built without the designer",
          "`make designer` builds it in; without the Makefile: install Emscripten, Node.js and npm (Debian: emscripten "
          "nodejs npm), then configure with -DBUMPFOIL_BUILD_DESIGNER=ON and build again"}});
  }
  write_text(options.path, std::string(designer_page()), options.force, session);
}

}  // namespace

void add_designer_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<DesignerOptions>();
  CLI::App* command = program.add_subcommand("designer", "Write the designer: one interactive HTML page");
  command->add_option("-o,--output", options->path, "File to write; default designer.html")->type_name("FILE");
  command->add_flag("--force", options->force, "Replace the file if it exists");
  command->footer(
      "Example:\n"
      "  bumpfoil designer\n"
      "Open the file in a browser of 2023 or later. It needs no network and no other file, and computes the same "
      "results as the program, in the browser.");
  command->callback([options, &session] { run_designer(*options, session); });
}

}  // namespace bumpfoil
