#include "bumpfoil/ensemble/draws.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace bumpfoil {
namespace {

TEST(Draws, AreThoseOfPhilox) {
  // Known answers of philox4x32-10 (Random123, kat_vectors): the first two words for counter and key zero, and for all
  // bits set.
  EXPECT_EQ(uniform_draw({}), ((0x6627e8d5e169c58dU >> 12U) + 0.5) * 0x1p-52);
  const std::uint64_t all = ~std::uint64_t{0};
  EXPECT_EQ(uniform_draw({all, all, ~0U, ~0U}), ((0x408f276d41c83b0eU >> 12U) + 0.5) * 0x1p-52);
}

TEST(Draws, EveryPartOfThePlaceCounts) {
  const DrawPlace place{.seed = 1, .sample = 2, .variable = 3, .element = 4};
  std::set<double> draws{uniform_draw(place)};
  for (const std::uint64_t bit : {1ULL, 1ULL << 31U, 1ULL << 32U, 1ULL << 63U}) {
    DrawPlace other = place;
    other.seed ^= bit;
    draws.insert(uniform_draw(other));
    other = place;
    other.sample ^= bit;
    draws.insert(uniform_draw(other));
  }
  DrawPlace other = place;
  other.variable ^= 1U;
  draws.insert(uniform_draw(other));
  other = place;
  other.element ^= 1U;
  draws.insert(uniform_draw(other));
  EXPECT_EQ(draws.size(), 11U);
}

TEST(Draws, AreUniformAndIndependentOfTheirNeighbours) {
  constexpr int n = 100'000;
  std::array<int, 20> counts{};
  double sum = 0.0, next = 0.0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = uniform_draw({.seed = 7, .sample = i});
    ASSERT_GT(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++counts[static_cast<std::size_t>(20.0 * u)];
    sum += u;
    next += (u - 0.5) * (uniform_draw({.seed = 7, .sample = i + 1}) - 0.5);
  }
  // Five standard errors: sqrt(1/12) for a draw, 1/12 for the product of two, sqrt(n p (1 - p)) for a count.
  EXPECT_NEAR(sum / n, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / n));
  EXPECT_NEAR(next / n, 0.0, 5.0 / 12.0 / std::sqrt(n));
  for (const int count : counts) EXPECT_NEAR(count, n / 20, 5.0 * std::sqrt(n * 0.05 * 0.95));
}

}  // namespace
}  // namespace bumpfoil
