#include <benchmark/benchmark.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "alternating.hpp"
#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/rest.hpp"

namespace bumpfoil {
namespace {

constexpr Gas air{.viscosity = 1.85e-5, .ambient_pressure = 101325.0};
constexpr double speed = 45000.0 * std::numbers::pi / 30.0;

BearingModel bearing_with_friction(double coefficient, const benchmark::State& bench) {
  Case input = reference_case();
  input.friction = {.top_bump = coefficient, .bump_sleeve = coefficient};
  return make_film_bearing(
      input, air, {.columns_per_pitch = static_cast<int>(bench.range(0)), .rows = static_cast<int>(bench.range(1))});
}

BearingModel frictionless_bearing(const benchmark::State& bench) {
  return bearing_with_friction(0.0, bench);
}

/// The journal displaced towards +X by a fraction of the clearance, started from ambient pressure.
BearingState cold_state(const BearingModel& bearing, double eccentricity, benchmark::State& bench,
                        double omega = speed) {
  BearingState state;
  FilmStepper stepper(bearing);
  const FilmReport report = start_from_ambient(stepper, {eccentricity * bearing.clearance, 0.0}, omega, state);
  if (report.status != Status::converged) bench.SkipWithError("no state");
  return state;
}

void meshes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({6, 8})->Args({6, 16})->Args({12, 16})->Unit(benchmark::kMicrosecond);
}

/// Residuals and derivatives of the film.
void linearise_film(benchmark::State& bench) {
  const BearingModel bearing = frictionless_bearing(bench);
  const BearingState state = cold_state(bearing, 0.5, bench);
  const ReynoldsEquation equation = film_equation(*bearing.film, bearing.film->pads.front(), speed);
  Matrix residual;
  FilmJacobian jacobian;
  for (auto _ : bench) {
    linearise_reynolds(equation, state.film, residual, jacobian);
    benchmark::DoNotOptimize(residual.data());
  }
}
BENCHMARK(linearise_film)->Apply(meshes);

/// The same with the top foil, and everything between the crests eliminated.
void condense_film(benchmark::State& bench) {
  const BearingModel bearing = frictionless_bearing(bench);
  const BearingState state = cold_state(bearing, 0.5, bench);
  const ReynoldsEquation equation = film_equation(*bearing.film, bearing.film->pads.front(), speed);
  FoilFilmSystem system(bearing.film->pads.front().foil);
  for (auto _ : bench) {
    if (!system.linearise(equation, state.film)) bench.SkipWithError("singular");
  }
}
BENCHMARK(condense_film)->Apply(meshes);

/// One step of a path: a twentieth of the clearance.
void step_of_a_path(const BearingModel& bearing, benchmark::State& bench) {
  const BearingState start = cold_state(bearing, 0.5, bench);
  FilmStepper stepper(bearing);
  int iterations = 0;
  for (auto _ : bench) {
    BearingState state = start;
    const FilmReport report = stepper.advance(OperatingPoint::held_at({0.55 * bearing.clearance, 0.0}, speed), state);
    if (report.status != Status::converged) bench.SkipWithError("not converged");
    iterations = report.iterations;
  }
  bench.counters["iterations"] = iterations;
}

void warm_step(benchmark::State& bench) {
  step_of_a_path(frictionless_bearing(bench), bench);
}
BENCHMARK(warm_step)->Apply(meshes);

void warm_step_with_friction(benchmark::State& bench) {
  step_of_a_path(bearing_with_friction(0.1, bench), bench);
}
BENCHMARK(warm_step_with_friction)->Apply(meshes);

/// A step in time, a hundredth of a revolution, of a journal under a rotating load: 5 N around 50 N, gas inlet at the
/// weld, after a quarter of a revolution.
void step_in_time(const BearingModel& bearing, benchmark::State& bench) {
  constexpr int steps_per_revolution = 100;
  FilmStepper stepper(bearing);
  BearingState start = cold_state(bearing, 0.6, bench, -speed);
  const auto loaded = [](int step) {
    const double angle = 2.0 * std::numbers::pi * step / steps_per_revolution;
    return OperatingPoint::loaded_by({50.0 + 5.0 * std::sin(angle), 5.0 - 5.0 * std::cos(angle)}, -speed);
  };
  const double dt = 2.0 * std::numbers::pi / (speed * steps_per_revolution);
  FilmReport report = follow(stepper, loaded(0), start);
  for (int step = 1; step <= 25; ++step) report += stepper.advance(stepper.move_to(loaded(step), dt), start);
  if (report.status != Status::converged) bench.SkipWithError("no state");
  const Move move = stepper.move_to(loaded(26), dt);
  for (auto _ : bench) {
    BearingState state = start;
    report = stepper.advance(move, state);
    if (report.status != Status::converged) bench.SkipWithError("not converged");
  }
  bench.counters["iterations"] = report.iterations;
}

void time_step(benchmark::State& bench) {
  step_in_time(frictionless_bearing(bench), bench);
}
BENCHMARK(time_step)->Apply(meshes);

void time_step_with_friction(benchmark::State& bench) {
  step_in_time(bearing_with_friction(0.1, bench), bench);
}
BENCHMARK(time_step_with_friction)->Apply(meshes);

/// The step of a path on 6 x 16 with film and foils solved alternately. The foils' response is relaxed by range(0)
/// thousandths; the step starts at range(1) hundredths of the clearance and advances by range(2) thousandths.
void film_and_foils_in_turn(benchmark::State& bench) {
  Case input = reference_case();
  input.friction = {.top_bump = 0.0, .bump_sleeve = 0.0};
  const BearingModel bearing = make_film_bearing(input, air, {.columns_per_pitch = 6, .rows = 16});
  const double begin = 1e-2 * static_cast<double>(bench.range(1));
  const double end = begin + 1e-3 * static_cast<double>(bench.range(2));
  const BearingState start = cold_state(bearing, begin, bench);
  AlternatingReport report;
  for (auto _ : bench) {
    BearingState state = start;
    report = alternate(bearing, {end * bearing.clearance, 0.0}, speed,
                       {.relaxation = 1e-3 * static_cast<double>(bench.range(0)), .most = 1000}, state);
  }
  bench.counters["iterations"] = report.iterations;
  bench.counters["change"] = report.change;
  switch (report.end) {
    case AlternatingReport::End::converged:
      return bench.SetLabel("converged");
    case AlternatingReport::End::no_room:
      return bench.SetLabel("the foil is thrown onto the journal");
    case AlternatingReport::End::no_film:
      return bench.SetLabel("no film over the foils' answer");
    case AlternatingReport::End::no_contact:
      return bench.SetLabel("no foils under the film's pressure");
    case AlternatingReport::End::spent:
      return bench.SetLabel("not at rest after 1000 iterations");
  }
}
BENCHMARK(film_and_foils_in_turn)
    ->Args({1000, 50, 0})  // already a solution: nothing to do
    ->Args({1000, 10, 1})
    ->Args({100, 10, 1})
    ->Args({10, 10, 1})
    ->Args({100, 50, 1})
    ->Args({10, 50, 1})
    ->Args({1, 50, 1})
    ->Args({10, 50, 50})
    ->Args({1, 50, 50})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

void cold_start(benchmark::State& bench) {
  const BearingModel bearing = frictionless_bearing(bench);
  for (auto _ : bench) {
    const BearingState state = cold_state(bearing, 0.5, bench);
    benchmark::DoNotOptimize(state.speed);
  }
}
BENCHMARK(cold_start)->Apply(meshes);

/// The same under a load: 50 N, from the state under 45 N.
void equilibrium_from_a_neighbour(benchmark::State& bench) {
  const BearingModel bearing = frictionless_bearing(bench);
  BearingState start = cold_state(bearing, 0.6, bench);
  FilmStepper stepper(bearing);
  const FilmReport there = follow(stepper, OperatingPoint::loaded_by({45.0, 0.0}, speed), start);
  if (there.status != Status::converged) bench.SkipWithError("no state");
  int iterations = 0;
  for (auto _ : bench) {
    BearingState state = start;
    const FilmReport report = follow(stepper, OperatingPoint::loaded_by({50.0, 0.0}, speed), state);
    if (report.status != Status::converged) bench.SkipWithError("not converged");
    iterations = report.iterations;
  }
  bench.counters["iterations"] = iterations;
}
BENCHMARK(equilibrium_from_a_neighbour)->Apply(meshes);

/// Stiffness and damping at 20 frequencies, from 0.1 to 2 times the rotation frequency.
void impedances(benchmark::State& bench) {
  const BearingModel bearing = frictionless_bearing(bench);
  const BearingState state = cold_state(bearing, 0.6, bench);
  FilmStepper stepper(bearing);
  std::vector<std::complex<double>> rates;
  for (int i = 1; i <= 20; ++i) rates.emplace_back(0.0, 0.1 * i * speed);
  for (auto _ : bench) {
    if (!stepper.impedances(state, rates)) bench.SkipWithError("singular");
  }
}
BENCHMARK(impedances)->Apply(meshes);

/// 50 speeds from 45,000 to 5,000 rpm under 50 N, excluding the start.
void coasting_down(benchmark::State& bench) {
  constexpr int speeds = 50;
  const BearingModel bearing = frictionless_bearing(bench);
  BearingState start = cold_state(bearing, 0.6, bench);
  FilmStepper stepper(bearing);
  const FilmReport there = follow(stepper, OperatingPoint::loaded_by({50.0, 0.0}, speed), start);
  if (there.status != Status::converged) bench.SkipWithError("no state");
  int iterations = 0;
  for (auto _ : bench) {
    BearingState state = start;
    iterations = 0;
    for (int i = 1; i <= speeds; ++i) {
      const OperatingPoint to = OperatingPoint::loaded_by({50.0, 0.0}, speed * (1.0 - 8.0 / 9.0 * i / speeds));
      const FilmReport report = follow(stepper, to, state);
      if (report.status != Status::converged) bench.SkipWithError("not converged");
      iterations += report.iterations;
    }
  }
  bench.counters["iterations"] = iterations;
}
BENCHMARK(coasting_down)->Apply(meshes);

/// A complete analysis without files: 60 equidistant speeds from rest to 45,000 rpm under 50 N on rough surfaces, on
/// all cores.
void run_up(benchmark::State& bench) {
  constexpr int speeds = 60;
  Case input = reference_case();
  input.top_foil.formed_radius = {FormedTo::seated};
  input.friction = {.top_bump = 0.1, .bump_sleeve = 0.1};
  input.gas = {.viscosity = air.viscosity, .ambient_pressure = air.ambient_pressure};
  input.film.columns_per_pitch = static_cast<int>(bench.range(0));
  input.film.rows = static_cast<int>(bench.range(1));
  input.asperity = AsperitySettings{.sigma = 0.3e-6, .density = 1.7e10, .radius = 10e-6, .friction = 0.2};
  input.settings.set(
      EquilibriumSettings{.loads = {{50.0, 0.0}}, .path = FilmPath::speed_ramp, .paths = ComparedPaths::one});
  for (int i = 0; i < speeds; ++i) input.settings.get<EquilibriumSettings>().speeds.push_back(speed * i / (speeds - 1));
  for (auto _ : bench) {
    if (!analyse_running_bearing(input).converged()) bench.SkipWithError("not converged");
  }
}
BENCHMARK(run_up)->Args({6, 8})->Args({6, 16})->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace bumpfoil
