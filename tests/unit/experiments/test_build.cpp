#include "bumpfoil/experiments/build.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"

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
  input.strip = StripSettings{.bumps = 3, .amplitude = {Control::displacement, 1e-6}};
  EXPECT_EQ(make_strip_foils(input)->bumps(), 3);
}

}  // namespace
}  // namespace bumpfoil
