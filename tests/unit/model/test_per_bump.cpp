#include "bumpfoil/model/per_bump.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace bumpfoil {
namespace {

TEST(PerBump, IsOneForAllOrOneForEach) {
  const PerBump common = 3.0;
  EXPECT_EQ(common.at(0, 5), 3.0);
  EXPECT_EQ(common.at(4, 5), 3.0);
  EXPECT_FALSE(common.is_list());
  const PerBump each(std::vector{1.0, 2.0, 4.0});
  EXPECT_EQ(each.at(1, 3), 2.0);
  EXPECT_EQ(each.at(1, 2), 2.0);  // within the first two
  EXPECT_TRUE(each.is_list());
}

TEST(PerBump, GoesFromTheFirstToTheLastByItsLaw) {
  const PerBump linear(1.0, 16.0, Grading::linear);
  const PerBump geometric(1.0, 16.0, Grading::geometric);
  EXPECT_FALSE(linear.is_list());
  for (const PerBump& law : {linear, geometric}) {
    EXPECT_EQ(law.at(0, 5), 1.0);
    EXPECT_EQ(law.at(4, 5), 16.0);  // exact
    EXPECT_EQ(law.at(0, 1), 1.0);
  }
  EXPECT_DOUBLE_EQ(linear.at(1, 5), 4.75);
  EXPECT_DOUBLE_EQ(geometric.at(1, 5), 2.0);
  EXPECT_DOUBLE_EQ(geometric.at(3, 5), 8.0);
}

TEST(PerBump, IsListedAsItIs) {
  const PerBump law(1.0, 16.0, Grading::geometric);
  const PerBump list = listed(law, 5);
  ASSERT_TRUE(list.is_list());
  for (std::size_t n = 0; n < 5; ++n) EXPECT_EQ(list.at(n, 5), law.at(n, 5));
}

TEST(PerBump, IsShiftedAtEveryBump) {
  for (const PerBump& one : {PerBump(2.0), PerBump(std::vector{1.0, 2.0, 5.0}), PerBump(1.0, 9.0, Grading::linear),
                             PerBump(1.0, 9.0, Grading::geometric)}) {
    const PerBump more = shifted(one, 3, 0.5);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_DOUBLE_EQ(more.at(n, 3), one.at(n, 3) + 0.5);
  }
}

}  // namespace
}  // namespace bumpfoil
