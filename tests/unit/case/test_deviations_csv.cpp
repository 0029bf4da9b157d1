#include "case/deviations_csv.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class DeviationsCsv : public ::testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    try {
      read_deviations(folder_.write("measured.csv", text));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  test_support::TemporaryFolder folder_;
};

TEST_F(DeviationsCsv, HoldsANumberInEachLine) {
  EXPECT_EQ(read_deviations(folder_.write("measured.csv", "deviation\n1e-6\r\n\n -2e-6 \n0")),
            (std::vector<double>{1e-6, -2e-6, 0.0}));
}

TEST_F(DeviationsCsv, TellsEveryErrorWithItsLine) {
  const std::string errors = refusal("deviations\n1e-6\n5 um\ninf\n");
  for (const char* line :
       {"measured.csv:1: line = deviations: is not a header", "measured.csv:3: line = 5 um: is not a finite",
        "measured.csv:4: line = inf: is not a finite"}) {
    EXPECT_NE(errors.find(line), std::string::npos) << errors;
  }
  EXPECT_NE(refusal("deviation\n").find("contains no deviations"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
