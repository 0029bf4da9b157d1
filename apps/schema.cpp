#include <memory>
#include <string>

#include "bumpfoil/case/case_writer.hpp"
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
  write_text(options.path, options.results ? result_schema() : case_schema(), options.force, session);
}

}  // namespace

void add_schema_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<SchemaOptions>();
  CLI::App* command = program.add_subcommand("schema", "Describe case files, as JSON Schema for editors, or results");
  command->add_flag(
      "--results", options->results,
      "Instead every variable of result.nc of every command: names, units, meanings, dimensions, as JSON");
  command->add_option("-o,--output", options->path, "File to write; default: standard output")->type_name("FILE");
  command->add_flag("--force", options->force, "Replace the file if it exists");
  command->footer("Example:\n  bumpfoil schema -o case.schema.json\n  bumpfoil schema --results -o variables.json");
  command->callback([options, &session] { run_schema(*options, session); });
}

}  // namespace bumpfoil
