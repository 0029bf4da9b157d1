#include "bumpfoil/motion/work_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

/// The work balance of a rotor on springs and dampers only, pushed by a constant force.
WorkBalance balance_of(double damping, int steps) {
  Rotor rotor = make_point_mass(2.0);
  rotor.stiffness = 50.0 * Eigen::Matrix2d::Identity();
  rotor.damping = damping * Eigen::Matrix2d::Identity();
  rotor.bearings.clear();
  MachineStepper stepper(rotor, {});
  const RotorForces forces = [](const RotorInstant&) -> Eigen::VectorXd { return Eigen::Vector2d(3.0, 0.0); };
  MachineState state{.speed = 1.0, .rotor = {.y = Eigen::Vector2d::Zero(), .v = Eigen::Vector2d(0.0, 0.1)}};
  EnergyMeter meter(stepper, forces, state);
  WorkBalance sum;
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(stepper.advance({.dt = 1.0 / steps, .speed = 1.0}, forces, state).status, Status::converged);
    sum += meter.step_to(state);
  }
  // The stored energy is that of the final state, and the constant force does its work on the way.
  const double stored = state.rotor.v.squaredNorm() + 25.0 * state.rotor.y.squaredNorm() - 0.01;
  EXPECT_NEAR(sum.stored, stored, 1e-14);
  EXPECT_NEAR(sum.forces, 3.0 * state.rotor.y.x(), 1e-14);
  return sum;
}

TEST(WorkBalance, IsMetByShorterSteps) {
  const double coarse = std::abs(balance_of(4.0, 200).defect());
  const double fine = std::abs(balance_of(4.0, 400).defect());
  EXPECT_GT(balance_of(4.0, 200).damping, 0.01);
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(coarse / fine, 4.0, 1.0);  // second order
}

TEST(WorkBalance, DampsNothingWithoutDampers) {
  const WorkBalance sum = balance_of(0.0, 400);
  EXPECT_EQ(sum.damping, 0.0);
  EXPECT_EQ(sum.friction + sum.entrained + sum.dissipated + sum.supplied + sum.rubbing, 0.0);
  EXPECT_LT(std::abs(sum.defect()), 1e-3 * std::abs(sum.forces));
}

/// A journal pushed back and forth on its foils: their friction loss is part of the balance.
TEST(WorkBalance, HasTheFrictionOfTheFoils) {
  const auto bearing = std::make_shared<const BearingModel>(film_reference_bearing({4, 3}, 0.1));
  FilmStepper film(bearing);
  const double speed = speed_of_rpm(-45000.0);
  const Eigen::Vector2d load(30.0, 0.0);
  const BearingState rest = state_under(film, load, speed);
  MachineStepper stepper(make_point_mass(0.5), {&film});
  MachineState state = stepper.at_rest({rest}, load);
  const RotorForces forces = [&](const RotorInstant& now) -> Eigen::VectorXd {
    return load * (1.0 + 0.8 * std::sin(2.0 * now.angle));
  };
  EnergyMeter meter(stepper, forces, state);
  WorkBalance sum;
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const double dt = std::numbers::pi / (steps * std::abs(speed));
    ASSERT_EQ(stepper.advance({.dt = dt, .speed = speed}, forces, state).status, Status::converged);
    sum += meter.step_to(state);
  }
  EXPECT_GT(sum.friction, 5e-8);                          // J
  EXPECT_LT(std::abs(sum.defect()), 0.3 * sum.friction);  // time step error
}

}  // namespace
}  // namespace bumpfoil
