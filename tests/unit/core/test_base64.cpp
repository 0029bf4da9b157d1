#include "core/base64.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace bumpfoil {
namespace {

std::string of(const std::string& letters) {
  return base64_of(std::vector<signed char>(letters.begin(), letters.end()));
}

TEST(Base64, IsWhatRfc4648Says) {
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foob"), "Zm9vYg==");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of(std::vector<signed char>{-1, 0, -128}), "/wCA");
}

TEST(Base64, HoldsNumbersAsLittleEndianSinglePrecision) {
  EXPECT_EQ(base64_of(std::vector<double>{1.0}), "AACAPw==");
  EXPECT_EQ(base64_of(std::vector<double>{1.0, -2.0}), "AACAPwAAAMA=");
}

TEST(Base64, HasNaNForWhatIsNoNumberOfSinglePrecision) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300}) {
    EXPECT_EQ(base64_of(std::vector<double>{number}), "AADAfw==") << number;
  }
}

}  // namespace
}  // namespace bumpfoil
