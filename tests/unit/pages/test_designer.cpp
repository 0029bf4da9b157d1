#include "bumpfoil/pages/designer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/increment_rows.hpp"
#include "bumpfoil/experiments/cycle/sampled_cycles.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/properties/properties.hpp"
#include "bumpfoil/experiments/properties/properties_report.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/cycle/cycle_outcome.hpp"
#include "experiments/equilibrium/equilibrium_json.hpp"
#include "experiments/equilibrium/running_outcome.hpp"
#include "pages/shown_run.hpp"
#include "pages/shown_states.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

json ask(const json& request) {
  return json::parse(designer_answer(request.dump()));
}

std::string case_text(int steps = 10) {
  Case input = reference_case();
  input.settings.get<CycleSettings>().steps = steps;
  return case_to_toml(input);
}

std::string with_ensemble(const std::string& text) {
  return text + "\n[montecarlo]\nsamples = 4\nseed = 7\nbump_height = { distribution = \"normal\", std = \"5 um\" }\n";
}

TEST(DesignerAnswer, DescribesEveryKeyOfTheCaseFile) {
  const json answer = ask({{"what", "keys"}});
  EXPECT_EQ(answer["version"], version());
  const auto key = [&answer](const std::string& path) {
    const json& keys = answer["keys"];
    return *std::find_if(keys.begin(), keys.end(), [&path](const json& one) { return one["path"] == path; });
  };
  EXPECT_EQ(key("bearing.radius")["unit"], "m");
  EXPECT_EQ(key("bearing.radius")["value"], 19.05e-3);
  EXPECT_EQ(key("bearing.radius")["presence"], "required");
  EXPECT_EQ(key("bump_foil.truss")["kind"], "");
  EXPECT_EQ(key("top_foil.youngs_modulus")["otherwise"], "bump_foil.youngs_modulus");
  // The page lists all keys of case files: those of the reference page.
  const std::string reference = case_reference();
  for (const json& one : answer["keys"]) {
    const auto path = one["path"].get<std::string>();
    const std::string name = path.substr(path.rfind('.') + 1);
    EXPECT_NE(reference.find(name.substr(0, name.find('['))), std::string::npos) << path;
  }
  for (const auto& [name, text] : answer["presets"].items()) EXPECT_NO_THROW(parse_case(text.get<std::string>(), name));
}

TEST(DesignerAnswer, OffersUnitsWithTheirSizes) {
  const json units = ask({{"what", "keys"}})["units"];
  EXPECT_EQ(units["m"]["um"], 1e-6);
  EXPECT_DOUBLE_EQ(units["m"]["inch"].get<double>(), 25.4e-3);
  EXPECT_EQ(units["N/m"]["N/um"], 1e6);
  EXPECT_DOUBLE_EQ(units["rad"]["deg"].get<double>(), 0.017453292519943295);
  EXPECT_EQ(units["rad"]["mrad"], 1e-3);
  // Revolutions are counted: 60 rpm are one revolution per second.
  EXPECT_DOUBLE_EQ(60.0 * units["rad/s"]["rpm"].get<double>(), 6.283185307179586);
  for (const auto& [si, sizes] : units.items()) EXPECT_EQ(sizes[si], 1.0) << si;
}

TEST(DesignerAnswer, CyclesAreThoseOfAReport) {
  const Case input = parse_case(case_text(), "case");
  const CycleResult result = run_cycles(input);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& file : test_support::files_of("cycle", input, cycle_outcome(input, result)))
    folder.write(file.name, file.contents);
  json expected = json::parse(report_json({folder.path()}))["runs"][0];
  json run = json::parse(shown_run(input, result).dump());
  for (const char* part : {"kind", "nodes", "last_increment", "quantities"})
    EXPECT_EQ(run[part], expected[part]) << part;
  // The file also has the numbers of bumps and feet.
  for (const auto& [name, values] : run["geometry"].items()) EXPECT_EQ(values, expected["geometry"][name]) << name;
  EXPECT_EQ(run["geometry"].size() + 2, expected["geometry"].size());
  for (const auto& [name, meaning] : run["meanings"].items()) {
    if (!expected["meanings"].contains(name)) continue;
    EXPECT_EQ(meaning, expected["meanings"][name]) << name;
  }
  ASSERT_EQ(run["cycles"].size(), expected["cycles"].size());
  for (std::size_t i = 0; i < run["cycles"].size(); ++i) {
    const json& cycle = run["cycles"][i];
    const json& stored = expected["cycles"][i];
    for (const char* part : {"at", "increments", "fields"}) EXPECT_EQ(cycle[part], stored[part]) << i << ' ' << part;
    for (const auto& [name, values] : stored["series"].items()) {
      // A truss has no stresses of the bump foil; the file has fill values.
      if (name.find("stress_bump_foil") == 0) {
        EXPECT_FALSE(cycle["series"].contains(name));
      } else {
        EXPECT_EQ(cycle["series"][name], values) << i << ' ' << name;
      }
    }
    const json& summary = run["summary"]["cycles"][i];
    for (const auto& [key, value] : summary.items()) EXPECT_EQ(value, expected["summary"]["cycles"][i][key]) << key;
  }
  EXPECT_EQ(run["summary"]["case"], expected["summary"]["case"]);
}

TEST(DesignerAnswer, ComputesTheCaseItIsGiven) {
  const json answer = ask({{"what", "cycles"}, {"text", case_text()}});
  const CycleResult result = run_cycles(parse_case(case_text(), "case"));
  ASSERT_EQ(answer["run"]["summary"]["cycles"].size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(answer["run"]["summary"]["cycles"][i]["max_force_N"], result.cycles[i].turning_point->max_force);
  }
  const auto csv = ask({{"what", "csv"}, {"text", case_text()}})["csv"].get<std::string>();
  EXPECT_EQ(csv, csv_text(increment_rows(result)));
  const json properties = ask({{"what", "properties"}, {"text", case_text()}});
  const Case input = parse_case(case_text(), "case");
  EXPECT_EQ(properties, json::parse(properties_json(input, compute_properties(input))));
}

/// Without data that differs between runs.
json cycles_of(const json& request) {
  json run = ask(request)["run"];
  for (json& cycle : run["summary"]["cycles"]) cycle.erase("wall_time_s");
  return run;
}

TEST(DesignerAnswer, DividesCyclesAmongSeveral) {
  const json whole = cycles_of({{"what", "cycles"}, {"text", case_text()}});
  // With more parts than directions some are empty.
  for (const std::size_t parts : {2U, 3U, 5U}) {
    json cycles = json::array();
    json summaries = json::array();
    for (std::size_t number = 0; number < parts; ++number) {
      json part = cycles_of({{"what", "cycles"}, {"text", case_text()}, {"part", {number, parts}}});
      EXPECT_LE(part["cycles"].size(), 2U);
      for (const json& one : part["cycles"]) cycles.push_back(one);
      for (const json& one : part["summary"]["cycles"]) summaries.push_back(one);
      part["cycles"] = whole["cycles"];
      part["summary"]["cycles"] = whole["summary"]["cycles"];
      EXPECT_EQ(part, whole) << number << " of " << parts;
    }
    EXPECT_EQ(cycles, whole["cycles"]) << parts;
    EXPECT_EQ(summaries, whole["summary"]["cycles"]) << parts;
  }
}

TEST(DesignerAnswer, VibratesAboutALoad) {
  Case input = parse_case(case_text(), "case");
  const std::vector<double> amplitudes{1e-6, 4e-6};
  const json answer = ask({{"what", "vibration"},
                           {"text", case_text()},
                           {"load", {0.0, -50.0}},
                           {"amplitudes", amplitudes},
                           {"steps", 10}});
  input.settings.set(VibrationSettings{
      .loads = {{0.0, -50.0}}, .directions = {0.0}, .amplitudes = amplitudes, .frequencies = {1.0}, .steps = 10});
  const std::vector<LinearFoils> foils = linear_foils(input.settings.get<VibrationSettings>(), run_vibration(input));
  ASSERT_EQ(answer["directions"].size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(answer["directions"][0]["stiffness"][k], foils[k].stiffness(0, 0));
    EXPECT_EQ(answer["directions"][0]["loss_factor"][k], foils[k].loss_factor.x());
    EXPECT_GT(answer["directions"][1]["dissipation"][k], 0.0);
  }
  // Larger amplitudes cause more slip and a lower stiffness.
  EXPECT_LT(answer["directions"][1]["stiffness"][1], answer["directions"][1]["stiffness"][0]);
}

/// A running bearing on a coarse mesh.
std::string running_text() {
  Case input = reference_case();
  input.film.columns_per_pitch = 4;
  input.film.rows = 4;
  input.settings.set(EquilibriumSettings{.speeds = {3000.0, 4000.0}, .loads = {{20.0, 0.0}}, .steps = 4});
  return case_to_toml(input);
}

TEST(DesignerAnswer, RunningBearingsAreThoseOfAReport) {
  Case input = parse_case(running_text(), "case");
  input.settings.get<EquilibriumSettings>().loads = {{20.0, 0.0}, {5000.0, 0.0}};  // the second one is too large
  const EquilibriumResult result = run_equilibrium(input);
  ASSERT_EQ(status_of(result), RunStatus::failed);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& file : test_support::files_of("equilibrium", input, running_outcome(input, result)))
    folder.write(file.name, file.contents);
  const json expected = json::parse(report_json({folder.path()}))["runs"][0];
  const json run = json::parse(shown_states(input, result).dump());
  for (const char* part : {"kind", "dimensions", "left_out", "quantities"})
    EXPECT_EQ(run[part], expected[part]) << part;
  for (const auto& [name, variable] : expected["variables"].items())
    EXPECT_EQ(run["variables"][name], variable) << name;
  EXPECT_EQ(run["variables"].size(), expected["variables"].size());
  for (const auto& [name, text] : run["attributes"].items())
    EXPECT_EQ(text, expected["attributes"].value(name, "")) << name;
  for (const char* part : {"case", "status"}) EXPECT_EQ(run["summary"][part], expected["summary"][part]) << part;
}

/// Without data that differs between runs.
json states_of(const json& request) {
  json states = ask(request)["states"];
  for (json& state : states) state.erase("wall_time_s");
  return states;
}

json states_of(const Case& input) {
  const EquilibriumResult result = run_equilibrium(input);
  json states = json::array();
  for (const RunningState& state : result.states) {
    states.push_back(json::parse(state_json(*result.bearing, state).dump()));
    states.back().erase("wall_time_s");
  }
  return states;
}

TEST(DesignerAnswer, RunsTheBearingAtPoints) {
  Case input = parse_case(running_text(), "case");
  json request{{"what", "equilibrium"},
               {"text", running_text()},
               {"speeds", {2500.0, 3500.0}},
               {"loads", {{30.0, -10.0}, {40.0, -10.0}}}};
  EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  equilibrium.speeds = {2500.0, 3500.0};
  equilibrium.loads = {{30.0, -10.0}, {40.0, -10.0}};
  const json loaded = states_of(request);
  EXPECT_EQ(loaded, states_of(input));
  ASSERT_EQ(loaded.size(), 4U);
  EXPECT_EQ(loaded[0]["status"], "converged");
  // The mesh of the case has 4 columns and 4 rows, and a quick answer follows one path.
  request["mesh"] = {4, 3};
  input.film.rows = 3;
  equilibrium.paths = ComparedPaths::one;
  EXPECT_EQ(states_of(request), states_of(input));
  EXPECT_NE(states_of(request)[0], loaded[0]);
  // The only path of a case that does not lead to positions is a load ramp.
  equilibrium.loads.clear();
  equilibrium.positions = {{10e-6, 5e-6}};
  equilibrium.path = FilmPath::position_ray;
  request.erase("loads");
  request["positions"] = {{10e-6, 5e-6}};
  EXPECT_EQ(states_of(request), states_of(input));
  const json touching =
      ask({{"what", "equilibrium"}, {"text", running_text()}, {"speeds", {2500.0}}, {"loads", {{5000.0, 0.0}}}});
  EXPECT_EQ(touching["states"][0]["status"], "touchdown");
  EXPECT_EQ(touching["states"][0]["reason"], touching["run"]["attributes"]["status_message"]);
  EXPECT_NE(touching["states"][0]["reason"].get<std::string>().find("touchdown: the film is thinner"),
            std::string::npos);
}

TEST(DesignerAnswer, RunsBearingsOfAnEnsemble) {
  const std::string text = with_ensemble(running_text());
  const json request{
      {"what", "equilibrium"}, {"text", text}, {"speeds", {3000.0}}, {"loads", {{20.0, 0.0}}}, {"sample", 2}};
  const Case input = parse_case(text, "case", {.overrides = {}, .commands = {"montecarlo"}});
  Case second = sampled_case(input, draw_sample(input, 2));
  second.settings.get<EquilibriumSettings>().speeds = {3000.0};
  second.solver = parse_case(text, "case").solver;
  EXPECT_EQ(states_of(request), states_of(second));
  json without = request;
  without["text"] = running_text();
  EXPECT_EQ(ask(without)["errors"][0]["key"], "montecarlo");
}

TEST(DesignerAnswer, RunsWhatSaysNothingOfRunning) {
  const json request{{"what", "equilibrium"}, {"text", case_text()}, {"speeds", {4000.0}}, {"loads", {{50.0, 0.0}}}};
  EXPECT_EQ(ask(request)["states"][0]["status"], "converged");
}

TEST(DesignerAnswer, KnowsPads) {
  const json keys = ask({{"what", "keys"}});
  Case input = reference_case();
  input.bump_foil.bumps = 8;
  input.settings.get<CycleSettings>().steps = 10;
  const std::string text = case_to_toml(input) + "\n[[pad]]\n\n[[pad]]\n\n[[pad]]\n";
  EXPECT_NE(std::find_if(keys["keys"].begin(), keys["keys"].end(),
                         [](const json& one) { return one["path"] == "pad[1].lobe"; }),
            keys["keys"].end());
  EXPECT_EQ(ask({{"what", "cycles"}, {"text", text}})["run"]["nodes"]["pad"], 3);
}

TEST(DesignerAnswer, RefusesToRunWhatTheProgramRefuses) {
  const auto error = [](const std::string& text, double speed) {
    return ask({{"what", "equilibrium"}, {"text", text}, {"speeds", {speed}}, {"loads", {{50.0, 0.0}}}})["errors"][0];
  };
  EXPECT_EQ(error(running_text(), 0.0)["what"], "a journal at rest has no film");
  EXPECT_EQ(error(running_text(), 0.0)["key"], "equilibrium.speeds[1]");
  Case events = parse_case(running_text(), "case");
  events.solver.name = SolverName::events;
  EXPECT_EQ(error(case_to_toml(events), 3000.0)["key"], "solver.name");
}

/// A rotor of 2 kg whose whirl starts between these speeds, rad/s.
const std::vector<double> rotor_speeds{1250.0, 1450.0};
std::string rotor_text() {
  Case input = parse_case(running_text(), "case");
  input.settings.remove<EquilibriumSettings>();
  input.bearing.weld_angle = 0.5 * std::numbers::pi;
  input.bearing.wrap = Wrap::counterclockwise;
  input.top_foil.formed_radius = FormedRadius{.to = FormedTo::seated};
  RotorSettings rotor;
  rotor.mass = 2.0;
  input.settings.set(rotor);
  return case_to_toml(input);
}

TEST(DesignerAnswer, RotorsAreThoseOfAReport) {
  Case input = parse_case(rotor_text(), "case");
  // The last speed is a fraction of a turn per second, where the film carries no load.
  input.settings.set(StabilitySettings{.speeds = {1450.0, 1250.0, 1.0}});
  const StabilityResult result = run_stability(input);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& file : test_support::files_of("stability", input)) folder.write(file.name, file.contents);
  const json expected = json::parse(report_json({folder.path()}))["runs"][0];
  const json run = json::parse(shown_rotor(input, result).dump());
  EXPECT_FALSE(run["attributes"]["status_message"].empty());
  for (const char* part : {"kind", "dimensions", "left_out", "quantities", "variables"})
    EXPECT_EQ(run[part], expected[part]) << part;
  for (const auto& [name, text] : run["attributes"].items())
    EXPECT_EQ(text, expected["attributes"].value(name, "")) << name;
  for (const char* part : {"case", "status", "onsets"})
    EXPECT_EQ(run["summary"][part], expected["summary"][part]) << part;
  EXPECT_EQ(run["summary"]["onsets"].size(), 2U);
}

TEST(DesignerAnswer, FollowsTheRotorOverSpeedsOnAMeshThatIsCoarseEnough) {
  const auto onset_of = [](const json& mesh) {
    json request{{"what", "stability"}, {"text", rotor_text()}, {"speeds", rotor_speeds}};
    if (!mesh.is_null()) request["mesh"] = mesh;
    return ask(request)["run"]["summary"]["onsets"][0]["speed_rad_per_s"].get<double>();
  };
  Case input = parse_case(rotor_text(), "case");
  const auto expected = [&input] {
    input.settings.set(StabilitySettings{.speeds = rotor_speeds});
    return run_stability(input).map.onsets.front().onset.speed;
  };
  // The mesh of the case has 4 columns and 4 rows.
  const double own = expected();
  EXPECT_EQ(onset_of(nullptr), own);
  EXPECT_EQ(onset_of({6, 8}), own);
  input.film.rows = 2;
  EXPECT_EQ(onset_of({6, 2}), expected());
  EXPECT_NE(onset_of({6, 2}), own);
  EXPECT_EQ(ask({{"what", "stability"}, {"text", running_text()}, {"speeds", rotor_speeds}})["errors"][0]["key"],
            "rotor");
}

TEST(DesignerAnswer, CoarsensBearingsOfTheirOwn) {
  Case input = parse_case(rotor_text(), "case");
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.bearings = {-0.06, 0.06};
  rotor.transverse_inertia = 4e-3;
  rotor.polar_inertia = 5e-4;
  input.settings.set(rotor);
  input.rotor_bearings.resize(2);
  const auto onset_of = [&](int rows, const json& mesh) {
    FilmSettings film = input.film;
    film.rows = rows;
    input.rotor_bearings[0].film = film;
    json request{{"what", "stability"}, {"text", case_to_toml(input)}, {"speeds", rotor_speeds}};
    if (!mesh.is_null()) request["mesh"] = mesh;
    return ask(request)["run"]["summary"]["onsets"][0]["speed_rad_per_s"];
  };
  EXPECT_EQ(onset_of(6, {6, 4}), onset_of(4, nullptr));
  EXPECT_NE(onset_of(6, nullptr), onset_of(4, nullptr));
}

TEST(DesignerAnswer, DrawsTheSamplesOfTheProgram) {
  const std::string text = with_ensemble(case_text());
  const json answer = ask({{"what", "samples"}, {"text", text}, {"first", 1}, {"count", 2}});
  const Case input = parse_case(text, "case", {.overrides = {}, .commands = {"montecarlo"}});
  ASSERT_EQ(answer["samples"].size(), 2U);
  const auto name = [](const json& quantity) { return quantity["name"] == "max_force"; };
  const json& quantities = answer["quantities"];
  const auto place = std::find_if(quantities.begin(), quantities.end(), name) - quantities.begin();
  const CycleResult second = run_sampled_cycles(sampled_case(input, draw_sample(input, 2))).value();
  EXPECT_EQ(answer["samples"][1][3][static_cast<std::size_t>(place)], second.cycles[3].turning_point->max_force);
  EXPECT_NE(answer["samples"][0], answer["samples"][1]);
  const auto of_last = [&](const char* key) {
    json values = json::array();
    for (const json& sample : answer["samples"]) values.push_back(sample[3][static_cast<std::size_t>(place)]);
    values.push_back(nullptr);
    return ask({{"what", "statistics"}, {"values", values}})[key];
  };
  EXPECT_EQ(of_last("mean"), answer["statistics"][3]["max_force_N"]["mean"]);
  EXPECT_EQ(of_last("undefined"), 1);
  EXPECT_EQ(ask({{"what", "samples"}, {"text", case_text()}, {"first", 0}, {"count", 1}})["errors"][0]["key"],
            "montecarlo");
}

TEST(DesignerAnswer, SaysWhichTableIsMissingForLoops) {
  const std::string text = case_text();
  const json answer = ask({{"what", "cycles"}, {"text", text.substr(0, text.find("[cycle]"))}});
  ASSERT_EQ(answer["errors"].size(), 1U);
  EXPECT_EQ(answer["errors"][0]["key"], "cycle");
}

TEST(DesignerAnswer, TellsEveryErrorWithItsKey) {
  const json answer = ask({{"what", "cycles"}, {"text", "[bearing]\nradius = \"-1 mm\"\nraduis = 1\n"}});
  EXPECT_FALSE(answer.contains("run"));
  const auto error = [&answer](const std::string& key) {
    for (const json& one : answer["errors"]) {
      if (one["key"] == key) return one;
    }
    return json{};
  };
  EXPECT_EQ(error("bearing.radius")["line"], 2);
  EXPECT_EQ(error("bearing.raduis")["advice"], "did you mean \"radius\"?");
  EXPECT_EQ(error("bump_foil")["what"], "this table is missing");
  EXPECT_EQ(error("bearing.raduis")["message"].get<std::string>().find("bearing.raduis = 1: unknown key"), 0U);
  EXPECT_EQ(ask({{"what", "parsnips"}})["errors"][0]["what"], "is not a request");
  // Files cannot be read in a browser; invalid UTF-8 is repaired.
  EXPECT_EQ(ask({{"what", "cycles"}, {"text", "x = ["}})["errors"][0]["line"], 1);
}

}  // namespace
}  // namespace bumpfoil
