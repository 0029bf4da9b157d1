#include "bumpfoil/analysis/properties.hpp"

#include <memory>
#include <string>
#include <vector>

#include "bumpfoil/io/case_reader.hpp"
#include "bumpfoil/io/properties_report.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace bumpfoil {
namespace {

struct PropertiesOptions {
  std::string case_path;
  std::vector<std::string> overrides;
  bool json{};
};

}  // namespace

void add_properties_command(CLI::App& program, Session& /*session*/) {
  const auto options = std::make_shared<PropertiesOptions>();
  CLI::App* command = program.add_subcommand(
      "properties", "Print truss constants, stiffness of a single bump, softest and stiffest modes of the foils");
  command->add_option("CASE", options->case_path, "Case file")->required();
  command->add_flag("--json", options->json, "Print JSON, SI units in the keys");
  add_overrides(*command, options->overrides);
  command->footer("Example:\n  bumpfoil properties case.toml --set bump_foil.height_reference=midsurface");
  command->callback([options] {
    const Case input = read_case(options->case_path, {.overrides = options->overrides, .required_tables = {}});
    const Properties properties = compute_properties(input);
    print_output(options->json ? properties_json(input, properties) : properties_table(input, properties));
  });
}

}  // namespace bumpfoil
