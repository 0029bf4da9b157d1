#include "bumpfoil/core/assert.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Assert, EvaluatesATrueConditionAtMostOnceAndGoesOn) {
  int evaluations = 0;
  BUMPFOIL_ASSERT(++evaluations == 1);
#ifdef BUMPFOIL_ASSERTIONS
  EXPECT_EQ(evaluations, 1);
#else
  EXPECT_EQ(evaluations, 0);
#endif
}

#ifdef BUMPFOIL_ASSERTIONS
TEST(AssertDeathTest, NamesConditionAndPlace) {
  const int blocks = 2;
  EXPECT_DEATH(BUMPFOIL_ASSERT(blocks == 3), "bumpfoil bug: blocks == 3 is false at .*test_assert\\.cpp");
}
#endif

}  // namespace
