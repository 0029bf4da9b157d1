#include "core/number_text.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace bumpfoil {
namespace {

/// The same number, end and status as std::from_chars.
void expect_as_from_chars(const std::string& text) {
  SCOPED_TRACE(text);
  double expected = 7.0;
  double found = 7.0;
  const auto due = std::from_chars(text.data(), text.data() + text.size(), expected);
  const auto met = read_decimal(text, found);
  EXPECT_EQ(met.ec, due.ec);
  EXPECT_EQ(met.ptr - text.data(), due.ptr - text.data());
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(found));
  } else {
    EXPECT_EQ(found, expected);
  }
}

TEST(ReadDecimal, ReadsWhatFromCharsReads) {
  for (const char* text : {"0",
                           "-0",
                           "31.8",
                           "31.8 um",
                           "-2e1",
                           "1e",
                           "1e+",
                           "1e+3x",
                           "1.e3",
                           ".5",
                           "-.5",
                           ".",
                           "-",
                           "",
                           "e5",
                           "1e5.5",
                           "0x10",
                           "1_000",
                           " 1",
                           "+1",
                           "--1",
                           "inf",
                           "-inf",
                           "INFINITY",
                           "infinit",
                           "nan",
                           "nanx",
                           "1e308",
                           "1.7976931348623159e308",
                           "1e400",
                           "-1e400",
                           "1e-400",
                           "4.9e-324",
                           "2.2250738585072011e-308",
                           "0.1",
                           "3.141592653589793238462643383279",
                           "9007199254740993",
                           "19.05mm"}) {
    expect_as_from_chars(text);
  }
}

TEST(NumberText, HasFiveDigits) {
  EXPECT_EQ(number_text(31.8e-6, 1e-6), "31.800");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity(), 1.0), "-");
}

TEST(NumberText, HasAUnitWhereThereIsANumber) {
  EXPECT_EQ(unit_beside("um", {"-", "31.800", "-"}), "um");
  EXPECT_EQ(unit_beside("um", {"-", "-"}), "");
}

}  // namespace
}  // namespace bumpfoil
