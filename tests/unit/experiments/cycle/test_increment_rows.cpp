#include "bumpfoil/experiments/cycle/increment_rows.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

CycleResult tabulated_run() {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0, 1.0};
  cycle.steps = 3;
  return run_cycles(input);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

TEST(IncrementRows, HasOneLinePerDirectionAndIncrement) {
  const std::vector<std::string> lines = split(csv_text(increment_rows(tabulated_run())), '\n');
  ASSERT_EQ(lines.size(), 1U + 2U * 7U);
  EXPECT_EQ(lines[0],
            "direction_deg,increment,branch,displacement_m,x_m,y_m,force_x_N,force_y_N,force_direct_N,force_cross_N,"
            "elastic_energy_J,dissipated_energy_J,work_J,residual,iterations,substeps,status");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], ',');
    ASSERT_EQ(cells.size(), 17U);
    EXPECT_EQ(cells[1], std::to_string((i - 1) % 7));
    EXPECT_EQ(cells[2], (i - 1) % 7 <= 3 ? "loading" : "unloading");
    EXPECT_EQ(cells[16], "converged");
  }
}

TEST(IncrementRows, NumbersReadBackToTheLastBit) {
  const CycleResult result = tabulated_run();
  const std::vector<std::string> cells = split(split(csv_text(increment_rows(result)), '\n')[1 + 7 + 3], ',');
  const Increment& increment = result.cycles[1].increments[3];
  EXPECT_EQ(std::stod(cells[3]), increment.displacement);
  EXPECT_EQ(std::stod(cells[4]), increment.x);
  EXPECT_EQ(std::stod(cells[5]), increment.y);
  EXPECT_EQ(std::stod(cells[6]), increment.force_x);
  EXPECT_EQ(std::stod(cells[7]), increment.force_y);
  EXPECT_EQ(std::stod(cells[8]), increment.force_direct);
  EXPECT_EQ(std::stod(cells[9]), increment.force_cross);
  EXPECT_EQ(std::stod(cells[10]), increment.elastic_energy);
  EXPECT_EQ(std::stod(cells[11]), increment.dissipated_energy);
  EXPECT_EQ(std::stod(cells[12]), increment.work);
  EXPECT_EQ(std::stod(cells[13]), increment.residuals.equilibrium);
  EXPECT_EQ(std::stoi(cells[14]), increment.cost.iterations);
  EXPECT_EQ(std::stoi(cells[15]), increment.substeps);
}

TEST(IncrementRows, LeavesOutWhatIsNotFinite) {
  CycleResult result = tabulated_run();
  result.cycles[0].increments[0].force_x = std::numeric_limits<double>::quiet_NaN();
  const std::string text = csv_text(increment_rows(result));
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(split(split(text, '\n')[1], ',')[6], "");
}

TEST(IncrementRows, AFailedIncrementHasItsPlaceAndStatusButNoNumbers) {
  const CycleResult result = failed_at_increment_three(tabulated_run());
  const std::vector<std::string> lines = split(csv_text(increment_rows(result)), '\n');
  ASSERT_EQ(lines.size(), 1U + 4U);
  const std::vector<std::string> cells = split(lines[4], ',');
  EXPECT_EQ(cells[1], "3");
  EXPECT_EQ(std::stod(cells[3]), result.cycles[0].increments[3].displacement);
  for (int column = 6; column <= 13; ++column) EXPECT_EQ(cells[static_cast<std::size_t>(column)], "");
  EXPECT_EQ(cells[16], name_of(result.cycles[0].status));
}

}  // namespace
}  // namespace bumpfoil
