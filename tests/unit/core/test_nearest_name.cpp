#include "bumpfoil/core/nearest_name.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

const std::vector<std::string> commands{"cycle", "check", "bump_foil", "top_foil"};

TEST(NearestName, IsTheOneFewestEditsAway) {
  EXPECT_EQ(nearest_name("cylce", commands), "cycle");
  EXPECT_EQ(nearest_name("chek", commands), "check");
  EXPECT_EQ(nearest_name("topfoil", commands), "top_foil");
}

TEST(NearestName, TakesASwapOfNeighboursForOneEdit) {
  EXPECT_EQ(nearest_name("ste", {"seed", "set"}), "set");
  EXPECT_EQ(nearest_name("abdc", {"abce", "abcd"}), "abcd");
}

TEST(NearestName, KnowsNoCaseAndTakesDashesForUnderscores) {
  EXPECT_EQ(nearest_name("BUMP-FOIL", commands), "bump_foil");
}

TEST(NearestName, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("friction", commands), std::nullopt);
  EXPECT_EQ(nearest_name("", commands), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100, 'c'), commands), std::nullopt);
}

}  // namespace
}  // namespace bumpfoil
