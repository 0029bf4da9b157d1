// `bumpfoil sweep` from the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/running_program.hpp"

namespace bumpfoil {
namespace {

class SweepProgram : public Program {
 protected:
  [[nodiscard]] std::vector<std::string> sweep_over(const std::string& over) const {
    return {"sweep", case_path_, "--over", over, "-o", results_, "--set", "cycle.steps=4"};
  }
};

/// Without computing times.
json timeless(json cycles) {
  for (json& cycle : cycles) cycle.erase("wall_time_s");
  return cycles;
}

/// Without quantities that a sweep omits: those per bump, foot and pad.
json swept_part(json cycles) {
  for (json& cycle : cycles) {
    for (const char* each : {"bump_loads_N", "foot_loads_N", "journal_loads_N", "pad_forces_x_N", "pad_forces_y_N"}) {
      cycle.erase(each);
    }
  }
  return timeless(std::move(cycles));
}

TEST_F(SweepProgram, GivesWhatCycleGivesAtEveryPoint) {
  const ProgramOutcome sweep = run(sweep_over("friction.coefficient=0:0.5:0.05"));
  EXPECT_EQ(sweep.exit_code, 0) << sweep.errors;
  EXPECT_NE(sweep.output.find("\n0.15 "), std::string::npos) << sweep.output;
  EXPECT_NE(sweep.output.find("11 points; results in " + results_ + " (summary.json, sweep.csv, sweep.nc)\n"),
            std::string::npos);
  EXPECT_EQ(names_in("results"), (std::set<std::string>{"summary.json", "sweep.csv", "sweep.nc"}));
  const json swept = summary();
  EXPECT_EQ(swept.at("status"), "complete");
  ASSERT_EQ(swept.at("points").size(), 11U);

  const std::string alone = (folder_.path() / "alone").string();
  ASSERT_EQ(
      run({"cycle", case_path_, "-o", alone, "--set", "cycle.steps=4", "--set", "friction.coefficient=0.15"}).exit_code,
      0);
  const json cycles = json::parse(folder_.read("alone/summary.json")).at("cycles");
  // All digits: numbers in JSON read back to the last bit.
  EXPECT_EQ(timeless(swept.at("points").at(3).at("cycles")), swept_part(cycles));
}

TEST_F(SweepProgram, ThreadsMakeNoDifference) {
  const std::vector<std::string> sweep = sweep_over("cycle.amplitude=60 um:80 um:10 um") +
                                         std::vector<std::string>{"--over", "friction.coefficient=[0, 0.1]", "--force"};
  ASSERT_EQ(run(sweep + std::vector<std::string>{"--threads", "1"}).exit_code, 0);
  const json one = summary();
  ASSERT_EQ(run(sweep + std::vector<std::string>{"--threads", "5"}).exit_code, 0);
  const json five = summary();
  ASSERT_EQ(one.at("points").size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(timeless(one.at("points").at(i).at("cycles")), timeless(five.at("points").at(i).at("cycles")));
  }
  EXPECT_EQ(run(sweep + std::vector<std::string>{"--threads", "0"}).exit_code, 2);
}

TEST_F(SweepProgram, RunsNothingWhereAnythingIsWrong) {
  const ProgramOutcome points = run(sweep_over("friction.coefficient=[0.1, -0.2, -0.3]"));
  EXPECT_EQ(points.exit_code, 2);
  EXPECT_NE(points.errors.find("--over: friction.coefficient = -0.2: "), std::string::npos) << points.errors;
  EXPECT_NE(points.errors.find("(at friction.coefficient=-0.3)"), std::string::npos) << points.errors;
  const ProgramOutcome key = run(sweep_over("friction.coeficient=0:1:0.5"));
  EXPECT_EQ(key.exit_code, 2);
  EXPECT_NE(key.errors.find("did you mean \"friction.coefficient\"?"), std::string::npos) << key.errors;
  EXPECT_EQ(run({"sweep", case_path_, "-o", results_}).exit_code, 2);
  EXPECT_EQ(run(sweep_over("cycle.amplitude=[60 um]") + std::vector<std::string>{"--command", "check"}).exit_code, 2);
  const ProgramOutcome strip =
      run(sweep_over("cycle.amplitude=[60 um]") + std::vector<std::string>{"--command", "strip"});
  EXPECT_EQ(strip.exit_code, 2);
  EXPECT_NE(strip.errors.find("add [strip]"), std::string::npos) << strip.errors;
  EXPECT_FALSE(wrote_results());
}

TEST_F(SweepProgram, KeepsPointsThatFail) {
  // Flattened bumps carry less than 1 MN.
  const ProgramOutcome sweep =
      run(sweep_over("strip.load=[50 N, 1 MN, 60 N]") +
          std::vector<std::string>{"--command", "strip", "--set", "strip.bumps=4", "--set", "strip.steps=4"});
  EXPECT_EQ(sweep.exit_code, 3) << sweep.errors;
  EXPECT_NE(sweep.errors.find("bumpfoil: strip.load=1 MN: cycle 1, increment 1 of 8, "), std::string::npos)
      << sweep.errors;
  EXPECT_NE(sweep.errors.find("are partial and flagged as such"), std::string::npos);
  const json swept = summary();
  EXPECT_EQ(swept.at("status"), "failed");
  EXPECT_EQ(swept.at("points").at(0).at("status"), "complete");
  EXPECT_EQ(swept.at("points").at(1).at("status"), "failed");
  EXPECT_EQ(swept.at("points").at(1).at("cycles").at(0).at("status"), "load_out_of_reach");
  EXPECT_EQ(swept.at("points").at(2).at("status"), "complete");
  const std::string csv = folder_.read("results/sweep.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3);

  EXPECT_EQ(run(sweep_over("friction.coefficient=[0]")).exit_code, 4);  // contains results
  EXPECT_EQ(run(cycle_).exit_code, 4);
  EXPECT_EQ(run(cycle_ + std::vector<std::string>{"--force"}).exit_code, 0);
  EXPECT_EQ(names_in("results"), (std::set<std::string>{"cycle.csv", "result.nc", "summary.json"}));
}

TEST_F(SweepProgram, VibratesAtEveryPoint) {
  const std::vector<std::string> vibration{"--set", "vibration.loads=[[\"0 N\", \"-50 N\"]]",
                                           "--set", "vibration.directions=[\"+Y\"]",
                                           "--set", "vibration.amplitudes=[\"1 um\"]",
                                           "--set", "vibration.frequencies=[\"100 Hz\"]",
                                           "--set", "vibration.steps=5"};
  const ProgramOutcome sweep = run(sweep_over("friction.coefficient=[0.1, 0.2]") +
                                   std::vector<std::string>{"--command", "vibration"} + vibration);
  EXPECT_EQ(sweep.exit_code, 0) << sweep.errors;
  EXPECT_NE(sweep.output.find("load (0, -50) N, 90 deg, 1 um\nfriction.coefficient  stiffness "), std::string::npos)
      << sweep.output;
  const json swept = summary();
  EXPECT_EQ(swept.at("swept_command"), "vibration");
  ASSERT_EQ(swept.at("points").size(), 2U);

  const std::string alone = (folder_.path() / "alone").string();
  const ProgramOutcome single = run(
      std::vector<std::string>{"vibration", case_path_, "-o", alone, "--set", "friction.coefficient=0.2"} + vibration);
  ASSERT_EQ(single.exit_code, 0) << single.errors;
  const json summary_alone = json::parse(folder_.read("alone/summary.json"));
  for (const char* list : {"loads", "coefficients"}) {
    EXPECT_EQ(swept.at("points").at(1).at(list), summary_alone.at(list));
  }
  EXPECT_EQ(timeless(swept.at("points").at(1).at("vibrations")), timeless(summary_alone.at("vibrations")));
}

TEST_F(SweepProgram, GivesOfPadsWhatEveryCommandGivesAlone) {
  ASSERT_EQ(run({"init", "--preset", "gen3-three-pad", "-o", case_path_, "--force"}).exit_code, 0);
  const std::string alone = (folder_.path() / "alone").string();
  for (const std::string command : {"cycle", "vibration"}) {
    std::vector<std::string> settings{"--set", "cycle.directions=[\"+Y\"]"};
    if (command == "vibration") {
      settings = {"--set", "vibration.loads=[[\"0 N\", \"-50 N\"]]",
                  "--set", "vibration.directions=[\"+X\", \"+Y\"]",
                  "--set", "vibration.amplitudes=[\"1 um\"]",
                  "--set", "vibration.frequencies=[\"100 Hz\"]",
                  "--set", "vibration.steps=5"};
    }
    const ProgramOutcome sweep = run(sweep_over("pad[2].lobe=0 um:20 um:10 um") +
                                     std::vector<std::string>{"--command", command, "--force"} + settings);
    ASSERT_EQ(sweep.exit_code, 0) << sweep.errors;
    const ProgramOutcome single = run(std::vector<std::string>{command, case_path_, "-o", alone, "--force", "--set",
                                                               "pad[2].lobe=20 um", "--set", "cycle.steps=4"} +
                                      settings);
    ASSERT_EQ(single.exit_code, 0) << single.errors;
    const json swept = summary().at("points");
    const json summary_alone = json::parse(folder_.read("alone/summary.json"));
    const std::string list = command == "cycle" ? "cycles" : "vibrations";
    const json expected = swept_part(summary_alone.at(list));
    ASSERT_EQ(swept.size(), 3U);
    EXPECT_EQ(timeless(swept.at(2).at(list)), expected);
    EXPECT_NE(timeless(swept.at(0).at(list)), expected);
  }
}

TEST_F(SweepProgram, FindsRunningBearingsAtEveryPoint) {
  const std::vector<std::string> running{"--set", "equilibrium.speeds=[\"45000 rpm\"]",
                                         "--set", "equilibrium.loads=[[\"30 N\", \"0 N\"]]",
                                         "--set", "film.rows=4",
                                         "--set", "film.columns_per_pitch=4"};
  const ProgramOutcome sweep = run(sweep_over("bearing.radial_clearance=[30 um, 32 um]") +
                                   std::vector<std::string>{"--command", "equilibrium"} + running);
  EXPECT_EQ(sweep.exit_code, 0) << sweep.errors;
  EXPECT_NE(sweep.output.find("load_ramp from rest, 45000 rpm, load (30, 0) N\n"), std::string::npos) << sweep.output;
  const json swept = summary();
  const std::string alone = (folder_.path() / "alone").string();
  const ProgramOutcome single =
      run(std::vector<std::string>{"equilibrium", case_path_, "-o", alone, "--set", "bearing.radial_clearance=32 um"} +
          running);
  ASSERT_EQ(single.exit_code, 0) << single.errors;
  EXPECT_EQ(timeless(swept.at("points").at(1).at("states")),
            timeless(json::parse(folder_.read("alone/summary.json")).at("states")));
}

TEST_F(SweepProgram, FindsLimitsOverTheSpeed) {
  const std::vector<std::string> sweep = sweep_over("equilibrium.speeds=40000rpm:45000rpm:5000rpm") +
                                         std::vector<std::string>{"--command",
                                                                  "equilibrium",
                                                                  "--limits",
                                                                  "--set",
                                                                  "equilibrium.loads=[[\"30 N\", \"0 N\"]]",
                                                                  "--set",
                                                                  "film.rows=4",
                                                                  "--set",
                                                                  "film.columns_per_pitch=4"};
  const ProgramOutcome thick = run(sweep);
  EXPECT_EQ(thick.exit_code, 2);
  EXPECT_NE(thick.errors.find("film.h_lift_off: is missing"), std::string::npos) << thick.errors;
  const ProgramOutcome done =
      run(sweep + std::vector<std::string>{"--set", "film.h_lift_off=8 um", "top_foil.formed_radius=seated"});
  ASSERT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.output.find("load_ramp from rest, load (30, 0) N\n"), std::string::npos) << done.output;
  EXPECT_NE(done.output.find(" capacity  "), std::string::npos) << done.output;
  EXPECT_NE(done.output.find("rpm         N\n"), std::string::npos) << done.output;
  const json points = summary().at("points");
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points.at(0).at("states").size(), 1U);
  const auto capacity = [&points](std::size_t point) {
    const json& limit = points.at(point).at("limits").at(1);
    EXPECT_EQ(limit.at("kind"), "load_capacity");
    return limit.at("load_N").get<double>();
  };
  EXPECT_GT(capacity(1), capacity(0));
  const std::string csv = folder_.read("results/sweep.csv");
  EXPECT_NE(csv.substr(0, csv.find('\n')).find(",lift_off_speed_rad_per_s,load_capacity_N,lift_off_bounded_by,"),
            std::string::npos)
      << csv;
  const std::string bounds = ",film_thickness,,,film_thickness,,\n";
  ASSERT_TRUE(csv.ends_with(bounds)) << csv;
  const std::string row = csv.substr(0, csv.size() - bounds.size());
  EXPECT_EQ(std::stod(row.substr(row.rfind(',') + 1)), capacity(1));

  const ProgramOutcome cycles =
      run(sweep_over("friction.coefficient=[0, 1]") + std::vector<std::string>{"--limits", "--force"});
  EXPECT_EQ(cycles.exit_code, 2);
  EXPECT_NE(cycles.errors.find("--limits: are those of running bearings; add --command equilibrium"), std::string::npos)
      << cycles.errors;
}

TEST_F(SweepProgram, AnInterruptedSweepLeavesFlaggedResults) {
  // The first point is done at once, the others are long enough to be interrupted on any machine.
  Running program({"sweep", case_path_, "--over", "cycle.steps=[2, 80000, 80001]", "-o", results_, "--set",
                   "cycle.directions=[\"+X\"]", "--threads", "1"},
                  (folder_.path() / "output").string());
  while (!wrote_results()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  program.interrupt();
  EXPECT_EQ(program.wait(), 130);
  EXPECT_NE(program.errors().find("interrupted: 2 of 3 points are missing"), std::string::npos) << program.errors();
  const json swept = summary();
  EXPECT_EQ(swept.at("status"), "interrupted");
  ASSERT_EQ(swept.at("points").size(), 3U);
  EXPECT_EQ(swept.at("points").at(0).at("status"), "complete");
  EXPECT_EQ(swept.at("points").at(1).at("status"), "interrupted");
  EXPECT_EQ(swept.at("points").at(1).at("cycles").at(0).at("status"), "interrupted");
  EXPECT_TRUE(swept.at("points").at(2).at("cycles").empty());
}

}  // namespace
}  // namespace bumpfoil
