#include "bumpfoil/case/swept_key.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

using Words = std::vector<std::string>;

/// The error of an option, with its advice.
std::string swept_key_error(const std::string& argument) {
  try {
    static_cast<void>(parse_swept_key(argument));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.errors().size(), 1U);
    return error.what();
  }
  return "none";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(SweptKey, RangeHoldsNumbersAsPeopleWriteThem) {
  const SweptKey swept = parse_swept_key("friction.coefficient=0:0.5:0.05");
  EXPECT_EQ(swept.key, "friction.coefficient");
  EXPECT_EQ(swept.values, (Words{"0", "0.05", "0.1", "0.15", "0.2", "0.25", "0.3", "0.35", "0.4", "0.45", "0.5"}));
}

TEST(SweptKey, UnitsStandBehindEveryNumber) {
  EXPECT_EQ(parse_swept_key("cycle.amplitude=60 um:90 um:10 um").values, (Words{"60 um", "70 um", "80 um", "90 um"}));
  EXPECT_EQ(parse_swept_key("a.b = -10um : 10um : 10um").values, (Words{"-10 um", "0 um", "10 um"}));
  EXPECT_TRUE(has(swept_key_error("a.b=60 um:90 um:10"), "has the units \"um\", \"um\" and \"\""));
  EXPECT_TRUE(has(swept_key_error("a.b=60 um:0.1 mm:10 um"), "same unit"));
}

TEST(SweptKey, RangesMayFallStandStillOrUsePowersOfTen) {
  EXPECT_EQ(parse_swept_key("a.b=0.3:-0.1:-0.2").values, (Words{"0.3", "0.1", "-0.1"}));
  EXPECT_EQ(parse_swept_key("a.b=2:2:1").values, (Words{"2"}));
  EXPECT_EQ(parse_swept_key("a.b=1e2:3e2:1e2").values, (Words{"100", "200", "300"}));
  EXPECT_EQ(parse_swept_key("a.b=1e-5:3.0e-5:1E-5").values, (Words{"0.00001", "0.00002", "0.00003"}));
  EXPECT_EQ(parse_swept_key("a.b=.5:1.5:+.5").values, (Words{"0.5", "1", "1.5"}));
  EXPECT_EQ(parse_swept_key("a.b=0e99:2:1").values, (Words{"0", "1", "2"}));
  EXPECT_EQ(parse_swept_key("a.b=1e40:2e40:1e40").values, (Words{"1e40", "2e40"}));
}

TEST(SweptKey, RangeEndsWhereItWasToldTo) {
  // Thirds with limited digits: a final step that is too short, and one that is too long.
  EXPECT_EQ(parse_swept_key("a.b=0:1:0.3333333").values, (Words{"0", "0.3333333", "0.6666666", "1"}));
  EXPECT_EQ(parse_swept_key("a.b=0:1:0.33333334").values.back(), "1");
  EXPECT_TRUE(has(swept_key_error("a.b=0:0.5:0.2"), "does not end at 0.5; steps of 0.2 lead to 0.4 and 0.6"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1:0.333"), "does not end at 1"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:-1:-0.3"), "lead to -0.9 and -1.2"));
}

TEST(SweptKey, ListHoldsWhatWasWritten) {
  EXPECT_EQ(parse_swept_key("a.b=[0.1, 0.20,3]").values, (Words{"0.1", "0.20", "3"}));
  EXPECT_EQ(parse_swept_key("a.b=[\"60 um\", '0.1 mm', 70 um]").values, (Words{"60 um", "0.1 mm", "70 um"}));
  EXPECT_TRUE(has(swept_key_error("a.b=[]"), "empty entry"));
  EXPECT_TRUE(has(swept_key_error("a.b=[1,]"), "empty entry"));
  EXPECT_TRUE(has(swept_key_error("a.b=[1, 2"), "close it with ]"));
  EXPECT_TRUE(has(swept_key_error("a.b=[truss, frame]"), "has \"truss\", expected a number"));
}

TEST(SweptKey, SaysWhatElseIsWrong) {
  EXPECT_EQ(swept_key_error("friction.coefficient").find("--over = friction.coefficient: does not give"), 0U);
  EXPECT_TRUE(has(swept_key_error("friction.coefficient"), "write KEY=FROM:TO:STEP or KEY=[a, b]"));
  EXPECT_TRUE(has(swept_key_error("=0:1:1"), "does not give"));
  EXPECT_TRUE(has(swept_key_error("a.b=0.1"), "neither a range nor a list"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1"), "neither a range nor a list"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1:2:3"), "neither a range nor a list"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:0,5:0,1"), "has a decimal comma; write decimal points"));
  EXPECT_TRUE(has(swept_key_error("a.b="), "expected a number"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:nan:1"), "has \"nan\", expected a number"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1:0"), "has no step"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1:-0.1"), "steps away from its end; give the step 0.1"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1:1e-9"), "a sweep takes at most 10000"));
  EXPECT_TRUE(has(swept_key_error("a.b=0:1e30:1"), "spans more than 15 digits"));
  EXPECT_TRUE(has(swept_key_error("a.b=0.1234567890123456:1:1"), "more than 15 digits"));
  EXPECT_TRUE(has(swept_key_error("a.b=1e999:1:1"), "expected a number"));
  EXPECT_TRUE(has(swept_key_error("a.b=[" + std::string(10'000, ',') + "]"), "has 10001 values"));
}

/// digits * 10^-decimals, written with a decimal point.
std::string decimal(int digits, int decimals) {
  std::string text = std::to_string(std::abs(digits));
  if (decimals > 0) {
    const auto places = static_cast<std::size_t>(decimals);
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, 1, '.');
  }
  return digits < 0 ? "-" + text : text;
}

RC_GTEST_PROP(SweptKey, AnyRangeEndsAtBothEndsWithoutRoundings, ()) {
  const int decimals = *rc::gen::inRange(0, 7);
  const int from = *rc::gen::inRange(-100'000, 100'000);
  const int step = *rc::gen::distinctFrom(rc::gen::inRange(-1000, 1000), 0);
  const int steps = *rc::gen::inRange(0, 200);
  const SweptKey swept = parse_swept_key("a.b=" + decimal(from, decimals) + ":" +
                                         decimal(from + steps * step, decimals) + ":" + decimal(step, decimals));
  RC_ASSERT(swept.values.size() == static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) {
    const std::string& value = swept.values[static_cast<std::size_t>(i)];
    // The nearest double of the decimal, with a text that is not longer than the decimal.
    RC_ASSERT(std::stod(value) == std::stod(decimal(from + i * step, decimals)));
    RC_ASSERT(value.size() <= decimal(from + i * step, decimals).size());
    RC_ASSERT(value != "-0");
  }
}

}  // namespace
}  // namespace bumpfoil
