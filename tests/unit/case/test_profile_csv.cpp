#include "case/profile_csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class ProfileFile : public ::testing::Test {
 protected:
  std::vector<double> read(const std::string& text) { return read_profile(folder_.write("profile.csv", text)); }

  std::string refusal(const std::string& text) {
    try {
      (void)read(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return {};
  }

 private:
  test_support::TemporaryFolder folder_;
};

TEST_F(ProfileFile, HasALineForEachOfEqualAngles) {
  const std::vector<double> expected{1.5 * 1e-6, -2.0 * 1e-6, 0.0};
  EXPECT_EQ(read("deviation_um\n1.5\n-2\n0\n"), expected);
  EXPECT_EQ(read("# of an instrument\nangle_deg;deviation_um;note\n0;1,5;a\n120,01;-2;b\n\n239,99;0;c\n"), expected);
}

TEST_F(ProfileFile, SaysWhatIsWrongAndWhere) {
  EXPECT_NE(refusal("angle_deg,radius_um\n0,1\n")
                .find("profile.csv:1: line = angle_deg,radius_um: has no column of "
                      "deviations among its 2 columns, separated by commas"),
            std::string::npos);
  EXPECT_NE(refusal("deviation_um,deviation_mm\n0,1\n").find("has 2 columns of deviations"), std::string::npos);
  const std::string lines = refusal("deviation_um,angle_deg\n1\nx,0\n");
  EXPECT_NE(lines.find("profile.csv:2: line = 1: has 1 column,"), std::string::npos) << lines;
  EXPECT_NE(lines.find("profile.csv:3: line = x,0: has no finite number for the deviation"), std::string::npos)
      << lines;
  EXPECT_NE(refusal("deviation_um\n").find("contains no deviations"), std::string::npos);
  EXPECT_NE(refusal("").find("contains no deviations"), std::string::npos);
}

TEST_F(ProfileFile, WantsEqualAnglesOfOneTurn) {
  // Closed at 360 degrees.
  const std::string closed = refusal("angle_deg,deviation_um\n0,1\n90,1\n180,1\n270,1\n360,1\n");
  EXPECT_NE(closed.find("profile.csv:3: line = 90,1: should be 72 degrees: 5 lines are 72 degrees apart"),
            std::string::npos)
      << closed;
  EXPECT_NE(refusal("angle_deg,deviation_um\n90,1\n180,1\n270,1\n0,1\n").find("profile.csv:2"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
