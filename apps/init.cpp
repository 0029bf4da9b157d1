#include <filesystem>
#include <memory>
#include <string>

#include "bumpfoil/case/case_writer.hpp"
#include "commands.hpp"

namespace bumpfoil {
namespace {

struct InitOptions {
  std::string preset{"gen1"};
  std::string path;
  bool keys{};
  bool force{};
};

void run_init(const InitOptions& options, const Session& session) {
  if (options.keys) return write_text(options.path, case_reference(), options.force, session);
  write_text(options.path, case_template(options.preset), options.force, session);
  // Editors read it next to the case; other cases there may already use it.
  const std::filesystem::path schema = std::filesystem::path(options.path).replace_filename(case_schema_name);
  if (options.path.empty() || (std::filesystem::exists(schema) && !options.force)) return;
  write_text(schema, case_schema(), options.force, session);
}

}  // namespace

void add_init_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<InitOptions>();
  CLI::App* command =
      program.add_subcommand("init", "Write a commented case file to start from, and its schema for editors");
  command->add_option("--preset", options->preset, "Bearing to start from")
      ->check(one_of(preset_names()))
      ->capture_default_str();
  command->add_option("-o,--output", options->path, "File to write; default: standard output")->type_name("FILE");
  command->add_flag("--keys", options->keys, "Write a reference of all keys instead of a case file, in Markdown");
  command->add_flag("--force", options->force, "Replace the file if it exists");
  command->footer("Example:\n  bumpfoil init -o case.toml");
  command->callback([options, &session] { run_init(*options, session); });
}

}  // namespace bumpfoil
