#include "bumpfoil/bearing/tangents.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(TangentMatrices, AlongADirectionAreQuadraticForms) {
  TangentMatrices tangents;
  tangents.unloading = Eigen::Matrix2d{{4.0, 1.0}, {3.0, 2.0}};
  const TangentStiffnesses along = tangents.along({0.6, 0.8});
  EXPECT_DOUBLE_EQ(along.unloading.value(), 0.36 * 4.0 + 0.48 * (1.0 + 3.0) + 0.64 * 2.0);
  EXPECT_FALSE(along.loading);
}

}  // namespace
}  // namespace bumpfoil
