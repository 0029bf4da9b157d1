#include "bumpfoil/model/bearing_design.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {
namespace {

TEST(BearingDesign, IsFlatWithoutARadius) {
  EXPECT_TRUE(BearingDesign{}.bearing.is_flat());
  EXPECT_FALSE(reference_case().bearing.is_flat());
}

TEST(BearingDesign, IsRoundWithoutWavesProfilesAndTaper) {
  Bearing bearing;
  EXPECT_TRUE(bearing.is_round());
  bearing.taper = 1e-6;
  EXPECT_FALSE(bearing.is_round());
  bearing = {};
  bearing.journal.waves = {{.harmonic = 2, .amplitude = 1e-6, .phase = 0.0}};
  EXPECT_FALSE(bearing.is_round());
}

/// Cases may also differ in their loading; designs do not.
TEST(BearingDesign, IsThePartOfACaseThatIsTheBearing) {
  const Case input = reference_case();
  Case other = input;
  other.settings.get<CycleSettings>().steps += 1;
  EXPECT_NE(other, input);
  EXPECT_EQ(static_cast<const BearingDesign&>(other), static_cast<const BearingDesign&>(input));
  other.top_foil.thickness *= 2.0;
  EXPECT_NE(static_cast<const BearingDesign&>(other), static_cast<const BearingDesign&>(input));
}

}  // namespace
}  // namespace bumpfoil
