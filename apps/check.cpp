#include <memory>
#include <string>
#include <vector>

#include "bumpfoil/io/case_reader.hpp"
#include "bumpfoil/io/case_writer.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace bumpfoil {
namespace {

struct CheckOptions {
  std::string case_path;
  std::vector<std::string> overrides;
};

}  // namespace

void add_check_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand("check", "Read and validate a case; print it as understood, in SI");
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  add_overrides(*command, options->overrides);
  command->footer("Example:\n  bumpfoil check case.toml\nWhat is printed is a case file itself.");
  command->callback([options, &session] {
    const Case input = read_case(options->case_path, {.overrides = options->overrides, .required_tables = {}});
    if (!session.quiet) print_output(case_to_toml(input));
  });
}

}  // namespace bumpfoil
