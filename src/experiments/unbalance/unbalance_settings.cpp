#include <cmath>

#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "case/case_keys.hpp"
#include "experiments/rotor_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, UnbalanceSettings& unbalance) {
  keys.value({"speeds", Presence::required, "Speeds", "of the rotor, one after the other; positive turns X to Y",
              "[\"8000 rpm\", \"12000 rpm\"]", Dimension::frequency},
             &unbalance.speeds);
  keys.value({"orbits", Presence::defaulted, "Orbits",
              "true: find periodic orbits with contacts and friction as well, by steps in time"},
             &unbalance.orbits);
  keys.value({"steps_per_revolution", Presence::defaulted, "Steps per revolution", "of the orbits"},
             &unbalance.steps_per_revolution);
}

void describe_unbalance(CaseVisitor& keys, Case& input) {
  settings_table<UnbalanceSettings>(keys,
                                    {"unbalance", Presence::optional, "Unbalance response",
                                     "of rotor, film and foils over speed, for the command unbalance"},
                                    input.settings, describe);
}

void check_unbalance(Checks& checks, const Case& input, const CheckedBumpFoil& /*foil*/) {
  const UnbalanceSettings* const unbalance = input.settings.find<UnbalanceSettings>();
  if (unbalance == nullptr) return;
  check_rotor_speeds(checks, "unbalance.speeds", unbalance->speeds);
  checks.count("unbalance.steps_per_revolution", unbalance->steps_per_revolution, "steps per revolution", {20, 10'000});
  const RotorSettings* const rotor = input.settings.find<RotorSettings>();
  checks.require_for("unbalance", rotor != nullptr, "rotor", "", "this table is missing",
                     "add [rotor] with a mass such as \"2 kg\"");
  checks.require_for("unbalance", rotor == nullptr || !rotor->unbalances.empty(), "rotor.unbalance", "",
                     "is missing: a balanced rotor does not respond",
                     "add [[rotor.unbalance]] with an amount such as \"2 g mm\"");
}

}  // namespace

CaseTable unbalance_settings() {
  return {.experiment = "unbalance",
          .needs = "unbalance",
          .foils = true,
          .film = true,
          .rotor = true,
          .describe = describe_unbalance,
          .check = check_unbalance,
          .given = gives<UnbalanceSettings>,
          .swept = true,
          .sampled_by = SolverName::newton};
}

}  // namespace bumpfoil
