#include "bumpfoil/io/sweep.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/case_reader.hpp"
#include "bumpfoil/io/case_writer.hpp"

namespace bumpfoil {
namespace {

using Words = std::vector<std::string>;

Sweep sweep_over(const Words& over, const Words& overrides = {}, Experiment experiment = Experiment::cycle) {
  return parse_sweep(case_template("gen1"), "case.toml",
                     {.experiment = experiment, .over = over, .overrides = overrides});
}

std::vector<Fault> faults_of(const Words& over, const Words& overrides = {},
                             Experiment experiment = Experiment::cycle) {
  try {
    static_cast<void>(sweep_over(over, overrides, experiment));
  } catch (const Error& error) {
    return error.faults();
  }
  return {};
}

TEST(Sweep, GridIsEveryCombinationTheLastKeyFastest) {
  const Sweep sweep = sweep_over({"friction.coefficient=[0.1, 0.2]", "cycle.amplitude=60 um:80 um:10 um"});
  ASSERT_EQ(sweep.cases.size(), 6U);
  EXPECT_EQ(indices_of(sweep, 4), (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(point_name(sweep, 4), "friction.coefficient=0.2, cycle.amplitude=70 um");
  EXPECT_EQ(sweep.cases[4].friction.bump_sleeve, 0.2);
  EXPECT_EQ(sweep.axes[0].name, "friction_coefficient");
  EXPECT_EQ(sweep.axes[0].unit, "1");
  EXPECT_EQ(sweep.axes[0].values, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(sweep.axes[1].title, "Cycle: Amplitude");
  EXPECT_EQ(sweep.axes[1].unit, "m");
  EXPECT_EQ(sweep.axes[1].values, (std::vector<double>{60e-6, 70e-6, 80e-6}));
}

TEST(Sweep, CasesAreThoseOfOverrides) {
  const Sweep sweep =
      sweep_over({"bump_foil.height=0.45 mm:0.55 mm:0.05 mm", "friction.coefficient=0:0.3:0.05"}, {"cycle.steps=7"});
  for (std::size_t point = 0; point < sweep.cases.size(); ++point) {
    const std::vector<std::size_t> at = indices_of(sweep, point);
    const Words overrides{"cycle.steps=7", "bump_foil.height=" + sweep.axes[0].swept.values[at[0]],
                          "friction.coefficient=" + sweep.axes[1].swept.values[at[1]]};
    EXPECT_EQ(sweep.cases[point], parse_case(case_template("gen1"), "case.toml", {overrides, {"cycle"}}));
  }
}

TEST(Sweep, WholeNumbersAndAnglesAreSwept) {
  EXPECT_EQ(sweep_over({"cycle.steps=[5, 10]"}).cases[1].cycle.steps, 10);
  const Sweep turned = sweep_over({"bearing.weld_angle=0 deg:180 deg:90 deg"});
  EXPECT_EQ(turned.axes[0].unit, "rad");
  EXPECT_EQ(turned.axes[0].values[2], reference_case().bearing.weld_angle);
}

TEST(Sweep, TablesMayBeMadeByTheSweptKey) {
  const Sweep strip = sweep_over({"strip.load=20 N:60 N:20 N"}, {"strip.bumps=4"}, Experiment::strip);
  EXPECT_EQ(strip.axes[0].unit, "N");
  EXPECT_EQ(strip.axes[0].values, (std::vector<double>{20.0, 40.0, 60.0}));
}

TEST(Sweep, KeysOfTwoKindsNeedTheirUnits) {
  const Words load{"strip.load=20 N"};
  const Sweep strip = sweep_over({"strip.preload=[30 N, 0.05 kN]"}, load, Experiment::strip);
  EXPECT_EQ(strip.axes[0].unit, "N");
  EXPECT_EQ(strip.axes[0].values, (std::vector<double>{30.0, 50.0}));
  const Sweep lifted = sweep_over({"strip.preload=[10 um, 20 um]"}, {"strip.displacement=5 um"}, Experiment::strip);
  EXPECT_EQ(lifted.axes[0].unit, "m");
  EXPECT_EQ(lifted.axes[0].values, (std::vector<double>{10e-6, 20e-6}));
  ASSERT_EQ(faults_of({"strip.preload=[30, 50]"}, load, Experiment::strip).size(), 1U);
  ASSERT_EQ(faults_of({"strip.preload=[30 N, 50 um]"}, load, Experiment::strip).size(), 1U);
}

TEST(Sweep, EveryWrongOptionIsTold) {
  const std::vector<Fault> faults =
      faults_of({"friction.coeficient=0:1:1", "bump_foil.model=[1, 2]", "cycle.steps=0:1", "bearing=[1, 2]",
                 "bump_foil.height_errors=[1, 2]", "friction.coefficient=[0.1]", "friction.coefficient=[0.2]"},
                {"friction.coefficient=0"});
  ASSERT_EQ(faults.size(), 7U);
  EXPECT_EQ(faults[0].advice, "did you mean \"friction.coefficient\"?");
  EXPECT_EQ(faults[1].what, "holds no number");
  EXPECT_EQ(faults[2].what, "is neither a range nor a list");
  EXPECT_EQ(faults[3].what, "is no known key");
  EXPECT_EQ(faults[4].what, "holds no number");
  EXPECT_EQ(faults[5].what, "is swept, and set by --set");
  EXPECT_EQ(faults[6].what, "is swept twice");
}

TEST(Sweep, SizeOfTheGridIsToldBeforeItIsMade) {
  const std::vector<Fault> faults = faults_of({"friction.coefficient=0:1:0.001", "cycle.steps=1:1000:1"});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].what, "make a grid of 1001000 points");
  EXPECT_EQ(faults[0].advice, "a sweep takes at most 10000");
}

TEST(Sweep, FaultsOfPointsNameTheFirstAndCountTheOthers) {
  const std::vector<Fault> faults =
      faults_of({"friction.coefficient=-0.1:0.1:0.1", "cycle.amplitude=[60 um, 70 um, 50 N]"}, {"cycle.stepz=3"});
  ASSERT_EQ(faults.size(), 3U);
  // Of every point: it has nothing to do with the sweep.
  EXPECT_EQ(faults[0].key, "cycle.stepz");
  EXPECT_EQ(faults[0].file, "--set");
  EXPECT_EQ(faults[0].what, "is no known key");
  EXPECT_EQ(faults[1].key.substr(0, 9), "friction.");
  EXPECT_EQ(faults[1].value, "-0.1");
  EXPECT_NE(faults[1].what.find(" (at friction.coefficient=-0.1, cycle.amplitude=60 um and 2 more points)"),
            std::string::npos)
      << faults[1].what;
  EXPECT_EQ(faults[2].file, "--over");
  EXPECT_EQ(faults[2].key, "cycle.amplitude");
  EXPECT_NE(faults[2].what.find("(at friction.coefficient=-0.1, cycle.amplitude=50 N and 2 more points)"),
            std::string::npos)
      << faults[2].what;
}

TEST(Sweep, ValuesThatAreTheSameAreRefused) {
  const std::vector<Fault> faults = faults_of({"bump_foil.height=[0.5 mm, 0.51 mm, 500 um]"});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].value, "500 um");
  EXPECT_EQ(faults[0].what, "is the same value as 0.5 mm");
}

CycleResult result_of(const Sweep& sweep, std::size_t point) {
  return run_cycles(sweep.cases[point]);
}

TEST(Sweep, PointKeepsQuantitiesAndLoops) {
  const Sweep sweep = sweep_over({"friction.coefficient=[0.1]"}, {"cycle.steps=3"});
  const CycleResult whole = result_of(sweep, 0);
  const SweepPoint point = sweep_point(whole, true);
  EXPECT_EQ(point.status, RunStatus::complete);
  ASSERT_EQ(point.loops.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(point.result.cycles[i].loss_factor, whole.cycles[i].loss_factor);
    EXPECT_EQ(point.result.cycles[i].fields.increments(), 0);
    ASSERT_EQ(point.loops[i].force_direct.size(), 7U);
    EXPECT_EQ(point.loops[i].force_direct[3], whole.cycles[i].increments[3].force_direct);
    EXPECT_EQ(point.loops[i].displacement[3], whole.cycles[i].increments[3].displacement);
  }
  EXPECT_TRUE(sweep_point(whole, false).loops.empty());
}

TEST(Sweep, PointThatWasStoppedBetweenCyclesIsInterrupted) {
  const Sweep sweep = sweep_over({"friction.coefficient=[0.1]"}, {"cycle.steps=3"});
  CycleResult result = result_of(sweep, 0);
  result.cycles.pop_back();
  EXPECT_EQ(sweep_point(result, true).status, RunStatus::interrupted);
  result.cycles.back().status = Status::no_modes;
  EXPECT_EQ(sweep_point(result, true).status, RunStatus::failed);
  EXPECT_EQ(status_of({SweepPoint{.result = {}, .status = RunStatus::complete, .loops = {}},
                       SweepPoint{.result = {}, .status = RunStatus::failed, .loops = {}}}),
            RunStatus::failed);
}

TEST(Sweep, LoopsAreKeptAsLongAsTheyAreFew) {
  // Two hundred points, four directions, 2 n + 1 increments.
  const Words over{"friction.coefficient=0.001:0.2:0.001"};
  EXPECT_TRUE(keeps_loops(sweep_over(over, {"cycle.steps=2499"})));
  EXPECT_FALSE(keeps_loops(sweep_over(over, {"cycle.steps=2500"})));
}

}  // namespace
}  // namespace bumpfoil
