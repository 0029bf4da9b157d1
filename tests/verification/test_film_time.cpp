// docs/verification/film_time.md: time steps of second order, against eigenvalues, smaller steps, and symmetry.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/vibration/vibration_settings.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

constexpr FilmResolution coarse_film{.columns_per_pitch = 4, .rows = 4};

/// Time steps change the rate of a motion by s (s dt)^2 / 3, to leading order.
TEST(FilmTime, FreeMotionsGrowAndDecayAsTheEigenvalueSays) {
  struct Motion {
    double rpm, load;
    double part;                   ///< of the gauge pressure, as initial disturbance
    double revolutions, accuracy;  ///< until only this motion is left; of its rate
  };
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 6, .rows = 8}));
  for (const auto& [rpm, load, part, turns, accuracy] :
       {Motion{12000.0, 9.81, 1e-9, 3.0, 3e-6}, Motion{-45000.0, 200.0, 1e-2, 4.0, 1e-5}}) {
    const BearingState rest = state_under(stepper, {load, 0.0}, speed_of_rpm(rpm));
    const std::optional<HeldMotion> motion = stepper.held_motion(rest);
    ASSERT_TRUE(motion.has_value());
    for (const int steps : {100, 200, 400}) {
      SCOPED_TRACE(testing::Message() << rpm << " rpm, " << steps << " steps");
      const double dt = 2.0 * std::numbers::pi / (std::abs(rest.speed) * steps);
      const Complex s = motion->rate;
      const Complex marched = marched_rate(stepper, rest, part, turns, steps);
      EXPECT_LT(std::abs(marched - bdf2_rate(s, dt)), accuracy * std::abs(s));
      const Complex leading = s * (s * dt) * (s * dt) / 3.0;
      EXPECT_LT(std::abs(marched - s - leading), 0.2 * std::abs(leading));  // the next term is s dt times as large
    }
  }
}

/// Implicit Euler in growing steps settles in a state that is unstable.
TEST(FilmTime, AnUnstableStateIsLeftThatImplicitEulerCallsAtRest) {
  FilmStepper stepper(film_reference_bearing(coarse_film));
  const BearingState unstable = state_under(stepper, {9.81, 0.0}, speed_of_rpm(12000.0));
  const BearingState disturbed = pressed(unstable, 1e-5);
  const double start = stepper.distance(disturbed, unstable);
  BearingState settled = disturbed;
  ASSERT_EQ(settle(stepper, held_there(unstable), settled).status, Status::converged);
  EXPECT_LT(stepper.distance(settled, unstable), 1e-7);
  const BearingState later = march_on(stepper, {revolutions(held_there(unstable), 2, 100)}, disturbed);
  EXPECT_GT(stepper.distance(later, unstable), 10.0 * start);
  for (const double rpm : {-12000.0, -45000.0}) {
    SCOPED_TRACE(rpm);
    const BearingState stable = state_under(stepper, {9.81, 0.0}, speed_of_rpm(rpm));
    const BearingState after = march_on(stepper, {revolutions(held_there(stable), 2, 100)}, pressed(stable, 1e-3));
    EXPECT_LT(stepper.distance(after, stable), 0.01 * stepper.distance(pressed(stable, 1e-3), stable));
  }
}

/// Steps halved twice: differences of the final states fall by a factor of four.
TEST(FilmTime, IsOfSecondOrder) {
  FilmStepper stepper(film_reference_bearing(coarse_film));
  for (const bool loaded : {false, true}) {
    for (const double uneven : {1.0, 1.2}) {
      SCOPED_TRACE(testing::Message() << loaded << ' ' << uneven);
      const std::vector<BearingState> ends = refined_ends(stepper, loaded, uneven, {40, 80, 160});
      const double ratio = stepper.distance(ends[0], ends[1]) / stepper.distance(ends[1], ends[2]);
      EXPECT_GT(ratio, 3.5);
      EXPECT_LT(ratio, 4.5);
    }
  }
}

void expect_same(const BearingState& a, const BearingState& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.film.pressure, b.film.pressure);
  EXPECT_EQ(a.film.thickness, b.film.thickness);
  EXPECT_EQ(a.film.deflection, b.film.deflection);
  EXPECT_EQ(a.film.moment, b.film.moment);
  EXPECT_EQ(a.contacts.x, b.contacts.x);
  EXPECT_EQ(a.contacts.normal_force, b.contacts.normal_force);
  EXPECT_EQ(a.contacts.friction_force, b.contacts.friction_force);
  EXPECT_EQ(a.contacts.mode, b.contacts.mode);
  EXPECT_EQ(a.last_step.dt, b.last_step.dt);
  EXPECT_EQ(a.last_step.content, b.last_step.content);
}

TEST(FilmTime, GoesOnFromAKeptStateToTheLastBit) {
  const BearingModel bearing = film_reference_bearing(coarse_film, 0.1);
  FilmStepper stepper(bearing);
  const BearingState rest = state_under(stepper, {50.0, 0.0}, speed_of_rpm(-45000.0));
  const OperatingPoint to = OperatingPoint::loaded_by({55.0, 5.0}, rest.speed);
  const Program part{revolutions(to, 0.1, 100)};
  const BearingState kept = march_on(stepper, part, rest);
  const BearingState end = march_on(stepper, part, kept);
  EXPECT_GT(stepper.distance(end, kept), 1e-5);
  expect_same(march_on(stepper, part, kept), end);
  FilmStepper other(bearing);
  expect_same(march_on(other, part, kept), end);
}

/// The load rotates, then stays constant.
TEST(FilmTime, FrictionOpposesEverySlipAndStuckContactsDoNotCreep) {
  const BearingModel bearing = film_reference_bearing(coarse_film, 0.3);
  FilmStepper stepper(bearing);
  const BearingState rest = state_under(stepper, {50.0, 0.0}, speed_of_rpm(-45000.0));
  const OperatingPoint still = OperatingPoint::loaded_by({50.0, 0.0}, rest.speed);
  Program program;
  constexpr int steps = 40;
  OperatingPoint from = still;
  for (int i = 1; i <= steps; ++i) {
    OperatingPoint to = still;
    to.journal.x() += 20.0 * std::sin(2.0 * std::numbers::pi * i / steps);
    program.push_back(ramp(from, to, 1));
    program.back().dt = 2.0 * std::numbers::pi / (std::abs(rest.speed) * 100);
    from = to;
  }
  BearingState state = rest;
  Step step;
  int slipping = 0;
  double dissipated = 0.0;
  ASSERT_TRUE(march(stepper_of(stepper), schedule_of(program), state, step, [&](const Passage& at) {
    EXPECT_TRUE(at.step.converged());
    const ContactState& contacts = at.step.state.contacts;
    EXPECT_EQ(at.step.state.slip_origin, at.from.contacts.x);
    for_each_contact(bearing.problem, [&](const CoulombContact& contact) {
      const double slip = contact.tangential(contacts.x) - contact.tangential(at.from.contacts.x);
      const double work = -contacts.friction_force[contact.index] * slip;
      EXPECT_GE(work, -1e-20);  // J: 1e-9 N over 1e-11 m
      dissipated += work;
      if (slips(contacts.mode[static_cast<std::size_t>(contact.index)])) ++slipping;
    });
    return at.step.converged() ? Verdict::go_on : Verdict::refuse;
  }));
  EXPECT_GT(slipping, steps);
  EXPECT_GT(dissipated, 1e-9);
  const BearingState calm = march_on(stepper, {revolutions(still, 5, 100)}, state);
  const BearingState later = march_on(stepper, {revolutions(still, 1, 100)}, calm);
  for_each_contact(bearing.problem, [&](const CoulombContact& contact) {
    EXPECT_NEAR(contact.tangential(later.contacts.x), contact.tangential(calm.contacts.x), 1e-14);  // m
  });
}

TEST(FilmTime, IsTheSameTurnedAndMirrored) {
  const Eigen::Vector2d load(40.0, 15.0);
  Case input = film_reference_case(coarse_film, 0.1);
  FilmStepper here(make_film_bearing(input));
  const BearingState rest = state_under(here, load, speed_of_rpm(-45000.0));
  const auto moved = [&](FilmStepper& stepper, const Eigen::Matrix2d& map, double sense) {
    BearingState start = rest;
    start.position = map * rest.position;
    start.speed = sense * rest.speed;
    const OperatingPoint to = OperatingPoint::loaded_by(map * Eigen::Vector2d(1.2 * load), start.speed);
    return march_on(stepper, {revolutions(to, 0.3, 100)}, start);
  };
  const BearingState end = moved(here, Eigen::Matrix2d::Identity(), 1.0);
  EXPECT_GT((end.position - rest.position).norm(), 1e-7);
  const auto expect_image = [&](const Case& image, const Eigen::Matrix2d& map, double sense) {
    FilmStepper there(make_film_bearing(image));
    const BearingState other = moved(there, map, sense);
    EXPECT_LT((other.position - map * end.position).norm(), 1e-10 * here.bearing().clearance);
    EXPECT_LT((other.film.pressure - end.film.pressure).cwiseAbs().maxCoeff(), 1e-10);
  };
  const Eigen::Rotation2Dd turn(0.7);
  Case turned = input;
  turned.bearing.weld_angle += turn.angle();
  expect_image(turned, turn.toRotationMatrix(), 1.0);
  Case mirrored = input;
  mirrored.bearing.weld_angle = -input.bearing.weld_angle;
  mirrored.bearing.wrap = input.bearing.wrap == Wrap::clockwise ? Wrap::counterclockwise : Wrap::clockwise;
  expect_image(mirrored, Eigen::Vector2d(1.0, -1.0).asDiagonal(), -1.0);
}

}  // namespace
}  // namespace bumpfoil
