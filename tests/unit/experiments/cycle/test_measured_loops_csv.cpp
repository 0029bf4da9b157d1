#include "experiments/cycle/measured_loops_csv.hpp"

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

  std::string refusal(const std::string& text, const std::string& columns = "", const std::string& at = "") {
    try {
      read_measured_loops(folder_.write("loop.csv", text), "direction", parse_measured_columns(columns), at);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "";
  }

  test_support::TemporaryFolder folder_;
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
    ASSERT_EQ(loops[0].cycle.points.size(), 3U) << text;
    EXPECT_NEAR(loops[0].cycle.points[1].displacement, 10e-6, 1e-18) << text;
    EXPECT_NEAR(loops[0].cycle.points[1].force, 5.5, 1e-12) << text;
  }
}

TEST_F(MeasuredLoopsCsv, TellLoopsApart) {
  const std::vector<MeasuredLoop> loops =
      read("direction,displacement_um,force_N\n+X,0,0\n-Y,0,1\n+X,10,5\n+X,0,0\n-Y,8,3\n-Y,0,0\n");
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].at, 0.0);
  EXPECT_EQ(loops[1].at, 270.0);
  EXPECT_EQ(loops[1].cycle.points[1].force, 3.0);
  EXPECT_EQ(read("direction_deg,displacement_um,force_N\n37.5,0,0\n37.5,1,1\n37.5,0,0\n")[0].at, 37.5);
  EXPECT_EQ(read("cycle,displacement_um,force_N\n3,0,0\n3,1,1\n3,0,0\n", "cycle")[0].at, 3.0);
}

TEST_F(MeasuredLoopsCsv, UnderstandTheNamesThatRigsGive) {
  for (const char* header :
       {"Time (s),Displacement (mm),Force (N)", "s,disp_mm,F_N", "t,Weg [mm],Kraft [N]", "no,TRAVEL (MM),LOAD (N)",
        "t,Stroke in mm,Load Cell (N)", "t,Verschiebung (mm),Last_N", "t,Position [mm],F [N]",
        "Position (inch),Displacement (mm),Force (N)", "t,Deflection mm,Load N"}) {
    const std::vector<MeasuredLoop> loops = read(std::string(header) + "\n0,0,0\n1,0.01,5.5\n2,0.002,0\n");
    ASSERT_EQ(loops.size(), 1U) << header;
    EXPECT_NEAR(loops[0].cycle.points[1].displacement, 10e-6, 1e-18) << header;
    EXPECT_NEAR(loops[0].cycle.points[1].force, 5.5, 1e-12) << header;
  }
}

TEST_F(MeasuredLoopsCsv, AreReadFromTheColumnsThatAreNamed) {
  const std::string points = "\n0;0;0;+Y\n1;0,01;5,5;+Y\n2;0,002;0;+Y\n";
  for (const auto& [header, columns] : std::vector<std::pair<std::string, std::string>>{
           {"t;s [mm];Load (N);axis", "displacement=\"s [mm]\",force=\"Load (N)\",direction=axis"},
           {"t;s [mm];Channel 3;axis", "displacement=s,force=Channel 3 [N], direction=axis"},
           {"t;\"s, corrected\";Force A (N);axis", "direction=axis,displacement=s, corrected [mm],force=Force A"}}) {
    const auto loops =
        read_measured_loops(folder_.write("loop.csv", header + points), "direction", parse_measured_columns(columns));
    ASSERT_EQ(loops.size(), 1U) << header;
    EXPECT_EQ(loops[0].at, 90.0) << header;
    EXPECT_NEAR(loops[0].cycle.points[1].displacement, 10e-6, 1e-18) << header;
    EXPECT_NEAR(loops[0].cycle.points[1].force, 5.5, 1e-12) << header;
  }
  const std::string header = "displacement_mm,Force (N),Force (kN)\n0,0,0\n1,1,1\n0,0,0\n";
  EXPECT_NE(refusal(header).find("has 2 columns of the force; specify which one: --columns 'force=NAME [N]'"),
            std::string::npos)
      << refusal(header);
  EXPECT_EQ(
      read_measured_loops(folder_.write("loop.csv", header), "direction", parse_measured_columns("force=Force (kN)"))[0]
          .cycle.points[1]
          .force,
      1e3);
  EXPECT_NE(
      refusal("a,b\n0,0\n", "displacement=c").find("has no c among its 2 columns, separated by commas: \"a\", \"b\""),
      std::string::npos);
  EXPECT_NE(refusal("a,b\n0,0\n", "weg=c").find("write displacement=NAME,force=NAME,direction=NAME"),
            std::string::npos);
}

TEST_F(MeasuredLoopsCsv, AreOfTheDirectionThatIsGivenWithTheFile) {
  const std::string text = "displacement_um,force_N\n0,0\n1,1\n0,0\n";
  EXPECT_EQ(read_measured_loops(folder_.write("loop.csv", text), "direction", {}, "-X")[0].at, 180.0);
  EXPECT_EQ(read_measured_loops(folder_.write("loop.csv", text), "cycle", {}, "2")[0].at, 2.0);
  const std::string commas = "displacement_um;force_N\n0;0\n1,5;1,5\n0;0\n";
  EXPECT_EQ(read_measured_loops(folder_.write("loop.csv", commas), "direction", {}, "37.5")[0].at, 37.5);
  EXPECT_NE(refusal(text, "", "up").find("is assigned to the direction up, which does not exist; write +X, -X, +Y, -Y"),
            std::string::npos)
      << refusal(text, "", "up");
  EXPECT_NE(refusal("direction," + text, "", "-X").find("has a column direction"), std::string::npos);
}

TEST_F(MeasuredLoopsCsv, TellEveryErrorWithItsLine) {
  const std::string errors = refusal("direction;displacement_um;force_N\n+X;0\n+X;a;1\nup;0;1\n");
  for (const char* error :
       {"loop.csv:2: line = +X;0: has 2 columns, separated by semicolons, and the header 3",
        "loop.csv:3: line = +X;a;1: has no finite number for the displacement",
        "loop.csv:4: line = up;0;1: has no direction", "write +X, -X, +Y, -Y or an angle in degrees"}) {
    EXPECT_NE(errors.find(error), std::string::npos) << errors;
  }
  const std::string unknown = refusal("x,force_N\n0,1\n");
  for (const char* part : {"has no displacement_um among its 2 columns, separated by commas: \"x\", \"force_N\"",
                           "displacement, disp, deflection", "--columns 'displacement=NAME [um]'"}) {
    EXPECT_NE(unknown.find(part), std::string::npos) << unknown;
  }
  EXPECT_NE(refusal("x,Kraft\n0,1\n").find("say its unit: Kraft_N"), std::string::npos);
  EXPECT_NE(refusal("displacement_um,force_N\n0,0\n1,1\n").find("does not go to a displacement and back"),
            std::string::npos);
  EXPECT_NE(refusal("").find("contains no loop"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
