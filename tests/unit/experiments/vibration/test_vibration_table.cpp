#include "bumpfoil/experiments/vibration/vibration_table.hpp"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <netcdf>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "experiments/vibration/ross_toml.hpp"
#include "experiments/vibration/vibration_outcome.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

/// One load is reachable, the other is not.
Case filed_vibration_case() {
  Case input = reference_case();
  input.settings.set(VibrationSettings{.loads = {{0.0, -50.0}, {0.0, -1e8}},
                                       .directions = {0.0, 0.5 * std::numbers::pi},
                                       .amplitudes = {1e-6, 2e-6},
                                       .frequencies = {1000.0, 2000.0},
                                       .steps = 8});
  return input;
}

struct Run {
  Case input{filed_vibration_case()};
  VibrationResult result{run_vibration(input)};
  std::vector<LinearFoils> foils{linear_foils(input.settings.get<VibrationSettings>(), result)};
  std::vector<ResultFile> files{test_support::files_of("vibration", input, vibration_outcome(input, result),
                                                       RunStatus::failed,
                                                       {.command_line = "bumpfoil", .case_text = ""})};

  [[nodiscard]] std::string file(std::string_view name) const {
    for (const ResultFile& one : files) {
      if (one.name == name) return one.contents;
    }
    ADD_FAILURE() << name;
    return {};
  }
};

const Run& run() {
  static const Run one;
  return one;
}

std::vector<std::vector<std::string>> table_of(const std::string& csv) {
  std::vector<std::vector<std::string>> table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    table.emplace_back();
    std::istringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
  }
  return table;
}

TEST(VibrationFiles, AreOneSetWithSummaryKnowingTheOthers) {
  const json summary = json::parse(run().file("summary.json"));
  ASSERT_EQ(run().files.size(), experiment_named("vibration").files.size());
  EXPECT_EQ(summary.at("schema"), "bumpfoil-summary/2");
  EXPECT_EQ(summary.at("command"), "vibration");
  EXPECT_EQ(summary.at("status"), "failed");
  EXPECT_EQ(summary.at("case").at("vibration").at("loads"), json::parse("[[0.0, -50.0], [0.0, -1e8]]"));
  for (const std::string& name : experiment_named("vibration").files) {
    if (name == "summary.json") continue;
    EXPECT_EQ(summary.at("files").at(name).at("xxh3_128"), xxh3_128(run().file(name))) << name;
  }
}

TEST(VibrationFiles, TabulateCoefficientsInTheColumnsThatOthersRelyOn) {
  const auto table = table_of(run().file("coefficients.csv"));
  ASSERT_EQ(run().file("coefficients.csv").substr(0, run().file("coefficients.csv").find('\n')),
            "load_x_N,load_y_N,amplitude_m,frequency_rad_per_s,kxx_N_per_m,kxy_N_per_m,kyx_N_per_m,kyy_N_per_m,"
            "cxx_N_s_per_m,cxy_N_s_per_m,cyx_N_s_per_m,cyy_N_s_per_m,residual,loss_factor_x,loss_factor_y");
  ASSERT_EQ(table.size(), 1U + 2U * 2U * 2U);
  const LinearFoils& foils = run().foils[1];  // the first load with the second amplitude
  const std::vector<std::string>& row = table[4];
  EXPECT_EQ(std::stod(row[1]), -50.0);
  EXPECT_EQ(std::stod(row[2]), 2e-6);
  EXPECT_EQ(std::stod(row[3]), 2000.0);
  EXPECT_EQ(std::stod(row[5]), foils.stiffness(0, 1));  // dF_x/dy
  EXPECT_EQ(std::stod(row[6]), foils.stiffness(1, 0));
  EXPECT_EQ(std::stod(row[8]), foils.loss(0, 0) / 2000.0);
  EXPECT_EQ(std::stod(row[12]), foils.residual);
  EXPECT_EQ(std::stod(row[13]), foils.loss_factor.x());
  EXPECT_EQ(table[5][4], "");  // not reached
}

TEST(VibrationFiles, TabulateVibrationsAndSaysWhatFailed) {
  const auto table = table_of(run().file("vibration.csv"));
  ASSERT_EQ(table.size(), 1U + 8U);
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), name) - table[0].begin());
  };
  EXPECT_EQ(table[3][column("direction_deg")], "90");
  EXPECT_EQ(std::stod(table[3][column("stiffness_direct_N_per_m")]), run().foils[0].stiffness(1, 1));
  EXPECT_EQ(table[3][column("status")], "converged");
  EXPECT_EQ(table[5][column("status")], "load_out_of_reach");
  EXPECT_EQ(table[5][column("loop_energy_J")], "");
  const std::vector<std::string> failures = failure_lines(run().input, run().result);
  ASSERT_EQ(failures.size(), 1U);  // not repeated for each vibration
  EXPECT_EQ(failures[0], "load (0, -1e+08) N was not reached: the load is not met before the bumps are pressed flat");
  const std::vector<Vibration>& vibrations = run().result.vibrations;
  const auto unsettled = std::count_if(vibrations.begin(), vibrations.end(), [](const Vibration& one) {
    return one.cycle.converged() && !one.cycle.settled;
  });
  ASSERT_GT(unsettled, 0);
  const std::vector<std::string> warnings = warning_lines(run().input, run().result);
  EXPECT_EQ(std::ssize(warnings), unsettled);
  EXPECT_EQ(warnings[0].find("load (0, -50) N, 0 deg, 1 um: the loop has not settled after 100 loops: its energy"), 0U);
  EXPECT_NE(vibration_table(run().input, run().result).find("loss factor"), std::string::npos);
  VibrationResult none = run().result;
  for (Vibration& vibration : none.vibrations) vibration.harmonic.reset();
  EXPECT_NE(vibration_table(run().input, run().result).find("MN/m"), std::string::npos);
  EXPECT_EQ(vibration_table(run().input, none).find("MN/m"), std::string::npos) << "a unit without a value";
}

TEST(VibrationFiles, SummaryHasTheSameNumbers) {
  const json summary = json::parse(run().file("summary.json"));
  EXPECT_EQ(summary.at("vibrations").size(), 8U);
  EXPECT_EQ(summary.at("coefficients").size(), 8U);
  EXPECT_EQ(summary.at("coefficients")[3].at("cxy_N_s_per_m"), run().foils[1].loss(0, 1) / 2000.0);
  EXPECT_TRUE(summary.at("coefficients")[4].at("kxx_N_per_m").is_null());
  EXPECT_EQ(summary.at("loads")[0].at("stuck").at("kyy_N_per_m"), (*run().result.loads[0].tangents.unloading)(1, 1));
  EXPECT_EQ(summary.at("loads")[1].at("status"), "load_out_of_reach");
  EXPECT_EQ(summary.at("vibrations")[0].at("settled"), run().result.vibrations[0].cycle.settled);
  EXPECT_EQ(summary.at("failures").size(), 1U);
}

TEST(VibrationFiles, NetcdfHasTheLoopsAndTheSameNumbers) {
  const test_support::TemporaryFolder folder;
  const netCDF::NcFile file(folder.write("result.nc", run().file("result.nc")), netCDF::NcFile::read);
  std::string text;
  file.getAtt("bumpfoil_command").getValues(text);
  EXPECT_EQ(text, "vibration");
  file.getAtt("status").getValues(text);
  EXPECT_EQ(text, "partial");
  double value = 0.0;
  file.getVar("cyx").getVar({0, 1, 0}, &value);
  EXPECT_EQ(value, run().foils[1].loss(1, 0) / 1000.0);
  file.getVar("kyy_stuck").getVar({0}, &value);
  EXPECT_EQ(value, (*run().result.loads[0].tangents.unloading)(1, 1));
  ASSERT_EQ(file.getDim("point").getSize(), 33U);
  const LoopPoint& point = run().result.vibrations[2].cycle.curve[8];
  file.getVar("displacement").getVar({0, 1, 0, 8}, &value);
  EXPECT_EQ(value, point.displacement);
  file.getVar("force_y").getVar({0, 1, 0, 8}, &value);
  EXPECT_EQ(value, point.force.y());
}

TEST(VibrationFiles, TellWhatEachPadTakes) {
  Case input = filed_vibration_case();
  input.bump_foil.bumps = 7;
  input.bearing.radial_clearance = -2e-6;
  input.pads.resize(3);
  input.settings.get<VibrationSettings>().directions.pop_back();
  const VibrationResult result = run_vibration(input);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& file : test_support::files_of("vibration", input, vibration_outcome(input, result), {},
                                                       {.command_line = "bumpfoil", .case_text = ""})) {
    folder.write(file.name, file.contents);
  }
  const netCDF::NcFile file((folder.path() / "result.nc").string(), netCDF::NcFile::read);
  const auto at = [&file](const char* name, const std::vector<std::size_t>& place) {
    double value = 0.0;
    file.getVar(name).getVar(place, &value);
    return value;
  };
  ASSERT_EQ(file.getDim("pad").getSize(), 3U);
  double sum = 0.0;
  double load = 0.0;
  for (std::size_t pad = 0; pad < 3; ++pad) {
    sum += at("pad_force_y", {0, 0, 1, 5, pad});
    load += at("load_pad_force_y", {0, pad});
    EXPECT_EQ(at("load_pad_force_y", {1, pad}), NC_FILL_DOUBLE);  // out of reach
    EXPECT_EQ(at("max_pad_forces", {1, 0, 0, pad}), NC_FILL_DOUBLE);
  }
  EXPECT_NEAR(sum, at("force_y", {0, 0, 1, 5}), 1e-9 * std::abs(sum));
  EXPECT_NEAR(load, -50.0, 1e-6);
  std::ifstream text(folder.path() / "summary.json");
  const json summary = json::parse(text);
  EXPECT_EQ(summary.at("vibrations")[1].at("max_pad_forces_N")[2], at("max_pad_forces", {0, 0, 1, 2}));
  EXPECT_EQ(summary.at("loads")[0].at("pad_forces_x_N")[1], at("load_pad_force_x", {0, 1}));
  EXPECT_TRUE(summary.at("loads")[1].at("pad_forces_x_N").is_null());
  EXPECT_NE(vibration_table(input, result).find("pad 3, max"), std::string::npos);
  EXPECT_EQ(vibration_table(run().input, run().result).find("pad 1"), std::string::npos);
  const json shown = json::parse(report_json({folder.path()})).at("runs").at(0).at("variables");
  EXPECT_EQ(shown.at("max_pad_forces").at("dims"), (json{"load", "direction", "amplitude", "pad"}));
}

TEST(VibrationFiles, AreReadByReports) {
  const test_support::TemporaryFolder folder;
  for (const ResultFile& file : run().files) folder.write(file.name, file.contents);
  const json one = json::parse(report_json({folder.path()})).at("runs").at(0);
  EXPECT_EQ(one.at("kind"), "vibration");
  EXPECT_EQ(one.at("variables").at("kxy").at("dims"), (json{"load", "amplitude"}));
  EXPECT_EQ(one.at("variables").at("kxy").at("text"), "stiffness dF_x/dy");
  EXPECT_EQ(one.at("variables").at("cyy").at("unit"), "N s/m");
  EXPECT_EQ(one.at("dimensions").at("direction"), 2);
  EXPECT_FALSE(one.at("summary").contains("vibrations"));
  for (const char* attribute : {"status_message", "warnings"}) EXPECT_TRUE(one.at("attributes").contains(attribute));
  for (const json& quantity : one.at("quantities")) {
    EXPECT_EQ(quantity.at("label").get<std::string>().find('_'), std::string::npos);
    EXPECT_TRUE(one.at("variables").contains(quantity.at("name"))) << quantity;
  }
}

TEST(RossToml, ReadsBackAsTheArgumentsOfABearing) {
  const toml::table document = toml::parse(run().file("coefficients.toml"));
  const toml::array& bearings = *document.get_as<toml::array>("bearing");
  ASSERT_EQ(bearings.size(), 2U);  // those about the load that was reached
  const toml::table& bearing = *bearings[1].as_table();
  EXPECT_EQ(bearing["load_N"][1].value<double>(), -50.0);
  EXPECT_EQ(bearing["amplitude_m"].value<double>(), 2e-6);
  const toml::table& element = *bearing["element"].as_table();
  // Only arguments that constructors accept.
  EXPECT_EQ(element.size(), 9U);
  const LinearFoils& foils = run().foils[1];
  const toml::array& frequencies = *element["frequency"].as_array();
  ASSERT_GE(frequencies.size(), 5U);
  double last = 0.0;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const double frequency = frequencies[i].value<double>().value();
    EXPECT_GT(frequency, last);  // ascending for interpolation
    last = frequency;
    EXPECT_TRUE(frequencies[i].is_floating_point());
    EXPECT_EQ(element["kxx"][i].value<double>(), foils.stiffness(0, 0));
    EXPECT_EQ(element["kxy"][i].value<double>(), foils.stiffness(0, 1));
    EXPECT_EQ(element["kyx"][i].value<double>(), foils.stiffness(1, 0));
    EXPECT_EQ(element["kyy"][i].value<double>(), foils.stiffness(1, 1));
    EXPECT_EQ(element["cxx"][i].value<double>(), foils.loss(0, 0) / frequency);
    EXPECT_EQ(element["cxy"][i].value<double>(), foils.loss(0, 1) / frequency);
    EXPECT_EQ(element["cyx"][i].value<double>(), foils.loss(1, 0) / frequency);
    EXPECT_EQ(element["cyy"][i].value<double>(), foils.loss(1, 1) / frequency);
  }
  for (const char* words : {"foils at rest", "gas film", "The case gives 2 frequencies", "1e+08"}) {
    EXPECT_NE(run().file("coefficients.toml").find(words), std::string::npos) << words;
  }
}

TEST(ExportedFrequencies, AreFiveAtLeast) {
  const std::vector<double> enough{5.0, 3.0, 1.0, 2.0, 4.0};
  EXPECT_EQ(exported_frequencies(enough), (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0}));
  const std::vector<double> one = exported_frequencies({300.0});
  ASSERT_EQ(one.size(), 9U);  // that of the case is among the nine
  EXPECT_EQ(one[0], 150.0);
  EXPECT_EQ(one[4], 300.0);
  EXPECT_NEAR(one[8], 600.0, 1e-9);  // a root and its power
  const std::vector<double> two = exported_frequencies({1000.0, 100.0});
  EXPECT_NE(std::find(two.begin(), two.end(), 1000.0), two.end());
  EXPECT_EQ(two.front(), 50.0);
  EXPECT_NEAR(two.back(), 2000.0, 1e-8);
}

TEST(VibrationFiles, OfOrbitsHaveASenseForADirection) {
  Case input = filed_vibration_case();
  VibrationSettings& vibration = input.settings.get<VibrationSettings>();
  vibration.loads.pop_back();
  vibration.motion = Motion::orbit;
  vibration.directions.clear();
  const VibrationResult result = run_vibration(input);
  const std::vector<LinearFoils> foils = linear_foils(vibration, result);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& file : test_support::files_of("vibration", input, vibration_outcome(input, result), {},
                                                       {.command_line = "bumpfoil", .case_text = ""})) {
    folder.write(file.name, file.contents);
  }
  const auto table = table_of(folder.read("vibration.csv"));
  ASSERT_EQ(table.size(), 1U + 4U);
  EXPECT_EQ(table[0][2], "sense");
  EXPECT_EQ(table[2][2], "counterclockwise");
  EXPECT_EQ(table[3][2], "clockwise");
  const json vibrations = json::parse(folder.read("summary.json")).at("vibrations");
  EXPECT_EQ(vibrations[2].at("sense"), "clockwise");
  // The outward force averaged over both senses is the mean of the direct stiffnesses.
  const double mean = 0.5 * (vibrations[0].at("stiffness_direct_N_per_m").get<double>() +
                             vibrations[2].at("stiffness_direct_N_per_m").get<double>());
  EXPECT_NEAR(mean, 0.5 * foils[0].stiffness.trace(), 1e-9 * mean);
  EXPECT_TRUE(vibrations[0].at("stiffness_cross_N_per_m").is_null());
  const netCDF::NcFile file((folder.path() / "result.nc").string(), netCDF::NcFile::read);
  EXPECT_EQ(file.getDim("sense").getSize(), 2U);
  EXPECT_TRUE(file.getDim("direction").isNull());
  EXPECT_EQ(file.getVar("loop_energy").getDim(1).getName(), "sense");
  EXPECT_EQ(file.getDim("point").getSize(), 32U);
  EXPECT_NE(vibration_table(input, result).find("  counterclockwise"), std::string::npos);
  EXPECT_NE(warning_lines(input, result).front().find("counterclockwise, 1 um"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
