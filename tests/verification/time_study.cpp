/// Not a test: prints the tables of docs/verification/film_time.md.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

std::string in_speeds(Complex rate) {
  return fmt::format("{:.6f}{:+.6f}i", rate.real(), rate.imag());
}

void print_growth(FilmStepper& stepper, double rpm, double load, double part, double turns) {
  const BearingState rest = state_under(stepper, {load, 0.0}, speed_of_rpm(rpm));
  const std::optional<HeldMotion> motion = stepper.held_motion(rest);
  if (!motion) return;
  const double unit = std::abs(rest.speed);
  fmt::print("{} rpm, {} N: {}\n", rpm, load, in_speeds(motion->rate / unit));
  for (const int steps : {100, 200, 400}) {
    const double dt = 2.0 * std::numbers::pi / (unit * steps);
    const Complex marched = marched_rate(stepper, rest, part, turns, steps);
    const Complex expected = bdf2_rate(motion->rate, dt);
    fmt::print("| {:.0f} | {:.2f} | {} | {} | {} | {:.1e} | {:.1e} | {} |\n", rpm, load, steps,
               in_speeds(marched / unit), in_speeds(expected / unit), std::abs(marched - expected) / std::abs(expected),
               std::abs(marched - motion->rate) / std::abs(motion->rate),
               in_speeds(-std::log(1.0 - motion->rate * dt) / (dt * unit)));
  }
}

void print_order(FilmStepper& stepper) {
  for (const bool loaded : {false, true}) {
    for (const double uneven : {1.0, 1.2}) {
      const std::vector<BearingState> ends = refined_ends(stepper, loaded, uneven, {20, 40, 80, 160, 320});
      double before = 0.0;
      for (std::size_t i = 1; i < ends.size(); ++i) {
        const double difference = stepper.distance(ends[i - 1], ends[i]);
        fmt::print("| {} | {} | {} to {} | {:.2e} | {:.2f} |\n", loaded ? "changing load" : "disturbed film",
                   uneven == 1.0 ? "equal" : "2 : 3", 20 << (i - 1), 20 << i, difference, before / difference);
        before = difference;
      }
    }
  }
}

}  // namespace
}  // namespace bumpfoil

int main() {
  using namespace bumpfoil;
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 6, .rows = 8}));
  print_growth(stepper, 12000.0, 9.81, 1e-9, 2.5);
  print_growth(stepper, -45000.0, 200.0, 1e-2, 4.0);
  FilmStepper coarse(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}));
  print_order(coarse);
  return 0;
}
