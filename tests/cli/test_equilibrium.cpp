// `bumpfoil equilibrium` and `bumpfoil film` from the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "cli/running_program.hpp"

namespace bumpfoil {
namespace {

/// On a coarse mesh, where a state takes a tenth of a second.
class RunningBearing : public Program {
 protected:
  [[nodiscard]] std::vector<std::string> command(const std::string& name, const std::vector<std::string>& more) const {
    return std::vector<std::string>{name,    case_path_,
                                    "-o",    results_,
                                    "--set", "film.rows=3",
                                    "--set", "film.columns_per_pitch=4",
                                    "--set", "equilibrium.steps=3",
                                    "--set", "equilibrium.speeds=[\"45000 rpm\"]",
                                    "--set"} +
           more;
  }
};

TEST_F(RunningBearing, IsFoundUnderItsLoads) {
  const ProgramOutcome missing = run({"equilibrium", case_path_, "-o", results_});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.errors.find("add [equilibrium]"), std::string::npos);
  EXPECT_FALSE(wrote_results());

  const ProgramOutcome done = run(command("equilibrium", {"equilibrium.loads=[[20, 0], [40, 0]]"}));
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.output.find("minimum film thickness"), std::string::npos);
  EXPECT_NE(
      done.output.find(results_ + " (summary.json, equilibrium.csv, coefficients.csv, coefficients.toml, result.nc)"),
      std::string::npos);
  EXPECT_EQ(names_in("results"), (std::set<std::string>{"coefficients.csv", "coefficients.toml", "equilibrium.csv",
                                                        "result.nc", "summary.json"}));
  EXPECT_EQ(summary().at("command"), "equilibrium");
  EXPECT_EQ(summary().at("status"), "complete");
  ASSERT_EQ(summary().at("states").size(), 2U);
  EXPECT_NEAR(summary().at("states").at(1).at("force_x_N"), 40.0, 1e-6);
  const std::string csv = folder_.read("results/equilibrium.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "speed_rad_per_s,load_x_N,load_y_N,x_m,y_m,force_x_N,force_y_N,eccentricity_ratio,attitude_angle_deg,"
            "h_min_m,h_min_theta_deg,p_max_Pa,p_min_Pa,torque_N_m,power_W,loaded_bumps,status,path,kxx_N_per_m,"
            "kxy_N_per_m,kyx_N_per_m,kyy_N_per_m,kxx_stuck_N_per_m,kxy_stuck_N_per_m,kyx_stuck_N_per_m,"
            "kyy_stuck_N_per_m,stable,growth_held,whirl_ratio_held,growth_held_stuck,whirl_ratio_held_stuck,"
            "hold_down_N,critical_mass_kg,critical_whirl_ratio,critical_mass_stuck_kg,"
            "critical_whirl_ratio_stuck");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);

  EXPECT_NE(folder_.read("results/coefficients.toml").find("[bearing.synchronous]"), std::string::npos);
  EXPECT_EQ(run(command("equilibrium", {"equilibrium.loads=[[20, 0]]"})).exit_code, 4);  // results exist
  const auto for_ross = [&](const std::string& version) {
    return run(command("equilibrium", {"equilibrium.loads=[[20, 0]]", "--ross-version", version, "--force"}));
  };
  EXPECT_EQ(for_ross("2").exit_code, 0);
  EXPECT_EQ(folder_.read("results/coefficients.toml").find("[bearing.synchronous]"), std::string::npos);
  const ProgramOutcome unknown = for_ross("4");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.errors.find("--ross-version: unknown value '4'"), std::string::npos) << unknown.errors;
  const ProgramOutcome other =
      run(command("equilibrium", {"equilibrium.loads=[[20, 0]]", "--solver", "uzawa", "--force"}));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.errors.find("solver.name = uzawa: cannot solve contacts under a film"), std::string::npos)
      << other.errors;
}

TEST_F(RunningBearing, IsNoConcernOfOtherCommands) {
  std::string text = folder_.read("case.toml") + "\n[solver]\nname = \"events\"\n";
  const auto line = std::count(text.begin(), text.end(), '\n');
  text += "[equilibrium]\nspeeds = [\"45000 rpm\"]\nloads = [[\"50 N\", \"0 N\"]]\n";
  case_path_ = folder_.write("events.toml", text);
  EXPECT_EQ(run({"cycle", case_path_, "-o", results_, "--set", "cycle.steps=4"}).exit_code, 0);
  const ProgramOutcome refused = run({"equilibrium", case_path_, "-o", results_, "--force"});
  EXPECT_EQ(refused.exit_code, 2);
  const std::string why = case_path_ + ":" + std::to_string(line) + ": solver.name";
  EXPECT_NE(refused.errors.find(why), std::string::npos) << refused.errors;

  const ProgramOutcome checked = run({"check", case_path_});
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  EXPECT_NE(checked.output.find("\n# cycle: ok\n# equilibrium: not possible\n#   " + why), std::string::npos)
      << checked.output;
  EXPECT_EQ(run({"check", folder_.write("understood.toml", checked.output)}).exit_code, 0);
  // An invalid key is an error of the file.
  EXPECT_EQ(run({"check", case_path_, "--set", "equilibrium.speeds=[0]"}).exit_code, 2);
  // So is a file that no command can run.
  const ProgramOutcome none = run({"check", case_path_, "--set", "cycle.amplitude=0.6 mm"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.errors.find("would press the bumps flat"), std::string::npos) << none.errors;
  EXPECT_NE(none.errors.find(why), std::string::npos) << none.errors;
}

TEST_F(RunningBearing, LeavesPartialResultsWhereTheFilmIsTooThin) {
  const ProgramOutcome beyond = run(command(
      "equilibrium", {"equilibrium.loads=[[20, 0], [100, 0], [110, 0]]", "--set", "film.h_floor=10 um", "--force"}));
  EXPECT_EQ(beyond.exit_code, 3);
  EXPECT_EQ(summary().at("status"), "failed");
  const json failed = summary().at("states").at(1);
  EXPECT_EQ(failed.at("status"), "touchdown");
  EXPECT_TRUE(failed.at("x_m").is_null());
  EXPECT_GT(failed.at("last_state").at("h_min_m"), 10e-6);
  EXPECT_EQ(summary().at("states").at(2).at("status"), "not_reached");
  EXPECT_NE(beyond.errors.find("bumpfoil: load_ramp from load (20, 0) N, 45000 rpm, load (100, 0) N: touchdown"),
            std::string::npos)
      << beyond.errors;
}

TEST_F(RunningBearing, IsFoundByEveryPath) {
  const ProgramOutcome done = run(command("equilibrium", {"equilibrium.loads=[[40, 0]]", "--paths"}));
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.output.find("4 paths to 45000 rpm, load (40, 0) N"), std::string::npos) << done.output;
  ASSERT_EQ(summary().at("spreads").size(), 1U);
  const json spread = summary().at("spreads").at(0);
  EXPECT_EQ(spread.at("states").size(), 4U);
  EXPECT_LE(spread.at("h_min_m").at("min"), spread.at("h_min_m").at("max"));
}

TEST_F(RunningBearing, MayHaveAWallInPlaceOfFoils) {
  const ProgramOutcome by_load = run(command("film", {"equilibrium.loads=[[20, 0]]"}));
  EXPECT_EQ(by_load.exit_code, 2);
  EXPECT_NE(by_load.errors.find("equilibrium.positions"), std::string::npos);
  const ProgramOutcome done = run(command("film", {"equilibrium.positions=[[\"10 um\", 0]]"}));
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.output.find(results_ + " (summary.json, film.csv, result.nc)"), std::string::npos);
  EXPECT_EQ(summary().at("command"), "film");
  EXPECT_GT(summary().at("states").at(0).at("force_x_N"), 0.0);
  EXPECT_FALSE(summary().at("states").at(0).contains("loaded_bumps"));
}

TEST_F(RunningBearing, MayHavePads) {
  const auto of_pads = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words{"--set", "pad=[{lobe=\"8 um\"}, {weld_edge=\"trailing\"}, {lobe=\"8 um\"}]", "--set",
                                   "bump_foil.bumps=8", "--force"};
    words.insert(words.begin(), more.begin(), more.end());
    return run(command(name, words));
  };
  const ProgramOutcome done = of_pads("equilibrium", {"equilibrium.loads=[[20, 0], [40, 0]]"});
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.output.find("\nforce of pad 3 "), std::string::npos) << done.output;
  const json state = summary().at("states").at(1);
  double sum = 0.0;
  for (const double force : state.at("pad_forces_x_N")) sum += force;
  EXPECT_NEAR(sum, 40.0, 1e-6);
  // Only one pad is in contact: it cannot carry more.
  const ProgramOutcome beyond =
      of_pads("equilibrium", {"equilibrium.loads=[[20, 0], [100, 0]]", "--set", "film.h_floor=10 um"});
  EXPECT_EQ(beyond.exit_code, 3);
  EXPECT_EQ(summary().at("states").at(1).at("status"), "touchdown");
  EXPECT_TRUE(summary().at("states").at(1).at("pad_forces_x_N").at(0).is_null());
  EXPECT_GT(summary().at("states").at(1).at("last_state").at("pad_forces_x_N").size(), 2U);
  // A wall instead of foils has no such limit.
  const ProgramOutcome wall = of_pads("film", {"equilibrium.positions=[[\"10 um\", 0]]"});
  EXPECT_EQ(wall.exit_code, 2);
  EXPECT_NE(wall.errors.find("pad: are parts of the sleeve"), std::string::npos) << wall.errors;
}

TEST_F(RunningBearing, MayBeInterrupted) {
  // Takes long enough to be interrupted on any machine.
  Running program(command("equilibrium", {"equilibrium.loads=[[40, 0]]", "--set", "film.rows=40", "--set",
                                          "film.columns_per_pitch=12"}),
                  (folder_.path() / "output").string());
  while (!wrote_results()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  program.interrupt();
  EXPECT_EQ(program.wait(), 130);
  EXPECT_EQ(summary().at("status"), "interrupted");
  EXPECT_EQ(summary().at("states").at(0).at("status"), "interrupted");
}

}  // namespace
}  // namespace bumpfoil
