#include "bumpfoil/experiments/stability/stability.hpp"
#include "case/case_keys.hpp"
#include "experiments/rotor_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, StabilitySettings& stability) {
  keys.value({"speeds", Presence::required, "Speeds", "of the rotor, one after the other; positive turns X to Y",
              "[\"10000 rpm\", \"12000 rpm\", \"14000 rpm\"]", Dimension::frequency},
             &stability.speeds);
}

void describe_stability(CaseVisitor& keys, Case& input) {
  describe_rotor(keys, input);
  settings_table<StabilitySettings>(keys,
                                    {"stability", Presence::optional, "Stability",
                                     "free motions of rotor, film and foils over speed, for the command stability"},
                                    input.settings, describe);
}

void check_stability(Checks& checks, const Case& input, const CheckedBumpFoil& /*foil*/) {
  check_rotor(checks, input);
  const StabilitySettings* const stability = input.settings.find<StabilitySettings>();
  if (stability == nullptr) return;
  checks.require_for("stability", input.settings.find<RotorSettings>() != nullptr, "rotor", "", "this table is missing",
                     "add [rotor] with a mass such as \"2 kg\"");
  check_rotor_speeds(checks, "stability.speeds", stability->speeds);
}

}  // namespace

CaseTable stability_settings() {
  return {.experiment = "stability",
          .needs = "stability",
          .foils = true,
          .film = true,
          .rotor = true,
          .describe = describe_stability,
          .check = check_stability,
          .given = gives<StabilitySettings>,
          .swept = true,
          .sampled_by = SolverName::newton};
}

}  // namespace bumpfoil
