#include <cmath>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "case/case_keys.hpp"
#include "experiments/rotor_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

constexpr Range transient_time{1e-9, 1e6, "s"};
constexpr double most_turning_speed = 1e6;  // rad/s

void describe(CaseVisitor& keys, SpeedPhase& phase) {
  using enum Presence;
  using enum Dimension;
  keys.value({"from", optional, "From", "speed at its start; default: that at the end of the previous entry, or `to`",
              "24000 rpm", frequency},
             &phase.from);
  keys.value({"to", required, "To", "speed at its end; positive turns X to Y", "6000 rpm", frequency}, &phase.to);
  keys.value({"time", required, "Time", "its duration", "0.2 s", duration}, &phase.time);
}

void describe(CaseVisitor& keys, RotorPulse& pulse) {
  using enum Presence;
  using enum Dimension;
  keys.value({"force", required, "Force", "peak value, along X and Y", "[\"0 N\", \"20 N\"]", force}, &pulse.force);
  keys.value({"begin", required, "Start", "", "0.01 s", duration}, &pulse.begin);
  keys.value({"duration", required, "Duration", "of half a sine wave", "2 ms", duration}, &pulse.duration);
  keys.value({"at", defaulted, "Place", "by name: a bearing, an end, a disk or an unbalance of the rotor"}, &pulse.at);
}

void describe(CaseVisitor& keys, BaseMotion& base) {
  using enum Presence;
  using enum Dimension;
  keys.value({"acceleration", required, "Acceleration", "peak value, along X and Y", "[\"0 m/s2\", \"30 m/s2\"]",
              acceleration},
             &base.acceleration);
  keys.value({"begin", required, "Start", "", "0.01 s", duration}, &base.begin);
  keys.value({"duration", required, "Duration", "", "11 ms", duration}, &base.duration);
  keys.value(
      {"frequency", optional, "Frequency", "of a sine wave; default: half a sine wave, a shock", "50 Hz", frequency},
      &base.frequency);
}

void describe(CaseVisitor& keys, TransientSettings& transient) {
  using enum Presence;
  using enum Dimension;
  list_of_tables(keys, {"speed", required, "Speed", "one entry, or several one after the other"}, transient.speed,
                 [](CaseVisitor& inner, SpeedPhase& phase) { describe(inner, phase); });
  keys.value(
      {"steps_per_revolution", defaulted, "Steps per revolution",
       "in time: with 100 the error of an amplitude above the critical speed is 0.3 %, with 200 a quarter of it"},
      &transient.steps_per_revolution);
  keys.value({"longest_step", optional, "Longest step",
              "in time, at low speed; default: that of a tenth of the highest speed", "0.1 ms", duration},
             &transient.longest_step);
  list_of_tables(keys, {"pulse", optional, "Pulse", "a force on the rotor, half a sine wave in time"}, transient.pulses,
                 [](CaseVisitor& inner, RotorPulse& pulse) { describe(inner, pulse); });
  list_of_tables(keys, {"base", optional, "Base motion", "acceleration of the foundation of the bearings"},
                 transient.base, [](CaseVisitor& inner, BaseMotion& base) { describe(inner, base); });
  keys.value({"revolutions_per_spectrum", defaulted, "Revolutions per spectrum",
              "of the waterfall: its resolution in orders is 1 over this number"},
             &transient.revolutions_per_spectrum);
}

void describe_transient(CaseVisitor& keys, Case& input) {
  settings_table<TransientSettings>(keys,
                                    {"transient", Presence::optional, "Transient",
                                     "run-up, coast-down, impulse of the rotor in time, for the command transient"},
                                    input.settings, describe);
}

void check_speed(Checks& checks, const TransientSettings& transient) {
  const std::vector<SpeedPhase>& phases = transient.speed;
  checks.require(!phases.empty(), "transient.speed", "", "is missing",
                 "give one such as { from = \"24000 rpm\", to = \"6000 rpm\", time = \"0.2 s\" }");
  bool turns = phases.empty();
  double sense = 0.0;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const SpeedPhase& phase = phases[i];
    const std::string name = fmt::format("transient.speed[{}]", i + 1);
    checks.within(name + ".time", phase.time, transient_time);
    for (const auto& [key, speed] : {std::pair{".from", phase.from.value_or(phase.to)}, std::pair{".to", phase.to}}) {
      if (!checks.finite(name + key, speed, "rad/s")) continue;
      checks.require(std::abs(speed) <= most_turning_speed, name + key, quantity(speed, "rad/s"), "is too fast",
                     fmt::format("give {} rad/s at most", most_turning_speed));
      checks.require(speed * sense >= 0.0, name + key, quantity(speed, "rad/s"), "has another sign than those before",
                     "give speeds of one sense of rotation");
      if (sense == 0.0) sense = speed;
      turns |= speed != 0.0;
    }
    if (i == 0 || !phase.from) continue;
    checks.require(
        *phase.from == phases[i - 1].to, name + ".from", quantity(*phase.from, "rad/s"),
        fmt::format("is not the speed at which the one before ends, {}", quantity(phases[i - 1].to, "rad/s")),
        "remove it");
  }
  checks.require(turns, "transient.speed", "", "never turns the rotor", "give a speed other than zero");
}

/// Checks two components, and a time.
void check_wave(Checks& checks, const std::string& name, const char* key, const std::vector<double>& components,
                const char* unit, double begin, double duration) {
  const bool two =
      checks.require(components.size() == 2, fmt::format("{}.{}", name, key),
                     fmt::format("{} numbers", components.size()), "is not one along X and one along Y", "give two");
  for (std::size_t i = 0; two && i < 2; ++i) checks.finite(fmt::format("{}.{}", name, key), components[i], unit);
  checks.within(name + ".begin", begin, {0.0, transient_time.most, "s"});
  checks.within(name + ".duration", duration, transient_time);
}

void check_transient(Checks& checks, const Case& input, const CheckedBumpFoil& /*foil*/) {
  const TransientSettings* const transient = input.settings.find<TransientSettings>();
  if (transient == nullptr) return;
  check_speed(checks, *transient);
  checks.count("transient.steps_per_revolution", transient->steps_per_revolution, "steps per revolution", {20, 10'000});
  checks.count("transient.revolutions_per_spectrum", transient->revolutions_per_spectrum, "revolutions", {1, 1000});
  if (transient->longest_step) checks.within("transient.longest_step", *transient->longest_step, transient_time);
  for (std::size_t i = 0; i < transient->pulses.size(); ++i) {
    const RotorPulse& pulse = transient->pulses[i];
    check_wave(checks, fmt::format("transient.pulse[{}]", i + 1), "force", pulse.force, "N", pulse.begin,
               pulse.duration);
  }
  for (std::size_t i = 0; i < transient->base.size(); ++i) {
    const BaseMotion& base = transient->base[i];
    const std::string name = fmt::format("transient.base[{}]", i + 1);
    check_wave(checks, name, "acceleration", base.acceleration, "m/s2", base.begin, base.duration);
    if (base.frequency) checks.within(name + ".frequency", *base.frequency, frequency_range);
  }
  checks.require_for("transient", input.settings.find<RotorSettings>() != nullptr, "rotor", "", "this table is missing",
                     "add [rotor] with a mass such as \"2 kg\"");
  const bool rests =
      !transient->speed.empty() && transient->speed.front().from.value_or(transient->speed.front().to) == 0.0;
  checks.require_for("transient", !rests || input.asperity.has_value(), "asperity", "",
                     "this table is missing: a rotor at rest lies on its foils",
                     "add [asperity], or start at a speed at which the film carries");
}

}  // namespace

CaseTable transient_settings() {
  return {.experiment = "transient",
          .needs = "transient",
          .foils = true,
          .film = true,
          .rotor = true,
          .describe = describe_transient,
          .check = check_transient,
          .given = gives<TransientSettings>,
          .swept = true,
          .sampled_by = SolverName::newton};
}

}  // namespace bumpfoil
