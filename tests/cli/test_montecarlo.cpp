// `bumpfoil montecarlo` from the command line.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "cli/montecarlo_program.hpp"

namespace bumpfoil {
namespace {

TEST_F(MonteCarloProgram, WritesStatisticsAndSamples) {
  const ProgramOutcome run_of_ten = run(montecarlo("results", 10));
  EXPECT_EQ(run_of_ten.exit_code, 0) << run_of_ten.errors;
  EXPECT_NE(run_of_ten.output.find("\nmaximum force "), std::string::npos) << run_of_ten.output;
  EXPECT_NE(run_of_ten.output.find("10 samples; results in " + results_), std::string::npos);
  EXPECT_EQ(names_in("results"), (std::set<std::string>{"summary.json", "ensemble.nc", "ensemble.checkpoint"}));
  const json found = summary();
  EXPECT_EQ(found.at("status"), "complete");
  EXPECT_EQ(found.at("samples"), 10);
  EXPECT_EQ(found.at("statistics").at("+X").at("max_force_N").at("count"), 10);
  EXPECT_EQ(run(montecarlo("results", 10)).exit_code, 4);  // contains results
  EXPECT_EQ(run(montecarlo("results", 5) + std::vector<std::string>{"--force", "--seed", "2"}).exit_code, 0);
  EXPECT_EQ(summary().at("seed"), 2);
  EXPECT_EQ(summary().at("samples"), 5);
}

TEST_F(MonteCarloProgram, FollowsEventsUnlessASolverIsNamed) {
  const std::string alone = (folder_.path() / "alone").string();
  const auto sample = [&](const std::vector<std::string>& more) {
    const std::vector<std::string> one{
        "cycle", case_path_, "-o", alone, "--force", "--sample", results_ + "/ensemble.nc:0"};
    const ProgramOutcome single = run(
        one + std::vector<std::string>{"--set", "cycle.steps=4", "--set", "cycle.directions=[\"+X\", \"-X\"]"} + more);
    EXPECT_EQ(single.exit_code, 0) << single.errors;
    return summary_of("alone");
  };
  const auto energy_of_mean = [this] {
    return summary().at("statistics").at("+X").at("loop_energy_J").at("mean").get<double>();
  };
  const auto energy = [](const json& single) { return single.at("cycles").at(0).at("loop_energy_J").get<double>(); };

  ASSERT_EQ(run(montecarlo("results", 1)).exit_code, 0);
  EXPECT_EQ(summary().at("solver"), "events");
  EXPECT_EQ(summary().at("case").at("solver").at("name"), "events");
  const double followed = energy_of_mean();
  json single = sample({});
  EXPECT_EQ(single.at("solver"), "events");
  // Sums of rates by solves and by the tableau.
  EXPECT_NEAR(energy(single), followed, 1e-9 * followed);
  single = sample({"--solver", "newton"});
  EXPECT_EQ(single.at("solver"), "newton");
  EXPECT_GT(std::abs(energy(single) - followed), 1e-3 * followed);  // four increments each way

  // A run is resumed only with its initial settings.
  const ProgramOutcome other =
      run(montecarlo("results", 2) + std::vector<std::string>{"--resume", "--solver", "newton"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.errors.find("solver.name = \"events\": is \"newton\" now"), std::string::npos) << other.errors;
  EXPECT_EQ(run(montecarlo("results", 2) + std::vector<std::string>{"--resume", "--solver", "events"}).exit_code, 0);

  ASSERT_EQ(run(montecarlo("results", 1) + std::vector<std::string>{"--force", "--solver", "newton"}).exit_code, 0);
  EXPECT_EQ(summary().at("solver"), "newton");
  single = sample({});
  EXPECT_EQ(single.at("solver"), "newton");
  EXPECT_NEAR(energy(single), energy_of_mean(), 1e-9 * followed);
}

TEST_F(MonteCarloProgram, WantsSomethingThatScatters) {
  EXPECT_EQ(run({"montecarlo", case_path_, "-o", results_}).exit_code, 2);
  const ProgramOutcome nothing = run({"montecarlo", case_path_, "-o", results_, "--samples", "5"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_NE(nothing.errors.find("nothing scatters"), std::string::npos) << nothing.errors;
  EXPECT_FALSE(wrote_results());
}

TEST_F(MonteCarloProgram, SamplesOfCycleAreWhatTheySay) {
  ASSERT_EQ(run(montecarlo("results", 2)).exit_code, 0);
  const auto refusal = [&](const std::string& sample) {
    return run({"cycle", case_path_, "-o", (folder_.path() / "alone").string(), "--sample", sample});
  };
  EXPECT_EQ(refusal(results_ + "/ensemble.nc").exit_code, 2);
  EXPECT_EQ(refusal(results_ + "/ensemble.nc:2").exit_code, 2);
  EXPECT_EQ(refusal(results_ + "/ensemble.nc:-1").exit_code, 2);
  EXPECT_EQ(refusal(results_ + "/none.nc:1").exit_code, 4);
}

TEST_F(MonteCarloProgram, ScattersEveryBumpOfEveryPad) {
  ASSERT_EQ(run({"init", "--preset", "gen3-three-pad", "-o", case_path_, "--force"}).exit_code, 0);
  const std::vector<std::string> scatter{"--set", "montecarlo.top_foil_thickness.std=1 um"};
  const ProgramOutcome ensemble = run(montecarlo("results", 40) + scatter);
  ASSERT_EQ(ensemble.exit_code, 0) << ensemble.errors;
  const json found = summary();
  EXPECT_EQ(found.at("bump_loads").at("+X").at("mean_N").size(), 24U);
  // Pad 2 carries the load in +X: its bump heights matter, those of pads 1 and 3 only by chance.
  const auto heights = found.at("sensitivities").at("+X").at("max_force").at("bump_height").get<std::vector<double>>();
  ASSERT_EQ(heights.size(), 24U);
  EXPECT_EQ((std::max_element(heights.begin(), heights.end()) - heights.begin()) / 8, 1);
  const std::string alone = (folder_.path() / "alone").string();
  const ProgramOutcome single = run({"cycle", case_path_, "-o", alone, "--sample", results_ + "/ensemble.nc:17",
                                     "--set", "cycle.steps=4", "--set", "cycle.directions=[\"+X\", \"-X\"]"});
  ASSERT_EQ(single.exit_code, 0) << single.errors;
  const json pads = json::parse(folder_.read("alone/summary.json")).at("case").at("pad");
  EXPECT_NE(pads.at(0).at("bump_foil").at("height_errors"), pads.at(1).at("bump_foil").at("height_errors"));
  EXPECT_NE(pads.at(0).at("bump_foil").at("thickness"), 0.102e-3);
  const ProgramOutcome other = run({"cycle", case_path_, "-o", alone, "--force", "--sample",
                                    results_ + "/ensemble.nc:17", "--set", "pad[2].lobe=0 um"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.errors.find("pad[2].lobe"), std::string::npos) << other.errors;
}

TEST_F(MonteCarloProgram, RunsBearingsOnTheirFilms) {
  const std::vector<std::string> film{"--set",
                                      "film.columns_per_pitch=4",
                                      "film.rows=6",
                                      "equilibrium.steps=2",
                                      "equilibrium.paths=one",
                                      "equilibrium.speeds=[\"45000 rpm\"]",
                                      "equilibrium.loads=[[\"20 N\", \"5 N\"]]"};
  const auto ensemble = [&](const char* folder, const char* samples) {
    return std::vector<std::string>{"montecarlo", case_path_, "-o",      (folder_.path() / folder).string(),
                                    "--samples",  samples,    "--limit", "h_min > 1 um"} +
           film +
           std::vector<std::string>{"montecarlo.command=equilibrium", "montecarlo.radial_clearance.std=1 um",
                                    "montecarlo.bump_height.std=1 um"};
  };
  const ProgramOutcome four = run(ensemble("results", "4"));
  ASSERT_EQ(four.exit_code, 0) << four.errors;
  EXPECT_NE(four.output.find("\nminimum film thickness "), std::string::npos) << four.output;
  EXPECT_NE(four.output.find("yield: 4 of 4 bearings"), std::string::npos) << four.output;
  const json found = summary();
  const json& state = found.at("statistics").at("45000 rpm, load (20, 5) N");
  EXPECT_EQ(state.at("h_min_m").at("count"), 4);
  EXPECT_GT(state.at("h_min_m").at("std"), 0.0);

  // A single sample gives the numbers stored in the ensemble.
  ASSERT_EQ(run(ensemble("first", "1")).exit_code, 0);
  const std::vector<std::string> alone{
      "equilibrium", case_path_, "-o", (folder_.path() / "alone").string(), "--sample", results_ + "/ensemble.nc:0"};
  ASSERT_EQ(run(alone + film).exit_code, 0);
  const json single = json::parse(folder_.read("alone/summary.json")).at("states").at(0);
  const json first = summary_of("first");
  const json& kept = first.at("statistics").begin().value();
  for (const char* name : {"h_min_m", "power_W", "kxy_N_per_m", "max_stress_top_foil_Pa"}) {
    const auto value = single.at(name).get<double>();
    EXPECT_NEAR(kept.at(name).at("mean").get<double>(), value, 1e-9 * std::abs(value)) << name;
  }
  // With limits these are quantities like others, and sample 0 has its own.
  const std::vector<std::string> stable{"film.h_lift_off=8 um", "top_foil.formed_radius=seated"};
  const std::vector<std::string> limits = std::vector<std::string>{"--limits", "--set"} + stable;
  const ProgramOutcome without = run(ensemble("limits", "1") + std::vector<std::string>{"--limits"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.errors.find("film.h_lift_off: is missing"), std::string::npos) << without.errors;
  ASSERT_EQ(run(ensemble("limits", "1") + limits).exit_code, 0);
  std::vector<std::string> with_limits = alone;
  with_limits.back() = (folder_.path() / "limits/ensemble.nc:0").string();
  ASSERT_EQ(run(with_limits + film + stable + std::vector<std::string>{"--limits", "--force"}).exit_code, 0);
  const json of_limits = summary_of("limits").at("statistics").begin().value();
  const json of_one = json::parse(folder_.read("alone/summary.json")).at("limits");
  EXPECT_NEAR(of_limits.at("lift_off_speed_rad_per_s").at("mean").get<double>(),
              of_one.at(0).at("speed_rad_per_s").get<double>(), 1e-6);
  EXPECT_NEAR(of_limits.at("load_capacity_N").at("mean").get<double>(), of_one.at(1).at("load_N").get<double>(), 1e-6);
  EXPECT_FALSE(kept.contains("load_capacity_N"));
  EXPECT_EQ(run(montecarlo("other", 1) + std::vector<std::string>{"--limits"}).exit_code, 2);  // cycles have none
  // Errors of the case are not those of a sample.
  const ProgramOutcome events = run(ensemble("other", "4") + std::vector<std::string>{"--solver", "events"});
  EXPECT_EQ(events.exit_code, 2);
  EXPECT_NE(events.errors.find("cannot solve contacts under a film"), std::string::npos) << events.errors;
  EXPECT_FALSE(has("other/ensemble.checkpoint"));
  const ProgramOutcome none = run({"montecarlo", case_path_, "-o", results_, "--force", "--set",
                                   "montecarlo.command=equilibrium", "--set", "montecarlo.bump_height.std=1 um"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.errors.find("needs the table [equilibrium]"), std::string::npos) << none.errors;
}

TEST_F(MonteCarloProgram, RunsRotorsOnBearingsOfTheirSample) {
  const std::vector<std::string> rotor{"--set",
                                       "film.columns_per_pitch=4",
                                       "film.rows=4",
                                       "bearing.weld_angle=90 deg",
                                       "bearing.wrap=counterclockwise",
                                       "top_foil.formed_radius=seated",
                                       "rotor.mass=2 kg",
                                       "stability.speeds=[\"12000 rpm\", \"15000 rpm\"]"};
  const auto ensemble = [&](const char* samples) {
    return std::vector<std::string>{"montecarlo", case_path_, "-o", results_, "--samples", samples} +
           std::vector<std::string>{"--limit", "stable_up_to > 12500 rpm"} + rotor +
           std::vector<std::string>{"montecarlo.command=stability", "montecarlo.radial_clearance.std=2 um",
                                    "montecarlo.bump_height.std=1 um"};
  };
  const ProgramOutcome two = run(ensemble("2"));
  ASSERT_EQ(two.exit_code, 0) << two.errors;
  EXPECT_NE(two.output.find("\nonset of whirl "), std::string::npos) << two.output;
  EXPECT_NE(two.output.find("\nstable at all speeds: 0 of 2 samples"), std::string::npos) << two.output;
  EXPECT_NE(two.output.find("\nyield: 2 of 2 bearings"), std::string::npos) << two.output;
  // A resumed run adds samples, and a single sample gives the numbers stored in the ensemble.
  ASSERT_EQ(run(ensemble("3") + std::vector<std::string>{"--resume"}).exit_code, 0);
  const json kept = summary().at("statistics").at("rotor").at("stable_up_to_rad_per_s");
  EXPECT_EQ(kept.at("count"), 3);
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(run(std::vector<std::string>{"stability", case_path_, "-o", (folder_.path() / "alone").string(),
                                           "--force", "--sample", results_ + "/ensemble.nc:" + std::to_string(i)} +
                  rotor)
                  .exit_code,
              0);
    sum += summary_of("alone").at("stable_up_to_rad_per_s").get<double>();
  }
  EXPECT_NEAR(kept.at("mean").get<double>(), sum / 3.0, 1e-9 * sum);
  EXPECT_GT(kept.at("std"), 0.0);
  // Its response to unbalance, too.
  const ProgramOutcome unbalance =
      run(std::vector<std::string>{"montecarlo", case_path_, "-o", results_, "--force", "--samples", "2", "--limit",
                                   "largest_amplitude < 20 um"} +
          rotor +
          std::vector<std::string>{"rotor.unbalance=[{amount=\"2 g mm\"}]", "unbalance.speeds=[\"9000 rpm\"]",
                                   "montecarlo.command=unbalance", "montecarlo.radial_clearance.std=2 um"});
  ASSERT_EQ(unbalance.exit_code, 0) << unbalance.errors;
  EXPECT_NE(unbalance.output.find("\nlargest amplitude "), std::string::npos) << unbalance.output;
  EXPECT_NE(unbalance.output.find("\nyield: 2 of 2 bearings"), std::string::npos) << unbalance.output;
  EXPECT_EQ(summary().at("statistics").at("rotor").at("largest_amplitude_speed_rad_per_s").at("std"), 0.0);
  const ProgramOutcome none = run({"montecarlo", case_path_, "-o", results_, "--force", "--set",
                                   "montecarlo.command=stability", "--set", "montecarlo.bump_height.std=1 um"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.errors.find("add [stability]"), std::string::npos) << none.errors;
}

TEST_F(MonteCarloProgram, KeepsSamplesThatFail) {
  const ProgramOutcome failing =
      run(montecarlo("results", 30) + std::vector<std::string>{"--set", "montecarlo.friction_top_bump.std=0.2"});
  EXPECT_EQ(failing.exit_code, 3) << failing.errors;
  EXPECT_NE(failing.errors.find("invalid sample"), std::string::npos) << failing.errors;
  const json found = summary();
  EXPECT_EQ(found.at("status"), "failed");
  const std::size_t failed = found.at("failed").size() / 2;
  EXPECT_GT(failed, 0U);
  EXPECT_EQ(found.at("statistics").at("+X").at("max_force_N").at("count"), 30U - failed);
}

TEST_F(MonteCarloProgram, StopsWhereTheErrorIsSmallEnough) {
  const ProgramOutcome enough =
      run(montecarlo("results", 100000) + std::vector<std::string>{"--set", "cycle.steps=1", "--target-error", "0.5"});
  EXPECT_EQ(enough.exit_code, 0) << enough.errors;
  EXPECT_EQ(summary().at("samples"), 1000);
  EXPECT_EQ(summary().at("status"), "complete");
}

TEST_F(MonteCarloProgram, AnInterruptedRunLeavesFlaggedResultsAndGoesOn) {
  const std::vector<std::string> command = montecarlo("results", 1000000);
  Running program(command, (folder_.path() / "output").string());
  while (!has("results/ensemble.checkpoint")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  program.interrupt();
  EXPECT_EQ(program.wait(), 130);
  EXPECT_NE(program.errors().find(" of 1000000 samples are missing"), std::string::npos) << program.errors();
  const int samples = summary().at("samples").get<int>();
  EXPECT_EQ(summary().at("status"), "interrupted");
  ASSERT_GT(samples, 0);

  const std::vector<std::string> resumed = montecarlo("results", samples + 20) + std::vector<std::string>{"--resume"};
  const ProgramOutcome other = run(resumed + std::vector<std::string>{"--seed", "2"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.errors.find("montecarlo.seed = 1: is 2 now"), std::string::npos) << other.errors;
  EXPECT_EQ(run(resumed + std::vector<std::string>{"--threads", "1"}).exit_code, 0);
  ASSERT_EQ(run(montecarlo("whole", samples + 20)).exit_code, 0);
  EXPECT_EQ(summary().at("statistics"), summary_of("whole").at("statistics"));
}

/// A run killed at random moments and resumed gives the numbers of an uninterrupted one, bit for bit.
TEST_F(MonteCarloProgram, GoesOnWhereItWasKilled) {
  constexpr int samples = 500;
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run(montecarlo("whole", samples)).exit_code, 0);
  const auto whole = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin);
  const std::vector<std::string> command = montecarlo("results", samples) + std::vector<std::string>{"--resume"};
  std::mt19937 random(20);
  // Long enough for some samples to be written, also on slow machines.
  std::uniform_int_distribution<int> milliseconds(0, std::max(600, static_cast<int>(whole.count() / 8)));
  for (int kills = 0; kills < 20; ++kills) {
    Running program(command, (folder_.path() / "output").string());
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
    program.end(SIGKILL);
    const int ended = program.wait();
    ASSERT_TRUE(ended == 1000 + SIGKILL || ended == 0) << program.errors();
  }
  // The killed run left samples; one is 768 bytes.
  EXPECT_GT(std::filesystem::file_size(folder_.path() / "results/ensemble.checkpoint"), 20'000U);
  const ProgramOutcome last = run(command);
  ASSERT_EQ(last.exit_code, 0) << last.errors;
  EXPECT_EQ(summary().at("statistics"), summary_of("whole").at("statistics"));
  EXPECT_EQ(summary().at("bump_loads"), summary_of("whole").at("bump_loads"));
}

}  // namespace
}  // namespace bumpfoil
