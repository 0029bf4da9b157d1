#include "bumpfoil/motion/march.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// The assembled reference bearing at the start of a march.
class March : public ::testing::Test {
 protected:
  March() {
    stepper_.assemble({}, step_);
    state_ = step_.state;
  }

  [[nodiscard]] bool take(const Program& program, const Observer& observe) {
    return march(stepper_of(stepper_, largest_place(program), 0.3e-3), schedule_of(program), state_, step_, observe);
  }

  SharedBearing foils_{make_bearing_foils(case_with_given_constants())};
  FoilStepper stepper_ = make_stepper(foils_);
  Step step_;
  BearingState state_;
};

const Program pushed{{Branch::loading, Control::displacement, {}, 0.0, 60e-6, 3}};

TEST_F(March, TakesLegsOfBothKinds) {
  Program program = pushed;
  program.push_back({Branch::loading, Control::load, {}, 300.0, 400.0, 2});
  int taken = 0;
  Eigen::Vector2d before = state_.position;
  const bool all = take(program, [&](const Passage& at) {
    EXPECT_TRUE(at.step.converged()) << taken;
    EXPECT_EQ(at.from.position, before);
    before = at.step.state.position;
    if (at.leg.control == Control::displacement) {
      EXPECT_EQ(before, Eigen::Vector2d(at.target, 0.0));
    } else {
      const Eigen::Vector2d force = holding_force(*foils_, at.step.state.contacts.normal_force);
      EXPECT_LT((force - Eigen::Vector2d(at.target, 0.0)).norm(), 1e-6);
    }
    ++taken;
    EXPECT_EQ(at.ends_leg, taken == 3 || taken == 5);
    return Verdict::go_on;
  });
  EXPECT_TRUE(all);
  EXPECT_EQ(taken, 5);
  EXPECT_EQ(state_.position, before);
}

TEST_F(March, KeepsTheStateOfAnIncrementThatStopsItAndNotOfOneThatIsRefused) {
  for (const Verdict verdict : {Verdict::stop, Verdict::refuse}) {
    stepper_.assemble({}, step_);
    state_ = step_.state;
    int taken = 0;
    EXPECT_FALSE(take(pushed, [&](const Passage&) { return ++taken == 2 ? verdict : Verdict::go_on; }));
    EXPECT_EQ(taken, 2);
    EXPECT_DOUBLE_EQ(state_.position.x(), verdict == Verdict::stop ? 40e-6 : 20e-6);
  }
}

/// Under zero load the position would be undetermined: a millionth of the largest load replaces it.
TEST_F(March, ALoadOfZeroIsAMillionthOfTheLargest) {
  const Program program{{Branch::loading, Control::load, {}, 0.0, 100.0, 1},
                        {Branch::unloading, Control::load, {}, 100.0, 0.0, 1}};
  ASSERT_TRUE(take(program, [](const Passage& at) { return at.step.converged() ? Verdict::go_on : Verdict::refuse; }));
  EXPECT_NEAR(holding_force(*foils_, state_.contacts.normal_force).x(), 1e-4, 1e-8);
}

TEST(FilmMarch, RampsAndStepsInTimeAreLegsOfOneProgram) {
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 3}, 0.1);
  FilmStepper stepper(bearing);
  const double speed = speed_of_rpm(45000.0);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.5 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
  state.time = 0.0;
  const OperatingPoint begin = point_of(bearing, state, {});
  const OperatingPoint further = OperatingPoint::held_at({0.55 * bearing.clearance, 0.0}, 0.9 * speed);
  const OperatingPoint loaded = OperatingPoint::loaded_by({30.0, 0.0}, 0.9 * speed);
  constexpr double dt = 1e-5;  // s
  Program program{ramp(begin, further, 2), ramp(loaded, loaded, 5)};
  program.back().dt = dt;
  Step step;
  step.substeps = 7;  // from an earlier march
  int taken = 0;
  BearingState before = state;
  ASSERT_TRUE(march(stepper_of(stepper), schedule_of(program), state, step, [&](const Passage& at) {
    EXPECT_TRUE(at.step.converged());
    EXPECT_EQ(at.step.substeps, 0);
    EXPECT_EQ(at.from.contacts.x, before.contacts.x);
    EXPECT_EQ(at.step.state.slip_origin, at.from.contacts.x);
    EXPECT_DOUBLE_EQ(at.step.state.time - at.from.time, at.leg.dt);
    before = at.step.state;
    if (++taken == 2) {
      EXPECT_EQ(before.position, further.journal);
    }
    return Verdict::go_on;
  }));
  EXPECT_EQ(taken, 7);
  EXPECT_NEAR(state.time, 5.0 * dt, 1e-18);
  EXPECT_EQ(state.speed, 0.9 * speed);
  EXPECT_LT((film_force(*bearing.film, state.film.pressure) - loaded.journal).norm(), 1e-3);  // N, for P to 1e-6
}

/// A prescribed journal moves by at most 0.00625 C_r per iteration: longer distances need more iterations.
TEST(FilmMarch, AStepInTimeThatFailsIsTakenInParts) {
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 3}, 0.1);
  FilmBearingOptions options;
  FilmStepper patient(bearing, options);
  options.newton.max_iterations = 8;
  FilmStepper hasty(bearing, options);
  const double speed = speed_of_rpm(-45000.0);
  BearingState start;
  ASSERT_EQ(start_from_ambient(patient, {0.5 * bearing.clearance, 0.0}, speed, start).status, Status::converged);
  const auto moved = [&](FilmStepper& stepper, double way, int steps, BearingState& state) {
    const OperatingPoint to = OperatingPoint::held_at({(0.5 + way) * bearing.clearance, 0.0}, speed);
    Program program{ramp(point_of(bearing, state, {}), to, steps)};
    program.back().dt = 1e-4 / steps;
    Step step;
    const bool all = march(stepper_of(stepper), schedule_of(program), state, step,
                           [](const Passage& at) { return at.step.converged() ? Verdict::go_on : Verdict::refuse; });
    EXPECT_EQ(all, step.converged());
    return step;
  };
  BearingState parts = start;
  const int taken = moved(hasty, 0.1, 1, parts).substeps + 1;
  EXPECT_GT(taken, 1);
  // The same steps, with friction measured from the start of each.
  BearingState whole = start;
  EXPECT_EQ(moved(patient, 0.1, taken, whole).substeps, 0);
  EXPECT_LT(patient.distance(parts, whole), 1e-8);
  EXPECT_DOUBLE_EQ(parts.last_step.dt, 1e-4 / taken);
  EXPECT_NEAR(parts.time - start.time, 1e-4, 1e-12 * parts.time);

  options.newton.max_iterations = 1;
  FilmStepper hopeless(bearing, options);
  BearingState same = parts;
  EXPECT_EQ(moved(hopeless, 0.2, 1, same).substeps, 127);
  EXPECT_EQ(same.time, parts.time);
  EXPECT_EQ(same.film.pressure, parts.film.pressure);
  EXPECT_EQ(same.last_step.content, parts.last_step.content);
}

TEST(FilmMarch, ARetryGoesByTheSchedule) {
  const Leg leg = ramp(OperatingPoint::held_at({0.0, 0.0}, 0.0), OperatingPoint::held_at({1.0, 0.0}, 0.0), 2);
  int legs = 0;
  BearingState state;
  Step step;
  const auto take = [&](const Leg& of, int taken, const BearingState& from, Step& next) {
    EXPECT_EQ(from.position.x(), legs == 1 ? 0.0 : 0.5 * (taken - 1));
    next.state.position = of.point(taken).journal;
  };
  const bool all = march(
      take, [&]() -> const Leg* { return ++legs == 3 ? nullptr : &leg; }, state, step,
      [&](const Passage&) { return legs == 1 ? Verdict::retry : Verdict::go_on; });
  EXPECT_TRUE(all);
  EXPECT_EQ(state.position.x(), 1.0);
}

/// Half of a rotor on the reference bearing.
class MachineMarch : public ::testing::Test {
 protected:
  [[nodiscard]] MachineState start() const { return machine_.at_rest({rest_}, weight({})); }
  [[nodiscard]] static Eigen::VectorXd weight(const RotorInstant& /*now*/) { return Eigen::Vector2d(30.0, 0.0); }

  TimeStep step_{.dt = 1e-5, .speed = speed_of_rpm(-45000.0)};
  FilmStepper bearing_{std::make_shared<const BearingModel>(film_reference_bearing({4, 3}, 0.1))};
  MachineStepper machine_{make_point_mass(3.0), {&bearing_}};
  BearingState rest_ = state_under(bearing_, {30.0, 0.0}, step_.speed);
};

TEST_F(MachineMarch, TakesTheStepsOfItsSchedule) {
  MachineState alone = start();
  for (int i = 0; i < 3; ++i) ASSERT_EQ(machine_.advance(step_, weight, alone).status, Status::converged);
  MachineState state = start();
  MachineStep step;
  int seen = 0;
  EXPECT_TRUE(march(machine_, equal_steps(3, step_), weight, state, step, [&](const MachineStep& at) {
    EXPECT_NEAR(at.state.time, ++seen * step_.dt, 1e-18);
    return Verdict::go_on;
  }));
  EXPECT_EQ(seen, 3);
  EXPECT_EQ(state.rotor.y, alone.rotor.y);
  EXPECT_EQ(state.bearings[0].film.pressure, alone.bearings[0].film.pressure);
}

TEST_F(MachineMarch, EndsAsItsObserverSays) {
  for (const Verdict last : {Verdict::stop, Verdict::refuse}) {
    MachineState state = start();
    MachineStep step;
    EXPECT_FALSE(march(machine_, equal_steps(9, step_), weight, state, step,
                       [&](const MachineStep& at) { return at.state.time < 1.5 * step_.dt ? Verdict::go_on : last; }));
    EXPECT_NEAR(state.time, (last == Verdict::stop ? 2 : 1) * step_.dt, 1e-18);
  }
}

/// A push that throws the journal through the foils.
TEST_F(MachineMarch, ShowsAStepThatFailedAtItsStart) {
  MachineState state = start();
  const Eigen::VectorXd y = state.rotor.y;
  MachineStep step;
  const auto push = [](const RotorInstant&) -> Eigen::VectorXd { return Eigen::Vector2d(1e7, 0.0); };
  EXPECT_FALSE(march(machine_, equal_steps(2, step_), push, state, step, [&](const MachineStep& at) {
    EXPECT_TRUE(at.report.status == Status::not_converged || at.report.status == Status::touchdown);
    EXPECT_EQ(at.state.time, 0.0);
    EXPECT_EQ(at.state.rotor.y, y);
    return Verdict::refuse;
  }));
  EXPECT_EQ(state.rotor.y, y);
}

TEST_F(MachineMarch, MayTryAShorterStep) {
  MachineState state = start();
  MachineStep step;
  double dt = 4.0 * step_.dt;
  const auto halved = [&](const MachineState& reached) -> std::optional<TimeStep> {
    if (reached.time > 0.0) return std::nullopt;
    return TimeStep{.dt = dt *= 0.5, .speed = step_.speed};
  };
  EXPECT_TRUE(march(machine_, halved, weight, state, step,
                    [&](const MachineStep&) { return dt > step_.dt ? Verdict::retry : Verdict::go_on; }));
  EXPECT_EQ(state.time, step_.dt);
}

}  // namespace
}  // namespace bumpfoil
