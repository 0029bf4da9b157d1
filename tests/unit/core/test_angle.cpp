#include "bumpfoil/core/angle.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bumpfoil {
namespace {

TEST(ToDegrees, GivesWholeDegreesWhereTheyWereMeant) {
  for (int degrees = -360; degrees <= 360; ++degrees) {
    EXPECT_EQ(to_degrees(degrees * (std::numbers::pi / 180.0)), degrees);
  }
  EXPECT_DOUBLE_EQ(to_degrees(37.5 * std::numbers::pi / 180.0), 37.5);
}

}  // namespace
}  // namespace bumpfoil
