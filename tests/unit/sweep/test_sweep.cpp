#include "bumpfoil/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "experiments/cycle/cycle_outcome.hpp"
#include "sweep/sweep_layout.hpp"

namespace bumpfoil {
namespace {

using Words = std::vector<std::string>;

Sweep sweep_over(const Words& over, const Words& overrides = {}, const std::string& command = "cycle") {
  return parse_sweep(case_template("gen1"), "case.toml", {.command = command, .over = over, .overrides = overrides});
}

std::vector<InputError> errors_of(const Words& over, const Words& overrides = {},
                                  const std::string& command = "cycle") {
  try {
    static_cast<void>(sweep_over(over, overrides, command));
  } catch (const Error& error) {
    return error.errors();
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

/// Another process sends its completed points.
TEST(Sweep, PointsAreTheSameAsBytes) {
  SweepPoint point{.status = RunStatus::failed,
                   .dims = {"state", "step"},
                   .extents = {2, 0},
                   .variables = {"a", "b", "c"},
                   .values = {{0.1, absent}, {}, {-0.0, 1.0 / 3.0, 5e-324, 7.0}},
                   .rows = "a,b\n1,2\n",
                   .more = {"k\n"},
                   .lists = R"({"x": 1})",
                   .failures = {"one"},
                   .warnings = {"two", "three"}};
  const SweepPoint same = point_of_bytes(bytes_of(point));
  EXPECT_EQ(same.status, point.status);
  EXPECT_EQ(same.dims, point.dims);
  EXPECT_EQ(same.extents, point.extents);
  EXPECT_EQ(same.variables, point.variables);
  ASSERT_EQ(same.values.size(), 3U);
  EXPECT_EQ(same.values[0][0], 0.1);
  EXPECT_TRUE(std::isnan(same.values[0][1]));
  EXPECT_EQ(same.values[2], point.values[2]);
  EXPECT_TRUE(std::signbit(same.values[2][0]));
  EXPECT_EQ(same.rows + same.more.at(0) + same.lists, point.rows + point.more[0] + point.lists);
  EXPECT_EQ(same.failures, point.failures);
  EXPECT_EQ(same.warnings, point.warnings);
}

TEST(Sweep, SpectraHaveOneAxis) {
  const std::vector<InputError> errors = errors_of({"transient.revolutions_per_spectrum=[8, 16]"}, {}, "transient");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].what, "is the same at all points");
}

TEST(Sweep, TablesOfAListAreCounted) {
  const Sweep sweep = sweep_over({"bump_foil.shim[2].thickness=[5 um, 10 um]"},
                                 {"bump_foil.shim=[{from=1, to=2, thickness=1e-6}, {from=5, to=6, thickness=1e-6}]"});
  EXPECT_EQ(sweep.axes[0].name, "bump_foil_shim_2_thickness");
  EXPECT_EQ(sweep.axes[0].title, "Shim: Thickness");
  EXPECT_EQ(sweep.cases[1].bump_foil.shims, (std::vector<Shim>{{1, 2, 1e-6}, {5, 6, 10e-6}}));
}

/// Keys of tables with the differences of a pad or bearing from the common design.
TEST(Sweep, GoesOverKeysOfPadsAndOfBearingsOfARotor) {
  const Words rotor{"rotor.mass=2 kg", "rotor.transverse_inertia=9e-3 kg m2", "rotor.bearings=[-0.07, 0.09]",
                    "rotor.bearing=[{}, {}]", "stability.speeds=[\"12000 rpm\"]"};
  const Sweep sweep = sweep_over({"rotor.bearing[2].bearing.radial_clearance=[28 um, 30 um]"}, rotor, "stability");
  ASSERT_EQ(sweep.axes.size(), 1U);
  EXPECT_EQ(sweep.axes[0].name, "rotor_bearing_2_bearing_radial_clearance");
  EXPECT_EQ(sweep.axes[0].unit, "m");
  EXPECT_EQ(sweep.axes[0].title, "Bearing: Radial clearance");
  EXPECT_EQ(sweep.axes[0].values, (std::vector<double>{28e-6, 30e-6}));
  EXPECT_EQ(bearing_at(sweep.cases[0], 0).bearing.radial_clearance, 31.8e-6);
  EXPECT_EQ(bearing_at(sweep.cases[0], 1).bearing.radial_clearance, 28e-6);
  const Sweep pads = sweep_over({"pad[2].bump_foil.height=[0.5 mm, 0.51 mm]"}, {"bump_foil.bumps=7", "pad=[{}, {}]"});
  EXPECT_EQ(pads.cases[1].pads[1].bump_foil->height.at(0, 7), 0.51e-3);
  EXPECT_EQ(errors_of({"rotor.bearing[2].bearing.clearance=[28 um, 30 um]"}, rotor, "stability").at(0).what,
            "unknown key");
}

TEST(Sweep, WholeNumbersAndAnglesAreSwept) {
  EXPECT_EQ(sweep_over({"cycle.steps=[5, 10]"}).cases[1].settings.get<CycleSettings>().steps, 10);
  const Sweep turned = sweep_over({"bearing.weld_angle=0 deg:180 deg:90 deg"});
  EXPECT_EQ(turned.axes[0].unit, "rad");
  EXPECT_EQ(turned.axes[0].values[2], reference_case().bearing.weld_angle);
}

TEST(Sweep, TablesMayBeMadeByTheSweptKey) {
  const Sweep strip = sweep_over({"strip.load=20 N:60 N:20 N"}, {"strip.bumps=4"}, "strip");
  EXPECT_EQ(strip.axes[0].unit, "N");
  EXPECT_EQ(strip.axes[0].values, (std::vector<double>{20.0, 40.0, 60.0}));
}

TEST(Sweep, KeysOfTwoKindsNeedTheirUnits) {
  const Words load{"strip.load=20 N"};
  const Sweep strip = sweep_over({"strip.preload=[30 N, 0.05 kN]"}, load, "strip");
  EXPECT_EQ(strip.axes[0].unit, "N");
  EXPECT_EQ(strip.axes[0].values, (std::vector<double>{30.0, 50.0}));
  const Sweep lifted = sweep_over({"strip.preload=[10 um, 20 um]"}, {"strip.displacement=5 um"}, "strip");
  EXPECT_EQ(lifted.axes[0].unit, "m");
  EXPECT_EQ(lifted.axes[0].values, (std::vector<double>{10e-6, 20e-6}));
  ASSERT_EQ(errors_of({"strip.preload=[30, 50]"}, load, "strip").size(), 1U);
  ASSERT_EQ(errors_of({"strip.preload=[30 N, 50 um]"}, load, "strip").size(), 1U);
}

TEST(Sweep, EveryWrongOptionIsTold) {
  const std::vector<InputError> errors =
      errors_of({"friction.coeficient=0:1:1", "bump_foil.model=[1, 2]", "cycle.steps=0:1", "bearing=[1, 2]",
                 "bump_foil.height_errors=[1, 2]", "friction.coefficient=[0.1]", "friction.coefficient=[0.2]"},
                {"friction.coefficient=0"});
  ASSERT_EQ(errors.size(), 7U);
  EXPECT_EQ(errors[0].advice, "did you mean \"friction.coefficient\"?");
  EXPECT_EQ(errors[1].what, "is not numeric");
  EXPECT_EQ(errors[2].what, "is neither a range nor a list");
  EXPECT_EQ(errors[3].what, "unknown key");
  EXPECT_EQ(errors[4].what, "is not numeric");
  EXPECT_EQ(errors[5].what, "is swept, and set by --set");
  EXPECT_EQ(errors[6].what, "is swept twice");
}

TEST(Sweep, SuggestsTheWholeKey) {
  const std::vector<InputError> errors = errors_of({"coefficient=0:1:1", "thickness=[0.1 mm]", "frobnication=0:1:1"});
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0].advice, "did you mean \"friction.coefficient\"?");
  EXPECT_EQ(errors[1].advice, "did you mean \"bump_foil.thickness\" or \"top_foil.thickness\"?");
  EXPECT_EQ(errors[2].advice, "`bumpfoil init --keys` lists them");
}

TEST(Sweep, SizeOfTheGridIsToldBeforeItIsMade) {
  const std::vector<InputError> errors = errors_of({"friction.coefficient=0:1:0.001", "cycle.steps=1:1000:1"});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].what, "make a grid of 1001000 points");
  EXPECT_EQ(errors[0].advice, "a sweep takes at most 10000");
}

TEST(Sweep, ErrorsOfPointsNameTheFirstAndCountTheOthers) {
  const std::vector<InputError> errors =
      errors_of({"friction.coefficient=-0.1:0.1:0.1", "cycle.amplitude=[60 um, 70 um, 50 N]"}, {"cycle.stepz=3"});
  ASSERT_EQ(errors.size(), 3U);
  // It applies to every point, independent of the sweep.
  EXPECT_EQ(errors[0].key, "cycle.stepz");
  EXPECT_EQ(errors[0].file, "--set");
  EXPECT_EQ(errors[0].what, "unknown key");
  EXPECT_EQ(errors[1].key.substr(0, 9), "friction.");
  EXPECT_EQ(errors[1].value, "-0.1");
  EXPECT_NE(errors[1].what.find(" (at friction.coefficient=-0.1, cycle.amplitude=60 um and 2 more points)"),
            std::string::npos)
      << errors[1].what;
  EXPECT_EQ(errors[2].file, "--over");
  EXPECT_EQ(errors[2].key, "cycle.amplitude");
  EXPECT_NE(errors[2].what.find("(at friction.coefficient=-0.1, cycle.amplitude=50 N and 2 more points)"),
            std::string::npos)
      << errors[2].what;
}

TEST(Sweep, GoesOverDiameters) {
  const Sweep sweep = sweep_over({"bearing.diameter=38 mm:40 mm:1 mm"});
  EXPECT_EQ(sweep.axes[0].values, (std::vector<double>{38e-3, 39e-3, 40e-3}));
  EXPECT_EQ(sweep.cases[2].bearing.radius, 20e-3);
}

TEST(Sweep, ValuesThatAreTheSameAreRefused) {
  const std::vector<InputError> errors = errors_of({"bump_foil.height=[0.5 mm, 0.51 mm, 500 um]"});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].value, "500 um");
  EXPECT_EQ(errors[0].what, "is the same value as 0.5 mm");
}

/// The values of a variable stored with a point.
std::vector<double> values_of(const Sweep& sweep, const SweepPoint& point, const std::string& name) {
  const Dataset data = layout_of(sweep, {point}).dataset;
  for (std::size_t i = 0; i < data.variables.size(); ++i) {
    if (data.variables[i].meaning.name == name) return point.values[i];
  }
  return {};
}

TEST(Sweep, PointKeepsQuantitiesAndLoops) {
  Sweep sweep = sweep_over({"friction.coefficient=[0.1]"}, {"cycle.steps=3", "cycle.directions=[\"-X\", \"+Y\"]"});
  const CycleResult whole = run_cycles(sweep.cases[0]);
  const SweepPoint point = run_point(sweep, 0);
  EXPECT_EQ(point.status, RunStatus::complete);
  // Directions are sorted, unlike those of the case.
  EXPECT_EQ(values_of(sweep, point, "loss_factor"),
            (std::vector<double>{*whole.cycles[1].loss_factor, *whole.cycles[0].loss_factor}));
  const std::vector<double> forces = values_of(sweep, point, "force_direct");
  const std::vector<double> displacements = values_of(sweep, point, "displacement");
  ASSERT_EQ(forces.size(), 14U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(forces[i], whole.cycles[1].increments[i].force_direct);
    EXPECT_EQ(forces[7 + i], whole.cycles[0].increments[i].force_direct);
    EXPECT_EQ(displacements[7 + i], whole.cycles[0].increments[i].displacement);
  }
  sweep.with_loops = false;
  EXPECT_TRUE(values_of(sweep, sweep_point(sweep, cycle_outcome(sweep.cases[0], whole)), "force_direct").empty());
}

TEST(Sweep, PointThatWasStoppedBetweenCyclesIsInterrupted) {
  const Sweep sweep = sweep_over({"friction.coefficient=[0.1]"}, {"cycle.steps=3"});
  CycleResult result = run_cycles(sweep.cases[0]);
  result.cycles.pop_back();
  const SweepPoint interrupted = sweep_point(sweep, cycle_outcome(sweep.cases[0], result));
  EXPECT_EQ(interrupted.status, RunStatus::interrupted);
  result.cycles.back().status = Status::no_modes;
  const SweepPoint failed = sweep_point(sweep, cycle_outcome(sweep.cases[0], result));
  EXPECT_EQ(failed.status, RunStatus::failed);
  EXPECT_EQ(status_of({run_point(sweep, 0), failed}), RunStatus::failed);
  EXPECT_EQ(status_of({interrupted, failed}), RunStatus::interrupted);
}

TEST(Sweep, PointsThatWereNotBegunSaySo) {
  const Sweep sweep = sweep_over({"friction.coefficient=[0.1, 0.2]"}, {"cycle.steps=3"});
  std::vector<SweepPoint> points(2);
  points[0] = run_point(sweep, 0);
  complete(sweep, points);
  EXPECT_EQ(points[0].status, RunStatus::complete);
  EXPECT_EQ(points[1].status, RunStatus::interrupted);
  EXPECT_EQ(points[1].extents, points[0].extents);
  EXPECT_EQ(values_of(sweep, points[1], "converged"), std::vector<double>(4, 0.0));
  EXPECT_EQ(values_of(sweep, points[1], "status"), std::vector<double>(4, static_cast<double>(Status::interrupted)));
}

TEST(Sweep, LoopsAreKeptAsLongAsTheyAreFew) {
  // Two hundred points, four directions, 2 n + 1 increments.
  const Words over{"friction.coefficient=0.001:0.2:0.001"};
  EXPECT_TRUE(sweep_over(over, {"cycle.steps=2499"}).with_loops);
  EXPECT_FALSE(sweep_over(over, {"cycle.steps=2500"}).with_loops);
  // Two vibrations of 4 n points.
  const auto keeps = [&over](const std::string& steps) {
    return sweep_over(
               over,
               {"vibration.loads=[[\"0 N\", \"-50 N\"]]", "vibration.directions=[\"+X\", \"+Y\"]",
                "vibration.amplitudes=[\"1 um\"]", "vibration.frequencies=[\"100 Hz\"]", "vibration.steps=" + steps},
               "vibration")
        .with_loops;
  };
  EXPECT_TRUE(keeps("2500"));
  EXPECT_FALSE(keeps("2501"));
}

}  // namespace
}  // namespace bumpfoil
