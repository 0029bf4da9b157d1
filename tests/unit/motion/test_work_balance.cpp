#include "bumpfoil/motion/work_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bumpfoil {
namespace {

/// A rotor on springs and dampers alone that an even force pushes along, then its balance.
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
  // What is stored is that of the state, and the even force does its work on the way.
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
  EXPECT_NEAR(coarse / fine, 4.0, 1.0);  // of second order
}

TEST(WorkBalance, DampsNothingWithoutDampers) {
  const WorkBalance sum = balance_of(0.0, 400);
  EXPECT_EQ(sum.damping, 0.0);
  EXPECT_EQ(sum.friction + sum.entrained + sum.dissipated + sum.supplied + sum.rubbing, 0.0);
  EXPECT_LT(std::abs(sum.defect()), 1e-3 * std::abs(sum.forces));
}

}  // namespace
}  // namespace bumpfoil
