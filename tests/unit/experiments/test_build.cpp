#include "bumpfoil/experiments/build.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"

namespace bumpfoil {
namespace {

TEST(Build, ChecksTheCaseFirst) {
  Case input = reference_case();
  EXPECT_EQ(make_bearing_foils(input)->bumps(), 26);
  input.bump_foil.bumps = 0;
  EXPECT_THROW(static_cast<void>(make_bearing_foils(input)), Error);
  EXPECT_THROW(static_cast<void>(make_film_bearing(input)), Error);
}

TEST(Build, NeedsAStripToMakeOne) {
  Case input = reference_case();
  EXPECT_THROW(static_cast<void>(make_strip_foils(input)), Error);
  input.settings.set(StripSettings{.bumps = 3, .amplitude = {Control::displacement, 1e-6}});
  EXPECT_EQ(make_strip_foils(input)->bumps(), 3);
}

TEST(Build, TiltsTheJournalAsFarAsGivenOrAsTheMomentOnItDoes) {
  Case input = reference_case();
  input.bearing.axial_length = 40e-3;
  EXPECT_EQ(surroundings_of(input, 1e5).tilt, JournalTilt());
  input.width.tilt = {1e-4, -2e-4};
  const JournalTilt given = surroundings_of(input, 1e5).tilt;
  EXPECT_EQ(given.control, Control::displacement);
  EXPECT_LT((given.value - Eigen::Vector2d(2e-6, -4e-6)).norm(), 1e-20);
  input.width.moment = {0.5, 0.2};
  const JournalTilt found = surroundings_of(input, 1e5).tilt;
  EXPECT_EQ(found.control, Control::load);
  EXPECT_LT((found.value - Eigen::Vector2d(25.0, 10.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace bumpfoil
