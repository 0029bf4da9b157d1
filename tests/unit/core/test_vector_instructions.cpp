#include "bumpfoil/core/vector_instructions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace bumpfoil {
namespace {

TEST(VectorInstructions, BeginWithWhatTheProgramIsBuiltForAndEndWithTheWidest) {
  const auto& all = vector_instructions();
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(all[i]), i);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(widest_vector_instructions(), all.back());
  EXPECT_EQ(name_of(all.front()), "baseline");
}

TEST(VectorInstructions, TellTheBodyTheirLanesAndHandItsResultOn) {
  for (const VectorInstructions instructions : vector_instructions()) {
    const int lanes = with_vectors(instructions, [&](auto count) BUMPFOIL_ALWAYS_INLINE { return count.value; });
    EXPECT_EQ(lanes, 2 << static_cast<int>(instructions));
  }
  bool called = false;
  with_widest_vectors([&](auto) BUMPFOIL_ALWAYS_INLINE { called = true; });
  EXPECT_TRUE(called);
}

/// Without fused instructions the library emulates them, with the same result.
TEST(VectorInstructions, RunTheSameLoopWithEach) {
  std::array<double, 37> a{}, b{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = std::sin(1.0 + static_cast<double>(i));
    b[i] = std::cos(static_cast<double>(i));
  }
  for (const VectorInstructions instructions : vector_instructions()) {
    std::array<double, 37> sums = b;
    with_vectors(instructions, [&](auto) BUMPFOIL_ALWAYS_INLINE {
      for (std::size_t i = 0; i < a.size(); ++i) sums[i] = std::fma(3.0, a[i], sums[i]);
    });
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(sums[i], std::fma(3.0, a[i], b[i]));
  }
}

}  // namespace
}  // namespace bumpfoil
