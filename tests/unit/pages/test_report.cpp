#include "bumpfoil/pages/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <netcdf>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/cycle/cycle_outcome.hpp"
#include "support/bearing_cases.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;
using test_support::TemporaryFolder;

Case short_case() {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0, 0.5 * std::numbers::pi};
  cycle.steps = 5;
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[2] = 10e-6;
  return input;
}

/// The results folder of a run.
class Results {
 public:
  explicit Results(const CycleResult& result, const Case& input = short_case(),
                   RunStatus status = RunStatus::complete) {
    for (const ResultFile& file : test_support::files_of("cycle", input, cycle_outcome(input, result), status))
      folder_.write(file.name, file.contents);
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path(); }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

std::vector<std::uint8_t> decode(const std::string& text) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(alphabet.find(letter));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
  }
  return bytes;
}

std::vector<float> numbers_of(const json& text) {
  const std::vector<std::uint8_t> bytes = decode(text.get<std::string>());
  std::vector<float> numbers;
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
    const std::uint32_t bits = bytes[i] | static_cast<std::uint32_t>(bytes[i + 1]) << 8 |
                               static_cast<std::uint32_t>(bytes[i + 2]) << 16 |
                               static_cast<std::uint32_t>(bytes[i + 3]) << 24;
    numbers.push_back(std::bit_cast<float>(bits));
  }
  return numbers;
}

std::vector<InputError> errors_of(const std::vector<std::filesystem::path>& folders, bool checked = true) {
  try {
    report_json(folders, {.checked = checked});
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    return error.errors();
  }
  return {};
}

TEST(Report, HoldsEveryIncrementRoundedToBinary32) {
  const CycleResult result = run_cycles(short_case());
  const Results results(result);
  const json report = json::parse(report_json({results.path()}));
  EXPECT_EQ(report.at("schema"), "bumpfoil-report/1");
  EXPECT_EQ(report.at("keys").at("bearing.radius"), json({{"title", "Radius"}, {"unit", "m"}}));
  EXPECT_EQ(report.at("keys").at("cycle.directions").at("unit"), "direction");
  EXPECT_EQ(report.at("keys").at("bump_foil"), json({{"title", "Bump foil"}}));
  EXPECT_EQ(report.at("version"), version());
  const json& run = report.at("runs").at(0);
  EXPECT_EQ(run.at("name"), results.path().filename().string());
  EXPECT_EQ(run.at("kind"), "cycle");
  EXPECT_EQ(run.at("summary"), json::parse(results.folder().read("summary.json")));
  EXPECT_EQ(run.at("attributes").at("status"), "complete");
  EXPECT_EQ(run.at("nodes"), (json{{"bump", 26}, {"foot", 26}}));
  EXPECT_EQ(run.at("geometry").at("bearing_radius"), 19.05e-3);
  EXPECT_EQ(run.at("geometry").at("height_error").at(2), 10e-6);
  // The page takes its labels from here.
  const json& quantity = run.at("quantities").at(0);
  EXPECT_EQ(quantity.at("key"), "steps");
  EXPECT_EQ(quantity.at("label"), "increments per branch");
  for (const json& one : run.at("quantities")) {
    EXPECT_TRUE(run.at("summary").at("cycles")[0].contains(one.at("key"))) << one;
  }
  ASSERT_EQ(run.at("cycles").size(), 2U);
  for (std::size_t d = 0; d < 2; ++d) {
    const json& direction = run.at("cycles").at(d);
    const std::vector<Increment>& increments = result.cycles[d].increments;
    const FoilFields& fields = result.cycles[d].fields;
    EXPECT_EQ(direction.at("at"), 90.0 * static_cast<double>(d));
    EXPECT_EQ(direction.at("increments").size(), 11U);
    const std::vector<float> force = numbers_of(direction.at("series").at("force_direct"));
    const json& loads = direction.at("fields").at("normal_force_top_bump");
    EXPECT_EQ(loads.at("at"), "bump");
    const std::vector<float> load = numbers_of(loads.at("values"));
    const std::vector<std::uint8_t> state = decode(direction.at("fields").at("state_bump_sleeve").at("values"));
    ASSERT_EQ(force.size(), 11U);
    ASSERT_EQ(load.size(), 11U * 26U);
    ASSERT_EQ(state.size(), 11U * 26U);
    for (std::size_t i = 0; i < 11; ++i) {
      EXPECT_EQ(force[i], static_cast<float>(increments[i].force_direct));
      for (std::size_t bump = 0; bump < 26; ++bump) {
        const auto node = static_cast<Eigen::Index>(bump);
        EXPECT_EQ(load[26 * i + bump],
                  static_cast<float>(fields.top_bump.normal_force(static_cast<Eigen::Index>(i), node)));
        EXPECT_EQ(state[26 * i + bump],
                  static_cast<std::uint8_t>(fields.bump_sleeve.mode(static_cast<Eigen::Index>(i), node)));
      }
    }
    EXPECT_FALSE(direction.at("fields").contains("gap_top_bump"));
  }
}

TEST(Report, EndsWhereAPartialRunEnded) {
  const Results results(failed_at_increment_three(run_cycles(short_case())), short_case(), RunStatus::failed);
  const std::string text = report_json({results.path()});
  EXPECT_EQ(text.find("nan"), std::string::npos);
  const json run = json::parse(text).at("runs").at(0);
  EXPECT_EQ(run.at("attributes").at("status"), "partial");
  EXPECT_EQ(run.at("cycles").at(0).at("increments"), (json{0, 1, 2}));  // there is no data of the failed one
  EXPECT_EQ(numbers_of(run.at("cycles").at(0).at("series").at("work")).size(), 3U);
  EXPECT_EQ(run.at("cycles").at(1).at("increments"), json::array());
  EXPECT_EQ(run.at("cycles").at(1).at("series").at("work"), "");
}

TEST(Report, ThinsWhatIsTooMuchButKeepsTheTurningPoint) {
  const Results results(run_cycles(short_case()));
  const json whole = json::parse(report_json({results.path()}));
  // 2 directions, 11 increments, 26 bumps and 13 fields are 7436 numbers: every third increment fits.
  const json thinned = json::parse(report_json({results.path()}, {.most_values = 7436 / 3 + 1}));
  const json& direction = thinned.at("runs").at(0).at("cycles").at(1);
  EXPECT_EQ(direction.at("increments"), (json{0, 3, 5, 8, 10}));
  const std::vector<float> all =
      numbers_of(whole.at("runs").at(0).at("cycles").at(1).at("fields").at("crest_v").at("values"));
  const std::vector<float> some = numbers_of(direction.at("fields").at("crest_v").at("values"));
  ASSERT_EQ(some.size(), 5U * 26U);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto increment = direction.at("increments").at(i).get<std::size_t>();
    for (std::size_t bump = 0; bump < 26; ++bump) EXPECT_EQ(some[26 * i + bump], all[26 * increment + bump]);
  }
}

TEST(Report, ComparesSeveralFolders) {
  Case frame = short_case();
  frame.bump_foil.model = BumpFoilModel::frame;
  const Results a(run_cycles(short_case()));
  const Results b(run_cycles(frame), frame);
  const json report = json::parse(report_json({a.path(), b.path()}));
  ASSERT_EQ(report.at("runs").size(), 2U);
  EXPECT_EQ(report.at("runs").at(0).at("name"), a.path().filename().string());
  EXPECT_EQ(report.at("runs").at(1).at("name"), b.path().filename().string());
  EXPECT_EQ(report.at("runs").at(1).at("nodes").at("foot"), 52);
}

TEST(Report, HasAQuantityForEachClearance) {
  Case input = short_case();
  input.settings.get<CycleSettings>().clearance_forces = {2.5, 20000.0};
  const Results results(run_cycles(input), input);
  const json run = json::parse(report_json({results.path()})).at("runs").at(0);
  std::vector<std::string> labels;
  for (const json& quantity : run.at("quantities")) {
    labels.push_back(quantity.at("label"));
    if (quantity.at("name") == "clearance_20000N") {
      EXPECT_TRUE(run.at("summary").at("cycles").at(0).at(quantity.at("key").get<std::string>()).is_null());
    }
  }
  const auto place = std::find(labels.begin(), labels.end(), "take-up point");
  ASSERT_LT(place + 2, labels.end());
  EXPECT_EQ(place[1], "clearance at 2.5 N");
  EXPECT_EQ(place[2], "clearance at 20000 N");
}

TEST(Report, ShowsMeasuredLoopsAsOneMoreRun) {
  const Results results(run_cycles(short_case()));
  const TemporaryFolder folder;
  const auto with = [&](const std::string& text) {
    return report_json({results.path()}, {.measured = {{folder.write("rig.csv", text)}}});
  };
  const json run =
      json::parse(with("direction,displacement_um,force_N\n450,0,0\n450,10,100\n450,2,0\n")).at("runs").at(1);
  EXPECT_EQ(run.at("name"), "rig.csv");
  EXPECT_EQ(run.at("kind"), "cycle");
  EXPECT_TRUE(run.at("measured").get<bool>());
  EXPECT_EQ(run.at("cycles")[0].at("at"), 90.0);
  EXPECT_EQ(numbers_of(run.at("cycles")[0].at("series").at("force_direct")), (std::vector<float>{0.0F, 100.0F, 0.0F}));
  const json& summary = run.at("summary").at("cycles")[0];
  EXPECT_EQ(summary.at("max_force_N"), 100.0);
  EXPECT_NEAR(summary.at("loop_energy_J").get<double>(), 1e-4, 1e-18);
  EXPECT_NEAR(summary.at("clearance_5N_m").get<double>(), 0.5e-6, 1e-18);
  for (const json& quantity : run.at("quantities")) EXPECT_TRUE(summary.contains(quantity.at("key"))) << quantity;

  const auto refusal = [&](const std::string& text) -> std::string {
    try {
      with(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("displacement_um,force_N\n0,0\n10,100\n2,0\n")
                .find("add a column direction, or name it after the file, FILE:+X: the results have +X, +Y"),
            std::string::npos);
  Case turned = short_case();
  std::swap(turned.settings.get<CycleSettings>().directions[0], turned.settings.get<CycleSettings>().directions[1]);
  const Results other(run_cycles(turned), turned);
  try {
    report_json({other.path(), results.path()},
                {.measured = {{folder.write("rig.csv", "displacement_um,force_N\n0,0\n10,100\n2,0\n")}}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the results have +Y, +X"), std::string::npos) << error.what();
  }
  EXPECT_NE(
      refusal("direction,displacement_um,force_N\n-X,0,0\n-X,10,100\n-X,2,0\n").find("of the direction 180, which"),
      std::string::npos);
}

TEST(Report, SaysWhichOfSeveralMeasuredCyclesItShows) {
  const Results results(run_cycles(short_case()));
  const TemporaryFolder folder;
  std::vector<std::string> warnings;
  const ReadingOptions options{
      .warn = [&](const std::string& warning) { warnings.push_back(warning); },
      .measured = {{folder.write("rig.csv", "s [um],Load (N)\n0,0\n10,100\n0,0\n20,200\n1,0\n20,200\n"), "+Y"}},
      .columns = "displacement=s"};
  const json run = json::parse(report_json({results.path()}, options)).at("runs").at(1);
  EXPECT_EQ(run.at("cycles")[0].at("at"), 90.0);
  const json& summary = run.at("summary").at("cycles")[0];
  EXPECT_EQ(summary.at("max_force_N"), 200.0);
  EXPECT_EQ(summary.at("warnings"),
            (std::vector<std::string>{
                "2 cycles found, the last is used", "continues after its last complete cycle; the rest is ignored",
                "does not close: it ends 1 um and 0 N from its start; a straight line closes it"}));
  ASSERT_EQ(warnings.size(), 3U);
  EXPECT_NE(warnings[0].find("rig.csv: +Y: 2 cycles found, the last is used"), std::string::npos) << warnings[0];
}

TEST(Report, NamesRunsByAsManyPartsOfTheirPathsAsTellThemApart) {
  const TemporaryFolder folder;
  const auto copy_to = [&](const char* place) {
    const Results results(run_cycles(short_case()));
    std::filesystem::create_directories((folder.path() / place).parent_path());
    std::filesystem::copy(results.path(), folder.path() / place);
    return folder.path() / place;
  };
  const std::filesystem::path a = copy_to("a/run");
  const std::filesystem::path b = copy_to("b/run");
  const auto names_in = [](const std::vector<std::filesystem::path>& folders) {
    std::vector<std::string> names;
    const json report = json::parse(report_json(folders));
    for (const json& run : report.at("runs")) names.push_back(run.at("name"));
    return names;
  };
  EXPECT_EQ(names_in({a}), (std::vector<std::string>{"run"}));
  EXPECT_EQ(names_in({a / "", b / "." / ".." / "run"}), (std::vector<std::string>{"a/run", "b/run"}));
  EXPECT_EQ(names_in({a, a, b}), (std::vector<std::string>{"a/run (1)", "a/run (2)", "b/run"}));
}

TEST(Report, LeavesThePathsOfTheMachineOut) {
  const Case input = short_case();
  const TemporaryFolder folder;
  const Provenance provenance{
      .command_line = "bumpfoil cycle '/home/jo doe/case.toml' -o /tmp/a/b --set 'f=\"/data/h.csv\"' -q 1/2 ../x",
      .case_text = ""};
  for (const ResultFile& file :
       test_support::files_of("cycle", input, cycle_outcome(input, run_cycles(input)), {}, provenance)) {
    folder.write(file.name, file.contents);
  }
  const std::string text = report_json({folder.path()});
  EXPECT_EQ(text.find(folder.path().parent_path().string() + "/"), std::string::npos);
  const json attributes = json::parse(text).at("runs").at(0).at("attributes");
  EXPECT_EQ(attributes.at("command_line"), "bumpfoil cycle 'case.toml' -o b --set 'f=\"h.csv\"' -q 1/2 ../x");
  EXPECT_FALSE(attributes.contains("history"));  // it contains the command line, too
}

TEST(Report, CarriesTheMeaningsThatTheResultHas) {
  const Results results(run_cycles(short_case()));
  {
    netCDF::NcFile file((results.path() / "result.nc").string(), netCDF::NcFile::write);
    file.getVar("loss_factor").putAtt("long_name", "as it was once defined");
  }
  const json run = json::parse(report_json({results.path()}, {.checked = false})).at("runs").at(0);
  EXPECT_EQ(run.at("meanings").at("work"), (json{{"unit", "J"}, {"text", "work of the journal since increment 0"}}));
  EXPECT_EQ(run.at("meanings").at("loss_factor").at("unit"), "");
  std::size_t found = 0;
  for (const json& quantity : run.at("quantities")) {
    EXPECT_FALSE(quantity.at("meaning").get<std::string>().empty()) << quantity;
    if (quantity.at("name") != "loss_factor") continue;
    ++found;
    EXPECT_EQ(quantity.at("meaning"), "as it was once defined");
  }
  EXPECT_EQ(found, 1U);
}

/// Linear interpolation of values at equal angles.
double at_angle(const std::vector<float>& numbers, double phi) {
  const double turns = phi / (2.0 * std::numbers::pi);
  const double place = (turns - std::floor(turns)) * static_cast<double>(numbers.size() - 1);
  const auto before = static_cast<std::size_t>(place);
  return numbers[before] + (numbers[before + 1] - numbers[before]) * (place - static_cast<double>(before));
}

TEST(Report, TellsHowSleeveAndJournalDifferFromCircles) {
  Case input = reference_case();
  CycleSettings& settings = input.settings.get<CycleSettings>();
  settings.directions = {0.0};
  settings.amplitude.value = 5e-6;  // the journal does not touch the foils
  settings.steps = 1;
  input.bearing.sleeve.waves = {{.harmonic = 3, .amplitude = 2e-6, .phase = 0.4}};
  input.bearing.sleeve.deviations = {1e-6, -2e-6, 3e-6, 0.0};
  input.bearing.journal.waves = {{.harmonic = 2, .amplitude = 4e-6, .phase = 1.0}};
  input.bearing.taper = 10e-6;
  const CycleResult result = run_cycles(input);
  const Results results(result, input);
  const json deviations = json::parse(report_json({results.path()})).at("runs").at(0).at("deviations");
  const auto [sleeve, journal, taper] = std::tuple(
      numbers_of(deviations.at("sleeve")), numbers_of(deviations.at("journal")), numbers_of(deviations.at("taper")));
  // The gaps agree: over the crests they are C_r + w_s - w_j, minus the displacement of the journal towards the top
  // foil.
  const Vector phi = polar_angles(input.bearing, crest_angles(input));
  const Cycle& cycle = result.cycles.front();
  for (Eigen::Index bump = 0; bump < phi.size(); ++bump) {
    const double moved = cycle.increments[1].x * std::cos(phi[bump]) - cycle.fields.top_displacement(1, bump);
    const double deviation = cycle.fields.journal_top.gap(1, bump) - input.bearing.radial_clearance + moved;
    // Linear interpolation over half degrees has errors of a k^2 (pi / 720)^2 / 2 for waves.
    EXPECT_NEAR(at_angle(sleeve, phi[bump]) - at_angle(journal, phi[bump]), deviation, 1e-9) << bump;
    EXPECT_NEAR(at_angle(taper, phi[bump]), 10e-6 * (static_cast<double>(bump) + 0.5) / 26.0, 1e-11);
  }
  // There are no foils between free end and weld, at 180 degrees.
  EXPECT_TRUE(std::isnan(sleeve[361]) && std::isnan(taper[361]) && !std::isnan(journal[361]));

  input.bearing = reference_case().bearing;
  input.bearing.taper = 10e-6;
  const json tapered = json::parse(report_json({Results(result, input).path()})).at("runs").at(0).at("deviations");
  EXPECT_TRUE(tapered.size() == 1 && tapered.contains("sleeve")) << tapered;
  input.bearing.taper = 0.0;
  EXPECT_FALSE(json::parse(report_json({Results(result, input).path()})).at("runs").at(0).contains("deviations"));
}

TEST(Report, HasTheLargestStressOfEveryIncrement) {
  Case input = short_case();
  input.bump_foil.model = BumpFoilModel::frame;
  const CycleResult result = run_cycles(input);
  const Results results(result, input);
  const json series = json::parse(report_json({results.path()})).at("runs").at(0).at("cycles").at(1).at("series");
  const StressFields& stress = result.cycles[1].fields.stress;
  for (const auto& [name, matrix] :
       {std::pair{"stress_top_foil", &stress.top_crest}, std::pair{"stress_bump_foil_foot", &stress.bump_foot},
        std::pair{"stress_bump_foil", &stress.bump_largest}}) {
    const std::vector<float> sizes = numbers_of(series.at(name));
    ASSERT_EQ(sizes.size(), 11U) << name;
    EXPECT_GT(sizes[5], 1e6F) << name;
    for (Eigen::Index i = 0; i < 11; ++i) {
      EXPECT_EQ(sizes[static_cast<std::size_t>(i)], static_cast<float>(matrix->row(i).cwiseAbs().maxCoeff())) << name;
    }
  }
}

TEST(Report, NamesEveryFolderThatHoldsNoResult) {
  const Results good(run_cycles(short_case()));
  const TemporaryFolder empty;
  const TemporaryFolder broken;
  broken.write("summary.json", good.folder().read("summary.json"));
  broken.write("result.nc", "no netCDF at all");
  const TemporaryFolder drawn;
  drawn.write("ensemble.nc", "");
  const Results cut(run_cycles(short_case()));
  cut.folder().write("summary.json", "{\"schema\": ");
  const std::vector<InputError> errors =
      errors_of({empty.path() / "nowhere", good.path(), empty.path(), good.path() / "summary.json", broken.path(),
                 cut.path(), drawn.path()});
  ASSERT_EQ(errors.size(), 6U);
  EXPECT_EQ(errors[0].file, (empty.path() / "nowhere").string());
  EXPECT_EQ(errors[0].what, "does not exist");
  EXPECT_EQ(errors[1].what, "contains no results: result.nc is missing");
  EXPECT_EQ(errors[2].what, "is not a folder");
  EXPECT_EQ(errors[3].file, (broken.path() / "result.nc").string());
  EXPECT_NE(errors[3].what.find("is damaged: it has 16 bytes"), std::string::npos);
  EXPECT_EQ(errors[4].what, "cannot be read: it is not JSON");
  EXPECT_EQ(errors[5].what, "contains no results: summary.json is missing");
}

TEST(Report, ReadsTheNewSetWhereItsPublicationWasCutShort) {
  const Results results(run_cycles(short_case()));
  Case input = short_case();
  input.title = "new";
  const std::filesystem::path mine = results.path() / "result.nc";
  {
    ResultFolder folder(results.path(), Existing::replace, experiment_named("cycle").files);
    for (const ResultFile& file : test_support::files_of("cycle", input)) {
      folder.stage(file.name, file.contents);
    }
    int step = 0;
    EXPECT_THROW(folder.publish([&] {
      if (++step != 3) return;
      std::filesystem::remove(mine);  // a folder in its place: the publication cannot be completed
      std::filesystem::create_directories(mine / "in the way");
    }),
                 Error);
  }
  const auto titles = [&] {
    const json run = json::parse(report_json({results.path()})).at("runs").at(0);
    EXPECT_EQ(run.at("summary").at("run_id"), run.at("attributes").at("run_id"));
    return run.at("attributes").at("title").get<std::string>();
  };
  EXPECT_EQ(titles(), "new");
  std::filesystem::remove_all(mine);
  EXPECT_EQ(titles(), "new");
  EXPECT_EQ(results.folder().listing(), "cycle.csv result.nc summary.json ");
}

TEST(Report, TakesNoOtherNetcdfForAResult) {
  const Results results(run_cycles(short_case()));
  netCDF::NcFile((results.path() / "result.nc").string(), netCDF::NcFile::replace).putAtt("schema", "other/1");
  const std::vector<InputError> errors = errors_of({results.path()}, false);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].what, "is not a result of this program");
}

TEST(Report, SaysWhichResultsItCannotShow) {
  const Results results(run_cycles(short_case()));
  netCDF::NcFile((results.path() / "result.nc").string(), netCDF::NcFile::write).putAtt("bumpfoil_command", "orbit");
  const std::vector<InputError> errors = errors_of({results.path()}, false);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].what, "is a result of `bumpfoil orbit`, which this version does not have");
}

TEST(Report, KeepsHostileTextsInsideTheirScriptElement) {
  Case input = short_case();
  input.title = "</script><img src=x onerror=alert(1)> <!-- \xe2\x80\xa8 \" \\ \xff";
  const Results results(run_cycles(input), input);
  const std::string data = report_json({results.path()});
  const std::string page = fill_report("<script>@bumpfoil-report-data@</script><p>after</p>", data);
  EXPECT_EQ(page.find("<script>"), 0U);
  EXPECT_EQ(page.find('<', 1), page.find("</script><p>after</p>"));
  const std::string between = page.substr(8, page.find("</script>") - 8);
  const json title = json::parse(between).at("runs").at(0).at("attributes").at("title");
  // Invalid UTF-8 is repaired, all else is unchanged.
  EXPECT_EQ(title, "</script><img src=x onerror=alert(1)> <!-- \xe2\x80\xa8 \" \\ \xef\xbf\xbd");
}

}  // namespace
}  // namespace bumpfoil
