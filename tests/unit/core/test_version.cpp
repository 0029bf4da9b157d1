#include "bumpfoil/core/version.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace {

TEST(Version, HasThreeNumbers) {
  EXPECT_TRUE(std::regex_match(std::string(bumpfoil::version()), std::regex(R"(\d+\.\d+\.\d+)")));
}

TEST(Version, CommitIsAHashOrUnknown) {
  EXPECT_TRUE(std::regex_match(std::string(bumpfoil::commit()), std::regex("[0-9a-f]{12,40}|unknown")));
}

}  // namespace
