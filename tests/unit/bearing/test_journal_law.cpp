#include "bumpfoil/bearing/journal_law.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

TEST(JournalLaw, IsAPositionOrALoad) {
  const FilmScales scales = film_reference_bearing({.columns_per_pitch = 4, .rows = 3}).film->scales;
  const Eigen::Vector2d q(3e-6, -1e-6);
  const Eigen::Vector2d F(20.0, 5.0);
  const Eigen::Vector2d target(5e-6, 2e-6);
  const JournalLaw held = held_journal(target, scales);
  EXPECT_EQ(held.residual(q, F), target - q);
  EXPECT_TRUE(held.holds_position());
  const Eigen::Vector2d load(50.0, 0.0);
  const JournalLaw loaded = loaded_journal(load, scales);
  EXPECT_EQ(loaded.residual(q, F), load - F);
  EXPECT_FALSE(loaded.holds_position());
  Eigen::Matrix2d K;
  K << 2.0, 1.0, -1.0, 3.0;
  EXPECT_EQ(held.matrix(K), Eigen::Matrix2d::Identity());
  EXPECT_EQ(loaded.matrix(K), K);
}

TEST(JournalLaw, MayHoldThePlaceInTheMidPlaneAndTheTiltInTwoWays) {
  const FilmScales scales = film_reference_bearing({.columns_per_pitch = 4, .rows = 3}).film->scales;
  const Eigen::Vector2d load(50.0, -3.0);
  const Eigen::Vector2d tilt(2e-6, 1e-6);
  const JournalLaw law = with_tilt(loaded_journal(load, scales), held_journal(tilt, scales));
  const Eigen::Vector4d q(3e-6, -1e-6, 4e-6, 5e-6);
  const Eigen::Vector4d F(20.0, 5.0, 7.0, 9.0);
  const Eigen::Vector4d lacking(30.0, -8.0, -2e-6, -4e-6);
  EXPECT_LT((law.residual(q, F) - lacking).norm(), 1e-14);
  EXPECT_FALSE(law.holds_position());
  EXPECT_TRUE(with_tilt(held_journal(load, scales), held_journal(tilt, scales)).holds_position());
  const Eigen::Matrix4d K = Eigen::Matrix4d::Random();
  Eigen::Matrix4d expected;
  expected << K.topRows(2), Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Identity();
  EXPECT_EQ(law.matrix(K), expected);
  EXPECT_EQ(law.units[0], scales.force());
  EXPECT_EQ(law.units[3], held_journal(tilt, scales).units[0]);
}

/// A journal held by springs with their rest position at q*: the film carries F* + k (q* - q).
TEST(JournalLaw, MayBeThatOfASpring) {
  const auto bearing =
      std::make_shared<const BearingModel>(film_reference_bearing({.columns_per_pitch = 4, .rows = 3}));
  const double speed = speed_of_rpm(45000.0);
  FilmStepper stepper(bearing, {.newton = {.step_tolerance = 1e-10}});
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.5 * bearing->clearance, 0.0}, speed, state).status, Status::converged);
  JournalLaw spring = loaded_journal(Eigen::Vector2d(10.0, 2.0), bearing->film->scales);
  spring.by_position = 2e6 * Eigen::Matrix2d::Identity();  // N/m, about the stiffness of the bearing
  spring.position = state.position;
  ASSERT_EQ(stepper.advance(Move{spring, speed}, state).status, Status::converged);
  const Eigen::Vector2d carried = film_force(*bearing->film, state.film.pressure);
  EXPECT_GT((state.position - spring.position).norm(), 0.01e-6);  // it moved
  // Tolerance of a step, 1e-10 c, times the stiffness of both.
  EXPECT_LT((spring.force + 2e6 * (spring.position - state.position) - carried).norm(), 1e-7);
}

}  // namespace
}  // namespace bumpfoil
