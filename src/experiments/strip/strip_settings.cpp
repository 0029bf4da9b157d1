#include <cstdint>
#include <string>
#include <utility>

#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "case/case_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, StripSettings& strip) {
  using enum Presence;
  using enum Dimension;
  keys.value({"bumps", defaulted, "Bumps", "the first bumps of the foil", "10", {}, "bump_foil.bumps"}, &strip.bumps);
  keys.choice({"weld", defaulted, "Weld", "both foils clamped before bump 1; \"none\": free at both ends"}, strip.weld);
  keys.value({"top_foil", defaulted, "Top foil", "false: the plate presses on the crests"}, &strip.top_foil);
  keys.one_of({"displacement", required, "Displacement", "displacement of the plate", "20 um", length},
              {"load", required, "Load", "load on the plate, instead", "100 N", force}, strip.amplitude);
  keys.either({"preload", optional, "Preload",
               "cycles run about it, by the amplitude each way; also a displacement, \"10 um\"", "\"50 N\""},
              strip.amplitude.control, strip.preload);
  keys.value({"cycles", defaulted, "Cycles", "one after the other, with friction carried over"}, &strip.cycles);
  keys.value({"steps", defaulted, "Increments per branch",
              "equal increments from the start of a cycle to full displacement or load"},
             &strip.steps);
}

void describe_strip(CaseVisitor& keys, Case& input) {
  using enum Presence;
  settings_table<StripSettings>(
      keys, {"strip", optional, "Strip", "a flat strip of the foils between two plates, for the command strip"},
      input.settings, describe);
}

/// Checks a target of the plate, named by its key.
void check_target(Checks& checks, const std::string& key, const Target& target, double rise) {
  if (target.control == Control::load) {
    checks.within(key, target.value, load_range);
  } else if (checks.within(key, target.value, length_range) && rise > 0.0) {
    checks.require_for("strip", target.value < rise, key, quantity(target.value, "m"), "would press the bumps flat",
                       fmt::format("give less than their rise, {:.6g} m", rise));
  }
}

void check_strip(Checks& checks, const Case& input, const CheckedBumpFoil& foil) {
  const StripSettings* const held = input.settings.find<StripSettings>();
  if (held == nullptr) return;
  const StripSettings& strip = *held;
  checks.require_for("strip", input.pads.empty(), "strip", "", "lies flat, cut from one foil, and the bearing has pads",
                     "remove [[pad]], and give the foils of one in [bump_foil] and [top_foil]");
  checks.require_for("strip", !input.has_own_strips(), "bump_foil.strip", "",
                     "differs over the width, but foils between plates are uniform", "remove [[bump_foil.strip]]");
  const double rise = foil.rise;
  checks.require_history("strip", input.bump_foil.model != BumpFoilModel::former,
                         "does not support strips: without gaps and history its loops would have no area");
  const bool by_load = strip.amplitude.control == Control::load;
  const std::string amplitude_key = by_load ? "strip.load" : "strip.displacement";
  const bool bumps = checks.count("strip.bumps", strip.bumps, "bumps", {1, most_bumps});
  if (bumps) check_strip_of(checks, input.bump_foil, strip.bumps);
  check_target(checks, amplitude_key, strip.amplitude, rise);
  if (strip.preload) {
    check_target(checks, "strip.preload", *strip.preload, rise);
    if (rise > 0.0 && !by_load && strip.preload->control == Control::displacement) {
      checks.require_for("strip", strip.preload->value + strip.amplitude.value < rise, "strip.displacement",
                         quantity(strip.amplitude.value, "m"), "would press the bumps flat on top of strip.preload",
                         fmt::format("give both less than their rise together, {:.6g} m", rise));
    }
    if (by_load) {
      checks.require(strip.preload->control == Control::load, "strip.preload", quantity(strip.preload->value, "m"),
                     "is a displacement where the strip is controlled by load",
                     "give a load, or a displacement in place of strip.load");
      checks.require(strip.preload->control != Control::load || strip.preload->value >= strip.amplitude.value,
                     "strip.preload", quantity(strip.preload->value, "N"),
                     fmt::format("is less than the amplitude, {:.6g} N: a plate cannot pull", strip.amplitude.value),
                     "give a larger preload or a smaller load");
    }
  }
  const bool cycles = checks.count("strip.cycles", strip.cycles, "cycles");
  const bool steps = checks.count("strip.steps", strip.steps, "increments");
  if (!bumps || !cycles || !steps) return;
  const std::int64_t branches = strip.preload ? 4 : 2;
  check_memory(checks, "strip", "strip.steps", strip.steps, branches * strip.steps * strip.cycles, strip.bumps);
}

}  // namespace

CaseTable strip_settings() {
  return {.experiment = "strip",
          .needs = "strip",
          .flat = true,
          .describe = describe_strip,
          .check = check_strip,
          .given = gives<StripSettings>,
          .swept = true};
}

}  // namespace bumpfoil
