#include "bumpfoil/io/designer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/analysis/properties.hpp"
#include "bumpfoil/analysis/vibration.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/io/case_reader.hpp"
#include "bumpfoil/io/case_writer.hpp"
#include "bumpfoil/io/cycle_csv.hpp"
#include "bumpfoil/io/cycle_files.hpp"
#include "bumpfoil/io/properties_report.hpp"
#include "bumpfoil/io/report.hpp"
#include "io/shown_run.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

json ask(const json& request) {
  return json::parse(designer_answer(request.dump()));
}

std::string case_text(int steps = 10) {
  Case input = reference_case();
  input.cycle.steps = steps;
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
  // All keys that a case file may have are on the page's list: those of its reference page.
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
  // Turns are counted: 60 rpm are one turn each second.
  EXPECT_DOUBLE_EQ(60.0 * units["rad/s"]["rpm"].get<double>(), 6.283185307179586);
  for (const auto& [si, sizes] : units.items()) EXPECT_EQ(sizes[si], 1.0) << si;
}

TEST(DesignerAnswer, CyclesAreThoseOfAReport) {
  const Case input = parse_case(case_text(), "case");
  const CycleResult result = run_cycles(input);
  const testing::TemporaryFolder folder;
  for (const ResultFile& file : cycle_files(input, result, status_of(result), {}))
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
      // A truss knows no stresses of the bump foil; the file says so number by number.
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
  EXPECT_EQ(csv, cycle_csv(result));
  const json properties = ask({{"what", "properties"}, {"text", case_text()}});
  const Case input = parse_case(case_text(), "case");
  EXPECT_EQ(properties, json::parse(properties_json(input, compute_properties(input))));
}

/// Without what differs from run to run.
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
  input.vibration = VibrationSettings{
      .loads = {{0.0, -50.0}}, .directions = {0.0}, .amplitudes = amplitudes, .frequencies = {1.0}, .steps = 10};
  const std::vector<LinearFoils> foils = linear_foils(*input.vibration, run_vibration(input));
  ASSERT_EQ(answer["directions"].size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(answer["directions"][0]["stiffness"][k], foils[k].stiffness(0, 0));
    EXPECT_EQ(answer["directions"][0]["loss_factor"][k], foils[k].loss_factor.x());
    EXPECT_GT(answer["directions"][1]["dissipation"][k], 0.0);
  }
  // Larger motions slip more, and are held less stiffly.
  EXPECT_LT(answer["directions"][1]["stiffness"][1], answer["directions"][1]["stiffness"][0]);
}

TEST(DesignerAnswer, DrawsTheSamplesOfTheProgram) {
  const std::string text = with_ensemble(case_text());
  const json answer = ask({{"what", "samples"}, {"text", text}, {"first", 1}, {"count", 2}});
  const Case input = parse_case(text, "case");
  ASSERT_EQ(answer["samples"].size(), 2U);
  const auto name = [](const json& quantity) { return quantity["name"] == "max_force"; };
  const json& quantities = answer["quantities"];
  const auto place = std::find_if(quantities.begin(), quantities.end(), name) - quantities.begin();
  const CycleResult second = run_sample(sampled_case(input, draw_sample(input, 2)));
  EXPECT_EQ(answer["samples"][1][3][static_cast<std::size_t>(place)], second.cycles[3].turning_point->max_force);
  EXPECT_NE(answer["samples"][0], answer["samples"][1]);
  EXPECT_EQ(ask({{"what", "samples"}, {"text", case_text()}, {"first", 0}, {"count", 1}})["faults"][0]["key"],
            "montecarlo");
}

TEST(DesignerAnswer, SaysWhichTableIsMissingForLoops) {
  const std::string text = case_text();
  const json answer = ask({{"what", "cycles"}, {"text", text.substr(0, text.find("[cycle]"))}});
  ASSERT_EQ(answer["faults"].size(), 1U);
  EXPECT_EQ(answer["faults"][0]["key"], "cycle");
}

TEST(DesignerAnswer, TellsEveryFaultWithItsKey) {
  const json answer = ask({{"what", "cycles"}, {"text", "[bearing]\nradius = \"-1 mm\"\nraduis = 1\n"}});
  EXPECT_FALSE(answer.contains("run"));
  const auto fault = [&answer](const std::string& key) {
    for (const json& one : answer["faults"]) {
      if (one["key"] == key) return one;
    }
    return json{};
  };
  EXPECT_EQ(fault("bearing.radius")["line"], 2);
  EXPECT_EQ(fault("bearing.raduis")["advice"], "did you mean \"radius\"?");
  EXPECT_EQ(fault("bump_foil")["what"], "this table is missing");
  EXPECT_EQ(fault("bearing.raduis")["message"].get<std::string>().find("bearing.raduis = 1: is no known key"), 0U);
  EXPECT_EQ(ask({{"what", "parsnips"}})["faults"][0]["what"], "is no request");
  // Files cannot be read in a browser; texts that are no UTF-8 are mended.
  EXPECT_EQ(ask({{"what", "cycles"}, {"text", "x = ["}})["faults"][0]["line"], 1);
}

}  // namespace
}  // namespace bumpfoil
