#include "support/film_motions.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {

std::complex<double> bdf2_rate(std::complex<double> s, double dt) {
  const std::complex<double> z = s * dt;
  return std::log((2.0 + std::sqrt(1.0 + 2.0 * z)) / (3.0 - 2.0 * z)) / dt;
}

BearingState state_under(FilmStepper& stepper, const Eigen::Vector2d& load, double speed) {
  BearingState state;
  EXPECT_EQ(start_from_ambient(stepper, 0.1 * stepper.bearing().clearance * load.normalized(), speed, state).status,
            Status::converged);
  EXPECT_EQ(settle(stepper, OperatingPoint::loaded_by(load, speed), state).status, Status::converged);
  return state;
}

OperatingPoint held_there(const BearingState& state) {
  return OperatingPoint::held_at(state.position, state.speed);
}

BearingState pressed(const BearingState& state, double part) {
  BearingState more = state;
  more.film.pressure.array() += part * (state.film.pressure.array() - 1.0);
  return more;
}

BearingState march_on(FilmStepper& stepper, const Program& program, const BearingState& from) {
  BearingState state = from;
  Step step;
  EXPECT_TRUE(march(stepper_of(stepper), schedule_of(program), state, step, [](const Passage& at) {
    EXPECT_TRUE(at.step.converged());
    return at.step.converged() ? Verdict::go_on : Verdict::refuse;
  }));
  return state;
}

namespace {

/// From one operating point to another in n increments of time, whose lengths alternate.
Program stretch(const OperatingPoint& from, const OperatingPoint& to, double turns, int n, double uneven) {
  const Leg whole = ramp(from, to, n);
  Program program;
  double at = 0.0;
  for (int i = 0; i < n; ++i) {
    const double length = i % 2 == 0 ? 2.0 - uneven : uneven;
    program.push_back(ramp(whole.point(at), whole.point(at + length), 1));
    program.back().dt = length * turns * 2.0 * std::numbers::pi / (std::abs(from.speed) * n);
    at += length;
  }
  return program;
}

}  // namespace

std::vector<BearingState> refined_ends(FilmStepper& stepper, bool loaded, double uneven,
                                       const std::vector<int>& steps) {
  const BearingState rest = state_under(stepper, {50.0, 0.0}, speed_of_rpm(-45000.0));
  const OperatingPoint from = loaded ? OperatingPoint::loaded_by({50.0, 0.0}, rest.speed) : held_there(rest);
  const OperatingPoint to = loaded ? OperatingPoint::loaded_by({60.0, 10.0}, rest.speed) : from;
  const BearingState start = loaded ? rest : pressed(rest, 1e-3);
  std::vector<BearingState> ends;
  for (const int n : steps) ends.push_back(march_on(stepper, stretch(from, to, 0.25, n, uneven), start));
  return ends;
}

std::complex<double> marched_rate(FilmStepper& stepper, const BearingState& rest, double part, double turns,
                                  int steps_per_revolution) {
  constexpr double quarter = 0.25;
  const OperatingPoint held = held_there(rest);
  BearingState state = march_on(stepper, {revolutions(held, turns, steps_per_revolution)}, pressed(rest, part));
  Eigen::MatrixX3d changes(rest.film.pressure.size(), 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Matrix before = state.film.pressure;
    state = march_on(stepper, {revolutions(held, quarter, steps_per_revolution)}, state);
    changes.col(i) = (state.film.pressure - before).reshaped();
  }
  Eigen::MatrixX2d terms = changes.leftCols<2>();
  terms.col(1) *= 2.0;
  const Eigen::Vector2d fitted = terms.colPivHouseholderQr().solve(changes.col(2));  // -|Z|^2, Re Z
  const std::complex<double> Z(fitted[1], std::sqrt(std::max(0.0, -fitted[0] - fitted[1] * fitted[1])));
  return std::log(Z) * std::abs(rest.speed) / (2.0 * std::numbers::pi * quarter);
}

}  // namespace bumpfoil
