#include "bumpfoil/core/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace bumpfoil {
namespace {

TEST(Error, NamesPlaceKeyValueAndAdvice) {
  const Fault fault{"case.toml", 7, "bearing.radius", "-1 mm", "must be positive", "give the radius of the sleeve"};
  EXPECT_EQ(format_fault(fault),
            "case.toml:7: bearing.radius = -1 mm: must be positive; give the radius of the sleeve");
}

TEST(Error, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(format_fault({"", 0, "bearing.radius", "", "is missing", ""}), "bearing.radius: is missing");
  EXPECT_EQ(format_fault({"", 0, "", "", "is empty", ""}), "is empty");
}

TEST(Error, ListsEveryFault) {
  const Error error(ErrorKind::input, {{"", 0, "a", "", "one", ""}, {"", 0, "b", "", "two", ""}});
  EXPECT_EQ(std::string(error.what()), "a: one\nb: two");
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_EQ(error.faults().size(), 2U);
}

TEST(Error, EchoesHostileValuesSafely) {
  const std::string escaped = format_fault({"", 0, "title", "\x1b[2J\n", "is odd", ""});
  EXPECT_EQ(escaped, "title = \\x1b[2J\\x0a: is odd");
  const std::string shortened = format_fault({"", 0, "title", std::string(1000, 'x'), "is long", ""});
  EXPECT_LT(shortened.size(), 200U);
  EXPECT_NE(shortened.find("(1000 characters)"), std::string::npos);
}

TEST(Error, EchoesHostileTextsOfOthersSafely) {
  EXPECT_EQ(format_fault({"a\x1b\nb", 0, "k\r", "", "has \"\xc2\x9b 31m\"", "not \xe2\x80\xae"}),
            "a\\x1b\\x0ab: k\\x0d: has \"\\xc2\\x9b 31m\"; not \\xe2\\x80\\xae");
}

}  // namespace
}  // namespace bumpfoil
