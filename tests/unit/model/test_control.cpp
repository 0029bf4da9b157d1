#include "bumpfoil/model/control.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(Control, IsByDisplacementWhereNothingIsSaid) {
  EXPECT_EQ(Control{}, Control::displacement);
  EXPECT_NE(Control{}, Control::load);
}

}  // namespace
}  // namespace bumpfoil
