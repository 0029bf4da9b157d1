#include <cmath>

#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "case/case_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

constexpr double most_rotor_speed = 1e6;  // rad/s

void describe(CaseVisitor& keys, RotorSettings& rotor) {
  using enum Presence;
  using enum Dimension;
  keys.value({"mass", required, "Mass", "of the rotor, on two equal bearings", "2 kg", mass}, &rotor.mass);
  keys.value({"transverse_inertia", optional, "Transverse inertia", "about a diameter through the centre of mass",
              "9e-3 kg m2", moment_of_inertia},
             &rotor.transverse_inertia);
  keys.value({"polar_inertia", optional, "Polar inertia", "about the axis", "1.1e-3 kg m2", moment_of_inertia},
             &rotor.polar_inertia);
  keys.value({"bearings", optional, "Bearings", "places along the axis, from the centre of mass",
              "[\"-50 mm\", \"60 mm\"]", length},
             &rotor.bearings);
  keys.value({"gravity", defaulted, "Gravity", "along X and Y", "[\"0 m/s2\", \"-9.81 m/s2\"]", acceleration},
             &rotor.gravity);
}

void describe(CaseVisitor& keys, StabilitySettings& stability) {
  using enum Presence;
  using enum Dimension;
  keys.value({"speeds", required, "Speeds", "of the rotor, one after the other; positive turns X to Y",
              "[\"10000 rpm\", \"12000 rpm\", \"14000 rpm\"]", frequency},
             &stability.speeds);
}

void describe_stability(CaseVisitor& keys, Case& input) {
  using enum Presence;
  settings_table<RotorSettings>(keys, {"rotor", optional, "Rotor", "that the bearings carry"}, input.settings,
                                describe);
  settings_table<StabilitySettings>(
      keys, {"stability", optional, "Stability", "free motions of rotor, film and foils, for the command stability"},
      input.settings, describe);
}

void judge_stability(Judge& judge, const Case& input, const JudgedBumpFoil& /*foil*/) {
  const StabilitySettings* const stability = input.settings.find<StabilitySettings>();
  const RotorSettings* const rotor = input.settings.find<RotorSettings>();
  if (stability == nullptr) return;
  judge.require(rotor != nullptr, "rotor.mass", "", "is missing: the rotor that the bearings carry",
                "give a table [rotor] with a mass such as \"2 kg\"");
  judge.require(!stability->speeds.empty(), "stability.speeds", "", "no speed specified",
                "give a list such as [\"10000 rpm\", \"14000 rpm\"]");
  for (std::size_t i = 0; i < stability->speeds.size(); ++i) {
    const double speed = stability->speeds[i];
    const std::string entry = fmt::format("stability.speeds[{}]", i + 1);
    if (!judge.finite(entry, speed, "rad/s")) continue;
    judge.require(speed != 0.0 && std::abs(speed) <= most_rotor_speed, entry, quantity(speed, "rad/s"),
                  "is not a speed at which a film carries", "give a speed other than zero, 1e6 rad/s at most");
    judge.require(speed * stability->speeds.front() > 0.0, entry, quantity(speed, "rad/s"),
                  "has another sign than the first", "give speeds of one sense of rotation");
  }
  if (rotor == nullptr) return;
  judge.require(rotor->mass > 0.0, "rotor.mass", quantity(rotor->mass, "kg"), "must be positive", "give a mass");
  judge.require(rotor->gravity.size() == 2 && std::hypot(rotor->gravity[0], rotor->gravity[1]) > 0.0, "rotor.gravity",
                "", "is not an acceleration along X and Y", "give two, such as [\"0 m/s2\", \"-9.81 m/s2\"]");
  if (!rotor->tilts()) return;
  judge.require(rotor->bearings.size() == 2 && rotor->bearings[0] != rotor->bearings[1], "rotor.bearings", "",
                "are not two different places", "give two, such as [\"-50 mm\", \"60 mm\"]");
  judge.require(rotor->transverse_inertia.value_or(0.0) > 0.0, "rotor.transverse_inertia", "",
                "is missing: a rotor with places of bearings can tilt",
                "give a moment of inertia such as \"9e-3 kg m2\"");
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
