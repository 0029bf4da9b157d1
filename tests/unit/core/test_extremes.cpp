#include "bumpfoil/core/extremes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace bumpfoil {
namespace {

TEST(Extremes, HoldAllNumbersWhereverTheyStand) {
  for (const Eigen::Index count : {1, 7, 8, 19}) {
    for (Eigen::Index at = 0; at < count; ++at) {
      Eigen::VectorXd numbers = Eigen::VectorXd::LinSpaced(count, -1.0, 1.0);
      numbers[at] = 5.0;
      EXPECT_EQ(extremes_of(numbers).most, 5.0) << count << ' ' << at;
      numbers[at] = -7.0;
      EXPECT_EQ(extremes_of(numbers).least, -7.0) << count << ' ' << at;
      EXPECT_EQ(extremes_of(numbers).size(), 7.0);
    }
  }
}

TEST(Extremes, HoldZeroAndLeaveOutWhatIsNoNumber) {
  EXPECT_EQ(extremes_of(Eigen::VectorXd()).size(), 0.0);
  const Extremes positive = extremes_of(Eigen::VectorXd::Constant(11, 3.0));
  EXPECT_EQ(positive.least, 0.0);
  EXPECT_EQ(positive.most, 3.0);
  // In vectors of two, four or eight, NaN comes after the minimum in the same lane.
  Eigen::VectorXd broken = Eigen::VectorXd::Constant(27, -3.0);
  broken[3] = -9.0;
  broken[11] = broken[25] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(extremes_of(broken).least, -9.0);
  EXPECT_EQ(extremes_of(broken).most, 0.0);
}

}  // namespace
}  // namespace bumpfoil
