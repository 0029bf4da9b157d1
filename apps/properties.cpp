#include "bumpfoil/analysis/properties.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>
#include <vector>

#include "bumpfoil/io/case_reader.hpp"
#include "bumpfoil/io/properties_report.hpp"
#include "bumpfoil/model/pads.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace bumpfoil {
namespace {

struct PropertiesOptions {
  std::string case_path;
  std::vector<std::string> overrides;
  bool json{};
};

std::string text_of(const std::vector<PlacedPad>& pads) {
  std::string out;
  for (const PlacedPad& pad : pads) {
    if (pads.size() > 1) out += fmt::format("{}Pad {}\n\n", out.empty() ? "" : "\n", &pad - pads.data() + 1);
    out += properties_table(pad.alone, compute_properties(pad.alone));
  }
  return out;
}

std::string json_of(const std::vector<PlacedPad>& pads) {
  std::vector<std::string> each;
  each.reserve(pads.size());
  for (const PlacedPad& pad : pads) each.push_back(properties_json(pad.alone, compute_properties(pad.alone)));
  return pads.size() == 1 ? each.front() : fmt::format("{{\"pads\": [\n{}]}}\n", fmt::join(each, ","));
}

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
    print_output(options->json ? json_of(place_pads(input)) : text_of(place_pads(input)));
  });
}

}  // namespace bumpfoil
