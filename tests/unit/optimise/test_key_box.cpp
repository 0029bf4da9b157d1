#include "optimise/key_box.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

std::vector<OptimisedKey> keys_of_box() {
  return {{.key = "bearing.radial_clearance", .lower = 18e-6, .upper = 42e-6},
          {.key = "bump_foil.youngs_modulus", .lower = 1e9, .upper = 1e11, .log = true}};
}

TEST(KeyBox, IsInPartsOfTheWayBetweenTheBounds) {
  const KeyBox box(keys_of_box());
  EXPECT_EQ(box.dimensions(), 2);
  const Eigen::VectorXd place = box.place_of({24e-6, 1e10});
  EXPECT_NEAR(place[0], 0.25, 1e-12);
  EXPECT_NEAR(place[1], 0.5, 1e-12);
  // The bounds are exact.
  EXPECT_EQ(box.values_at(Eigen::Vector2d(0.0, 0.0)), (KeyValues{18e-6, 1e9}));
  EXPECT_EQ(box.values_at(Eigen::Vector2d(1.0, 1.0)), (KeyValues{42e-6, 1e11}));
}

TEST(KeyBox, ValuesComeBackFromTheirPlaces) {
  const KeyBox box(keys_of_box());
  for (int k = 0; k < 50; ++k) {
    const KeyValues values =
        box.values_at(Eigen::Vector2d((k + 0.123456789) / 50.0, (k * 7 % 50 + 0.987654321) / 50.0));
    EXPECT_EQ(box.values_at(box.place_of(values)), values) << k;
  }
  // Values beyond the bounds by the round-off of their text are set to the bounds.
  EXPECT_EQ(box.short_values({42e-6 * (1.0 + 1e-15), 1e9}), (KeyValues{42e-6, 1e9}));
}

}  // namespace
}  // namespace bumpfoil
