#include "bumpfoil/sweep/sweep_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/case/case_writer.hpp"
#include "experiments/cycle/cycle_outcome.hpp"

namespace bumpfoil {
namespace {

Sweep tabulated_sweep(const std::vector<std::string>& over) {
  return parse_sweep(case_template("gen1"), "case.toml",
                     {.command = "cycle", .over = over, .overrides = {"cycle.directions=[\"+X\", \"-X\"]"}});
}

/// A result whose cycles have only this force at full displacement, N.
CycleResult result_of(double force, std::size_t cycles) {
  CycleResult result;
  result.due = cycles;
  for (std::size_t i = 0; i < cycles; ++i) {
    Cycle& cycle = result.cycles.emplace_back();
    cycle.direction = i == 0 ? 0.0 : 3.14159265358979323846;
    cycle.turning_point.emplace().max_force = force + static_cast<double>(i);
  }
  return result;
}

/// Points with these results; those without were not started.
std::vector<SweepPoint> points_of(const Sweep& sweep, const std::vector<std::optional<CycleResult>>& results) {
  std::vector<SweepPoint> points(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i]) points[i] = sweep_point(sweep, cycle_outcome(sweep.cases[i], *results[i]));
  }
  complete(sweep, points);
  return points;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(SweepTable, ValuesOfOneKeyStandDownAndQuantitiesAcross) {
  const Sweep sweep = tabulated_sweep({"cycle.amplitude=[60 um, 65 um, 70 um]"});
  CycleResult failed = result_of(200.0, 2);
  failed.cycles[1].status = Status::no_modes;
  const std::string table = sweep_table(sweep, points_of(sweep, {result_of(100.0, 2), failed, {}}));
  EXPECT_EQ(table,
            "direction +X\n"
            "                 maximum  structural\n"
            "cycle.amplitude    force   stiffness  loop energy  loss factor       status\n"
            "                       N\n"
            "60 um             100.00           -            -            -    converged\n"
            "65 um             200.00           -            -            -    converged\n"
            "70 um                  -           -            -            -  interrupted\n"
            "\n"
            "direction -X\n"
            "                 maximum  structural\n"
            "cycle.amplitude    force   stiffness  loop energy  loss factor       status\n"
            "                       N\n"
            "60 um             101.00           -            -            -    converged\n"
            "65 um             201.00           -            -            -     no_modes\n"
            "70 um                  -           -            -            -  interrupted\n");
}

TEST(SweepTable, GridsShowTheirExtremes) {
  const Sweep sweep = tabulated_sweep({"cycle.amplitude=[60 um, 70 um]", "friction.coefficient=[0, 0.1]"});
  const std::vector<SweepPoint> points =
      points_of(sweep, {result_of(300.0, 1), result_of(100.0, 1), {}, result_of(200.0, 1)});
  const std::string table = sweep_table(sweep, points);
  EXPECT_EQ(table.find("direction +X\nmaximum force (N)"), 0U) << table;
  EXPECT_TRUE(has(table, "smallest       100.00  at cycle.amplitude=60 um, friction.coefficient=0.1\n")) << table;
  EXPECT_TRUE(has(table, "largest        300.00  at cycle.amplitude=60 um, friction.coefficient=0\n")) << table;
  EXPECT_FALSE(has(table, "direction -X"));  // not started
}

TEST(SweepTable, ManyValuesShowTheirExtremes) {
  const Sweep sweep = tabulated_sweep({"friction.coefficient=0.01:0.51:0.01"});
  const std::vector<SweepPoint> points =
      points_of(sweep, std::vector<std::optional<CycleResult>>(51, result_of(100.0, 2)));
  const std::string table = sweep_table(sweep, points);
  EXPECT_LT(std::count(table.begin(), table.end(), '\n'), 25);
  EXPECT_TRUE(has(table, "at friction.coefficient=0.01\n"));
}

TEST(SweepTable, FailuresAndWarningsNameTheirPoint) {
  const Sweep sweep = tabulated_sweep({"friction.coefficient=[0, 0.1]"});
  CycleResult first = result_of(100.0, 2);
  first.cycles[0].compression = CompressionPeak{.compression = 300e-6, .bump = 2};
  CycleResult second = result_of(100.0, 2);
  Cycle& failed = second.cycles[1];
  failed.status = Status::no_modes;
  failed.due = 201;
  failed.increments.emplace_back();
  failed.increments.back().index = 37;
  failed.increments.back().status = Status::no_modes;
  const std::vector<SweepPoint> points = points_of(sweep, {first, second});
  const std::vector<std::string> failures = failure_lines(sweep, points);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].find("friction.coefficient=0.1: -X, increment 37 of 200, "), 0U) << failures[0];
  const std::vector<std::string> warnings = warning_lines(sweep, points);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].find("friction.coefficient=0: +X: bump 3 is compressed"), 0U) << warnings[0];
}

TEST(SweepTable, VibrationsHaveABlockEach) {
  const Sweep sweep =
      parse_sweep(case_template("gen1"), "case.toml",
                  {.command = "vibration",
                   .over = {"friction.coefficient=[0, 0.1]"},
                   .overrides = {"vibration.loads=[[0, -50]]", "vibration.directions=[\"+X\", \"+Y\"]",
                                 "vibration.amplitudes=[1e-6]", "vibration.frequencies=[1000]", "vibration.steps=4"}});
  std::vector<SweepPoint> points(2);
  points[1] = run_point(sweep, 1);
  complete(sweep, points);
  const std::string table = sweep_table(sweep, points);
  const std::string head =
      "friction.coefficient  stiffness     loss  residual  loss factor       status\n"
      "                           MN/m     MN/m\n"
      "0 ";
  EXPECT_EQ(table.find("load (0, -50) N, 0 deg, 1 um\n" + head), 0U) << table;
  EXPECT_TRUE(has(table, "\n\nload (0, -50) N, 90 deg, 1 um\nfriction.coefficient  stiffness ")) << table;
  EXPECT_TRUE(has(table, "  -  interrupted\n0.1  ")) << table;
}

}  // namespace
}  // namespace bumpfoil
