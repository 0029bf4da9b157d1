#include "bumpfoil/core/version.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace {

TEST(Version, HasThreeNumbers) {
  const std::string_view version = bumpfoil::version();
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2);
  EXPECT_EQ(version.find_first_not_of("0123456789."), std::string_view::npos);
  EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(version.front())));
  EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(version.back())));
  EXPECT_EQ(version.find(".."), std::string_view::npos);
}

TEST(Version, CommitIsAHashOrUnknown) {
  const std::string_view commit = bumpfoil::commit();
  if (commit == "unknown") return;  // built without a checkout
  EXPECT_GE(commit.size(), 12U);
  EXPECT_EQ(commit.find_first_not_of("0123456789abcdef"), std::string_view::npos);
}

}  // namespace
