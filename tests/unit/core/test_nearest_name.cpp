#include "bumpfoil/core/nearest_name.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

const std::vector<std::string> names{"cycle", "check", "bump_foil", "top_foil"};

TEST(NearestName, IsTheOneFewestEditsAway) {
  EXPECT_EQ(nearest_name("cylce", names), "cycle");
  EXPECT_EQ(nearest_name("chek", names), "check");
  EXPECT_EQ(nearest_name("topfoil", names), "top_foil");
}

TEST(NearestName, KnowsNoCaseAndTakesDashesForUnderscores) {
  EXPECT_EQ(nearest_name("BUMP-FOIL", names), "bump_foil");
}

TEST(NearestName, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("friction", names), std::nullopt);
  EXPECT_EQ(nearest_name("", names), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100, 'c'), names), std::nullopt);
}

}  // namespace
}  // namespace bumpfoil
