#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/backward_difference.hpp"
#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/motion/rotor_equilibria.hpp"

/// The common alternative to a second-order march with film and foils: its computing time, and its prediction of the
/// whirl of examples/rotor.toml (6 x 8; onset near 13,100 rpm) after a kick.
namespace bumpfoil {
namespace {

constexpr int steps_per_turn = 100;
constexpr int turns_of_march = 60;

/// The example in equilibrium at a speed in rpm.
struct Example {
  explicit Example(double rpm)
      : speed(rpm * std::numbers::pi / 30.0),
        input(read_case("examples/rotor.toml")),
        settings(input.settings.get<RotorSettings>()),
        machine(make_machine(input, {speed}, "stability")),
        steppers(machine.make_steppers()) {
    settings.unbalances.clear();
    const RotorEquilibria equilibria(machine.rotor, pointers_to(steppers), settings.gravity_vector());
    status = equilibria.go_to(speed, states);
  }

  double speed;
  Case input;
  RotorSettings settings;
  Machine machine;
  std::deque<FilmStepper> steppers;
  std::vector<BearingState> states;
  Status status{};
};

/// Half the peak-to-peak displacement of the journal along X and Y in the first turns after the kick, and in the last.
struct Decay {
  void see(int step, const Eigen::Vector2d& place) {
    const int turn_number = step / steps_per_turn;
    if (turn_number == 2) early.extend(place);
    if (turn_number == turns_of_march - 1) late.extend(place);
  }
  void report(benchmark::State& bench) const {
    bench.counters["first_um"] = early.half() * 1e6;
    bench.counters["last_um"] = late.half() * 1e6;
    bench.counters["steps"] = steps_per_turn * turns_of_march;
  }
  struct Box {
    Eigen::Vector2d low{Eigen::Vector2d::Constant(1e9)}, high{Eigen::Vector2d::Constant(-1e9)};
    void extend(const Eigen::Vector2d& place) {
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
    [[nodiscard]] double half() const { return 0.5 * (high - low).maxCoeff(); }
  } early, late;
};

/// Force on the rotor of the case: its weight, and a kick of half a turn.
Eigen::Vector2d kick(double angle) {
  return std::abs(angle) < std::numbers::pi ? Eigen::Vector2d(2.0 * std::sin(std::abs(angle)), 0.0)
                                            : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

void march(benchmark::State& bench, TimeScheme scheme) {
  Example example(static_cast<double>(bench.range(0)));
  if (example.status != Status::converged) bench.SkipWithError("no equilibrium");
  const Rotor& rotor = example.machine.rotor;
  const RotorForces weight = forces_on(example.settings, rotor);
  const RotorForces forces = [&](const RotorInstant& now) -> Eigen::VectorXd {
    return weight(now) + rotor.bearings.front().motion.transpose() * kick(now.angle);
  };
  const double dt = 2.0 * std::numbers::pi / std::abs(example.speed) / steps_per_turn;
  Decay decay;
  for (auto _ : bench) {
    MachineStepper machine(rotor, pointers_to(example.steppers));
    MachineState state = machine.at_rest(example.states, weight(RotorInstant{}));
    decay = {};
    for (int step = 0; step < steps_per_turn * turns_of_march; ++step) {
      const MachineReport report = machine.advance({.dt = dt, .speed = example.speed, .scheme = scheme}, forces, state);
      if (report.status != Status::converged) {
        bench.SkipWithError("a step failed");
        break;
      }
      decay.see(step, state.bearings.front().position);
    }
  }
  decay.report(bench);
}

/// Eight coefficients at the rotation frequency with full stick, instead of film and foils.
void march_by_coefficients(benchmark::State& bench) {
  Example example(static_cast<double>(bench.range(0)));
  if (example.status != Status::converged) bench.SkipWithError("no equilibrium");
  const double omega = std::abs(example.speed);
  const auto impedances = example.steppers.front().impedances(example.states.front(), {{0.0, omega}}, true);
  if (!impedances) {
    bench.SkipWithError("no coefficients");
    return;
  }
  const Eigen::Matrix2d K = impedances->front().real();
  const Eigen::Matrix2d C = impedances->front().imag() / omega;
  const double dt = 2.0 * std::numbers::pi / omega / steps_per_turn;
  const double mass = example.machine.rotor.total_mass();
  Decay decay;
  for (auto _ : bench) {
    decay = {};
    std::array<Eigen::Vector2d, 2> y{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
    std::array<Eigen::Vector2d, 2> v = y;
    for (int step = 0; step < steps_per_turn * turns_of_march; ++step) {
      const BackwardDifference rate = step == 0 ? implicit_euler(dt) : bdf2(dt, dt);
      const Eigen::Vector2d y_reference = rate.now * y[0] + rate.before * y[1];
      const Eigen::Vector2d v_reference = rate.now * v[0] + rate.before * v[1];
      const Eigen::Matrix2d by_rate = mass / rate.span * Eigen::Matrix2d::Identity() + C;
      const Eigen::Vector2d known =
          kick(omega * dt * (step + 1)) + (mass * v_reference + by_rate * y_reference) / rate.span;
      y[1] = y[0];
      v[1] = v[0];
      y[0] = (by_rate / rate.span + K).inverse() * known;
      v[0] = (y[0] - y_reference) / rate.span;
      decay.see(step, y[0]);
    }
  }
  decay.report(bench);
}

void speeds(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(12000)->Arg(13300)->Arg(16000)->Unit(benchmark::kMillisecond)->Iterations(1);
}
BENCHMARK_CAPTURE(march, bdf2, TimeScheme::bdf2)->Apply(speeds);
BENCHMARK_CAPTURE(march, implicit_euler, TimeScheme::implicit_euler)->Apply(speeds);
BENCHMARK(march_by_coefficients)->Apply(speeds);

}  // namespace
}  // namespace bumpfoil
