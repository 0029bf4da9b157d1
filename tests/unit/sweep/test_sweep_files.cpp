#include "bumpfoil/sweep/sweep_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <netcdf>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"
#include "bumpfoil/experiments/vibration/vibration_table.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"
#include "experiments/cycle/cycle_outcome.hpp"
#include "experiments/vibration/vibration_outcome.hpp"
#include "readers/summary_reader.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

/// Two amplitudes and three friction coefficients; the last point failed, the one before was not started.
class SweepFiles : public ::testing::Test {
 protected:
  SweepFiles()
      : sweep_(parse_sweep(case_template("gen1"), "case.toml",
                           {.command = "cycle",
                            .over = {"cycle.amplitude=[60 um, 70 um]", "friction.coefficient=0:0.2:0.1"},
                            .overrides = {"cycle.steps=3", "cycle.directions=[\"-X\", \"+Y\"]"}})),
        results_(sweep_.cases.size()),
        points_(sweep_.cases.size()) {
    for (const std::size_t i : {0U, 1U, 2U, 3U, 5U}) {
      CycleResult& result = results_[i] = run_cycles(sweep_.cases[i]);
      if (i == 5) {
        result.cycles[1].status = Status::no_modes;
        result.cycles[1].increments.back().status = Status::no_modes;
      }
      points_[i] = sweep_point(sweep_, cycle_outcome(sweep_.cases[i], result));
    }
    complete(sweep_, points_);
    for (const ResultFile& file : sweep_files(sweep_, points_, {.command_line = "bumpfoil", .case_text = "text"})) {
      folder_.write(file.name, file.contents);
    }
  }

  [[nodiscard]] json summary() const { return json::parse(folder_.read("summary.json")); }

  /// Lines of sweep.csv, split at their commas.
  [[nodiscard]] std::vector<std::vector<std::string>> rows() const {
    std::istringstream csv(folder_.read("sweep.csv"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(csv, line);) {
      std::istringstream cells(line + ",");
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
  }

  Sweep sweep_;
  std::vector<CycleResult> results_;
  std::vector<SweepPoint> points_;
  test_support::TemporaryFolder folder_;
};

TEST_F(SweepFiles, AreASetThatVouchesForItself) {
  EXPECT_EQ(sweep_file_names(sweep_), (std::vector<std::string>{"summary.json", "sweep.csv", "sweep.nc"}));
  const json written = summary();
  EXPECT_TRUE(is_sealed(folder_.read("summary.json"), written.at("xxh3_128").get<std::string>()));
  for (const char* name : {"sweep.csv", "sweep.nc"}) {
    EXPECT_EQ(written.at("files").at(name).at("xxh3_128"), xxh3_128(folder_.read(name)));
    EXPECT_EQ(written.at("files").at(name).at("bytes"), folder_.read(name).size());
  }
}

TEST_F(SweepFiles, SummaryHasEveryPointWithItsStatus) {
  const json written = summary();
  EXPECT_EQ(written.at("schema"), "bumpfoil-summary/2");
  EXPECT_EQ(written.at("command"), "sweep");
  EXPECT_EQ(written.at("swept_command"), "cycle");
  EXPECT_EQ(written.at("status"), "interrupted");
  const json axis{{"key", "cycle.amplitude"},
                  {"name", "cycle_amplitude"},
                  {"title", "Cycle: Amplitude"},
                  {"unit", "m"},
                  {"values", json::array({60e-6, 70e-6})},
                  {"written", json::array({"60 um", "70 um"})}};
  EXPECT_EQ(written.at("axes").at(0), axis);
  ASSERT_EQ(written.at("points").size(), 6U);
  const json& first = written.at("points").at(0);
  EXPECT_EQ(first.at("status"), "complete");
  EXPECT_EQ(first.at("values"), json::parse(R"({"cycle.amplitude": 60e-6, "friction.coefficient": 0})"));
  EXPECT_EQ(first.at("cycles").at(1).at("direction_deg"), 90);
  EXPECT_EQ(first.at("cycles").at(1).at("max_force_N"), results_[0].cycles[1].turning_point->max_force);
  EXPECT_EQ(written.at("points").at(4).at("status"), "interrupted");
  EXPECT_TRUE(written.at("points").at(4).at("cycles").empty());
  const json& failed = written.at("points").at(5);
  EXPECT_EQ(failed.at("status"), "failed");
  EXPECT_EQ(failed.at("cycles").at(1).at("status"), "no_modes");
  EXPECT_EQ(failed.at("cycles").at(1).at("failed_increment"), 6);
}

TEST_F(SweepFiles, CsvHasARowForEachPointAndDirection) {
  const std::vector<std::vector<std::string>> table = rows();
  ASSERT_EQ(table.size(), 1U + 6U * 2U);
  EXPECT_EQ(table[0][0], "cycle_amplitude_m");
  EXPECT_EQ(table[0][1], "friction_coefficient");
  EXPECT_EQ(table[0][2], "direction_deg");
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), name) - table[0].begin());
  };
  for (const std::vector<std::string>& row : table) EXPECT_EQ(row.size(), table[0].size());
  const std::vector<std::string>& row = table[1 + 2 * 4 - 1];  // point 3, +Y
  EXPECT_EQ(std::stod(row[0]), 70e-6);
  EXPECT_EQ(row[1], "0");
  EXPECT_EQ(row[2], "90");
  EXPECT_EQ(std::stod(row[column("loaded_stiffness_N_per_m")]), *results_[3].cycles[1].loaded_stiffness);
  EXPECT_EQ(row[column("status")], "converged");
  EXPECT_EQ(row[column("converged")], "true");
  // Not started, and failed.
  EXPECT_EQ(table[9][column("status")], "interrupted");
  EXPECT_EQ(table[9][column("max_force_N")], "");
  EXPECT_EQ(table[12][column("status")], "no_modes");
  EXPECT_EQ(table[12][column("converged")], "false");
}

TEST_F(SweepFiles, NetcdfHasTheKeysAsDimensions) {
  const netCDF::NcFile file((folder_.path() / "sweep.nc").string(), netCDF::NcFile::read);
  const netCDF::NcVar force = file.getVar("max_force");
  ASSERT_EQ(force.getDimCount(), 3);
  EXPECT_EQ(force.getDim(0).getName(), "cycle_amplitude");
  EXPECT_EQ(force.getDim(1).getName(), "friction_coefficient");
  EXPECT_EQ(force.getDim(2).getName(), "direction");
  double value = 0.0;
  // Directions are sorted, unlike those of the case.
  std::array<double, 2> directions{};
  file.getVar("direction").getVar(directions.data());
  EXPECT_EQ(directions, (std::array{90.0, 180.0}));
  force.getVar({1, 0, 0}, {1, 1, 1}, &value);
  EXPECT_EQ(value, results_[3].cycles[1].turning_point->max_force);
  force.getVar({1, 1, 0}, {1, 1, 1}, &value);
  EXPECT_EQ(value, NC_FILL_DOUBLE);
  const netCDF::NcVar loops = file.getVar("force_direct");
  ASSERT_EQ(loops.getDimCount(), 4);
  loops.getVar({0, 2, 0, 3}, {1, 1, 1, 1}, &value);
  EXPECT_EQ(value, results_[2].cycles[1].increments[3].force_direct);
  std::string text;
  file.getAtt("bumpfoil_command").getValues(text);
  EXPECT_EQ(text, "sweep");
  file.getAtt("status").getValues(text);
  EXPECT_EQ(text, "partial");
  file.getVar("cycle_amplitude").getAtt("case_key").getValues(text);
  EXPECT_EQ(text, "cycle.amplitude");
}

TEST_F(SweepFiles, NeedTheirKeysInReports) {
  const auto error_of = [](const json& changed) -> std::string {
    try {
      static_cast<void>(read_summary(changed.dump(), "summary.json"));
    } catch (const Error& error) {
      return error.errors().front().key + " " + error.errors().front().what;
    }
    return "";
  };
  json changed = summary();
  EXPECT_EQ(error_of(changed), "");
  changed["axes"][1].erase("key");
  EXPECT_EQ(error_of(changed), "key is missing");
  changed["axes"] = 2;
  EXPECT_EQ(error_of(changed), "axes is not a list");
}

TEST_F(SweepFiles, AreReadByReports) {
  const json report = json::parse(report_json({folder_.path()}));
  const json& run = report.at("runs").at(0);
  EXPECT_EQ(run.at("kind"), "sweep");
  EXPECT_EQ(run.at("attributes").at("swept_command"), "cycle");
  EXPECT_EQ(run.at("summary").at("status"), "interrupted");
  EXPECT_EQ(run.at("summary").at("axes"), summary().at("axes"));
  EXPECT_FALSE(run.at("summary").contains("points"));  // stored only once, as variables
  const json sizes{{"cycle_amplitude", 2}, {"direction", 2}, {"friction_coefficient", 3}, {"increment", 7}};
  for (const auto& [name, size] : sizes.items()) EXPECT_EQ(run.at("dimensions").at(name), size);
  const json& force = run.at("variables").at("max_force");
  EXPECT_EQ(force.at("dims"), (json{"cycle_amplitude", "friction_coefficient", "direction"}));
  EXPECT_EQ(force.at("unit"), "N");
  EXPECT_EQ(force.at("text"), "force along the direction at full displacement");
  EXPECT_EQ(force.at("words"), "");
  // 12 numbers of four bytes, three bytes in four letters.
  EXPECT_EQ(force.at("values").get<std::string>().size(), 12U * 4U / 3U * 4U);
  EXPECT_EQ(run.at("variables").at("status").at("words").get<std::string>().find("converged no_modes "), 0U);
  EXPECT_EQ(run.at("variables").at("friction_coefficient").at("text"), "Coefficients of friction: Both coefficients");
  EXPECT_TRUE(run.at("left_out").empty());
  bool found = false;
  for (const json& quantity : run.at("quantities")) {
    if (quantity.at("name") != "loss_factor") continue;
    found = true;
    EXPECT_EQ(quantity.at("meaning").get<std::string>().find("loop energy over (pi K X^2)"), 0U);
  }
  EXPECT_TRUE(found);
}

TEST_F(SweepFiles, LoseTheirLoopsInReportsThatWouldBeTooLarge) {
  const auto read = [this](std::size_t most) {
    return json::parse(report_json({folder_.path()}, {.most_values = most})).at("runs").at(0);
  };
  std::size_t all = 0;
  const json whole = read(most_report_values);
  for (const json& variable : whole.at("variables")) {
    std::size_t size = 1;
    for (const json& dim : variable.at("dims")) size *= whole.at("dimensions").at(dim).get<std::size_t>();
    all += size;
  }
  EXPECT_EQ(read(all), whole);
  const json run = read(all - 1);  // both are left out if one does not fit
  EXPECT_EQ(run.at("left_out"), (json{"displacement", "force_direct"}));
  EXPECT_TRUE(run.at("variables").contains("max_force"));
  EXPECT_FALSE(run.at("variables").contains("force_direct"));
}

TEST_F(SweepFiles, AreRefusedByReportsWhereTheyAreDamagedOrMixed) {
  const auto error = [this](bool checked) {
    try {
      static_cast<void>(report_json({folder_.path()}, {.checked = checked}));
      return std::string();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::file);
      return std::string(error.what()).substr(folder_.path().string().size());
    }
  };
  const std::string whole = folder_.read("sweep.nc");
  folder_.write("sweep.nc", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(error(true).find("/sweep.nc: is damaged: it has "), 0U);
  EXPECT_EQ(error(false).find("/sweep.nc: "), 0U);
  for (const ResultFile& file : sweep_files(sweep_, points_, {})) {
    if (file.name == "sweep.nc") folder_.write(file.name, file.contents);
  }
  EXPECT_EQ(error(false).find("/summary.json: run_id: differs from that of sweep.nc in the same folder"), 0U);
}

/// Points of a strip differ in their numbers of cycles and increments.
TEST(SweepFilesOfStrips, HaveRoomForTheLongest) {
  const Sweep sweep = parse_sweep(case_template("gen1"), "case.toml",
                                  {.command = "strip",
                                   .over = {"strip.cycles=[1, 2]", "strip.steps=[2, 3]"},
                                   .overrides = {"strip.bumps=2", "strip.displacement=10 um"}});
  std::vector<SweepPoint> points(4);  // none is started
  complete(sweep, points);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& one : sweep_files(sweep, points, {})) folder.write(one.name, one.contents);
  const netCDF::NcFile file((folder.path() / "sweep.nc").string(), netCDF::NcFile::read);
  EXPECT_EQ(file.getDim("cycle").getSize(), 2U);
  EXPECT_EQ(file.getDim("increment").getSize(), 7U);
  const std::string csv = folder.read("sweep.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 1 + 2 * 2);
}

Sweep sweep_of_vibrations(const std::vector<std::string>& over, std::vector<std::string> overrides) {
  for (const char* one : {"vibration.loads=[[0, -50], [0, -100]]", "vibration.directions=[\"+X\", \"+Y\"]",
                          "vibration.amplitudes=[5e-7, 1e-6]", "vibration.frequencies=[1000, 2000, 3000]"}) {
    overrides.emplace_back(one);
  }
  return parse_sweep(case_template("gen1"), "case.toml",
                     {.command = "vibration", .over = over, .overrides = overrides});
}

/// All values of a variable at the leading indices `start`.
std::vector<double> numbers_of(const netCDF::NcVar& variable, std::vector<std::size_t> start = {}) {
  std::vector<std::size_t> count(start.size(), 1);
  std::size_t size = 1;
  for (int i = static_cast<int>(start.size()); i < variable.getDimCount(); ++i) {
    start.push_back(0);
    count.push_back(variable.getDim(i).getSize());
    size *= count.back();
  }
  std::vector<double> numbers(size);
  variable.getVar(start, count, numbers.data());
  return numbers;
}

TEST(SweepFilesOfVibrations, HaveAllThatEachRunHas) {
  const Sweep sweep = sweep_of_vibrations({"bump_foil.height=[0.5 mm, 0.52 mm]", "friction.coefficient=[0.1, 0.2]"},
                                          {"vibration.steps=4"});
  const test_support::TemporaryFolder folder;
  std::vector<SweepPoint> points(sweep.cases.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = run_point(sweep, i);  // the last was not started
  complete(sweep, points);
  for (const ResultFile& one : sweep_files(sweep, points, {})) folder.write(one.name, one.contents);
  const netCDF::NcFile file((folder.path() / "sweep.nc").string(), netCDF::NcFile::read);
  EXPECT_EQ(file.getVar("kxx").getDimCount(), 4);
  EXPECT_EQ(file.getVar("kxx").getDim(2).getName(), "load");
  EXPECT_EQ(file.getVar("kxx").getDim(3).getName(), "amplitude");

  const Case& input = sweep.cases[2];
  const VibrationResult result = run_vibration(input);
  for (const ResultFile& one : test_support::files_of("vibration", input, vibration_outcome(input, result))) {
    folder.write("alone/" + one.name, one.contents);
  }
  const netCDF::NcFile single((folder.path() / "alone/result.nc").string(), netCDF::NcFile::read);
  EXPECT_GT(single.getVarCount(), 40);
  for (const auto& [name, variable] : single.getVars()) {
    if (name == "wall_time") continue;
    const netCDF::NcVar swept = file.getVar(name);
    ASSERT_FALSE(swept.isNull()) << name;
    const bool coordinate = swept.getDimCount() == variable.getDimCount();
    EXPECT_EQ(numbers_of(swept, coordinate ? std::vector<std::size_t>{} : std::vector<std::size_t>{1, 0}),
              numbers_of(variable))
        << name;
    EXPECT_EQ(swept.getAtts().size(), variable.getAtts().size()) << name;
    std::string meaning;
    std::string same;
    swept.getAtt("long_name").getValues(meaning);
    variable.getAtt("long_name").getValues(same);
    EXPECT_EQ(meaning, same);
  }
  // The only data of a point that was not started is its status.
  EXPECT_EQ(numbers_of(file.getVar("kxx"), {1, 1}), std::vector<double>(4, NC_FILL_DOUBLE));
  EXPECT_EQ(numbers_of(file.getVar("status"), {1, 1}),
            std::vector<double>(8, static_cast<double>(Status::interrupted)));
  EXPECT_EQ(numbers_of(file.getVar("force_x"), {1, 1}).front(), NC_FILL_DOUBLE);

  const json written = json::parse(folder.read("summary.json"));
  const json summary = json::parse(folder.read("alone/summary.json"));
  EXPECT_EQ(written.at("swept_command"), "vibration");
  EXPECT_EQ(written.at("status"), "interrupted");
  EXPECT_EQ(written.at("points").at(2).at("coefficients"), summary.at("coefficients"));
  EXPECT_EQ(written.at("points").at(2).at("loads"), summary.at("loads"));
  EXPECT_EQ(written.at("points").at(3).at("vibrations").at(7).at("status"), "interrupted");

  // A row has the keys and a row of vibration.csv, except for the time.
  std::istringstream rows(folder.read("sweep.csv"));
  std::istringstream expected(folder.read("alone/vibration.csv"));
  std::string row;
  std::string end;
  std::getline(rows, row);
  std::getline(expected, end);
  EXPECT_EQ(row, "bump_foil_height_m,friction_coefficient," + end);
  for (int i = 0; i < 2 * 8; ++i) std::getline(rows, row);
  const std::string keys = fmt::format("{:.17g},{:.17g},", sweep.axes[0].values[1], sweep.axes[1].values[0]);
  while (std::getline(expected, end)) {
    ASSERT_TRUE(std::getline(rows, row));
    EXPECT_EQ(row.substr(0, row.rfind(',')), keys + end.substr(0, end.rfind(',')));
  }
}

/// Texts with commas and lines of their own stay one cell, columns that a point lacks are blank.
TEST(SweepFilesOfVibrations, HaveTheRowsOfAllPointsUnderAllColumns) {
  const Sweep sweep = parse_sweep(case_template("gen1"), "case.toml",
                                  {.command = "cycle", .over = {"friction.coefficient=[0.1, 0.2]"}, .overrides = {}});
  std::vector<SweepPoint> points(2);
  complete(sweep, points);
  points[0].rows = "station,x_m\n\"a, \"\"b\"\"\nc\",1\n";
  points[1].rows = "station,y_m,x_m\nd,,2\n";
  EXPECT_EQ(sweep_files(sweep, points, {}).front().contents,
            "friction_coefficient,station,y_m,x_m\n0.10000000000000001,\"a, \"\"b\"\"\nc\",,1\n"
            "0.20000000000000001,d,,2\n");
}

TEST(SweepFilesOfVibrations, HaveRoomForTheLongestLoop) {
  const Sweep sweep = sweep_of_vibrations({"vibration.steps=[3, 5]"}, {});
  std::vector<SweepPoint> points{run_point(sweep, 0), run_point(sweep, 1)};
  const test_support::TemporaryFolder folder;
  for (const ResultFile& one : sweep_files(sweep, points, {})) folder.write(one.name, one.contents);
  const netCDF::NcFile file((folder.path() / "sweep.nc").string(), netCDF::NcFile::read);
  const std::vector<double> shorter = numbers_of(file.getVar("displacement"), {0, 1, 1, 1});
  const std::vector<double> longer = numbers_of(file.getVar("displacement"), {1, 1, 1, 1});
  ASSERT_EQ(shorter.size(), 4U * 5U + 1U);
  EXPECT_EQ(shorter[4 * 3 + 1], NC_FILL_DOUBLE);
  EXPECT_NE(shorter[4 * 3], NC_FILL_DOUBLE);
  EXPECT_NE(longer.back(), NC_FILL_DOUBLE);
}

Sweep sweep_of_equilibria(const std::string& path) {
  return parse_sweep(case_template("gen1"), "case.toml",
                     {.command = "equilibrium",
                      .over = {"bearing.radial_clearance=[31 um, 32 um]"},
                      .overrides = {"film.columns_per_pitch=4", "film.rows=4", "equilibrium.speeds=[4700, 4000]",
                                    "equilibrium.loads=[[30, 0], [40, 0], [60, 0]]", "equilibrium.steps=3",
                                    "equilibrium.frequencies=[900, 300]", "equilibrium.path=" + path}});
}

TEST(SweepFilesOfRunningBearings, HaveStatesOverSpeedAndLoadWhateverTheirOrder) {
  for (const std::string path : {"load_ramp", "speed_ramp"}) {
    const Sweep sweep = sweep_of_equilibria(path);
    std::vector<SweepPoint> points(2);
    points[1] = run_point(sweep, 1);
    complete(sweep, points);
    EXPECT_EQ(points[1].status, RunStatus::complete);
    EXPECT_EQ(points[0].status, RunStatus::interrupted);
    const test_support::TemporaryFolder folder;
    for (const ResultFile& one : sweep_files(sweep, points, {})) folder.write(one.name, one.contents);
    const netCDF::NcFile file((folder.path() / "sweep.nc").string(), netCDF::NcFile::read);
    EXPECT_EQ(numbers_of(file.getVar("speed")), (std::vector<double>{4700.0, 4000.0}));
    EXPECT_EQ(numbers_of(file.getVar("load_x")), (std::vector<double>{30.0, 40.0, 60.0}));

    EquilibriumResult alone = run_equilibrium(sweep.cases[1]);
    estimate_mesh_errors(sweep.cases[1], alone);
    ASSERT_EQ(alone.states.size(), 6U);
    for (const RunningState& state : alone.states) {
      const std::size_t speed = state.requested.speed == 4700.0 ? 0 : 1;
      const std::size_t load = state.requested.journal.x() == 30.0 ? 0 : state.requested.journal.x() == 40.0 ? 1 : 2;
      for (const RunningQuantity& quantity : running_quantities(*alone.bearing)) {
        if (quantity.name == "wall_time") continue;
        const netCDF::NcVar variable = file.getVar(std::string(quantity.name));
        ASSERT_FALSE(variable.isNull()) << quantity.name;
        if (variable.getDimCount() < 3) continue;  // requested values
        const double value = value_of(quantity, *alone.bearing, state);
        const double swept = numbers_of(variable, {1, speed, load}).front();
        if (std::isfinite(value)) {
          EXPECT_EQ(swept, value) << quantity.name;
        } else if (quantity.form.kind == Form::real) {
          EXPECT_EQ(swept, NC_FILL_DOUBLE) << quantity.name;
        }
      }
      for (const std::size_t frequency : {0U, 1U}) {
        EXPECT_EQ(numbers_of(file.getVar("kxy_at_frequency_stuck"), {1, speed, load, frequency}).front(),
                  state.whirls[frequency].stuck_impedance->real()(0, 1));
        EXPECT_EQ(numbers_of(file.getVar("cyy_at_frequency"), {0, speed, load, frequency}).front(), NC_FILL_DOUBLE);
      }
      EXPECT_EQ(numbers_of(file.getVar("status"), {0, speed, load}).front(), 6.0);  // interrupted
      EXPECT_EQ(numbers_of(file.getVar("h_min"), {0, speed, load}).front(), NC_FILL_DOUBLE);
    }
    const std::string csv = folder.read("sweep.csv");
    EXPECT_EQ(csv.find("bearing_radial_clearance_m,speed_rad_per_s,load_x_N,"), 0U) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 6);
    EXPECT_EQ(numbers_of(file.getVar("frequency")), (std::vector<double>{900.0, 300.0}));
    const std::string coefficients = folder.read("coefficients.csv");
    EXPECT_EQ(coefficients.find("bearing_radial_clearance_m,speed_rad_per_s,load_x_N,"), 0U) << coefficients;
    EXPECT_EQ(std::count(coefficients.begin(), coefficients.end(), '\n'), 1 + 6 * 2);
    const json written = json::parse(folder.read("summary.json"));
    EXPECT_EQ(written.at("points").at(0).at("states").at(5).at("status"), "interrupted");
    EXPECT_EQ(written.at("points").at(1).at("states").at(5).at("status"), "converged");
    // Coordinates are those of the states.
    EXPECT_EQ(written.at("points").at(1).at("states").at(1).at("load_x_N"), path == "load_ramp" ? 40.0 : 30.0);
    const std::string table = sweep_table(sweep, points);
    EXPECT_EQ(table.find(path + " from rest, 44881.7 rpm, load (30, 0) N\n"), 0U) << table;
    EXPECT_NE(table.find("\nbearing.radial_clearance  eccentricity"), std::string::npos) << table;

    const json run = json::parse(report_json({folder.path()})).at("runs").at(0);
    EXPECT_EQ(run.at("variables").at("h_min").at("dims"), (json{"bearing_radial_clearance", "speed", "load"}));
    for (const json& quantity : run.at("quantities")) {
      EXPECT_TRUE(run.at("variables").contains(quantity.at("name"))) << quantity;
      EXPECT_NE(quantity.at("label").get<std::string>().front(), ' ');
    }
  }
}

TEST(SweepFilesOfRunningBearings, TakePositions) {
  const Sweep sweep =
      parse_sweep(case_template("gen1"), "case.toml",
                  {.command = "equilibrium",
                   .over = {"friction.coefficient=[0, 0.1]"},
                   .overrides = {"equilibrium.speeds=[4700]", "equilibrium.positions=[[1e-6, 0], [2e-6, 3e-6]]"}});
  std::vector<SweepPoint> points(2);
  complete(sweep, points);
  const test_support::TemporaryFolder folder;
  for (const ResultFile& one : sweep_files(sweep, points, {})) folder.write(one.name, one.contents);
  const netCDF::NcFile file((folder.path() / "sweep.nc").string(), netCDF::NcFile::read);
  EXPECT_EQ(numbers_of(file.getVar("position_y")), (std::vector<double>{0.0, 3e-6}));
  EXPECT_EQ(file.getVar("h_min").getDim(2).getName(), "position");
}

/// Only a film that varies over the width has an axial position of its minimum thickness.
TEST(SweepFilesOfRunningBearings, HaveWhatOnlySomePointsHave) {
  const Sweep sweep = parse_sweep(
      case_template("gen1"), "case.toml",
      {.command = "equilibrium",
       .over = {"width.crowning=[0 um, 3 um, -3 um]"},
       .overrides = {"equilibrium.speeds=[4700]", "equilibrium.positions=[[10e-6, 0]]", "equilibrium.path=position_ray",
                     "equilibrium.paths=one", "film.columns_per_pitch=4", "film.rows=4"}});
  std::vector<SweepPoint> points(3);
  for (const std::size_t i : {0U, 1U}) points[i] = run_point(sweep, i);
  complete(sweep, points);
  ASSERT_LT(points[0].variables.size(), points[1].variables.size());
  const test_support::TemporaryFolder folder;
  for (const ResultFile& one : sweep_files(sweep, points, {})) folder.write(one.name, one.contents);
  const netCDF::NcFile file((folder.path() / "sweep.nc").string(), netCDF::NcFile::read);
  const std::vector<double> places = numbers_of(file.getVar("h_min_z"));
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[0], NC_FILL_DOUBLE);
  EXPECT_EQ(places[1], 0.0);
  const std::vector<double> torques = numbers_of(file.getVar("torque"));
  EXPECT_GT(torques[0], 1e-4);  // N m; variables after h_min_z are in their places
  EXPECT_NEAR(torques[1], torques[0], 0.1 * torques[0]);
  std::istringstream csv(folder.read("sweep.csv"));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(csv, line);) {
    std::istringstream cells(line + ",");
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) ASSERT_EQ(row.size(), rows[0].size());
  const auto cell = [&rows](std::size_t row, const std::string& name) {
    return rows[row][static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin())];
  };
  EXPECT_EQ(cell(1, "h_min_z_m"), "");
  EXPECT_EQ(std::stod(cell(2, "h_min_z_m")), 0.0);
  EXPECT_EQ(std::stod(cell(1, "torque_N_m")), torques[0]);
  EXPECT_EQ(cell(2, "status"), "converged");
  EXPECT_NE(sweep_table(sweep, points).find("3 um"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
