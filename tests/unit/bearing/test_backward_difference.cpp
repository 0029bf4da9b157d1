#include "bumpfoil/bearing/backward_difference.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

Matrix number(double value) {
  return Matrix::Constant(1, 1, value);
}

TEST(BackwardDifference, OfSecondOrderIsExactForParabolas) {
  const auto y = [](double t) { return number(3.0 - 2.0 * t + 5.0 * t * t); };
  const double now = 0.7;
  for (const double before : {0.01, 0.1, 0.3}) {
    for (const double ratio : {0.1, 1.0, 1.5, 2.4}) {
      const double dt = ratio * before;
      const BackwardDifference rate = bdf2(dt, before);
      const Matrix reference = rate.reference(y(now), y(now - before));
      EXPECT_NEAR((y(now + dt) - reference)(0, 0) / rate.span, -2.0 + 10.0 * (now + dt), 1e-11);
      EXPECT_NEAR(rate.now + rate.before, 1.0, 1e-15);
    }
  }
}

TEST(BackwardDifference, OfEqualStepsIsTheTextbooks) {
  const BackwardDifference rate = bdf2(0.5, 0.5);  // (3 y - 4 y_n + y_{n-1}) / (2 h)
  EXPECT_DOUBLE_EQ(1.0 / rate.span, 3.0);
  EXPECT_DOUBLE_EQ(rate.now / rate.span, 4.0);
  EXPECT_DOUBLE_EQ(rate.before / rate.span, -1.0);
}

TEST(BackwardDifference, StartsByImplicitEulerAndDoesNotReadWhatIsNot) {
  for (const BackwardDifference& rate : {implicit_euler(0.25), bdf2(0.25, 0.0), bdf2(0.25, 0.1)}) {
    EXPECT_EQ(rate.span, 0.25);
    EXPECT_EQ(rate.reference(number(7.0), Matrix())(0, 0), 7.0);
  }
}

}  // namespace
}  // namespace bumpfoil
