#include "bumpfoil/core/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace bumpfoil {
namespace {

TEST(Error, NamesPlaceKeyValueAndAdvice) {
  const InputError error{
      "case.toml", 7, "bearing.radius", "-1 mm", "must be positive", "give the radius of the sleeve"};
  EXPECT_EQ(format_error(error),
            "case.toml:7: bearing.radius = -1 mm: must be positive; give the radius of the sleeve");
}

TEST(Error, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(format_error({"", 0, "bearing.radius", "", "is missing", ""}), "bearing.radius: is missing");
  EXPECT_EQ(format_error({"", 0, "", "", "is empty", ""}), "is empty");
}

TEST(Error, ListsEveryError) {
  const Error error(ErrorKind::input, {{"", 0, "a", "", "one", ""}, {"", 0, "b", "", "two", ""}});
  EXPECT_EQ(std::string(error.what()), "a: one\nb: two");
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_EQ(error.errors().size(), 2U);
}

TEST(Error, EchoesHostileValuesSafely) {
  const std::string escaped = format_error({"", 0, "title", "\x1b[2J\n", "is odd", ""});
  EXPECT_EQ(escaped, "title = \\x1b[2J\\x0a: is odd");
  const std::string shortened = format_error({"", 0, "title", std::string(1000, 'x'), "is long", ""});
  EXPECT_LT(shortened.size(), 200U);
  EXPECT_NE(shortened.find("(1000 characters)"), std::string::npos);
}

TEST(Error, EchoesHostileTextsOfOthersSafely) {
  EXPECT_EQ(format_error({"a\x1b\nb", 0, "k\r", "", "has \"\xc2\x9b 31m\"", "not \xe2\x80\xae"}),
            "a\\x1b\\x0ab: k\\x0d: has \"\\xc2\\x9b 31m\"; not \\xe2\\x80\\xae");
}

}  // namespace
}  // namespace bumpfoil
