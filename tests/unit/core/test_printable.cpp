#include "bumpfoil/core/printable.hpp"

#include <gtest/gtest.h>

#include <string>

namespace bumpfoil {
namespace {

using namespace std::string_literals;

TEST(Printable, EscapesControlCharactersOfBothKinds) {
  EXPECT_EQ(printable("\x1b[2J\n\0a\tb\x7f"s), "\\x1b[2J\\x0a\\x00a\\x09b\\x7f");
  // CSI as a single C1 character.
  EXPECT_EQ(printable("\xc2\x9b 31m"), "\\xc2\\x9b 31m");
  EXPECT_EQ(printable("\xc2\x80\xc2\x9f\xc2\xa0"), "\\xc2\\x80\\xc2\\x9f\xc2\xa0");
}

TEST(Printable, LeavesTextsOfAllLanguages) {
  for (const std::string text :
       {"\xc2\xb5m \xe2\x80\xa6", "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d", "\xe8\xbb\xb8\xe5\x8f\x97",
        "\xf0\x9f\x91\xa9\xe2\x80\x8d\xf0\x9f\x94\xa7", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, EscapesWhatTurnsTheDirectionOrBreaksLines) {
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b"),
            "a\\xe2\\x80\\xaeb");
  for (const std::string text : {"\xd8\x9c", "\xe2\x80\x8e", "\xe2\x80\x8f", "\xe2\x80\xa8", "\xe2\x80\xa9",
                                 "\xe2\x80\xaa", "\xe2\x81\xa6", "\xe2\x81\xa9", "\xef\xbb\xbf"}) {
    EXPECT_EQ(printable(text).size(), 4 * text.size()) << printable(text);
  }
}

TEST(Printable, EscapesWhatIsNoUtf8) {
  // Continuation byte only, truncated, overlong, a surrogate, beyond the last code point.
  for (const std::string text : {"\x80", "\xff", "\xc2", "\xe2\x80", "\xc1\x9b", "\xe0\x82\x9b", "\xed\xa0\x80",
                                 "\xf4\x90\x80\x80", "\xf8\x88"}) {
    EXPECT_EQ(printable(text).size(), 4 * text.size()) << printable(text);
    EXPECT_FALSE(is_utf8("a" + text)) << printable(text);
  }
  for (const std::string text : {"", "a\n\x1b", "\xc2\xb5m", "\xe2\x80\xae", "\xf0\x9f\x98\x80"})
    EXPECT_TRUE(is_utf8(text));
  EXPECT_EQ(printable("\xe2\x80z\x9b\xc2\xb5"), "\\xe2\\x80z\\x9b\xc2\xb5");
}

TEST(Printable, CutsBetweenCharacters) {
  EXPECT_EQ(printable("\xc2\xb5\xc2\xb5\xc2\xb5", 3), "\xc2\xb5\xc2\xb5... (6 characters)");
  EXPECT_EQ(printable("abc", 3), "abc");
  EXPECT_LT(printable(std::string(1000, '\x80'), 10).size(), 100U);
}

TEST(Printable, LinesKeepTheirEnds) {
  const std::string line(200, 'x');
  EXPECT_EQ(printable_lines(line + "\n\n\x1b[31m\r\n" + line), line + "\n\n\\x1b[31m\\x0d\n" + line);
  EXPECT_EQ(printable_lines(""), "");
}

TEST(Printable, JsonMeansTheSame) {
  EXPECT_EQ(printable_json("{\n \"a\": \"\xc2\x9b\xe2\x80\xae\x7f\xc2\xb5\xf0\x9f\x91\xa9\"\n}"),
            "{\n \"a\": \"\\u009b\\u202e\\u007f\xc2\xb5\xf0\x9f\x91\xa9\"\n}");
}

}  // namespace
}  // namespace bumpfoil
