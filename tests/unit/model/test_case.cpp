#include "bumpfoil/model/case.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

TEST(BearingOfARotor, IsThatOfTheCaseButForItsOwnTables) {
  Case input = reference_case();
  input.rotor_bearings.resize(2);
  input.rotor_bearings[1].friction = Friction{.top_bump = 0.3, .bump_sleeve = 0.3};
  const Case first = bearing_at(input, 0);
  const Case second = bearing_at(input, 1);
  EXPECT_EQ(first.friction, input.friction);
  EXPECT_EQ(second.friction.top_bump, 0.3);
  EXPECT_EQ(second.bearing, input.bearing);
  EXPECT_EQ(second.settings.find<CycleSettings>(), nullptr);  // nothing is to be done to it
}

}  // namespace
}  // namespace bumpfoil
