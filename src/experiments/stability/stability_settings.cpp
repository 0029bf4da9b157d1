#include <cmath>

#include "bumpfoil/experiments/stability/stability.hpp"
#include "case/case_keys.hpp"
#include "experiments/rotor_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

constexpr double most_rotor_speed = 1e6;  // rad/s
constexpr std::size_t most_rotor_speeds = 10'000;

void describe(CaseVisitor& keys, StabilitySettings& stability) {
  keys.value({"speeds", Presence::required, "Speeds", "of the rotor, one after the other; positive turns X to Y",
              "{ from = \"10000 rpm\", to = \"60000 rpm\", points = 26 }", Dimension::frequency},
             &stability.speeds);
}

void describe_stability(CaseVisitor& keys, Case& input) {
  describe_rotor(keys, input);
  settings_table<StabilitySettings>(keys,
                                    {"stability", Presence::optional, "Stability",
                                     "free motions of rotor, film and foils over speed, for the command stability"},
                                    input.settings, describe);
}

void judge_stability(Judge& judge, const Case& input, const JudgedBumpFoil& /*foil*/) {
  judge_rotor(judge, input);
  const StabilitySettings* const stability = input.settings.find<StabilitySettings>();
  if (stability == nullptr) return;
  judge.require_for("stability", input.settings.find<RotorSettings>() != nullptr, "rotor", "", "this table is missing",
                    "add [rotor] with a mass such as \"2 kg\"");
  judge.require(!stability->speeds.empty(), "stability.speeds", "[]", "is empty",
                "give a list such as [\"10000 rpm\", \"14000 rpm\"]");
  judge.require(stability->speeds.size() <= most_rotor_speeds, "stability.speeds",
                fmt::format("{} speeds", stability->speeds.size()), "are too many",
                fmt::format("give {} at most", most_rotor_speeds));
  for (std::size_t i = 0; i < stability->speeds.size(); ++i) {
    const double speed = stability->speeds[i];
    const std::string entry = fmt::format("stability.speeds[{}]", i + 1);
    if (!judge.finite(entry, speed, "rad/s")) continue;
    const bool turns = judge.require(speed != 0.0 && std::abs(speed) <= most_rotor_speed, entry,
                                     quantity(speed, "rad/s"), "is not a speed at which a film carries",
                                     fmt::format("give a speed other than zero, {} rad/s at most", most_rotor_speed));
    if (!turns) continue;
    judge.require(speed * stability->speeds.front() >= 0.0, entry, quantity(speed, "rad/s"),
                  "has another sign than the first", "give speeds of one sense of rotation");
  }
}

}  // namespace

CaseTable stability_settings() {
  return {.experiment = "stability",
          .needs = "stability",
          .describe = describe_stability,
          .check = judge_stability,
          .given = [](const Case& input) { return input.settings.find<StabilitySettings>() != nullptr; }};
}

}  // namespace bumpfoil
