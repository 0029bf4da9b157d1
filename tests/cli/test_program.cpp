// The program from the command line: exit codes, output and files.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/running_program.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

TEST_F(Program, GoesFromInitOverCheckToCycle) {
  const ProgramOutcome check = run({"check", case_path_});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_EQ(check.errors, "");
  // The printed case file has the same meaning.
  const std::string understood = folder_.write("understood.toml", check.output);
  EXPECT_EQ(run({"check", understood}).output, check.output);

  const ProgramOutcome cycle = run(cycle_);
  EXPECT_EQ(cycle.exit_code, 0) << cycle.errors;
  EXPECT_EQ(cycle.errors, "");
  EXPECT_NE(cycle.output.find("maximum force"), std::string::npos);
  EXPECT_NE(cycle.output.find(results_ + " (summary.json, cycle.csv, result.nc)"), std::string::npos);
  const json written = summary();
  EXPECT_EQ(written.at("status"), "complete");
  ASSERT_EQ(written.at("cycles").size(), 4U);
  for (const json& one : written.at("cycles")) EXPECT_EQ(one.at("converged"), true);
  const std::string csv = folder_.read("results/cycle.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 9);
}

TEST_F(Program, VibratesAboutLoads) {
  const std::vector<std::string> vibration{"vibration", case_path_,
                                           "-o",        results_,
                                           "--set",     "vibration.directions=[\"+X\", \"+Y\"]",
                                           "--set",     "vibration.amplitudes=[\"1 um\"]",
                                           "--set",     "vibration.steps=8"};
  const auto with = [&](const std::string& load, const std::string& frequency) {
    return vibration + std::vector<std::string>{"--set", "vibration.loads=[[\"0 N\", \"" + load + "\"]]", "--set",
                                                "vibration.frequencies=[\"" + frequency + "\"]"};
  };
  const ProgramOutcome still = run(with("-50 N", "0 Hz"));
  EXPECT_EQ(still.exit_code, 2);
  EXPECT_NE(still.errors.find("vibration.frequencies[1] = 0 Hz: must be positive"), std::string::npos) << still.errors;
  EXPECT_EQ(run(with("-50 N", "200 1/s")).exit_code, 2);
  EXPECT_FALSE(wrote_results());

  const ProgramOutcome done = run(with("-50 N", "200 Hz"));
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_EQ(done.errors.find("warning: load (0, -50) N, 0 deg, 1 um: the loop has not settled"), 0U) << done.errors;
  EXPECT_NE(done.output.find("loss factor"), std::string::npos);
  EXPECT_NE(
      done.output.find(results_ + " (summary.json, vibration.csv, coefficients.csv, coefficients.toml, result.nc)"),
      std::string::npos);
  EXPECT_EQ(summary().at("command"), "vibration");
  EXPECT_EQ(summary().at("status"), "complete");
  const json coefficients = summary().at("coefficients").at(0);
  EXPECT_NEAR(coefficients.at("frequency_rad_per_s"), 1256.637061435917, 1e-9);
  EXPECT_GT(coefficients.at("kyy_N_per_m"), 1e6);
  EXPECT_GT(coefficients.at("cyy_N_s_per_m"), 0.0);
  EXPECT_EQ(run(with("-50 N", "200 Hz")).exit_code, 4);  // contains results

  const ProgramOutcome beyond = run(with("-1 GN", "200 Hz") + std::vector<std::string>{"--force"});
  EXPECT_EQ(beyond.exit_code, 3);
  EXPECT_EQ(beyond.errors.find("bumpfoil: load (0, -1e+09) N was not reached: "), 0U) << beyond.errors;
  EXPECT_EQ(summary().at("status"), "failed");
  EXPECT_TRUE(summary().at("coefficients").at(0).at("kyy_N_per_m").is_null());
}

TEST_F(Program, CompressesAStrip) {
  const std::vector<std::string> strip{"strip", case_path_,      "-o",    results_,
                                       "--set", "strip.bumps=4", "--set", "strip.steps=4"};
  const ProgramOutcome missing = run({"strip", case_path_, "-o", results_});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.errors.find("add [strip]"), std::string::npos);
  EXPECT_FALSE(wrote_results());

  const ProgramOutcome done =
      run(strip + std::vector<std::string>{"--set", "strip.load=50 N", "--set", "bump_foil.yield_stress=1 MPa"});
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.output.find(results_ + " (summary.json, strip.csv, result.nc)"), std::string::npos);
  EXPECT_NE(done.errors.find("warning: cycle 1: the top foil yields"), std::string::npos);
  EXPECT_EQ(summary().at("command"), "strip");
  EXPECT_NEAR(summary().at("cycles").at(0).at("max_force_N"), 50.0, 1e-6);
  EXPECT_EQ(summary().at("cycles").at(0).at("above_yield_top_foil"), true);
  const std::string csv = folder_.read("results/strip.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 9);

  EXPECT_EQ(run(strip + std::vector<std::string>{"--set", "strip.load=50 N"}).exit_code, 4);  // contains results
  // More than flattened bumps can carry: partial results.
  const ProgramOutcome beyond = run(strip + std::vector<std::string>{"--set", "strip.load=1 MN", "--force"});
  EXPECT_EQ(beyond.exit_code, 3);
  EXPECT_EQ(summary().at("status"), "failed");
  EXPECT_EQ(beyond.errors.find("bumpfoil: cycle 1, increment 1 of 8, "), 0U) << beyond.errors;
  EXPECT_NE(beyond.errors.find(": the load is not met before the bumps are pressed flat; the results in " + results_ +
                               " are partial and flagged as such\n"),
            std::string::npos);
  const json failed = summary().at("cycles").at(0);
  EXPECT_EQ(failed.at("status"), "load_out_of_reach");
  EXPECT_EQ(failed.at("failed_increment"), 1);
  EXPECT_EQ(failed.at("reason"), "the load is not met before the bumps are pressed flat");
}

TEST_F(Program, FollowsAPath) {
  const std::vector<std::string> path{"path", case_path_, "-o", results_};
  EXPECT_NE(run(path).errors.find("add [path]"), std::string::npos);

  // In the folder of the case file.
  folder_.write("path.csv", "x_m,y_m\n0,0\n0,-4e-5\n1e-5,-4e-5\n");
  const std::vector<std::string> file = path + std::vector<std::string>{"--set", "path.file=path.csv"};
  const ProgramOutcome done = run(file);
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  const std::string csv = folder_.read("results/path.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3);
  EXPECT_NE(csv.find(",orbit,kxx_N_per_m,kxy_N_per_m,kyx_N_per_m,kyy_N_per_m,kxx_stuck_N_per_m,"), std::string::npos);
  EXPECT_EQ(names_in("results"), (std::set<std::string>{"path.csv", "result.nc", "summary.json"}));

  const ProgramOutcome orbit =
      run(path + std::vector<std::string>{"--force", "--set", "path.centre=[\"0 N\", \"-80 N\"]", "--set",
                                          "path.semi_axes=[\"20 N\", \"10 N\"]", "--set", "path.steps=12", "--set",
                                          "path.orbits=2"});
  EXPECT_EQ(orbit.exit_code, 0) << orbit.errors;
  EXPECT_EQ(summary().at("cycles").at(0).at("orbits").size(), 2U);
  EXPECT_NE(orbit.errors.find("warning: path: the loop has not settled"), std::string::npos);

  folder_.write("path.csv", "x,y\n0,0\n");
  const ProgramOutcome wrong = run(file + std::vector<std::string>{"--force"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.errors.find("path.csv:1: line = x,y: is not a header of a path"), std::string::npos) << wrong.errors;
}

TEST_F(Program, DescribesItsResults) {
  const ProgramOutcome described = run({"schema", "--results"});
  EXPECT_EQ(described.exit_code, 0) << described.errors;
  EXPECT_TRUE(nlohmann::json::parse(described.output).at("experiments").contains("cycle"));
  const auto of_cases = nlohmann::json::parse(run({"schema"}).output);
  EXPECT_EQ(of_cases.at("properties").at("bearing").at("properties").at("radius").at("title"), "Radius");
}

TEST_F(Program, InitListsTheKeys) {
  const ProgramOutcome keys = run({"init", "--keys"});
  EXPECT_EQ(keys.exit_code, 0) << keys.errors;
  EXPECT_NE(keys.output.find("\n| `radial_clearance` | length | required |"), std::string::npos);
}

TEST_F(Program, InitPrintsOrWrites) {
  EXPECT_EQ(run({"init"}).output, folder_.read("case.toml"));
  EXPECT_EQ(run({"init", "--preset", "gen1"}).output, folder_.read("case.toml"));
  const ProgramOutcome again = run({"init", "-o", case_path_});
  EXPECT_EQ(again.exit_code, 4);
  EXPECT_NE(again.errors.find("exists already"), std::string::npos);
  folder_.write("case.toml", "mine");
  EXPECT_EQ(run({"init", "-o", case_path_, "--force"}).exit_code, 0);
  EXPECT_EQ(run({"init"}).output, folder_.read("case.toml"));
  EXPECT_EQ(run({"init", "--preset", "gen9"}).exit_code, 2);
}

TEST_F(Program, RunsItsPresets) {
  for (const auto& [preset, command] : {std::pair{"gen1-rubio", "cycle"},
                                        {"gen2-three-strips", "cycle"},
                                        {"gen3-three-pad", "cycle"},
                                        {"larsen-strip", "strip"},
                                        {"running", "equilibrium"}}) {
    const std::string path = (folder_.path() / preset).string();
    EXPECT_EQ(run({"init", "--preset", preset, "-o", path}).exit_code, 0) << preset;
    const ProgramOutcome done =
        run({command, path, "-o", results_, "--force", "--set", std::string(command) + ".steps=4"});
    EXPECT_EQ(done.exit_code, 0) << done.errors;
    EXPECT_EQ(summary().at("status"), "complete") << preset;
    for (const json& state : summary().value("states", json::array())) EXPECT_EQ(state.at("stable"), true) << preset;
  }
  // No truss has the bumps of the strip: its known properties are printed, with advice.
  const std::string strip = (folder_.path() / "larsen-strip").string();
  EXPECT_NE(run({"properties", strip}).output.find("no spring is negative"), std::string::npos);
  const std::vector<std::string> as_truss{strip, "--set", "bump_foil.model=truss"};
  const ProgramOutcome truss = run(std::vector<std::string>{"check"} + as_truss);
  EXPECT_EQ(truss.exit_code, 2);
  EXPECT_NE(truss.errors.find("bump_foil.truss.k2: is identified as -4.801e+06 N/m"), std::string::npos)
      << truss.errors;
  EXPECT_NE(truss.errors.find("set bump_foil.model = \"frame\", or give k2, k3 and k4, with k2 + k3 = 3.187e+06 N/m"),
            std::string::npos)
      << truss.errors;
  const ProgramOutcome properties = run(std::vector<std::string>{"properties"} + as_truss);
  EXPECT_EQ(properties.exit_code, 0) << properties.errors;
  EXPECT_NE(properties.output.find("no spring is negative"), std::string::npos) << properties.output;
}

TEST_F(Program, TakesAFrameForATrussThatNobodyAskedFor) {
  const std::vector<std::string> steep{"--set", "bump_foil.pitch=4.6 mm",  "--set", "bump_foil.length=3.2 mm",
                                       "--set", "bump_foil.height=0.55 mm"};
  EXPECT_EQ(run(cycle_ + steep + std::vector<std::string>{"--set", "bump_foil.model=truss"}).exit_code, 2);
  const ProgramOutcome framed = run(cycle_ + steep);
  EXPECT_EQ(framed.exit_code, 0) << framed.errors;
  const std::string said = "the bump foil is modelled as a frame, since it cannot be a truss";
  EXPECT_NE(framed.errors.find("warning: " + said), std::string::npos) << framed.errors;
  EXPECT_EQ(summary().at("case").at("bump_foil").at("model"), "frame");
  EXPECT_NE(summary().at("cycles").at(0).at("warnings").at(0).get<std::string>().find(said), std::string::npos);
  for (const std::string command : {"check", "properties"}) {
    const ProgramOutcome requested = run(std::vector<std::string>{command, case_path_} + steep);
    EXPECT_EQ(requested.exit_code, 0) << requested.errors;
    EXPECT_EQ(requested.errors.find("warning: " + said), 0U) << requested.errors;
  }
  const ProgramOutcome ensemble =
      run(std::vector<std::string>{"montecarlo", case_path_, "-o", results_, "--force", "--samples", "2", "--set",
                                   "cycle.steps=4", "--set", "montecarlo.bump_length.std=0.2 mm"} +
          steep);
  EXPECT_NE(ensemble.errors.find("warning: " + said), std::string::npos) << ensemble.errors;
  EXPECT_EQ(summary().at("case").at("bump_foil").at("model"), "frame");
  EXPECT_NE(summary().at("warnings").at(0).get<std::string>().find(said), std::string::npos);
  EXPECT_TRUE(run(cycle_ + std::vector<std::string>{"--force"}).errors.empty());
  EXPECT_EQ(summary().at("case").at("bump_foil").at("model"), "truss");
}

TEST_F(Program, OverridesKeysAsTheShellLeavesThem) {
  EXPECT_EQ(run(cycle_ + std::vector<std::string>{"--set", "friction.coefficient=0.2", "--set",
                                                  "bump_foil.height=0.5 mm", "--solver", "newton"})
                .exit_code,
            0);
  EXPECT_EQ(summary().at("case").at("friction").at("top_bump"), 0.2);
  EXPECT_EQ(summary().at("case").at("bump_foil").at("height"), 0.5e-3);
  EXPECT_EQ(summary().at("case").at("cycle").at("steps"), 4);
}

TEST_F(Program, OverridesMayStandBeforeTheCase) {
  EXPECT_EQ(run({"cycle", "--set", "cycle.steps=4", case_path_, "-o", results_}).exit_code, 0);
  EXPECT_EQ(summary().at("case").at("cycle").at("steps"), 4);
}

TEST_F(Program, OverridesMayFollowOneAnother) {
  EXPECT_EQ(run({"cycle", "--set", "cycle.steps=4", "friction.coefficient=0.3", "bump_foil.height=0.5 mm", case_path_,
                 "-o", results_})
                .exit_code,
            0);
  EXPECT_EQ(summary().at("case").at("cycle").at("steps"), 4);
  EXPECT_EQ(summary().at("case").at("friction").at("top_bump"), 0.3);
  EXPECT_EQ(summary().at("case").at("bump_foil").at("height"), 0.5e-3);
}

TEST_F(Program, ReadsACaseFromTheStandardInput) {
  const std::string program = std::filesystem::absolute(BUMPFOIL_PROGRAM).string();
  const auto shell = [&](const std::string& script) { return WEXITSTATUS(std::system(script.c_str())); };
  const std::string from = " < '" + case_path_ + "'";
  EXPECT_EQ(shell(program + " check - --quiet" + from), 0);
  EXPECT_EQ(shell(program + " cycle - -o '" + results_ + "' --set cycle.steps=4 --quiet" + from), 0);
  EXPECT_EQ(summary().at("case").at("cycle").at("steps"), 4);
  const std::string errors = results_ + "/errors";
  EXPECT_EQ(shell("echo 'x = 1' | " + program + " check - 2> '" + errors + "'"), 2);
  std::ifstream said(errors);
  EXPECT_NE(std::string(std::istreambuf_iterator<char>(said), {}).find("standard input:1: x"), std::string::npos);
  EXPECT_EQ(shell(program + " check - 2> '" + errors + "' < /dev/null"), 2);
  std::ifstream said_of_nothing(errors);
  EXPECT_NE(std::string(std::istreambuf_iterator<char>(said_of_nothing), {}).find("standard input: is empty"),
            std::string::npos);
  EXPECT_NE(run({"help", "check"}).output.find("- for the standard input"), std::string::npos);
}

TEST_F(Program, PropertiesPrintsTextOrJson) {
  const ProgramOutcome text = run({"properties", case_path_});
  EXPECT_EQ(text.exit_code, 0) << text.errors;
  EXPECT_NE(text.output.find("k1, rods"), std::string::npos);
  const ProgramOutcome structured = run({"properties", case_path_, "--json", "--set", "bump_foil.truss.k1=150 MN/m"});
  EXPECT_EQ(json::parse(structured.output).at("truss").at("k1_N_per_m"), 150e6);
}

TEST_F(Program, PropertiesSayWherePadsLie) {
  ASSERT_EQ(run({"init", "--preset", "gen3-three-pad", "-o", case_path_, "--force"}).exit_code, 0);
  const std::vector<std::string> turned{"--set", "bearing.weld_angle=180 deg", "bearing.pad_gap=10 deg",
                                        "pad[2].weld_edge=trailing"};
  const ProgramOutcome text = run(std::vector<std::string>{"properties", case_path_} + turned);
  ASSERT_EQ(text.exit_code, 0) << text.errors;
  // A third of the circumference each, 10 deg of it free; 8 pitches of 4.572 mm are 110.0079 deg of 19.05 mm.
  for (const char* line : {"Pad 1: weld at 180 deg, clockwise to its free end at 70 deg; pitches stretched by 0.99993",
                           "Pad 2: weld at -50 deg, counterclockwise to its free end at 60 deg;",
                           "Pad 3: weld at -60 deg, clockwise to its free end at -170 deg;"}) {
    EXPECT_NE(text.output.find(line), std::string::npos) << text.output;
  }
}

TEST_F(Program, RefusesToReplaceResultsUnlessForced) {
  EXPECT_EQ(run(cycle_).exit_code, 0);
  const json first = summary();
  const ProgramOutcome second = run(cycle_ + std::vector<std::string>{"--set", "friction.coefficient=0"});
  EXPECT_EQ(second.exit_code, 4);
  EXPECT_NE(second.errors.find("--force"), std::string::npos);
  EXPECT_EQ(summary(), first);
  EXPECT_EQ(run(cycle_ + std::vector<std::string>{"--set", "friction.coefficient=0", "--force"}).exit_code, 0);
  EXPECT_NE(summary(), first);
}

TEST_F(Program, WritesNothingForAWrongCase) {
  for (const test_support::WrongCase& wrong : test_support::wrong_cases()) {
    SCOPED_TRACE(wrong.name);
    const ProgramOutcome outcome = run({"cycle", folder_.write("wrong.toml", wrong.text), "-o", results_});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.errors.find("wrong.toml"), std::string::npos);
    // At least: `cycle` also reports a missing table.
    EXPECT_GE(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'),
              static_cast<std::ptrdiff_t>(wrong.errors));
    EXPECT_FALSE(wrote_results());
  }
}

TEST_F(Program, RefusesAHundredMegabytes) {
  folder_.write("large.toml", "");
  std::filesystem::resize_file(folder_.path() / "large.toml", 100'000'000);
  const ProgramOutcome outcome = run({"cycle", (folder_.path() / "large.toml").string(), "-o", results_});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("is larger than 10 MB"), std::string::npos);
  EXPECT_FALSE(wrote_results());
}

TEST_F(Program, WantsACycleForCycle) {
  std::string text = test_support::whole_case();
  text.resize(text.find("[cycle]"));
  const std::string without = folder_.write("without.toml", text);
  EXPECT_EQ(run({"check", without}).exit_code, 0);
  const ProgramOutcome outcome = run({"cycle", without, "-o", results_});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("cycle: this table is missing"), std::string::npos);
  EXPECT_FALSE(wrote_results());
}

TEST_F(Program, FilesThatCannotBeReadOrWrittenAreTold) {
  EXPECT_EQ(run({"check", (folder_.path() / "missing.toml").string()}).exit_code, 4);
  EXPECT_EQ(run({"check", folder_.path().string()}).exit_code, 4);
  EXPECT_EQ(run({"cycle", case_path_, "-o", case_path_}).exit_code, 4);
  EXPECT_EQ(run({"cycle", case_path_, "-o", case_path_ + "/below"}).exit_code, 4);
  EXPECT_EQ(run({"init", "-o", (folder_.path() / "missing/case.toml").string()}).exit_code, 4);
  const TemporaryFolder elsewhere;
  EXPECT_EQ(Running({"check", case_path_}, "/dev/full").wait(), 4);
}

TEST_F(Program, WrongCommandLinesAreWrongInput) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"frobnicate"},
                                             {"cycle"},
                                             {"cycle", case_path_},
                                             {"cycle", "-o", results_},
                                             {"check"},
                                             {"reproduce"},
                                             {"reproduce", "-o", results_, "--figure", "9"},
                                             {"reproduce", "-o", results_, "--study", "figure9"},
                                             {"check", case_path_, "--frob"},
                                             {"check", case_path_, case_path_},
                                             {"cycle", case_path_, "-o"},
                                             {"cycle", case_path_, "-o", results_, "--set"},
                                             {"cycle", case_path_, "-o", results_, "--set", "steps"},
                                             {"cycle", case_path_, "-o", results_, "--solver", "newtn"},
                                             {"cycle", case_path_, "-o", results_, "--solver", ""},
                                             {"cycle", case_path_, "-o", results_, "--solver="},
                                             {"cycle", case_path_, "-o", ""},
                                             {"check", ""},
                                             {"check", case_path_, "--set", ""},
                                             {"init", "-o", ""},
                                             {"init", "--preset", ""},
                                             {"report", ""},
                                             {"report", results_, "-o", ""},
                                             {"reproduce", "-o", ""}}) {
    const ProgramOutcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
    EXPECT_NE(outcome.errors, "");
    EXPECT_EQ(outcome.output, "");
  }
  EXPECT_FALSE(wrote_results());
}

TEST_F(Program, HelpsEverywhere) {
  for (const char* command : {"init", "check", "properties", "cycle", "sweep", "reproduce"}) {
    const ProgramOutcome help = run({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.output.find("Example"), std::string::npos) << command;
    EXPECT_NE(help.output.find(std::string("bumpfoil ") + command), std::string::npos) << command;
    EXPECT_EQ(help.errors, "");
    EXPECT_NE(run({"--help"}).output.find(command), std::string::npos);
    EXPECT_EQ(run({command, "--version"}).output, run({"--version"}).output);
  }
  EXPECT_TRUE(run({"--version"}).output.starts_with("bumpfoil "));
  EXPECT_EQ(run({"-V"}).output, run({"--version"}).output);
  EXPECT_EQ(run({"help", "sweep"}).output, run({"sweep", "--help"}).output);
  EXPECT_EQ(run({"help"}).output, run({"--help"}).output);
}

TEST_F(Program, IsQuietIfAsked) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--quiet", "check", case_path_},
                                             {"check", case_path_, "--quiet"},
                                             cycle_ + std::vector<std::string>{"--quiet"}}) {
    const ProgramOutcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.output + outcome.errors, "");
  }
  EXPECT_TRUE(wrote_results());
  EXPECT_NE(run({"--quiet", "check", "missing.toml"}).errors, "");
}

#if BUMPFOIL_HAS_REPORT
TEST_F(Program, ReportGoesBesideTheResultsOrWhereItIsTold) {
  ASSERT_EQ(run(cycle_).exit_code, 0);
  const ProgramOutcome report = run({"report", results_});
  EXPECT_EQ(report.exit_code, 0) << report.errors;
  EXPECT_EQ(report.output, "wrote " + results_ + "/report.html\n");
  const std::string page = folder_.read("results/report.html");
  EXPECT_EQ(page.find("<!doctype html>"), 0U);
  EXPECT_NE(page.find("\"schema\":\"bumpfoil-report/1\""), std::string::npos);

  const ProgramOutcome again = run({"report", results_});
  EXPECT_EQ(again.exit_code, 4);
  EXPECT_NE(again.errors.find("--force"), std::string::npos);
  EXPECT_EQ(run({"report", results_, "--force", "--quiet"}).output, "");
  EXPECT_EQ(folder_.read("results/report.html"), page);

  const std::string elsewhere = (folder_.path() / "both.html").string();
  EXPECT_EQ(run({"report", results_, results_, "-o", elsewhere}).exit_code, 0);
  EXPECT_GT(folder_.read("both.html").size(), page.size());

  // A report of replaced results would be wrong.
  EXPECT_EQ(run(cycle_ + std::vector<std::string>{"--force"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(results_ + "/report.html"));
}

TEST_F(Program, ReportNamesEveryFolderWithoutResults) {
  const ProgramOutcome report = run({"report", "nowhere", folder_.path().string()});
  EXPECT_EQ(report.exit_code, 4);
  EXPECT_NE(report.errors.find("nowhere: does not exist"), std::string::npos) << report.errors;
  EXPECT_NE(report.errors.find("result.nc is missing"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "report.html"));
  EXPECT_EQ(run({"report"}).exit_code, 2);
}
#else
TEST_F(Program, ReportSaysWhatItWasBuiltWithout) {
  ASSERT_EQ(run(cycle_).exit_code, 0);
  const ProgramOutcome report = run({"report", results_});
  EXPECT_EQ(report.exit_code, 4);
  EXPECT_NE(report.errors.find("Node.js"), std::string::npos);
}
#endif

TEST_F(Program, AnInterruptedRunLeavesFlaggedResults) {
  // Long enough to be interrupted on any machine: what it has computed then is written.
  Running program({"cycle", case_path_, "-o", results_, "--set", "cycle.steps=20000"},
                  (folder_.path() / "output").string());
  while (!wrote_results()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  program.interrupt();
  EXPECT_EQ(program.wait(), 130);
  EXPECT_NE(program.errors().find("interrupted"), std::string::npos);
  EXPECT_EQ(summary().at("status"), "interrupted");
  EXPECT_EQ(summary().at("cycles").back().at("converged"), false);
  EXPECT_EQ(names_in("results"), (std::set<std::string>{"cycle.csv", "result.nc", "summary.json"}));
}

TEST_F(Program, ReproducesAFigure) {
  const std::vector<std::string> reproduce{"reproduce", "-o", results_, "--figure", "16"};
  const ProgramOutcome outcome = run(reproduce);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_NE(outcome.output.find("figure16"), std::string::npos);
  EXPECT_EQ(names_in("results"), std::set<std::string>{"figure16"});
  EXPECT_EQ(names_in("results/figure16"), (std::set<std::string>{"contacts.csv", "foils.csv", "picture.gp",
                                                                 "picture.svg", "scatter20-bearing4", "study.json"}));
  EXPECT_EQ(names_in("results/figure16/scatter20-bearing4"),
            (std::set<std::string>{"case.toml", "cycle.csv", "result.nc", "summary.json"}));
  EXPECT_NE(folder_.read("results/figure16/picture.svg").find("</svg>"), std::string::npos);

  // The case stored with the results reproduces them.
  const std::string again = (folder_.path() / "again").string();
  EXPECT_EQ(run({"cycle", results_ + "/figure16/scatter20-bearing4/case.toml", "-o", again}).exit_code, 0);
  EXPECT_EQ(folder_.read("again/cycle.csv"), folder_.read("results/figure16/scatter20-bearing4/cycle.csv"));

  const ProgramOutcome refused = run(reproduce);
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_NE(refused.errors.find("already contains results (study.json)"), std::string::npos);
  const ProgramOutcome replaced = run(reproduce + std::vector<std::string>{"--force", "--quiet"});
  EXPECT_EQ(replaced.exit_code, 0);
  EXPECT_EQ(replaced.output + replaced.errors, "");
}

TEST_F(Program, ReproducesWithoutGnuplot) {
  const std::vector<std::string> reproduce{"reproduce", "-o", results_, "--study", "figure16", "--force"};
  EXPECT_EQ(run(reproduce).exit_code, 0);
  EXPECT_TRUE(names_in("results/figure16").contains("picture.svg"));
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder_.path().c_str(), 1);
  const ProgramOutcome outcome = run(reproduce);
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.errors.find("gnuplot is not installed"), std::string::npos);
  // The picture of the previous run would not match these results.
  EXPECT_EQ(names_in("results/figure16"),
            (std::set<std::string>{"contacts.csv", "foils.csv", "picture.gp", "scatter20-bearing4", "study.json"}));
  EXPECT_EQ(std::system(("cd " + results_ + "/figure16 && gnuplot picture.gp 2> /dev/null").c_str()), 0);
  EXPECT_TRUE(names_in("results/figure16").contains("picture.svg"));
}

TEST_F(Program, AnInterruptedReproductionLeavesWholeStudies) {
  Running program({"reproduce", "-o", results_, "--all"}, (folder_.path() / "output").string());
  while (!std::filesystem::exists(results_ + "/figure10/study.json")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  program.interrupt();
  EXPECT_EQ(program.wait(), 130);
  EXPECT_NE(program.errors().find("interrupted"), std::string::npos);
  for (const std::string& study : names_in("results")) {
    EXPECT_TRUE(names_in("results/" + study).contains("study.json")) << study;
  }
  EXPECT_FALSE(names_in("results").contains("clearance"));
}

}  // namespace
}  // namespace bumpfoil
