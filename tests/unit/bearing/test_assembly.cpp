#include "bumpfoil/bearing/assembly.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/model/case.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

PadAssembly assembly_of(double ratio) {
  Case input = film_reference_case({});
  input.top_foil.formed_radius = {FormedTo::radius, ratio * input.bearing.radius};
  return make_foils(input).assembly.front();
}

/// Values of an independent prototype, whose film has six nodes per pitch.
TEST(Assembly, IsThatOfThePrototype) {
  struct Reference {
    double ratio, hold_down, load, bulge;
  };
  for (const Reference& reference :
       {Reference{1.005, 0.01281165, 0.06212084, 9.883854e-6}, Reference{1.01, 0.02549644, 0.1236266, 19.66985e-6},
        Reference{1.02, 0.05049296, 0.2448292, 38.95401e-6}, Reference{1.1, 0.2341037, 1.135117, 180.605e-6}}) {
    const PadAssembly assembly = assembly_of(reference.ratio);
    EXPECT_NEAR(assembly.hold_down, reference.hold_down, 1e-6 * reference.hold_down);
    EXPECT_NEAR(assembly.load, reference.load, 1e-6 * reference.load);
    EXPECT_EQ(assembly.lifted, 8);  // bumps 1 to 17 and 26 are loaded
    // The maximum over crests: up to a quarter of a pitch from that of the prototype.
    EXPECT_NEAR(assembly.bulge, reference.bulge, 0.02 * reference.bulge);
  }
}

/// Rigid sleeve: the foil lifts off its bumps at psi_0 = 122.57 degrees, end load 1.18656 EI' kappa_0 / R, bulge
/// 0.10474 R^2 kappa_0 at 32.64 degrees from the last crest. The compliance of the bumps causes 0.5 %.
TEST(Assembly, IsThatOfACircularBeamReleasedOntoItsSupports) {
  const double kappa = (1.0 - 1.0 / 1.01) / 19.05e-3;
  const PadAssembly assembly = assembly_of(1.01);
  EXPECT_NEAR(assembly.hold_down, 1.18656 * 0.0007872451 * kappa / 19.05e-3, 0.005 * assembly.hold_down);
  EXPECT_NEAR(assembly.bulge, 0.1047423 * 19.05e-3 * 19.05e-3 * kappa, 0.025 * assembly.bulge);
  const double last = 25.5 * 4.572e-3 / 19.05e-3;
  EXPECT_NEAR((last - assembly.bulge_theta) * 180.0 / 3.14159265, 32.643, 0.5 * 13.75);  // half a pitch
}

/// The same with staggered strips: the foil ends on the very last crest, which belongs to one strip. It is uniform over
/// the width here, like the beam.
TEST(Assembly, IsThatOfACircularBeamOnStaggeredStrips) {
  Case input = film_reference_case({});
  input.bump_foil.bumps = 25;
  input.bump_foil.strips = 3;
  input.bump_foil.strip = {FoilStrip{}, FoilStrip{.stagger = 0.5, .height_errors = {}}, FoilStrip{}};
  input.top_foil.formed_radius = {FormedTo::radius, 1.01 * input.bearing.radius};
  const PadAssembly assembly = on_strips(make_foils(input), 1, {}).assembly.front();
  const double kappa = (1.0 - 1.0 / 1.01) / 19.05e-3;
  EXPECT_NEAR(assembly.hold_down, 1.18656 * 0.0007872451 * kappa / 19.05e-3, 0.005 * assembly.hold_down);
  EXPECT_NEAR(assembly.bulge, 0.1047423 * 19.05e-3 * 19.05e-3 * kappa, 0.01 * assembly.bulge);
  // The foil deflects beside the strip that supports its end.
  const PadAssembly bent = foils_without_journal(input).assembly.front();
  EXPECT_NEAR(bent.hold_down, assembly.hold_down, 0.02 * assembly.hold_down);
  EXPECT_LT(bent.bulge, assembly.bulge);
  EXPECT_NEAR(bent.bulge, assembly.bulge, 0.05 * assembly.bulge);
}

TEST(Assembly, IsKnownOnlyOfFormedFoils) {
  EXPECT_TRUE(make_foils(film_reference_case({})).assembly.empty());
}

/// Pressure only: equal loads on all bumps without a bulge, p_s L p each.
TEST(Assembly, PressesOnAllBumpsAlikeUnderASeatPressure) {
  Case input = film_reference_case({});
  input.top_foil.seat_pressure = 300.0;
  const PadAssembly assembly = make_foils(input).assembly.front();
  EXPECT_EQ(assembly.lifted, 0);
  EXPECT_LT(assembly.bulge, 1e-7);
  const double share = 300.0 * 38.1e-3 * 4.572e-3;
  EXPECT_NEAR(assembly.load, 25.5 * share, 0.03 * assembly.load);  // all except half a pitch at the weld
  EXPECT_NEAR(assembly.hold_down, share, 0.2 * share);             // with the overhang, and less beside it
}

}  // namespace
}  // namespace bumpfoil
