#include "experiments/cycle/cycle_dataset.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>
#include <udunits2.h>

#include <array>
#include <limits>
#include <memory>
#include <netcdf>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "experiments/cycle/cycle_outcome.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "support/bearing_cases.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcDim;
using netCDF::NcFile;
using netCDF::NcVar;
using test_support::TemporaryFolder;

Case described_case() {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.3, 0.5 * std::numbers::pi};
  cycle.steps = 5;
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[2] = 10e-6;
  return input;
}

/// A cycle that ended before it began.
Cycle ended(Status status) {
  Cycle cycle;
  cycle.status = status;
  return cycle;
}

/// A result as seen by its readers.
class OpenedResult {
 public:
  explicit OpenedResult(const CycleResult& result, const Case& input = described_case(),
                        RunStatus status = RunStatus::complete, const Provenance& provenance = {}) {
    const std::vector<ResultFile> files =
        test_support::files_of("cycle", input, cycle_outcome(input, result), status, provenance);
    folder_.write("result.nc", files[1].contents);
    summary_ = nlohmann::json::parse(files[2].contents);
    file_ = std::make_unique<NcFile>((folder_.path() / "result.nc").string(), NcFile::read);
  }

  [[nodiscard]] const NcFile& file() const { return *file_; }
  [[nodiscard]] NcVar variable(const std::string& name) const {
    NcVar found = file_->getVar(name);
    EXPECT_FALSE(found.isNull()) << name;
    return found;
  }
  [[nodiscard]] double at(const std::string& name, const std::vector<std::size_t>& index = {}) const {
    double value = 0.0;
    variable(name).getVar(index, &value);
    return value;
  }
  [[nodiscard]] std::string attribute(const std::string& name) const {
    std::string text;
    file_->getAtt(name).getValues(text);
    return text;
  }
  [[nodiscard]] std::string attribute(const std::string& variable_name, const std::string& name) const {
    std::string text;
    variable(variable_name).getAtt(name).getValues(text);
    return text;
  }

  [[nodiscard]] const nlohmann::json& summary() const { return summary_; }

 private:
  TemporaryFolder folder_;
  nlohmann::json summary_;
  std::unique_ptr<NcFile> file_;
};

TEST(CycleDataset, HoldsEveryIncrementToTheLastBit) {
  const CycleResult result = run_cycles(described_case());
  const OpenedResult file(result);
  EXPECT_EQ(file.file().getDim("direction").getSize(), 2U);
  EXPECT_EQ(file.file().getDim("increment").getSize(), 11U);
  EXPECT_EQ(file.at("direction", {0}), to_degrees(0.3));
  EXPECT_EQ(file.at("increment", {10}), 10);
  for (const std::size_t d : {0U, 1U}) {
    for (std::size_t i = 0; i < 11; ++i) {
      const Increment& expected = result.cycles[d].increments[i];
      EXPECT_EQ(file.at("displacement", {d, i}), expected.displacement);
      EXPECT_EQ(file.at("x", {d, i}), expected.x);
      EXPECT_EQ(file.at("y", {d, i}), expected.y);
      EXPECT_EQ(file.at("force_x", {d, i}), expected.force_x);
      EXPECT_EQ(file.at("force_y", {d, i}), expected.force_y);
      EXPECT_EQ(file.at("force_direct", {d, i}), expected.force_direct);
      EXPECT_EQ(file.at("force_cross", {d, i}), expected.force_cross);
      EXPECT_EQ(file.at("elastic_energy", {d, i}), expected.elastic_energy);
      EXPECT_EQ(file.at("dissipated_energy", {d, i}), expected.dissipated_energy);
      EXPECT_EQ(file.at("work", {d, i}), expected.work);
      EXPECT_EQ(file.at("residual", {d, i}), expected.residuals.equilibrium);
      EXPECT_EQ(file.at("iterations", {d, i}), expected.cost.iterations);
      EXPECT_EQ(file.at("factorisations", {d, i}), expected.cost.factorisations);
      EXPECT_EQ(file.at("substeps", {d, i}), expected.substeps);
      EXPECT_EQ(file.at("branch", {d, i}), i <= 5 ? 0 : 1);
      EXPECT_EQ(file.at("increment_converged", {d, i}), 1);
      EXPECT_EQ(file.at("increment_status", {d, i}), 0);
    }
  }
  EXPECT_EQ(file.attribute("branch", "flag_meanings"), "loading unloading");
  EXPECT_EQ(file.attribute("increment_status", "flag_meanings"), file.attribute("status", "flag_meanings"));
  EXPECT_TRUE(file.attribute("status", "flag_meanings").starts_with("converged no_modes "));
}

TEST(CycleDataset, HoldsEveryBumpAndFoot) {
  Case input = described_case();
  input.bump_foil.model = BumpFoilModel::frame;  // two feet per bump: bumps and feet cannot be mistaken
  const CycleResult result = run_cycles(input);
  ASSERT_TRUE(result.converged());
  const OpenedResult file(result, input);
  ASSERT_EQ(file.file().getDim("bump").getSize(), 26U);
  ASSERT_EQ(file.file().getDim("foot").getSize(), 52U);
  const std::size_t d = 1;
  const std::size_t i = 4;
  const FoilFields& expected = result.cycles[d].fields;
  const TurningPoint& turn = *result.cycles[d].turning_point;
  const auto expect_interface = [&](const std::string& name, const InterfaceFields& fields) {
    for (Eigen::Index k = 0; k < fields.gap.cols(); ++k) {
      const auto place = static_cast<std::size_t>(k);
      EXPECT_EQ(file.at("gap_" + name, {d, i, place}), fields.gap(4, k));
      EXPECT_EQ(file.at("normal_force_" + name, {d, i, place}), fields.normal_force(4, k));
      EXPECT_EQ(file.at("friction_force_" + name, {d, i, place}), fields.friction_force(4, k));
      EXPECT_EQ(file.at("state_" + name, {d, i, place}), static_cast<int>(fields.mode(4, k)));
    }
    EXPECT_EQ(file.attribute("state_" + name, "flag_meanings"), "open stick slip_forward slip_backward");
    std::vector<signed char> values(4);
    file.variable("state_" + name).getAtt("flag_values").getValues(values.data());
    EXPECT_EQ(values, (std::vector<signed char>{0, 1, 2, 3}));
  };
  expect_interface("journal_top", expected.journal_top);
  expect_interface("top_bump", expected.top_bump);
  expect_interface("bump_sleeve", expected.bump_sleeve);
  for (std::size_t k = 0; k < 52; ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    EXPECT_EQ(file.at("foot_u", {d, i, k}), expected.foot_u(4, place));
    EXPECT_EQ(file.at("foot_v", {d, i, k}), expected.foot_v(4, place));
    EXPECT_EQ(file.at("foot_theta", {k}), foot_angles(input)[place]);
    EXPECT_EQ(file.at("foot_loads", {d, k}), turn.foot_loads[place]);
    if (k >= 26) continue;
    EXPECT_EQ(file.at("crest_u", {d, i, k}), expected.crest_u(4, place));
    EXPECT_EQ(file.at("crest_v", {d, i, k}), expected.crest_v(4, place));
    EXPECT_EQ(file.at("top_displacement", {d, i, k}), expected.top_displacement(4, place));
    EXPECT_EQ(file.at("theta", {k}), crest_angles(input)[place]);
    EXPECT_EQ(file.at("phi", {k}), polar_angles(input.bearing, crest_angles(input))[place]);
    EXPECT_EQ(file.at("height_error", {k}), input.bump_foil.height_errors[k]);
    EXPECT_EQ(file.at("sleeve_gap", {k}), 0.0);
    EXPECT_EQ(file.at("bump", {k}), static_cast<double>(k + 1));
    EXPECT_EQ(file.at("bump_loads", {d, k}), turn.bump_loads[place]);
    EXPECT_EQ(file.at("journal_loads", {d, k}), turn.journal_loads[place]);
  }
}

TEST(CycleDataset, EveryUnitIsOneOfUdunits) {
  const OpenedResult file(run_cycles(described_case()));
  ut_set_error_message_handler(ut_ignore);
  ut_system* units = ut_read_xml(nullptr);
  ASSERT_NE(units, nullptr);
  for (const auto& [name, variable] : file.file().getVars()) {
    EXPECT_FALSE(file.attribute(name, "long_name").empty()) << name;
    const auto attributes = variable.getAtts();
    if (attributes.contains("flag_values")) continue;
    ASSERT_TRUE(attributes.contains("units")) << name;
    ut_unit* unit = ut_parse(units, file.attribute(name, "units").c_str(), UT_ASCII);
    EXPECT_NE(unit, nullptr) << name;
    ut_free(unit);
  }
  ut_free_system(units);
}

TEST(CycleDataset, HoldsWhatItTakesToDrawTheBearing) {
  const Case input = described_case();
  const OpenedResult file(run_cycles(input));
  EXPECT_EQ(file.at("bearing_radius"), input.bearing.radius);
  EXPECT_EQ(file.at("axial_length"), input.bearing.axial_length);
  EXPECT_EQ(file.at("radial_clearance"), input.bearing.radial_clearance);
  EXPECT_EQ(file.at("bump_pitch"), input.bump_foil.pitch.values.front());
  EXPECT_EQ(file.at("bump_half_length"), 0.5 * input.bump_foil.length.values.front());
  EXPECT_EQ(file.at("bump_rise"), nominal_bump(input.bump_foil).rise);
  EXPECT_EQ(file.at("bump_thickness"), input.bump_foil.thickness.values.front());
}

TEST(ResultLayout, HasOneNumberPerBumpWhereBumpsDiffer) {
  Case input = described_case();
  const auto values = [&](const std::string& name) {
    for (const NamedNumbers& numbers : make_result_layout(input, Experiment::cycle).at_bumps) {
      if (numbers.name == name) return numbers.values;
    }
    return std::vector<double>{};
  };
  EXPECT_EQ(values("bump_pitch"), std::vector<double>{});
  EXPECT_EQ(values("crest_offset"), std::vector<double>{});
  const auto bumps = static_cast<std::size_t>(input.bump_foil.bumps);
  input.bump_foil.height_errors.assign(bumps, 1e-6);
  EXPECT_EQ(values("crest_offset"), std::vector<double>{});
  input.bump_foil.sections = {{.from = 2, .to = 2, .pitch = 4.4e-3}};
  input.bump_foil.shims = {{.from = 1, .to = 1, .thickness = 5e-6}};
  ASSERT_EQ(values("bump_pitch").size(), bumps);
  EXPECT_EQ(values("bump_pitch")[1], 4.4e-3);
  EXPECT_EQ(values("bump_pitch")[2], 4.572e-3);
  EXPECT_EQ(values("bump_rise"), std::vector<double>{});
  ASSERT_EQ(values("crest_offset").size(), bumps);
  EXPECT_NEAR(values("crest_offset")[0], 6e-6, 1e-18);
  EXPECT_NEAR(values("crest_offset")[1], 1e-6, 1e-18);
  EXPECT_EQ(values("bump_thickness"), std::vector<double>{});
  input.bump_foil.sections = {{.from = 2, .to = 2, .thickness = 0.127e-3}};
  ASSERT_EQ(values("bump_thickness").size(), bumps);
  EXPECT_EQ(values("bump_thickness")[1], 0.127e-3);
  EXPECT_EQ(values("bump_thickness")[2], 0.102e-3);
}

TEST(CycleDataset, HasADimensionForSeveralPads) {
  Case input = described_case();
  input.bump_foil.height_errors.clear();
  input.bump_foil.bumps = 7;
  input.bearing.radial_clearance = -2e-6;
  input.pads.resize(2);
  input.pads[1].weld_edge = WeldEdge::trailing;
  input.pads[1].lobe = 4e-6;
  const CycleResult result = run_cycles(input);
  const OpenedResult file(result, input);
  EXPECT_EQ(file.file().getDim("pad").getSize(), 2U);
  EXPECT_EQ(file.file().getDim("bump").getSize(), 14U);
  EXPECT_EQ(file.at("bump_pad", {6}), 1.0);
  EXPECT_EQ(file.at("bump_pad", {7}), 2.0);
  EXPECT_EQ(file.at("foot_pad", {7}), 2.0);
  EXPECT_EQ(file.at("pad_lobe", {1}), 4e-6);
  const double arc = 7 * 4.572e-3 / 19.05e-3;
  EXPECT_NEAR(file.at("pad_end_angle", {0}), input.bearing.weld_angle - arc, 1e-14);
  EXPECT_NEAR(file.at("pad_end_angle", {1}) - file.at("pad_weld_angle", {1}), arc, 1e-14);
  EXPECT_NEAR(file.at("phi", {7}) - file.at("pad_weld_angle", {1}), 0.5 * arc / 7, 1e-14);
  // Parts of the force add up to it; increment 5 is the turning point.
  const double whole = file.at("force_y", {1, 5});
  EXPECT_NEAR(file.at("pad_force_y", {1, 5, 0}) + file.at("pad_force_y", {1, 5, 1}), whole, 1e-12 * std::abs(whole));
  EXPECT_EQ(file.at("pad_forces_y", {1, 1}), file.at("pad_force_y", {1, 5, 1}));
  EXPECT_GT(file.at("stress_top_foil_weld", {1, 5, 0}), 0.0);
  EXPECT_EQ(file.at("stress_top_foil_weld", {1, 5, 1}), 0.0);  // the journal has left it

  const OpenedResult one(run_cycles(described_case()));
  EXPECT_TRUE(one.file().getDim("pad").isNull());
  for (const char* name : {"pad", "bump_pad", "foot_pad", "pad_lobe", "pad_force_x", "pad_forces_x"}) {
    EXPECT_TRUE(one.file().getVar(name).isNull()) << name;
  }
  EXPECT_EQ(one.variable("stress_top_foil_weld").getDimCount(), 2);
}

TEST(CycleDataset, SaysWhereItComesFrom) {
  const Case input = described_case();
  const OpenedResult file(run_cycles(input), input, RunStatus::complete,
                          {.command_line = "bumpfoil cycle 'my case.toml' -o out", .case_text = "# as written\n"});
  EXPECT_EQ(file.attribute("Conventions"), "CF-1.8");
  EXPECT_EQ(file.attribute("title"), input.title);
  EXPECT_EQ(file.attribute("source"), "bumpfoil " + std::string(version()) + " (" + std::string(commit()) + ")");
  EXPECT_EQ(file.attribute("command_line"), "bumpfoil cycle 'my case.toml' -o out");
  EXPECT_EQ(file.attribute("history"), file.attribute("date_created") + ": " + file.attribute("command_line"));
  EXPECT_EQ(file.attribute("solver"), "newton");
  EXPECT_EQ(file.attribute("case_text"), "# as written\n");
  EXPECT_EQ(file.attribute("run_id"), file.summary().at("run_id"));
  EXPECT_EQ(parse_case(file.attribute("case_understood"), "understood.toml"), input);
  EXPECT_EQ(file.attribute("status"), "complete");
  EXPECT_FALSE(file.file().getAtts().contains("status_message"));
}

TEST(CycleDataset, KeepsItsVariablesInOrderAndTakesFurtherOnes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("result.nc", test_support::files_of("cycle", described_case())[1].contents);
  int file = 0;
  // netCDF adds to no file that has forgotten its order.
  ASSERT_EQ(nc_open(path.c_str(), NC_WRITE, &file), NC_NOERR);
  EXPECT_EQ(nc_put_att_text(file, NC_GLOBAL, "comment", 4, "mine"), NC_NOERR);
  std::array<char, NC_MAX_NAME + 1> name{};
  for (const auto& [place, expected] : {std::pair{0, "direction"}, {1, "increment"}, {2, "bump"}, {3, "foot"}}) {
    EXPECT_EQ(nc_inq_varname(file, place, name.data()), NC_NOERR);
    EXPECT_STREQ(name.data(), expected);
  }
  EXPECT_EQ(nc_close(file), NC_NOERR);
}

TEST(CycleDataset, TakesTheLargestCaseFile) {
  const std::string text(10'000'000, '#');
  const OpenedResult file(run_cycles(described_case()), described_case(), RunStatus::complete,
                          {.command_line = {}, .case_text = text});
  EXPECT_EQ(file.attribute("case_text"), text);
}

TEST(CycleDataset, APartialResultIsFlaggedAndHasNoNumbersWhereThereAreNone) {
  const CycleResult result = failed_at_increment_three(run_cycles(described_case()));
  const OpenedResult file(result, described_case(), RunStatus::failed);
  EXPECT_EQ(file.attribute("status"), "partial");
  EXPECT_EQ(file.attribute("status_message"), failure_lines(described_case(), result).at(0));
  // It is as large as the whole would be.
  EXPECT_EQ(file.file().getDim("direction").getSize(), 2U);
  EXPECT_EQ(file.file().getDim("increment").getSize(), 11U);
  EXPECT_EQ(file.at("direction", {1}), 90.0);
  for (const std::size_t d : {0U, 1U}) {
    EXPECT_EQ(file.at("converged", {d}), 0);
    EXPECT_EQ(file.at("max_force", {d}), NC_FILL_DOUBLE);
    EXPECT_EQ(file.at("loop_energy", {d}), NC_FILL_DOUBLE);
    EXPECT_EQ(file.at("bump_loads", {d, 3}), NC_FILL_DOUBLE);
    for (std::size_t i = d == 0 ? 4 : 0; i < 11; ++i) {
      EXPECT_EQ(file.at("force_direct", {d, i}), NC_FILL_DOUBLE);
      EXPECT_EQ(file.at("iterations", {d, i}), NC_FILL_INT);
      EXPECT_EQ(file.at("branch", {d, i}), NC_FILL_BYTE);
      EXPECT_EQ(file.at("increment_converged", {d, i}), NC_FILL_BYTE);
      EXPECT_EQ(file.at("crest_v", {d, i, 25}), NC_FILL_DOUBLE);
      EXPECT_EQ(file.at("state_bump_sleeve", {d, i, 25}), NC_FILL_BYTE);
    }
  }
  EXPECT_EQ(file.at("initial_force", {0}), result.cycles[0].increments[0].force_direct);
  EXPECT_EQ(file.at("initial_force", {1}), NC_FILL_DOUBLE);
  // A failed increment only has its displacement, its cost and its status.
  EXPECT_EQ(file.at("displacement", {0, 3}), result.cycles[0].increments[3].displacement);
  EXPECT_EQ(file.at("force_direct", {0, 3}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("residual", {0, 3}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("crest_v", {0, 3, 0}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("increment_status", {0, 2}), 0);
  EXPECT_EQ(file.at("increment_status", {0, 3}), static_cast<int>(result.cycles[0].status));
  EXPECT_EQ(file.at("increment_status", {0, 4}), NC_FILL_BYTE);
  EXPECT_EQ(file.at("status", {0}), static_cast<int>(result.cycles[0].status));
  EXPECT_EQ(file.at("status", {1}), NC_FILL_BYTE);  // never begun
  EXPECT_EQ(file.at("increment_converged", {0, 2}), 1);
  EXPECT_EQ(file.at("increment_converged", {0, 3}), 0);
  // The fill value is declared for readers.
  double fill = 0.0;
  file.variable("force_direct").getAtt("_FillValue").getValues(&fill);
  EXPECT_EQ(fill, NC_FILL_DOUBLE);
}

TEST(CycleDataset, AnInterruptedRunSaysSo) {
  const OpenedResult file({.solver = SolverName::newton, .cycles = {ended(Status::interrupted)}}, described_case(),
                          RunStatus::interrupted);
  EXPECT_EQ(file.attribute("status"), "partial");
  EXPECT_NE(file.attribute("status_message").find("interrupted"), std::string::npos);
  EXPECT_EQ(file.at("force_direct", {0, 0}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("initial_journal_load", {0}), NC_FILL_DOUBLE);
}

TEST(CycleDataset, NeverHoldsNanAsANumber) {
  CycleResult result = run_cycles(described_case());
  result.cycles[0].increments[2].force_x = std::numeric_limits<double>::quiet_NaN();
  result.cycles[0].fields.crest_v(2, 7) = std::numeric_limits<double>::infinity();
  result.cycles[0].turning_point->max_force = std::numeric_limits<double>::quiet_NaN();
  result.cycles[0].turning_point->bump_loads[4] = std::numeric_limits<double>::quiet_NaN();
  const OpenedResult file(result);
  EXPECT_EQ(file.at("force_x", {0, 2}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("crest_v", {0, 2, 7}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("max_force", {0}), NC_FILL_DOUBLE);
  EXPECT_EQ(file.at("bump_loads", {0, 4}), NC_FILL_DOUBLE);
}

TEST(CycleDataset, HoldsEventsWhereTheyWereFollowed) {
  Case input = described_case();
  EXPECT_TRUE(OpenedResult(run_cycles(input)).file().getDim("event").isNull());
  input.solver.name = SolverName::events;
  const CycleResult result = run_cycles(input);
  const OpenedResult file(result, input);
  const std::size_t first = result.cycles[0].events.size();
  ASSERT_GT(first, 0U);
  ASSERT_EQ(file.file().getDim("event").getSize(), first + result.cycles[1].events.size());
  for (std::size_t d = 0, at = 0; d < 2; ++d) {
    for (const CycleEvent& event : result.cycles[d].events) {
      EXPECT_EQ(file.at("event_direction", {at}), to_degrees(input.settings.get<CycleSettings>().directions[d]));
      EXPECT_EQ(file.at("event_displacement", {at}), event.displacement);
      EXPECT_EQ(file.at("event_branch", {at}), static_cast<int>(event.branch));
      EXPECT_EQ(file.at("event_interface", {at}), static_cast<int>(event.interface));
      EXPECT_EQ(file.at("event_index", {at}), event.index + 1);
      EXPECT_EQ(file.at("event_from", {at}), static_cast<int>(event.from));
      EXPECT_EQ(file.at("event_to", {at}), static_cast<int>(event.to));
      ++at;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
