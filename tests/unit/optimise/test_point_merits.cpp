#include "optimise/point_merits.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

/// Maximise a film thickness, minimise a power, with a force of at most 200 N.
OptimiseResult two_aims_and_a_limit() {
  OptimiseResult problem;
  problem.aims = {{.quantity = {.name = "h_min", .unit = "m", .shown = {}}, .maximise = true},
                  {.quantity = {.name = "power", .unit = "W", .shown = {}, .largest = true}}};
  problem.limits = {{.text = "force < 200 N", .quantity = {}, .above = false, .bound = 200.0}};
  return problem;
}

OptimisePoint found(double thickness, double power, double force) {
  return {
      .values = {thickness, power}, .status = PointStatus::converged, .aims = {thickness, power}, .limits = {force}};
}

class Merits : public ::testing::Test {
 protected:
  Merits() { merits_.take_sizes(points_); }

  OptimiseResult problem_ = two_aims_and_a_limit();
  std::vector<OptimisePoint> points_{{.values = {}, .status = PointStatus::failed},
                                     found(4e-6, 10.0, 100.0),  // 1: worse film, best power
                                     found(8e-6, 40.0, 150.0),  // 2: best film
                                     found(6e-6, 20.0, 100.0),  // 3: in between
                                     found(5e-6, 25.0, 100.0),  // 4: dominated by 3
                                     found(9e-6, 5.0, 220.0),   // 5: violates the limit by a tenth
                                     found(9e-6, 5.0, 300.0)};  // 6: by a half
  PointMerits merits_{problem_};
};

TEST_F(Merits, AreInPartsOfTheSizesOfQuantities) {
  EXPECT_DOUBLE_EQ(merits_.scaled_aim(points_[2], 0), -2.0);
  EXPECT_DOUBLE_EQ(merits_.scaled_aim(points_[2], 1), 4.0);
  EXPECT_DOUBLE_EQ(merits_.scaled_limits(points_[5], {0})[0], 0.1);
  const SearchGoal goal{0, OptimiseLimit{.text = {}, .quantity = {}, .above = false, .bound = 30.0}};
  EXPECT_DOUBLE_EQ(merits_.scaled_limits(points_[2], goal)[1], 1.0);
  EXPECT_FALSE(merits_.meets(points_[2], goal));
  EXPECT_TRUE(merits_.meets(points_[3], goal));
}

TEST_F(Merits, PutLimitsBeforeAims) {
  EXPECT_LT(merits_.merit(points_[4], {0}), merits_.merit(points_[5], {0}));
  EXPECT_LT(merits_.merit(points_[5], {0}), merits_.merit(points_[6], {0}));
  EXPECT_EQ(merits_.best_of(points_, {0}), &points_[2]);
  EXPECT_EQ(merits_.best_of(points_, {1}), &points_[1]);
  EXPECT_EQ(merits_.best_of({points_[0], points_[6]}, {0}), nullptr);
}

TEST_F(Merits, LeaveOfAFrontWhatNothingBeatsInBothAims) {
  const std::vector<SearchGoal> goals = merits_.goals_between(points_[2], points_[1], 2);
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_DOUBLE_EQ(goals[0].other->bound, 30.0);
  EXPECT_DOUBLE_EQ(goals[1].other->bound, 20.0);
  const std::vector<std::size_t> front = merits_.front_of(points_, goals);
  EXPECT_EQ(front, (std::vector<std::size_t>{2, 3, 1}));
  // In halves and thirds of the ranges: (0, 1), (1/2, 1/3), (1, 0).
  EXPECT_EQ(middle_of_front(points_, front), 3U);
  // A point that is worse in both aims is not on the front, even if it is the best for some goal.
  points_.push_back(found(3e-6, 9.0, 100.0));
  points_[1] = found(3e-6, 10.0, 100.0);
  EXPECT_EQ(merits_.front_of(points_, merits_.goals_between(points_[2], points_[7], 20)),
            (std::vector<std::size_t>{2, 3, 7}));
}

}  // namespace
}  // namespace bumpfoil
