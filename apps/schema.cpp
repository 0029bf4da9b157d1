#include <memory>
#include <string>

#include "bumpfoil/experiments/result_schema.hpp"
#include "commands.hpp"

namespace bumpfoil {
namespace {

struct SchemaOptions {
  std::string path;
  bool results{};
  bool force{};
};

void run_schema(const SchemaOptions& options, const Session& session) {
  write_text(options.path, result_schema(), options.force, session);
}

}  // namespace

void add_schema_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<SchemaOptions>();
  CLI::App* command = program.add_subcommand("schema", "Describe what results hold, for other programs");
  command
      ->add_flag("--results", options->results,
                 "Every variable of result.nc of every command: names, units, meanings, dimensions, as JSON")
      ->required();
  command->add_option("-o,--output", options->path, "File to write; default: standard output")->type_name("FILE");
  command->add_flag("--force", options->force, "Replace the file if it exists");
  command->footer("Example:\n  bumpfoil schema --results -o variables.json");
  command->callback([options, &session] { run_schema(*options, session); });
}

}  // namespace bumpfoil
