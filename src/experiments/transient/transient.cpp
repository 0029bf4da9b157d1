#include "bumpfoil/experiments/transient/transient.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/motion/march.hpp"
#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/motion/rotor_equilibria.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "experiments/transient/step_row.hpp"

namespace bumpfoil {
namespace {

/// Rows written together, after which a run can be resumed.
constexpr std::size_t rows_at_once = 500;
/// Fraction of the highest speed below which steps have their maximum length.
constexpr double slow_part = 0.1;

class MemoryTable : public StepTable {
 public:
  explicit MemoryTable(std::size_t width) : width_(width) {}
  [[nodiscard]] std::size_t rows() const override { return numbers_.size() / width_; }
  void append(std::span<const double> rows) override { numbers_.insert(numbers_.end(), rows.begin(), rows.end()); }
  [[nodiscard]] std::vector<double> column(std::size_t column, std::size_t first, std::size_t count) const override {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = numbers_[(first + i) * width_ + column];
    return values;
  }

 private:
  std::size_t width_;
  std::vector<double> numbers_;
};

/// Unit half sine, or sine of a given frequency; zero outside its duration.
double wave_at(double time, double begin, double duration, const std::optional<double>& frequency) {
  if (time < begin || time > begin + duration) return 0.0;
  return std::sin(frequency.value_or(std::numbers::pi / duration) * (time - begin));
}

std::vector<RotorStation>::const_iterator place_named(const std::vector<RotorStation>& places,
                                                      const std::string& name) {
  return std::find_if(places.begin(), places.end(), [&](const RotorStation& place) { return place.name == name; });
}

/// @throws Error (input) with the pulses whose places the rotor does not have
void require_places(const std::vector<RotorPulse>& pulses, const std::vector<RotorStation>& places) {
  const std::vector<std::string> names = each(places, [](const RotorStation& place) { return place.name; });
  std::vector<InputError> errors;
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    if (place_named(places, pulses[i].at) != places.end()) continue;
    errors.push_back({"", 0, fmt::format("transient.pulse[{}].at", i + 1), pulses[i].at, "is no place of the rotor",
                      fmt::format("give one of these: {}", fmt::join(names, ", "))});
  }
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

/// Weight, unbalance, pulses and the inertia forces of base motion.
RotorForces all_forces(const RotorSettings& rotor_settings, const TransientSettings& settings, const Machine& machine) {
  const Rotor& rotor = machine.rotor;
  const std::vector<RotorStation> places = machine.places();
  struct Pulse {
    RotorPulse wave;
    Eigen::VectorXd force;
  };
  std::vector<Pulse> pulses;
  pulses.reserve(settings.pulses.size());
  // On half a rotor that does not tilt, half of each force.
  const double part = rotor_settings.tilts() ? 1.0 : 0.5;
  for (const RotorPulse& pulse : settings.pulses) {
    const Eigen::Vector2d force(pulse.force[0], pulse.force[1]);
    pulses.push_back({pulse, place_named(places, pulse.at)->motion.transpose() * (part * force)});
  }
  std::vector<std::pair<BaseMotion, Eigen::VectorXd>> base;
  base.reserve(settings.base.size());
  for (const BaseMotion& motion : settings.base) {
    const Eigen::Vector2d acceleration(motion.acceleration[0], motion.acceleration[1]);
    base.emplace_back(motion, -rotor.inertia_force(acceleration));
  }
  return [turning = forces_on(rotor_settings, rotor), pulses, base](const RotorInstant& now) {
    Eigen::VectorXd force = turning(now);
    for (const Pulse& pulse : pulses) {
      force += wave_at(now.time, pulse.wave.begin, pulse.wave.duration, {}) * pulse.force;
    }
    for (const auto& [motion, inertia] : base) {
      force += wave_at(now.time, motion.begin, motion.duration, motion.frequency) * inertia;
    }
    return force;
  };
}

/// From the equilibrium at the first speed, on the small unbalance orbit there.
Status begin_run(const RotorSettings& settings, MachineStepper& machine, double speed, MachineState& state) {
  const Rotor& rotor = machine.rotor();
  const RotorEquilibria equilibria(rotor, machine.bearings(), settings.gravity_vector());
  std::vector<BearingState> states;
  const Status status = equilibria.go_to(speed, states);
  if (status != Status::converged) return status;
  state = machine.at_rest(states, forces_on(settings, rotor)(RotorInstant{}));
  if (speed == 0.0 || settings.unbalances.empty()) return status;
  const auto orbit = linear_response(rotor, equilibria.carrying(states), unbalance_force(settings, rotor, speed),
                                     {0.0, std::abs(speed)}, true);
  if (orbit) add_motion(machine, *orbit, state);
  return status;
}

}  // namespace

SpeedProgram speed_program(const TransientSettings& settings) {
  std::vector<SpeedRamp> ramps;
  ramps.reserve(settings.speed.size());
  for (const SpeedPhase& phase : settings.speed) {
    const double before = ramps.empty() ? phase.to : ramps.back().to;
    ramps.push_back({.from = phase.from.value_or(before), .to = phase.to, .time = phase.time});
  }
  return SpeedProgram(std::move(ramps));
}

std::unique_ptr<StepTable> make_step_table(std::size_t width) {
  return std::make_unique<MemoryTable>(width);
}

TransientResult transient_not_begun(const Case& input) {
  const TransientSettings& settings = input.settings.get<TransientSettings>();
  require_valid(input, {"transient"});
  const SpeedProgram program = speed_program(settings);
  TransientResult result{.machine = make_machine(input, {program.highest()}, "transient"),
                         .settings = settings,
                         .layout = {},
                         .steps = {}};
  const std::vector<RotorStation> places = result.machine.places();
  require_places(settings.pulses, places);
  result.layout = {.places = places.size(), .bearings = result.machine.rotor.bearings.size()};
  result.speed = program.start();
  return result;
}

TransientResult run_transient(const Case& input, TransientResult begun, const std::shared_ptr<StepTable>& table,
                              const TransientRun& run) {
  TransientResult result = std::move(begun);
  result.steps = table;
  const RotorSettings& rotor_settings = input.settings.get<RotorSettings>();
  const TransientSettings& settings = result.settings;
  const Rotor& rotor = result.machine.rotor;
  const SpeedProgram program = speed_program(settings);
  MachineState state;
  const auto goes_on = [&] { return !run.progress || run.progress(state.time / program.duration()); };
  std::deque<FilmStepper> steppers = result.machine.make_steppers(goes_on);
  MachineStepper machine(rotor, pointers_to(steppers));
  const double longest = settings.longest_step.value_or(2.0 * std::numbers::pi / settings.steps_per_revolution /
                                                        (slow_part * program.highest()));
  const RotorForces forces = all_forces(rotor_settings, settings, result.machine);

  std::vector<double> rows;
  if (run.from) {
    state = *run.from;
  } else {
    result.status = begin_run(rotor_settings, machine, program.start(), state);
    if (result.status != Status::converged) return result;
    rows = step_row({result.machine, state, {}, 0});
  }
  const auto keep = [&](const MachineState& reached) {
    if (rows.empty()) return;
    table->append(rows);
    rows.clear();
    if (run.keep) run.keep(reached);
  };
  EnergyMeter meter(machine, forces, state);
  result.status = Status::converged;
  // The schedule of an interrupted run ends early.
  const auto next_step = [&](const MachineState& reached) -> std::optional<TimeStep> {
    const auto next = program.next_step(reached, settings.steps_per_revolution, longest);
    if (!next || goes_on()) return next;
    result.status = Status::interrupted;
    return std::nullopt;
  };
  MachineStep step;
  march(machine, next_step, forces, state, step, [&](const MachineStep& at) {
    result.status = at.report.status;
    if (result.status != Status::converged) return Verdict::refuse;
    const std::vector<double> row = step_row({result.machine, at.state, meter.step_to(at.state), at.report.iterations});
    rows.insert(rows.end(), row.begin(), row.end());
    if (rows.size() >= rows_at_once * row.size()) keep(at.state);
    return Verdict::go_on;
  });
  keep(state);
  result.time = state.time;
  result.speed = state.speed;
  return result;
}

TransientResult run_transient(const Case& input, const std::function<bool(double)>& progress) {
  TransientResult begun = transient_not_begun(input);
  const std::size_t width = begun.layout.width();
  return run_transient(input, std::move(begun), make_step_table(width), {.progress = progress});
}

}  // namespace bumpfoil
