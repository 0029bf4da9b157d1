#include "bumpfoil/motion/machine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/rotor/unbalance.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

/// A rotor that can tilt, on two bearings with friction under 30 N each, with an unbalance away from the middle.
class Machine : public ::testing::Test {
 protected:
  [[nodiscard]] MachineState at_rest() const {
    return stepper_.at_rest({rest_, rest_}, Eigen::Vector4d(2.0 * load_.x(), 0.0, 0.0, 0.0));
  }
  [[nodiscard]] Eigen::VectorXd forces(const RotorInstant& now) const {
    const Rotor& rotor = stepper_.rotor();
    return rotor.rigid.leftCols<2>() * (2.0 * load_) + unbalance_force(rotor.stations.front(),
                                                                       {.amount = 4e-6, .phase = 0.3}, now.angle,
                                                                       now.speed, now.acceleration);
  }
  [[nodiscard]] MachineReport advance(const TimeStep& step, MachineState& state) {
    return stepper_.advance(
        step, [this](const RotorInstant& now) { return forces(now); }, state);
  }

  double speed_ = speed_of_rpm(-45000.0);
  double dt_ = 2.0 * std::numbers::pi / (100.0 * std::abs(speed_));
  Eigen::Vector2d load_{30.0, 0.0};
  SharedBearing bearing_ = std::make_shared<const BearingModel>(film_reference_bearing({4, 3}, 0.1));
  FilmStepper left_{bearing_}, right_{bearing_};
  MachineStepper stepper_{make_rigid_rotor({.mass = 2.0,
                                            .transverse_inertia = 5e-3,
                                            .polar_inertia = 1e-3,
                                            .bearings = {-0.06, 0.06},
                                            .planes = {0.03}}),
                          {&left_, &right_}};
  BearingState rest_ = state_under(left_, load_, speed_);
};

TEST_F(Machine, RestsInEquilibrium) {
  MachineState state = at_rest();
  EXPECT_LT((state.rotor.y - Eigen::Vector4d(rest_.position.x(), rest_.position.y(), 0.0, 0.0)).norm(), 1e-18);
  const MachineState begin = state;
  for (int i = 0; i < 3; ++i) {
    const MachineReport report = stepper_.advance(
        {.dt = dt_, .speed = speed_},
        [&](const RotorInstant&) { return Eigen::VectorXd(stepper_.rotor().rigid.leftCols<2>() * (2.0 * load_)); },
        state);
    ASSERT_EQ(report.status, Status::converged);
    EXPECT_EQ(report.parts, 1);
  }
  // The states settled to at least 1e-6 of P and U; a time step moves a mass only slightly.
  EXPECT_LT((state.rotor.y - begin.rotor.y).norm(), 1e-13);
}

/// M dv/dt + Omega G v = f - sum B^T F with the rates of parabolas through the last three levels.
TEST_F(Machine, ObeysItsEquations) {
  MachineState state = at_rest();
  const double lengths[] = {dt_, dt_, 1.4 * dt_, 0.6 * dt_, dt_};
  double before_dt = 0.0;
  for (const double dt : lengths) {
    const MachineState from = state;
    const double speed = from.speed * 1.001;
    ASSERT_EQ(advance({.dt = dt, .speed = speed}, state).status, Status::converged);
    const auto rate = [&](const Eigen::VectorXd& now, const Eigen::VectorXd& last,
                          const Eigen::VectorXd& before) -> Eigen::VectorXd {
      if (before_dt == 0.0) return (now - last) / dt;
      const double w = dt / before_dt;
      return ((1.0 + 2.0 * w) * now - (1.0 + w) * (1.0 + w) * last + w * w * before) / ((1.0 + w) * dt);
    };
    EXPECT_LT((rate(state.rotor.y, from.rotor.y, from.rotor_before.y) - state.rotor.v).norm(),
              1e-9 * state.rotor.v.norm());
    const RotorInstant end{.time = from.time + dt,
                           .angle = from.angle + 0.5 * (from.speed + speed) * dt,
                           .speed = speed,
                           .acceleration = (speed - from.speed) / dt};
    EXPECT_EQ(state.time, end.time);
    EXPECT_EQ(state.angle, end.angle);
    Eigen::VectorXd balance = forces(end) - speed * stepper_.rotor().gyroscopic * state.rotor.v -
                              stepper_.rotor().mass * rate(state.rotor.v, from.rotor.v, from.rotor_before.v);
    for (std::size_t i = 0; i < 2; ++i) {
      const Eigen::MatrixXd& B = stepper_.rotor().bearings[i].motion;
      const BearingState& bearing = state.bearings[i];
      EXPECT_LT((B * state.rotor.y - bearing.position).norm(), 1e-18);
      EXPECT_EQ(bearing.speed, speed);
      EXPECT_NEAR(bearing.time - rest_.time, end.time, 1e-15);
      EXPECT_EQ(bearing.last_step.dt, dt);
      EXPECT_EQ(bearing.slip_origin, from.bearings[i].contacts.x);  // each time step is a friction increment
      balance -= B.transpose() * journal_force(*bearing_->film, bearing.film, speed);
    }
    // Round-off of y in M y / dt^2, about 1e-20 m times 1e10 N/m.
    EXPECT_LT(balance.norm(), 1e-8);
    before_dt = dt;
  }
  EXPECT_GT((state.rotor.y - at_rest().rotor.y).norm(), 1e-9);
}

TEST_F(Machine, GoesOnFromACopyToTheLastBit) {
  MachineState state = at_rest();
  MachineState copy;
  for (int i = 0; i < 8; ++i) {
    if (i == 4) copy = state;
    ASSERT_EQ(advance({.dt = dt_, .speed = speed_}, state).status, Status::converged);
  }
  FilmStepper left(bearing_);
  FilmStepper right(bearing_);
  MachineStepper other(stepper_.rotor(), {&left, &right});
  for (int i = 4; i < 8; ++i) {
    ASSERT_EQ(other
                  .advance(
                      {.dt = dt_, .speed = speed_}, [this](const RotorInstant& now) { return forces(now); }, copy)
                  .status,
              Status::converged);
  }
  EXPECT_EQ(copy.rotor.y, state.rotor.y);
  EXPECT_EQ(copy.rotor.v, state.rotor.v);
  EXPECT_EQ(copy.time, state.time);
  EXPECT_EQ(copy.angle, state.angle);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(copy.bearings[i].film.pressure, state.bearings[i].film.pressure);
    EXPECT_EQ(copy.bearings[i].contacts.x, state.bearings[i].contacts.x);
    EXPECT_EQ(copy.bearings[i].contacts.friction_force, state.bearings[i].contacts.friction_force);
    EXPECT_EQ(copy.bearings[i].contacts.mode, state.bearings[i].contacts.mode);
    EXPECT_EQ(copy.bearings[i].last_step.content, state.bearings[i].last_step.content);
  }
}

/// An impact that no film can carry.
TEST_F(Machine, EndsWithItsLastState) {
  MachineState state = at_rest();
  ASSERT_EQ(advance({.dt = dt_, .speed = speed_}, state).status, Status::converged);
  const MachineState before = state;
  const MachineReport report = stepper_.advance(
      {.dt = dt_, .speed = speed_},
      [](const RotorInstant&) -> Eigen::VectorXd { return Eigen::Vector4d(1e7, 0.0, 0.0, 0.0); }, state);
  EXPECT_TRUE(report.status == Status::not_converged || report.status == Status::touchdown);
  EXPECT_EQ(state.time, before.time);
  EXPECT_EQ(state.rotor.y, before.rotor.y);
  EXPECT_EQ(state.bearings[1].film.pressure, before.bearings[1].film.pressure);
  // The march can continue from there.
  EXPECT_EQ(advance({.dt = dt_, .speed = speed_}, state).status, Status::converged);
}

/// A disc hanging from the journal by a spring: the spring extends by weight over stiffness.
TEST(MachineAtRest, BendsAShaft) {
  const double speed = speed_of_rpm(-45000.0);
  const Eigen::Vector2d load(20.0, -5.0);
  FilmStepper bearing(film_reference_bearing({4, 3}));
  const BearingState rest = state_under(bearing, load, speed);
  constexpr double k = 3e6;  // N/m
  Rotor rotor = make_point_mass(1.0);
  rotor.mass = Eigen::Vector4d(0.5, 0.5, 0.5, 0.5).asDiagonal();
  rotor.gyroscopic = rotor.damping = Eigen::Matrix4d::Zero();
  rotor.stiffness = Eigen::Matrix4d::Zero();
  for (const int axis : {0, 1}) {
    rotor.stiffness(axis, axis) = rotor.stiffness(axis + 2, axis + 2) = k;
    rotor.stiffness(axis, axis + 2) = rotor.stiffness(axis + 2, axis) = -k;
  }
  rotor.bearings.front().motion = Eigen::Matrix<double, 2, 4>::Identity();
  rotor.rigid = Eigen::Matrix<double, 4, 2>::Identity();
  rotor.rigid.bottomRows(2).setIdentity();
  const MachineStepper stepper(rotor, {&bearing});
  const Eigen::Vector4d weight(0.0, 0.0, load.x(), load.y());
  const MachineState state = stepper.at_rest({rest}, weight);
  EXPECT_LT((state.rotor.y.head(2) - rest.position).norm(), 1e-14);
  EXPECT_LT((state.rotor.y.tail(2) - rest.position - load / k).norm(), 1e-12);  // the load is met to 1e-6 of it
}

}  // namespace
}  // namespace bumpfoil
