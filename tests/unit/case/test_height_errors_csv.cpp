#include "case/height_errors_csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

/// A foil of four bumps, 0.5 mm high and 0.1 mm thick.
class HeightErrorsCsv : public ::testing::Test {
 protected:
  std::vector<double> read(const std::string& text) {
    return read_height_errors(folder_.write("h.csv", text), std::vector<double>(4, 0.5e-3),
                              std::vector<double>(4, 0.4e-3));
  }

  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_EQ(error.errors().size(), 1U) << error.what();
      return error.what();
    }
    return "";
  }

  void expect_refused(const std::string& text, const std::string& message) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(message), std::string::npos) << said;
  }

  test_support::TemporaryFolder folder_;
};

TEST_F(HeightErrorsCsv, AreReadAsPeopleHaveThem) {
  for (const char* text : {
           "bump,height_error_um\n1,12.5\n2,-3\n3,0\n4,1.5\n",
           "\"bump\",\"height_error_um\",\"note\"\n1,\"12,5\",\"good, clean\"\n2,-3,\n3,0,\"a "
           "\"\"b\"\"\"\n4,\"1,5\",x\n",
           "height_error_um\n12,5\n-3\n0\n1,5\n",
           "Bump,Height_Error_um\n1,12.5\n2,-3\n3,0\n4,1.5\n",
           "BUMP;HEIGHT ERROR [UM]\n1;12,5\n2;-3\n3;0\n4;1,5\n",
           "bump;height_error_\xc2\xb5m\n1;12.5\n2;\xe2\x88\x92"
           "3\n3;0\n4;1.5\n",
           "bump;height_error (\xb5m)\n1;12.5\n2;-3\n3;0\n4;1.5\n",
           "bump,height [mm]\n1,0.5125\n2,0.497\n3,0.5\n4,0.5015\n",
           "sep=;\nbump;height_error_um # of 3 May, by J.\n1;12.5  # again, twice\n2;-3\n3;0\n4;1.5\n",
           "bump,height_error_um\r1,12.5\r2,-3\r3,0\r4,1.5\r",
           "height_error_inch\n0.000492125984251968\n-0.000118110236220472\n0\n5.90551181102362e-05\n",
       }) {
    const std::vector<double> errors = read(text);
    ASSERT_EQ(errors.size(), 4U) << text;
    EXPECT_NEAR(errors[0], 12.5e-6, 1e-15) << text;
    EXPECT_NEAR(errors[1], -3e-6, 1e-15) << text;
    EXPECT_NEAR(errors[2], 0.0, 1e-15) << text;
    EXPECT_NEAR(errors[3], 1.5e-6, 1e-15) << text;
  }
  EXPECT_NEAR(read("height_error_mil\n0.1\n0\n0\n0\n")[0], 2.54e-6, 1e-15);
}

TEST_F(HeightErrorsCsv, KeepToOneDecimalSign) {
  expect_refused("bump;height_error_um\n1;1.5\n2;1,5\n3;0\n4;0\n",
                 "h.csv:3: line = 2;1,5: has a decimal comma where earlier lines have points");
  expect_refused("height_error_um\n1,5\n2.5\n3\n4\n", "h.csv:3: line = 2.5: has a decimal point");
  expect_refused("bump;height_error_um\n1;1.234,5\n2;1\n3;0\n4;0\n", "has no finite number for the height");
}

TEST_F(HeightErrorsCsv, TellDecimalCommasBetweenCommasOnce) {
  const std::string advice =
      "; decimal commas in a comma-separated file? write numbers in quotes, or semicolons between columns";
  EXPECT_TRUE(refusal("bump,height_error_um\n1,0\n2,0,2\n3,-1,5\n4,1,0\n")
                  .ends_with("h.csv:3: line = 2,0,2: has 3 columns, separated by commas, and the header 2 (as 2 more "
                             "lines)" +
                             advice));
  EXPECT_TRUE(refusal("bump,height_error_um\n1,0\n2,0,2\n3,-1\n4,1\n").ends_with("and the header 2" + advice));
  EXPECT_TRUE(refusal("bump;height_error_um\n1;0\n2;0;2\n3;-1\n4;1\n").ends_with("write a value for every column"));
  expect_refused(
      "bump,height_error_um\n1\n2\n3,0\n4,0\n",
      "h.csv:2: line = 1: has 1 column, separated by commas, and the header 2 (as 1 more line); write a value "
      "for every column");
}

TEST_F(HeightErrorsCsv, SuggestTheColumnThatWasMeant) {
  expect_refused("bump,hieght_error_um\n1,1\n", "did you mean \"height_error_um\"?");
  expect_refused("bump,height\n1,1\n", "say its unit: height_um");
  expect_refused("bump,height_error_N\n1,1\n", "\"N\" is not a unit for a length: write height_error_um");
}

TEST_F(HeightErrorsCsv, AreCheckedInTheirOwnLines) {
  expect_refused(
      "bump,height_error_um\n1,1\n2,2\n4,-450\n3,4\n",
      "h.csv:4: line = 4,-450: lies further from the nominal height than a bump rises, 0.0004 m; correct it");
  expect_refused("bump,height_um\n1,0.51\n2,0.5\n3,0.49\n4,0.5\n",
                 "h.csv:2: line = 1,0.51: and 3 more lie further from the nominal height than a bump rises, 0.0004 m; "
                 "millimetres in a column of micrometres?");
  expect_refused("bump,height_mm\n1,510\n2,500\n3,490\n4,500\n", "micrometres in a column of millimetres?");
  expect_refused("bump,height_error_um\n1,1e-5\n2,0\n3,-2e-6\n4,0\n",
                 "and all others are less than 0.1 um from the nominal height; metres in a column of micrometres?");
  expect_refused("bump,height_error_mm\n1,1e-5\n2,0\n3,-2e-6\n4,0\n", "metres in a column of millimetres?");
  expect_refused("height_error_um\n0.012\n0.05\n-0.02\n0\n", "millimetres in a column of micrometres?");
  expect_refused("height_error_nm\n12\n50\n-20\n0\n", "micrometres in a column of nanometres? Errors this small");
  EXPECT_EQ(read("height_error_um\n0\n0\n0\n0\n"), std::vector<double>(4, 0.0));
  EXPECT_NEAR(read("height_error_nm\n120\n0\n0\n0\n")[0], 120e-9, 1e-20);
}

TEST_F(HeightErrorsCsv, MayBeHeightsThatAreAsTheyShouldBe) {
  EXPECT_NEAR(read("height_mm\n0.5\n0.5\n0.5\n0.5\n")[0], 0.0, 1e-15);
  EXPECT_NEAR(read("height_mm\n0.50002\n0.5\n0.5\n0.5\n")[0], 20e-9, 1e-15);
  expect_refused("height_um\n0.5\n0.5\n0.5\n0.5\n", "millimetres in a column of micrometres?");
  expect_refused("height_mm\n0.0005\n0.0005\n0.0005\n0.0005\n", "metres in a column of millimetres?");
}

TEST_F(HeightErrorsCsv, TellMissingBumpsAtOnce) {
  expect_refused("bump,height_error_um\n1,1\n", "lacks bumps 2 to 4");
  expect_refused("bump,height_error_um\n2,1\n4,1\n", "lacks bumps 1 and 3");
}

}  // namespace
}  // namespace bumpfoil
