#include "io/measured_loops_csv.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class MeasuredLoopsCsv : public ::testing::Test {
 protected:
  std::vector<MeasuredLoop> read(const std::string& text, const std::string& column = "direction") {
    return read_measured_loops(folder_.write("loop.csv", text), column);
  }

  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "";
  }

  testing::TemporaryFolder folder_;
};

TEST_F(MeasuredLoopsCsv, AreReadAsProgramsWriteThem) {
  for (const char* text :
       {"displacement_um,force_N\n0,0\n10,5.5\n2,0\n",
        "# rig 3\nforce_kN;t;displacement_mm\r\n0;1;0\r\n0,0055;2;0,01\n0;3;0,002\n",
        "displacement_m\tforce_mN\n0\t0\n1e-5\t5500\n2e-6\t0\n", "Displacement (um),Force (N)\n0,0\n10,5.5\n2,0\n",
        "displacement_inch,force_lbf\n0,0\n3.93700787401575e-4,1.2364491870484078\n7.874e-5,0\n"}) {
    const std::vector<MeasuredLoop> loops = read(text);
    ASSERT_EQ(loops.size(), 1U) << text;
    EXPECT_FALSE(loops[0].at);
    ASSERT_EQ(loops[0].points.size(), 3U) << text;
    EXPECT_NEAR(loops[0].points[1].displacement, 10e-6, 1e-18) << text;
    EXPECT_NEAR(loops[0].points[1].force, 5.5, 1e-12) << text;
  }
}

TEST_F(MeasuredLoopsCsv, TellLoopsApart) {
  const std::vector<MeasuredLoop> loops =
      read("direction,displacement_um,force_N\n+X,0,0\n-Y,0,1\n+X,10,5\n+X,0,0\n-Y,8,3\n-Y,0,0\n");
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].at, 0.0);
  EXPECT_EQ(loops[1].at, 270.0);
  EXPECT_EQ(loops[1].points[1].force, 3.0);
  EXPECT_EQ(read("direction_deg,displacement_um,force_N\n37.5,0,0\n37.5,1,1\n37.5,0,0\n")[0].at, 37.5);
  EXPECT_EQ(read("cycle,displacement_um,force_N\n3,0,0\n3,1,1\n3,0,0\n", "cycle")[0].at, 3.0);
}

TEST_F(MeasuredLoopsCsv, TellEveryFaultWithItsLine) {
  const std::string faults = refusal("direction;displacement_um;force_N\n+X;0\n+X;a;1\nup;0;1\n");
  for (const char* fault :
       {"loop.csv:2: line = +X;0: has 2 columns, separated by semicolons, and the header 3",
        "loop.csv:3: line = +X;a;1: has no finite number for the displacement",
        "loop.csv:4: line = up;0;1: has no direction", "write +X, -X, +Y, -Y or an angle in degrees"}) {
    EXPECT_NE(faults.find(fault), std::string::npos) << faults;
  }
  EXPECT_NE(refusal("x,force_N\n0,1\n").find("has no displacement_um among its 2 columns, separated by commas"),
            std::string::npos);
  EXPECT_NE(refusal("displacement_um,force_N\n0,0\n1,1\n").find("does not go to a displacement and back"),
            std::string::npos);
  EXPECT_NE(refusal("").find("holds no loop"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
