#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <netcdf>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "core/number_text.hpp"
#include "experiments/equilibrium/running_outcome.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

Case small_case() {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
  input.settings.set(
      EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{30.0, 0.0}, {60.0, 0.0}}, .steps = 3});
  input.top_foil.yield_stress = 1e6;
  return input;
}

/// Two states found and, if `fails`, the second not.
const EquilibriumResult& example(bool fails = false) {
  static const EquilibriumResult result = run_equilibrium(small_case());
  static const EquilibriumResult failed = [] {
    EquilibriumResult half = result;
    half.states[1].report.status = Status::fold;
    return half;
  }();
  return fails ? failed : result;
}

std::vector<ResultFile> running_files(const Case& input, const EquilibriumResult& result, RunStatus status) {
  return test_support::files_of("equilibrium", input, running_outcome(input, result), status);
}

std::vector<std::string> rows_of_csv(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

TEST(EquilibriumFiles, AreOneSet) {
  const std::vector<ResultFile> files = running_files(small_case(), example(), RunStatus::complete);
  ASSERT_EQ(files.size(), 5U);
  EXPECT_EQ(files[0].name, "equilibrium.csv");
  EXPECT_EQ(files[1].name, "coefficients.csv");
  EXPECT_EQ(files[2].name, "coefficients.toml");
  const json summary = json::parse(files[4].contents);
  EXPECT_EQ(summary.at("command"), "equilibrium");
  EXPECT_TRUE(is_sealed(files[4].contents, summary.at("xxh3_128").get<std::string>()));
  for (const std::size_t i : {0U, 1U, 2U, 3U}) {
    EXPECT_EQ(summary.at("files").at(files[i].name).at("xxh3_128"), xxh3_128(files[i].contents));
  }
  ASSERT_EQ(summary.at("states").size(), 2U);
  EXPECT_EQ(summary.at("states")[0].at("status"), "converged");
  EXPECT_EQ(summary.at("states")[0].at("path"), "load_ramp");
  EXPECT_NEAR(summary.at("states")[1].at("force_x_N"), 60.0, 1e-6);
  EXPECT_LT(std::abs(summary.at("states")[1].at("mass_imbalance").get<double>()), 1e-12);
  EXPECT_LT(std::abs(summary.at("states")[1].at("energy_imbalance").get<double>()), 1e-3);
  EXPECT_TRUE(summary.at("states")[0].at("last_state").is_null());
  EXPECT_TRUE(summary.at("spreads").empty());
}

TEST(EquilibriumFiles, CsvHoldsWhatIsKnown) {
  const std::vector<std::string> lines = rows_of_csv(csv_text(state_table(example(true))));
  ASSERT_EQ(lines.size(), 3U);
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  EXPECT_EQ(commas(lines[0]), 35);
  for (const std::string& line : lines) EXPECT_EQ(commas(line), 35);
  EXPECT_NE(lines[1].find(",converged,load_ramp,"), std::string::npos);
  EXPECT_EQ(lines[2].substr(lines[2].find(",60,0,")), ",60,0,,,,,,,,,,,,,,fold,load_ramp,,,,,,,,,,,,,,,,,,");
}

TEST(EquilibriumFiles, CoefficientsAreThoseOfTheStatesThatWereFound) {
  const std::vector<std::string> lines = rows_of_csv(csv_text(film_coefficient_table(example(true))));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0],
            "speed_rad_per_s,load_x_N,load_y_N,x_m,y_m,path,frequency_rad_per_s,kxx_N_per_m,kxy_N_per_m,kyx_N_per_m,"
            "kyy_N_per_m,cxx_N_s_per_m,cxy_N_s_per_m,cyx_N_s_per_m,cyy_N_s_per_m,kxx_stuck_N_per_m,kxy_stuck_N_per_m,"
            "kyx_stuck_N_per_m,kyy_stuck_N_per_m,cxx_stuck_N_s_per_m,cxy_stuck_N_s_per_m,cyx_stuck_N_s_per_m,"
            "cyy_stuck_N_s_per_m");
  const FilmWhirl& whirl = example().states[0].whirls.at(0);
  const Eigen::Matrix2cd& Z = *whirl.impedance;
  EXPECT_NE(lines[1].find(fmt::format(",30,0,{:.17g},{:.17g},load_ramp,{:.17g},{:.17g},{:.17g},",
                                      example().states[0].last->position.x(), example().states[0].last->position.y(),
                                      whirl.frequency, Z(0, 0).real(), Z(0, 1).real())),
            std::string::npos);
  EXPECT_TRUE(lines[1].ends_with(fmt::format(",{:.17g}", whirl.stuck_impedance->imag()(1, 1) / whirl.frequency)));
  // At the frequency of the rotation these are quantities of the state, too.
  const json state =
      json::parse(running_files(small_case(), example(), RunStatus::complete)[4].contents).at("states").at(0);
  EXPECT_EQ(state.at("whirl_frequency_rad_per_s"), whirl.frequency);
  EXPECT_EQ(state.at("kyx_whirl_N_per_m"), Z(1, 0).real());
  EXPECT_EQ(state.at("cxy_whirl_N_s_per_m"), Z(0, 1).imag() / whirl.frequency);
  EXPECT_EQ(state.at("cyy_whirl_stuck_N_s_per_m"), whirl.stuck_impedance->imag()(1, 1) / whirl.frequency);
}

/// All values of a variable, one after the other.
Vector values_of(const netCDF::NcFile& file, const std::string& name) {
  Eigen::Index size = 1;
  for (const netCDF::NcDim& dimension : file.getVar(name).getDims()) {
    size *= static_cast<Eigen::Index>(dimension.getSize());
  }
  Vector values(size);
  file.getVar(name).getVar(values.data());
  return values;
}

/// A journal that is tilted has moments, sixteen stiffnesses and dampings, and films from side to side.
TEST(EquilibriumFiles, TellOfTiltedJournals) {
  Case input = small_case();
  input.width = {.modes = 3, .tilt = {1e-4, 0.0}};
  input.settings.get<EquilibriumSettings>().loads = {{40.0, 0.0}};
  StateCheckers checkers;
  const EquilibriumResult result = run_equilibrium(input, {}, {}, &checkers);
  const std::vector<ResultFile> files = running_files(input, result, RunStatus::complete);
  EXPECT_NE(files[0].contents.find(",tilt_x_rad,tilt_y_rad,moment_x_N_m,moment_y_N_m,"), std::string::npos);
  EXPECT_NE(files[1].contents.find(",kaa_N_m_per_rad,"), std::string::npos);
  EXPECT_NE(files[2].contents.find("[bearing."), std::string::npos);  // ROSS gets what it knows
  const json state = json::parse(files[4].contents).at("states").at(0);
  EXPECT_NEAR(state.at("tilt_x_rad").get<double>(), 1e-4, 1e-16);
  EXPECT_EQ(state.at("moment_x_N_m"), result.states[0].outcome->moment.x());
  const JournalMatrix& K = *result.states[0].stiffness;
  EXPECT_EQ(state.at("kab_N_m_per_rad"), K(2, 3));
  // N m/rad: the moment that the tilt takes, or nearly so.
  EXPECT_NEAR(K(2, 2) * 1e-4, result.states[0].outcome->moment.x(), 0.2 * result.states[0].outcome->moment.x());
  const test_support::TemporaryFolder folder;
  const netCDF::NcFile file(folder.write("result.nc", files[3].contents), netCDF::NcFile::read);
  std::vector<double> z(7);
  file.getVar("z").getVar(z.data());
  EXPECT_EQ(z.front(), -0.5 * input.bearing.axial_length);
  EXPECT_EQ(file.getVar("film_thickness").getDimCount(), 3);

  // Tilted the other way all is mirrored: the linear part over the width changes its sign, the parabola does not.
  input.width.tilt = {-1e-4, 0.0};
  const EquilibriumResult other = run_equilibrium(input, {}, {}, &checkers);
  const netCDF::NcFile mirrored(
      folder.write("mirrored.nc", running_files(input, other, RunStatus::complete)[3].contents), netCDF::NcFile::read);
  for (const auto& [name, sign] : {std::pair("film_top_slope", -1.0), std::pair("film_top_parabola", 1.0)}) {
    const Vector mode = values_of(file, name);
    const double largest = mode.cwiseAbs().maxCoeff();
    EXPECT_GT(largest, 1e-7) << name;
    // Far above the tolerances of the iterations.
    EXPECT_LT((values_of(mirrored, name) - sign * mode).cwiseAbs().maxCoeff(), 1e-6 * largest) << name;
  }
}

TEST(EquilibriumFiles, KeepStiffnessAndDampingAtEveryFrequency) {
  Case input = small_case();
  input.settings.get<EquilibriumSettings>().frequencies = {4000.0, 2000.0, 1000.0};
  StateCheckers checkers;
  const EquilibriumResult result = run_equilibrium(input, {}, {}, &checkers);
  const std::vector<FilmWhirl>& whirls = result.states[1].whirls;
  const std::vector<ResultFile> files = running_files(input, result, RunStatus::complete);
  const test_support::TemporaryFolder folder;
  const netCDF::NcFile file(folder.write("result.nc", files[3].contents), netCDF::NcFile::read);
  std::vector<double> frequencies(3), stiffness(6), damping(6);
  file.getVar("frequency").getVar(frequencies.data());
  file.getVar("kxy_at_frequency").getVar(stiffness.data());
  file.getVar("cyx_at_frequency_stuck").getVar(damping.data());
  EXPECT_EQ(frequencies, input.settings.get<EquilibriumSettings>().frequencies);
  const json motions = json::parse(files[4].contents).at("states").at(1).at("motions");
  ASSERT_EQ(motions.size(), 3U);
  const std::string table = equilibrium_table(result);
  EXPECT_NE(table.find("dynamic stiffness, xx"), std::string::npos) << table;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(stiffness[3 + i], (*whirls[i].impedance)(0, 1).real());
    EXPECT_EQ(damping[3 + i], (*whirls[i].stuck_impedance)(1, 0).imag() / whirls[i].frequency);
    EXPECT_EQ(motions[i].at("frequency_rad_per_s"), whirls[i].frequency);
    EXPECT_EQ(motions[i].at("kxy_N_per_m"), stiffness[3 + i]);
    EXPECT_EQ(motions[i].at("cyx_stuck_N_s_per_m"), damping[3 + i]);
    const std::string rpm = number_text(whirls[i].frequency, std::numbers::pi / 30.0);
    EXPECT_NE(table.find(fmt::format("rpm  {:>13}{:>13}\n", rpm, rpm)), std::string::npos) << table;
  }
  // The axis of the other file rises.
  EXPECT_NE(files[2].contents.find("\nfrequency = [1000"), std::string::npos) << files[2].contents;
}

TEST(EquilibriumFiles, KeepTheFrequenciesOfTheExportWhereTheCaseNamesNone) {
  StateCheckers checkers;
  const EquilibriumResult result = run_equilibrium(small_case(), {}, {}, &checkers);
  const test_support::TemporaryFolder folder;
  const netCDF::NcFile file(
      folder.write("result.nc", running_files(small_case(), result, RunStatus::complete)[3].contents),
      netCDF::NcFile::read);
  std::vector<double> stiffness(2 * 10);
  ASSERT_EQ(file.getDim("frequency").getSize(), 10U);
  file.getVar("kyy_at_frequency").getVar(stiffness.data());
  EXPECT_EQ(stiffness[9], (*result.states[0].tabulated[9].impedance)(1, 1).real());
  // Of one frequency alone there is nothing to say beside the whirl of the state.
  const std::string table = equilibrium_table(result);
  EXPECT_EQ(table.find("whirl frequency"), table.rfind("whirl frequency"));
  EXPECT_NE(table.find("synchronous stiffness, xx"), std::string::npos) << table;
}

TEST(EquilibriumFiles, KeepTheLastStateOfOneThatWasNotFound) {
  EquilibriumResult result = example(true);
  result.states[1].last->clearance_offset = 2e-6;
  const std::vector<ResultFile> files = running_files(small_case(), result, RunStatus::failed);
  const json failed = json::parse(files[4].contents).at("states").at(1);
  EXPECT_TRUE(failed.at("x_m").is_null());
  EXPECT_GT(failed.at("last_state").at("x_m"), 0.0);
  EXPECT_EQ(failed.at("last_state").at("radial_clearance_m"), result.bearing->clearance + 2e-6);
  EXPECT_NE(failed.at("reason").get<std::string>().find("the branch of states ends"), std::string::npos);
}

TEST(EquilibriumFiles, NetcdfHoldsTheFilmAndTheFoils) {
  const test_support::TemporaryFolder folder;
  const std::string path =
      folder.write("result.nc", running_files(small_case(), example(true), RunStatus::failed)[3].contents);
  const netCDF::NcFile file(path, netCDF::NcFile::read);
  std::string status;
  file.getAtt("status").getValues(status);
  EXPECT_EQ(status, "partial");
  EXPECT_EQ(file.getDim("column").getSize(), 105U);
  EXPECT_EQ(file.getDim("row").getSize(), 4U);
  const RunningState& found = example().states[0];
  std::vector<double> h_min(2), speed(2);
  file.getVar("h_min").getVar(h_min.data());
  EXPECT_DOUBLE_EQ(h_min[0], found.outcome->thinnest.thickness * example().bearing->film->scales.thickness);
  EXPECT_EQ(h_min[1], NC_FILL_DOUBLE);  // of the state that was not found
  file.getVar("speed").getVar(speed.data());
  EXPECT_EQ(speed[1], example(true).states[1].requested.speed);
  std::vector<double> p(2 * 4 * 105);
  file.getVar("pressure").getVar(p.data());
  EXPECT_DOUBLE_EQ(p[1 * 105 + 50], 101325.0 * found.last->film.pressure(1, 50));
  EXPECT_EQ(p[4 * 105], NC_FILL_DOUBLE);
  std::vector<double> loads(2 * 26);
  file.getVar("normal_force_top_bump").getVar(loads.data());
  double sum = 0.0;
  for (std::size_t b = 0; b < 26; ++b) sum += loads[b];
  EXPECT_NEAR(sum, found.last->contacts.normal_force(Eigen::seqN(0, 26, 2)).sum(), 1e-9);
  EXPECT_EQ(loads[26], NC_FILL_DOUBLE);
  // Loads of the columns integrate to the force.
  std::vector<double> q(2 * 105), phi(105);
  file.getVar("line_load").getVar(q.data());
  file.getVar("column_phi").getVar(phi.data());
  double force = 0.0;
  for (std::size_t k = 0; k < 105; ++k) force += q[k] * std::cos(phi[k]) * 4.572e-3 / 4;  // none at the ends
  EXPECT_NEAR(force, 30.0, 1e-6);
}

Case padded_case() {
  Case input = small_case();
  input.bump_foil.bumps = 8;
  input.pads.assign(3, {.lobe = 8e-6});
  input.pads[1].weld_edge = WeldEdge::trailing;
  return input;
}

const EquilibriumResult& padded_example() {
  static const EquilibriumResult result = run_equilibrium(padded_case());
  return result;
}

TEST(EquilibriumFiles, HaveThePadsInARow) {
  const EquilibriumResult& result = padded_example();
  ASSERT_TRUE(result.converged());
  const test_support::TemporaryFolder folder;
  const std::vector<ResultFile> files = running_files(padded_case(), result, RunStatus::complete);
  const std::string path = folder.write("result.nc", files[3].contents);
  const netCDF::NcFile file(path, netCDF::NcFile::read);
  const std::size_t columns = 3 * 33;
  EXPECT_EQ(file.getDim("column").getSize(), columns);
  EXPECT_EQ(file.getDim("pad").getSize(), 3U);
  const auto read = [&](const char* name, std::size_t size) {
    std::vector<double> values(size);
    file.getVar(name).getVar(values.data());
    return values;
  };
  const std::vector<double> pad = read("column_pad", columns);
  const std::vector<double> theta = read("column_theta", columns);
  const std::vector<double> phi = read("column_phi", columns);
  const std::vector<double> q = read("line_load", 2 * columns);
  const std::vector<double> forces = read("pad_force_x", 2 * 3);
  const std::vector<double> thickness = read("film_thickness", 2 * columns);
  EXPECT_EQ(read("bump_pad", 24)[8], 2.0);
  double sums[3] = {};
  for (std::size_t k = 0; k < columns; ++k) {
    EXPECT_EQ(pad[k], static_cast<double>(k / 33 + 1));
    sums[k / 33] += q[k] * std::cos(phi[k]) * 4.572e-3 / 4;  // none at the ends
  }
  EXPECT_EQ(theta[33], 0.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(sums[i], forces[i], 1e-6) << i;
  EXPECT_NEAR(forces[0] + forces[1] + forces[2], 30.0, 1e-6);
  const json state = json::parse(files[4].contents).at("states").at(0);
  EXPECT_EQ(state.at("pad_forces_x_N").get<std::vector<double>>(),
            std::vector<double>(forces.begin(), forces.begin() + 3));
  const auto thinnest = static_cast<std::size_t>(
      std::min_element(thickness.begin(), thickness.begin() + static_cast<std::ptrdiff_t>(columns)) -
      thickness.begin());
  EXPECT_EQ(state.at("h_min_pad").get<double>(), pad[thinnest]);
  EXPECT_NEAR(state.at("h_min_theta_deg").get<double>(), theta[thinnest] * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_NE(files[0].contents.find(",h_min_theta_deg,h_min_pad,"), std::string::npos);
  // Those of one pad have none of it.
  const std::vector<ResultFile> plain = running_files(small_case(), example(), RunStatus::complete);
  EXPECT_EQ(plain[0].contents.find("pad"), std::string::npos);
  EXPECT_FALSE(json::parse(plain[4].contents).at("states").at(0).contains("pad_forces_x_N"));
}

TEST(EquilibriumTable, TellsPads) {
  const std::string table = equilibrium_table(padded_example());
  for (const char* row : {"\nforce of pad 1 ", "\nforce of pad 3 ", "\n  of pad  "}) {
    EXPECT_NE(table.find(row), std::string::npos) << row;
  }
  const Vector loads = bump_loads(*padded_example().bearing, *padded_example().states[0].last);
  Eigen::Index most = 0;
  loads.maxCoeff(&most);
  EXPECT_NE(table.find(fmt::format(" {}.{} ", most / 8 + 1, most % 8 + 1)), std::string::npos) << table;
  EXPECT_EQ(equilibrium_table(example()).find("of pad"), std::string::npos);
}

TEST(EquilibriumTable, ShowsTheStates) {
  const std::string table = equilibrium_table(example(true));
  EXPECT_NE(table.find("\nminimum film thickness     um   "), std::string::npos) << table;
  EXPECT_NE(table.find("\n  at, from the weld        deg  "), std::string::npos) << table;
  EXPECT_NE(table.find("fold"), std::string::npos);
  EXPECT_NE(table.find("45000"), std::string::npos);
  EXPECT_EQ(table.find("paths to"), std::string::npos);
}

TEST(EquilibriumTable, ComparesPaths) {
  EquilibriumResult two = example();
  two.states[1].requested = two.states[0].requested;
  EXPECT_TRUE(path_spreads(two).empty());  // the same path twice
  two.states[1].path = FilmPath::cold_start;
  const std::vector<PathSpread> spreads = path_spreads(two);
  ASSERT_EQ(spreads.size(), 1U);
  EXPECT_EQ(spreads[0].states, (std::vector<std::size_t>{0, 1}));
  EXPECT_NE(equilibrium_table(two).find("2 paths to 45000 rpm, load (30, 0) N\n"), std::string::npos);
  EXPECT_NE(equilibrium_table(two).find("     smallest      largest\n"), std::string::npos);
}

TEST(EquilibriumLines, SayWhatFailedAndWhatToKnow) {
  EXPECT_TRUE(failure_lines(example()).empty());
  ASSERT_EQ(failure_lines(example(true)).size(), 1U);
  EquilibriumResult jumped = example();
  jumped.states[0].report.jumps = 2;
  const std::vector<std::string> warnings = warning_lines(small_case(), jumped);
  ASSERT_GE(warnings.size(), 4U);
  EXPECT_NE(warnings[0].find("states are unstable with the journal held"), std::string::npos);
  EXPECT_NE(warnings[1].find("2 times on the path"), std::string::npos);
  EXPECT_NE(warnings[2].find("the top foil yields: its bending stress reaches"), std::string::npos);
}

/// The state depends on its history: names include it.
TEST(EquilibriumLines, NameStatesByWhereTheyCameFrom) {
  RunningState state = example().states[0];
  EXPECT_EQ(name_of_state(state), "load_ramp from rest, 45000 rpm, load (30, 0) N");
  state = example().states[1];
  EXPECT_EQ(name_of_state(state), "load_ramp from load (30, 0) N, 45000 rpm, load (60, 0) N");
  state.before = state.requested;
  state.before->speed *= 2.0;
  EXPECT_EQ(name_of_state(state), "load_ramp from 90000 rpm, 45000 rpm, load (60, 0) N");
  const std::vector<ResultFile> files = running_files(small_case(), example(), RunStatus::complete);
  EXPECT_EQ(json::parse(files.back().contents).at("states").at(1).at("name"), name_of_state(example().states[1]));
}

TEST(EquilibriumLines, WarnOfOtherStatesAndOfSingularOnes) {
  EquilibriumResult result = example();
  const std::size_t before = warning_lines(small_case(), result).size();
  result.other_branches.push_back({1, FilmPath::speed_ramp, 3.25e-6});
  result.states[0].foil_response = 1e4;
  FilmLimit& limit = result.limits.emplace_back();
  limit.kind = FilmLimitKind::load_capacity;
  limit.status = Status::converged;
  limit.thick = result.states[0].requested;
  limit.jumps = 2;
  limit.unstable = {{30.0, 45.0}, {70.0, 70.0}};
  limit.unknown = 3;
  const std::vector<std::string> warnings = warning_lines(small_case(), result);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& line) {
    return line.starts_with("load capacity at 45000 rpm: the branch of states ended 2 times");
  }));
  ASSERT_EQ(warnings.size(), before + 5);
  const auto says = [&](std::string_view what) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [what](const std::string& line) { return line.find(what) != std::string::npos; });
  };
  EXPECT_TRUE(
      says("load capacity at 45000 rpm: without the states on the path that are unstable with the journal held "
           "(30 N to 45 N and 70 N)"));
  EXPECT_TRUE(
      says("load capacity at 45000 rpm: whether 3 states of the path are stable with the journal held is not "
           "known; they count as stable"));
  EXPECT_TRUE(says("speed_ramp ends in another state, with a minimum film thickness of 3.25 um instead of"));
  EXPECT_TRUE(says("load (30, 0) N: the state is nearly singular: the top foil moves 1e+04 times as far"));
}

/// A load capacity limited by stability, and a lift-off speed that does not exist.
TEST(EquilibriumFiles, TellWhatBoundsALimitAndWhatIsUnstable) {
  EquilibriumResult result = example();
  result.with_limits = true;
  const OperatingPoint& point = result.states[0].requested;
  result.limits = {{.kind = FilmLimitKind::lift_off_speed,
                    .status = Status::converged,
                    .bounded_by = LimitBound::stability,
                    .thick = point,
                    .thin = point,
                    .h_thick = 5e-6,
                    .h_thin = absent,
                    .value = absent,
                    .stable = false,
                    .unstable = {{100.0, point.speed}}},
                   {.kind = FilmLimitKind::load_capacity,
                    .status = Status::converged,
                    .bounded_by = LimitBound::stability,
                    .thick = point,
                    .thin = point,
                    .h_thick = 7e-6,
                    .h_thin = 6e-6,
                    .value = 30.0,
                    .stable = true,
                    .unstable = {{31.0, 40.0}, {50.0, 60.0}}}};
  result.states[0].lift_off_speed = result.limits[0];
  result.states[0].load_capacity = result.limits[1];
  const std::string csv = csv_text(state_table(result));
  std::vector<std::string> lines(3);
  std::istringstream rows(csv);
  for (std::string& line : lines) std::getline(rows, line);
  EXPECT_TRUE(lines[0].ends_with(
      ",lift_off_speed_rad_per_s,load_capacity_N,lift_off_bounded_by,lift_off_unstable_from_rad_per_s,"
      "lift_off_unstable_to_rad_per_s,capacity_bounded_by,capacity_unstable_from_N,capacity_unstable_to_N"))
      << csv;
  EXPECT_TRUE(lines[1].ends_with(fmt::format(",,30,stability,100,{:.17g},stability,31,60", point.speed))) << csv;
  EXPECT_TRUE(lines[2].ends_with(",,,,,,,,")) << csv;
  const json limits =
      json::parse(running_files(small_case(), result, RunStatus::complete).back().contents).at("limits");
  EXPECT_TRUE(limits.at(0).at("speed_rad_per_s").is_null());
  EXPECT_EQ(limits.at(0).at("bounded_by"), "stability");
  EXPECT_EQ(limits.at(0).at("unstable").at(0).at("from_speed_rad_per_s"), 100.0);
  EXPECT_EQ(limits.at(1).at("unstable").at(1), (json{{"from_load_N", 50.0}, {"to_load_N", 60.0}}));
  const std::string table = equilibrium_table(result);
  EXPECT_NE(table.find(": none, bounded by stability (minimum film thickness 5 um at 45000 rpm, none at 45000 rpm)"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("load capacity at 45000 rpm: 30 N, bounded by stability"), std::string::npos) << table;
  const std::vector<std::string> warnings = warning_lines(small_case(), result);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& line) {
    return line.ends_with(
        ": none, because every state on the path is unstable with the journal held (954.93 rpm to 45000 rpm)");
  }));
}

TEST(EquilibriumLines, WarnOfStatesThatDoNotLast) {
  EquilibriumResult result = example();
  const double speed = result.states[0].last->speed;
  const auto lines_with = [&](std::string_view what) {
    std::vector<std::string> lines = warning_lines(small_case(), result);
    std::erase_if(lines, [what](const std::string& line) { return line.find(what) == std::string::npos; });
    return lines;
  };
  const Eigen::Index last = result.bearing->film->columns() - 1;
  result.states[0].held.sliding = result.states[0].held.stuck = HeldMotion{.rate = {-0.1 * speed, 0.0}, .column = last};
  result.states[1].held = result.states[0].held;
  EXPECT_TRUE(lines_with("unstable").empty());
  result.states[1].held.stuck = HeldMotion{.rate = speed * std::complex<double>(0.1, 0.5), .column = last};
  const std::vector<std::string> unstable = lines_with("unstable");
  ASSERT_EQ(unstable.size(), 1U);
  for (const std::string_view what :
       {"1 of ", "load (60, 0) N", "would flutter at 375 Hz, growing 1.87-fold each revolution", "at the free end"}) {
    EXPECT_NE(unstable.front().find(what), std::string::npos) << what << '\n' << unstable.front();
  }
  EXPECT_TRUE(lines_with("is not known").empty());
  result.states[0].instead_of_unstable = true;
  EXPECT_EQ(lines_with("load (30, 0) N: stable; the path of the case leads to an unstable state").size(), 1U);
  result.states[0].held.stuck.reset();
  EXPECT_EQ(lines_with("is not known").size(), 1U);
}

TEST(EquilibriumLines, WarnOfVerdictsThatHangOnContactsWithoutLoad) {
  EquilibriumResult result = example();
  RunningState& state = result.states[0];
  const double speed = state.last->speed;
  const auto warned = [&](std::string_view what) {
    const std::vector<std::string> lines = warning_lines(small_case(), result);
    return std::count_if(lines.begin(), lines.end(),
                         [what](const std::string& line) { return line.find(what) != std::string::npos; });
  };
  state.held.sliding = state.held.stuck = HeldMotion{.rate = {-0.1 * speed, 0.0}};
  state.light_contacts = 2;
  state.held_if_open = state.held;
  EXPECT_EQ(warned("doubtful"), 0);
  state.held_if_open.sliding = HeldMotion{.rate = {0.1 * speed, 0.0}};
  EXPECT_EQ(warned("depends on 2 closed contacts with less than 1 mN"), 1);
}

TEST(EquilibriumLines, WarnOfAThinFilmOverTheOverhang) {
  EquilibriumResult result = example();
  RunningState& state = result.states[0];
  const auto warned = [&] {
    const std::vector<std::string> lines = warning_lines(small_case(), result);
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("shorten top_foil.overhang") != std::string::npos;
    });
  };
  // Half a pitch of this foil flutters below 5.5 um by itself; it is warned of below twice that.
  auto edge = state.last->film.thickness.col(result.bearing->film->columns() - 1);
  edge.setConstant(12e-6 / result.bearing->film->scales.thickness);
  EXPECT_FALSE(warned());
  edge.setConstant(10e-6 / result.bearing->film->scales.thickness);
  EXPECT_TRUE(warned());
  state.last->speed = -state.last->speed;  // gas enters at the weld
  EXPECT_FALSE(warned());
}

TEST(EquilibriumFiles, AReportShowsTheFilmAndEveryBump) {
  const test_support::TemporaryFolder folder;
  std::vector<ResultFile> files = running_files(small_case(), example(), RunStatus::complete);
  for (const ResultFile& file : files) folder.write(file.name, file.contents);
  const json run = json::parse(report_json({folder.path()})).at("runs").at(0);
  EXPECT_EQ(run.at("kind"), "equilibrium");
  EXPECT_TRUE(run.at("summary").at("limits").empty());
  EXPECT_TRUE(run.at("left_out").empty());
  const json& variables = run.at("variables");
  EXPECT_EQ(variables.at("pressure").at("dims"), (json{"state", "row", "column"}));
  EXPECT_EQ(variables.at("normal_force_top_bump").at("dims"), (json{"state", "bump"}));
  EXPECT_EQ(variables.at("state_bump_sleeve").at("dims"), (json{"state", "foot"}));
  for (const json& quantity : run.at("quantities")) {
    EXPECT_TRUE(variables.contains(quantity.at("name"))) << quantity;
    EXPECT_NE(quantity.at("label").get<std::string>().front(), ' ') << quantity;
  }
  json summary = json::parse(files[4].contents);
  summary["limits"] = {{{"kind", "load_capacity"}, {"status", "converged"}, {"thick", json::object()}}};
  folder.write("summary.json", summary.dump());
  EXPECT_THROW(report_json({folder.path()}, {.checked = false}), Error);
  const json point{{"speed_rad_per_s", 1.0}, {"load_x_N", 1.0}, {"load_y_N", 0.0}, {"h_min_m", nullptr}};
  const auto report_of = [&](const json& unstable) {
    summary["limits"] = {{{"kind", "load_capacity"},
                          {"status", "converged"},
                          {"bounded_by", "stability"},
                          {"unstable", unstable},
                          {"thick", point},
                          {"thin", point}}};
    folder.write("summary.json", summary.dump());
    return report_json({folder.path()}, {.checked = false});
  };
  EXPECT_NO_THROW(report_of({{{"from_load_N", 1.0}, {"to_load_N", 2.0}}}));
  EXPECT_THROW(report_of({{{"from_load_N", 1.0}, {"to_load_N", "2"}}}), Error);
  EXPECT_THROW(report_of("all"), Error);
}

}  // namespace
}  // namespace bumpfoil
