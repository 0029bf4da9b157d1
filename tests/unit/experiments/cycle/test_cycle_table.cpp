#include "bumpfoil/experiments/cycle/cycle_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/path/path.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

CycleResult short_run(int directions) {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.steps = 2;
  cycle.directions.clear();
  for (int i = 0; i < directions; ++i) cycle.directions.push_back(i * std::numbers::pi / 8.0);
  return run_cycles(input);
}

/// A cycle that ended before its first increment.
Cycle ended_row(Status status) {
  Cycle cycle;
  cycle.status = status;
  return cycle;
}

/// The last word of the line that starts with `name`.
std::string last_cell(const std::string& text, const std::string& name) {
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with(name)) return line.substr(line.rfind(' ') + 1);
  }
  ADD_FAILURE() << "no line " << name;
  return {};
}

TEST(CycleTable, FitsATerminalAndIsAligned) {
  const std::vector<std::string> lines = lines_of(cycle_table(reference_case(), short_run(6)));
  ASSERT_GT(lines.size(), 15U);
  for (const std::string& line : lines) {
    EXPECT_LE(line.size(), 120U);
    EXPECT_EQ(line.size(), lines[0].size()) << line;
  }
}

TEST(CycleTable, BreaksIntoBlocksOfSixDirections) {
  const std::string text = cycle_table(reference_case(), short_run(8));
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const auto& line) { return line.starts_with("direction"); }),
            2);
  EXPECT_NE(text.find("+X"), std::string::npos);
  EXPECT_NE(text.find("22.5 deg"), std::string::npos);
  EXPECT_NE(text.find("157.5 deg"), std::string::npos);
}

TEST(CycleTable, ShowsNumbersInTheUnitsItNames) {
  CycleResult result = short_run(1);
  Cycle& cycle = result.cycles[0];
  cycle.turning_point->max_force = 739.5719;
  cycle.loaded_stiffness = 15.8754e6;
  cycle.secant_stiffness = 9.30279e6;
  cycle.loop_energy = 4.73761e-3;
  cycle.clearances = {{.force = 5.0, .displacement = 33.2625e-6}, {.force = 10.0, .displacement = {}}};
  cycle.loss_factor = 0.0598763;
  cycle.turning_point->bump_loads.setZero();
  cycle.turning_point->bump_loads[12] = 138.624;
  const std::string text = cycle_table(reference_case(), result);
  EXPECT_EQ(last_cell(text, "maximum force"), "739.57");
  EXPECT_EQ(last_cell(text, "structural stiffness"), "15.875");
  EXPECT_EQ(last_cell(text, "secant with free travel"), "9.3028");
  EXPECT_EQ(last_cell(text, "loop energy"), "4.7376");
  EXPECT_EQ(last_cell(text, "loss factor"), "0.059876");
  EXPECT_EQ(last_cell(text, "clearance at 5 N"), "33.263");
  EXPECT_EQ(last_cell(text, "clearance at 10 N"), "-");
  EXPECT_EQ(last_cell(text, "maximum bump load"), "138.62");
  EXPECT_EQ(last_cell(text, "  on bump"), "13");
  EXPECT_EQ(last_cell(text, "converged"), "yes");
}

TEST(CycleTable, HasUnitsWhereThereAreValues) {
  CycleResult result = short_run(2);
  for (Cycle& cycle : result.cycles) cycle.loop_energy.reset();
  result.cycles[0].secant_stiffness.reset();
  for (const std::string& line : lines_of(cycle_table(reference_case(), result))) {
    // The truss has no stress of the bump foil.
    if (line.starts_with("loop energy") || line.starts_with("maximum stress, bump foil")) {
      EXPECT_EQ(line.find_first_not_of(' ', line.find("  ")), line.find('-')) << line;
    }
    if (line.starts_with("secant with free travel")) {
      EXPECT_NE(line.find("MN/m"), std::string::npos) << line;
    }
  }
}

TEST(CycleTable, OfAPathHasTheHighestForceOfEachPad) {
  Case input = reference_case();
  input.bump_foil.bumps = 7;
  input.bearing.radial_clearance = -2e-6;
  input.pads.resize(2);
  input.settings.set(PathSettings{}).points.values = {{0.0, 0.0}, {5e-6, 0.0}, {2e-6, 0.0}};
  const CycleResult result = run_path(input);
  const FoilFields& fields = result.cycles[0].fields;
  const std::string text = cycle_table(input, result);
  for (const Eigen::Index pad : {0, 1}) {
    double highest = 0.0;
    for (Eigen::Index i = 0; i < fields.increments(); ++i) {
      highest = std::max(highest, std::hypot(fields.pad_force_x(i, pad), fields.pad_force_y(i, pad)));
    }
    ASSERT_GT(highest, 1.0);
    EXPECT_EQ(last_cell(text, fmt::format("maximum force of pad {}", pad + 1)), number_text(highest, 1.0));
    EXPECT_NEAR(largest_pad_forces(fields)[pad], highest, 1e-12 * highest);
  }
}

TEST(CycleTable, TellsPadsApart) {
  Case input = reference_case();
  input.bump_foil.bumps = 7;
  input.bearing.radial_clearance = -2e-6;
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.steps = 2;
  cycle.amplitude.value = 30e-6;
  cycle.directions = {0.0};
  input.bearing.weld_angle = -0.5 * std::numbers::pi;
  input.pads.resize(2);  // about -X and about X
  const CycleResult result = run_cycles(input);
  const std::string text = cycle_table(input, result);
  const TurningPoint& turn = result.cycles[0].turning_point.value();
  EXPECT_EQ(last_cell(text, "force of pad 2"),
            number_text(std::hypot(turn.pad_forces_x[1], turn.pad_forces_y[1]), 1.0));
  EXPECT_NE(text.find("of pad 2"), std::string::npos);
  EXPECT_EQ(text.find("of pad 3"), std::string::npos);
  EXPECT_NE(text.find(" weld of pad 2\n"), std::string::npos);  // any width
  EXPECT_EQ(last_cell(text, "  on bump"), "2");
  const StressPeak at_weld{.stress = 1e6, .place = StressPlace::weld, .pad = 1};
  EXPECT_EQ(place_text(input, at_weld), "weld of pad 2");
  EXPECT_EQ(place_text(reference_case(), at_weld), "weld");
  const StressPeak at_crest{.stress = 1e6, .place = StressPlace::crest, .bump = 7 + 2};
  EXPECT_EQ(place_text(input, at_crest), "crest 3 of pad 2");
  EXPECT_EQ(pad_of(input, at_crest), 1U);
  EXPECT_EQ(pad_of(reference_case(), at_crest), std::nullopt);
  EXPECT_EQ(cycle_table(reference_case(), short_run(1)).find("pad"), std::string::npos);
}

TEST(CycleTable, NamesThePlaceOfTheHighestStress) {
  CycleResult result = short_run(1);
  result.cycles[0].top_foil_stress =
      StressPeak{.stress = 421.4321e6, .place = StressPlace::weld, .bump = -1, .increment = 2, .displacement = 1e-6};
  result.cycles[0].bump_foil_stress =
      StressPeak{.stress = 1004.3e6, .place = StressPlace::foot, .bump = 2, .increment = 1, .displacement = 1e-6};
  const std::string text = cycle_table(reference_case(), result);
  EXPECT_EQ(last_cell(text, "maximum stress, top foil"), "421.43");
  EXPECT_EQ(last_cell(text, "  at"), "weld");
  EXPECT_NE(text.find("foot 3"), std::string::npos);
}

TEST(CycleTable, OfAStripShowsTheFirstAndTheLastCycles) {
  Case input = reference_case();
  input.settings.set(StripSettings{.bumps = 3, .amplitude = {Control::displacement, 20e-6}, .cycles = 9, .steps = 2});
  const CycleResult result = run_strip(input);
  const std::string text = cycle_table(input, result);
  std::istringstream heads(lines_of(text).at(0));
  EXPECT_EQ(
      (std::vector<std::string>{std::istream_iterator<std::string>(heads), {}}),
      (std::vector<std::string>{"cycle", "1", "cycle", "2", "cycle", "3", "cycle", "7", "cycle", "8", "cycle", "9"}));
  EXPECT_EQ(last_cell(text, "amplitude"), "20.000");
  EXPECT_EQ(text.find("clearance"), std::string::npos);
  EXPECT_EQ(text.find("cross force"), std::string::npos);
}

TEST(CycleTable, DashesStandForWhatIsNotKnown) {
  const std::string text =
      cycle_table(reference_case(), {.solver = SolverName::newton, .cycles = {ended_row(Status::no_modes)}});
  for (const char* name : {"maximum force", "force at the start", "maximum bump load", "  on bump", "loss factor"}) {
    EXPECT_EQ(last_cell(text, name), "-");
  }
  EXPECT_EQ(last_cell(text, "converged"), "no");
}

}  // namespace
}  // namespace bumpfoil
