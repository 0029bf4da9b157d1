#include "case/path_csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class PathCsv : public ::testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    try {
      read_path(folder_.write("path.csv", text));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  test_support::TemporaryFolder folder_;
};

TEST_F(PathCsv, HoldsPositionsOrLoads) {
  EXPECT_EQ(read_path(folder_.write("path.csv", "x_m,y_m\n0,-4e-5\r\n\n 1e-5 , -4e-5\n")),
            (PathPoints{Control::displacement, {{0.0, -4e-5}, {1e-5, -4e-5}}}));
  EXPECT_EQ(read_path(folder_.write("path.csv", "force_x_N, force_y_N\n0,-50")),
            (PathPoints{Control::load, {{0.0, -50.0}}}));
}

TEST_F(PathCsv, TellsEveryErrorWithItsLine) {
  const std::string errors = refusal("x_m,y_m\n0\n1e-5,2e-5\nnan,0\n1,2,3\n");
  for (const char* line :
       {"path.csv:2: line = 0: does not have two columns", "path.csv:4: line = nan,0: is not two finite",
        "path.csv:5: line = 1,2,3: does not have two columns"}) {
    EXPECT_NE(errors.find(line), std::string::npos) << errors;
  }
  EXPECT_NE(refusal("x,y\n0,0\n").find("path.csv:1: line = x,y: is not a header of a path"), std::string::npos);
  EXPECT_NE(refusal("x_m,y_m\n").find("contains no points"), std::string::npos);
}

/// A path with invalid points is not reported as an orbit with missing keys: only the errors of its points are
/// reported.
TEST_F(PathCsv, IsBlamedAloneForItsErrors) {
  folder_.write("wrong.csv", "x_m,y_m\n0\n");
  const std::string file = folder_.write("case.toml", case_template("gen1"));
  const auto errors = [&file](const std::string& override) {
    try {
      read_case(file, {.overrides = {override}, .commands = {"path"}});
    } catch (const Error& error) {
      return error.errors();
    }
    return std::vector<InputError>{};
  };
  for (const char* override :
       {"path.file=wrong.csv", "path.file=missing.csv", "path.file=3", "path.file=\"\"", "path.points=[[1, 2, 3]]"}) {
    EXPECT_EQ(errors(override).size(), 1U) << override;
  }
  EXPECT_EQ(errors("path.file=wrong.csv").front().line, 2U);
  EXPECT_EQ(errors("path.tilt=0").size(), 2U);  // without points
}

}  // namespace
}  // namespace bumpfoil
