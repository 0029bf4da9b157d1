#include "bumpfoil/experiments/properties/properties.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/experiments/properties/properties_report.hpp"
#include "bumpfoil/model/geometry.hpp"
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

/// Position of a pad, and the stretch of its pitches that fills its arc.
std::string place_of(const Case& input, const PlacedPad& pad, std::size_t number) {
  const Bearing& bearing = pad.alone.bearing;
  constexpr double turn = 2.0 * std::numbers::pi;
  const auto degrees = [](double angle) { return std::remainder(angle, turn) * 360.0 / turn; };
  const auto pitch = [](const BumpFoil& foil) { return foil.pitch.at(0, static_cast<std::size_t>(foil.bumps)); };
  const double stretch = pitch(pad.alone.bump_foil) / pitch(bump_foil_of(input, number));
  return fmt::format("Pad {}: weld at {:.5g} deg, {} to its free end at {:.5g} deg{}\n\n", number + 1,
                     degrees(bearing.weld_angle), bearing.wrap == Wrap::clockwise ? "clockwise" : "counterclockwise",
                     degrees(pad.end()), stretch == 1.0 ? "" : fmt::format("; pitches stretched by {:.5g}", stretch));
}

std::string text_of(const Case& input, const std::vector<PlacedPad>& pads) {
  std::string out;
  for (std::size_t k = 0; k < pads.size(); ++k) {
    if (pads.size() > 1) out += (k == 0 ? "" : "\n") + place_of(input, pads[k], k);
    out += properties_table(pads[k].alone, compute_properties(pads[k].alone));
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
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  command->add_flag("--json", options->json, "Print JSON, SI units in the keys");
  add_overrides(*command, options->overrides);
  command->footer("Example:\n  bumpfoil properties case.toml --set bump_foil.height_reference=midsurface");
  command->callback([options] {
    const Case input = read_case(options->case_path, {.overrides = options->overrides, .commands = {}});
    print_some("warning: ", case_warnings(input));
    const std::vector<PlacedPad> pads = place_pads(input);
    print_output(options->json ? json_of(pads) : text_of(input, pads));
  });
}

}  // namespace bumpfoil
