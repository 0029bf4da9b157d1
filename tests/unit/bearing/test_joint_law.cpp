#include "bumpfoil/bearing/joint_law.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// A beam on two journals, with a third unknown that moves none of them.
TEST(JointLaw, AddsWhatAllJournalsCarry) {
  JointLaw law{.by_place = Eigen::Matrix3d::Identity()};
  law.place = Eigen::Vector3d(1.0, 2.0, 3.0);
  Eigen::Matrix2Xd left(2, 3);
  left << 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  Eigen::Matrix2Xd right(2, 3);
  right << 1.0, 4.0, 0.0, 0.0, 2.0, 0.0;
  law.journals = {{left, left.transpose(), Eigen::Vector2d(0.0, 0.0)},
                  {right, right.transpose(), Eigen::Vector2d(1.0, 0.0)}};
  const Eigen::VectorXd lacking =
      law.residual(Eigen::Vector3d(1.0, 1.0, 1.0), {Eigen::Vector2d(2.0, 3.0), Eigen::Vector2d(5.0, 7.0)});
  // (0, 1, 2) - (2, 3, 0) - (4, 4 * 4 + 2 * 7, 0)
  EXPECT_EQ(lacking, Eigen::Vector3d(-6.0, -32.0, 2.0));
  Eigen::Matrix2d K;
  K << 1.0, 2.0, 3.0, 4.0;
  Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
  expected.topLeftCorner<2, 2>() += K + right.leftCols<2>().transpose() * K * right.leftCols<2>();
  EXPECT_EQ(law.matrix({K, K}), expected);
  EXPECT_FALSE(law.holds_place());
  EXPECT_EQ(law.displacement(Eigen::Vector3d(-1.0, 1.0, 9.0)), std::hypot(3.0, 2.0));
}

TEST(JointLaw, OfOneBearingIsThatOfItsJournal) {
  const FilmScales scales = film_reference_bearing({.columns_per_pitch = 4, .rows = 3}).film->scales;
  const Eigen::Vector2d q(3e-6, -1e-6);
  const Eigen::Vector2d F(20.0, 5.0);
  for (const JournalLaw& one :
       {held_journal(Eigen::Vector2d(5e-6, 2e-6), scales), loaded_journal(Eigen::Vector2d(50.0, 0.0), scales)}) {
    const JointLaw law = law_of_one(one);
    EXPECT_EQ(law.residual(q, {F}), one.residual(q, F));
    EXPECT_EQ(law.holds_place(), one.holds_position());
    EXPECT_EQ(law.units, one.units);
    EXPECT_EQ(law.longest_step, one.longest_step);
  }
}

/// A body that only translates, under a load shared by two different bearings: each carries the same as alone with its
/// journal held there.
TEST(SolveTogether, LetsBearingsShareALoad) {
  const double speed = speed_of_rpm(-45000.0);
  const FilmResolution mesh{.columns_per_pitch = 4, .rows = 3};
  FilmStepper smooth(film_reference_bearing(mesh));
  FilmStepper rubbing(film_reference_bearing(mesh, 0.1));
  const std::vector<FilmStepper*> both{&smooth, &rubbing};
  const Eigen::Vector2d begin(10e-6, 0.0);
  std::vector<BearingState> states(2);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(start_from_ambient(*both[i], begin, speed, states[i]).status, Status::converged);
    states[i].begin_increment();
  }
  const std::vector<BearingState> held = states;

  JointMove move{.law = law_of_one(loaded_journal(Eigen::Vector2d(40.0, 0.0), smooth.film().scales)), .speed = speed};
  move.law.journals.push_back(move.law.journals.front());
  move.law.journals.back().force.setZero();
  Eigen::VectorXd y = begin;
  ASSERT_EQ(FilmStepper::solve_together(both, move, held, y, states).status, Status::converged);
  EXPECT_GT((y - begin).norm(), 1e-6);
  Eigen::Vector2d carried = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(states[i].position, Eigen::Vector2d(y));
    BearingState alone = held[i];
    ASSERT_EQ(both[i]->advance(OperatingPoint::held_at(y, speed), alone).status, Status::converged);
    // Friction has one path here, and so a state has: to the tolerance of a step.
    EXPECT_LT(both[i]->distance(alone, states[i]), 1e-8);
    carried += film_force(both[i]->film(), states[i].film.pressure);
  }
  EXPECT_LT((carried - Eigen::Vector2d(40.0, 0.0)).norm(), 1e-7);

  // A load that cannot be carried leaves all states unchanged.
  const std::vector<BearingState> before = states;
  const Eigen::VectorXd y_before = y;
  move.law.journals.front().force *= 1e6;
  EXPECT_NE(FilmStepper::solve_together(both, move, before, y, states).status, Status::converged);
  EXPECT_EQ(y, y_before);
  EXPECT_EQ(states[1].film.pressure, before[1].film.pressure);
}

}  // namespace
}  // namespace bumpfoil
