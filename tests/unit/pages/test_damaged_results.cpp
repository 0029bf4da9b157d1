// Damaged, inconsistent or malicious results: reported with file and variable, never read beyond the data.

#include <gtest/gtest.h>
#include <netcdf.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "support/bearing_cases.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;
using test_support::TemporaryFolder;

/// A variable to be declared in a file.
struct Declared {
  int type{NC_DOUBLE};
  std::vector<std::string> dims{};
  std::vector<double> values{};  ///< none: never written
  std::vector<std::size_t> chunk{};
  int fill_type{NC_DOUBLE};
  std::vector<double> fill{};
};

/// A small file that the reader accepts as a result, to be damaged.
struct SmallFile {
  std::map<std::string, std::size_t> dims{{"direction", 2}, {"increment", 5}, {"bump", 3}, {"foot", 3}};
  std::map<std::string, Declared> variables{
      {"direction", {.dims = {"direction"}, .values = {0.0, 90.0}}},
      {"increment", {.type = NC_INT, .dims = {"increment"}, .values = {0, 1, 2, 3, 4}}},
      {"bump", {.type = NC_INT, .dims = {"bump"}, .values = {1, 2, 3}}},
      {"foot", {.type = NC_INT, .dims = {"foot"}, .values = {1, 2, 3}}},
      {"steps", {.type = NC_INT, .dims = {"direction"}, .values = {2, 2}}},
      {"displacement", {.dims = {"direction", "increment"}, .values = {0, 1, 2, 1, 0, 0, 1, 2, 1, 0}}},
      {"force_direct", {.dims = {"direction", "increment"}, .values = {0, 1, 2, 1, 0, 0, 1, 2, 1, 0}}},
      {"crest_v", {.dims = {"direction", "increment", "bump"}, .values = std::vector<double>(30, 1.0)}},
      {"bump_rise", {.values = {1e-3}}},
      {"height_error", {.dims = {"bump"}, .values = {0, 0, 0}}}};
  std::map<std::string, std::string> texts{
      {"schema", "bumpfoil-result/2"}, {"bumpfoil_command", "cycle"}, {"run_id", "of this run"}};

  void write(const std::filesystem::path& path) const {
    int file = 0;
    ASSERT_EQ(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &file), NC_NOERR);
    for (const auto& [name, text] : texts) nc_put_att_text(file, NC_GLOBAL, name.c_str(), text.size(), text.data());
    std::map<std::string, int> ids;
    for (const auto& [name, size] : dims) nc_def_dim(file, name.c_str(), size, &ids[name]);
    for (const auto& [name, declared] : variables) {
      std::vector<int> own;
      for (const std::string& dim : declared.dims) own.push_back(ids.at(dim));
      int id = 0;
      ASSERT_EQ(nc_def_var(file, name.c_str(), declared.type, static_cast<int>(own.size()), own.data(), &id), NC_NOERR);
      if (!declared.chunk.empty()) {
        ASSERT_EQ(nc_def_var_chunking(file, id, NC_CHUNKED, declared.chunk.data()), NC_NOERR);
      }
      if (!declared.fill.empty()) {
        // Renamed, because the library refuses to write it.
        ASSERT_EQ(nc_put_att_double(file, id, "other", declared.fill_type, declared.fill.size(), declared.fill.data()),
                  NC_NOERR);
        ASSERT_EQ(nc_rename_att(file, id, "other", "_FillValue"), NC_NOERR);
      }
      if (!declared.values.empty()) {
        ASSERT_EQ(nc_put_var_double(file, id, declared.values.data()), NC_NOERR) << name;
      }
    }
    ASSERT_EQ(nc_close(file), NC_NOERR);
  }
};

json small_summary() {
  const auto cycle = [](double direction) {
    return json{
        {"direction_deg", direction}, {"amplitude_m", 2.0}, {"steps", 2}, {"converged", true}, {"max_force_N", 1.0}};
  };
  return {{"schema", "bumpfoil-summary/2"},
          {"command", "cycle"},
          {"case", {{"cycle", {{"steps", 2}}}}},
          {"version", "0"},
          {"commit", "0"},
          {"solver", "newton"},
          {"status", "complete"},
          {"run_id", "of this run"},
          {"cycles", {cycle(0.0), cycle(90.0)}}};
}

/// A folder with this file and a summary.
class SmallResult {
 public:
  void write(const SmallFile& file) const { file.write(folder_.path() / "result.nc"); }

  /// Writes the summary with the checksum of the file.
  void write(json summary) const {
    const std::string bytes = folder_.read("result.nc");
    summary["files"] = {{"result.nc", {{"bytes", bytes.size()}, {"xxh3_128", xxh3_128(bytes)}}}};
    write_as_it_is(summary);
  }

  /// Writes the summary with its list of files unchanged, and its own checksum.
  void write_as_it_is(json summary) const {
    summary["xxh3_128"] = blank_checksum;
    folder_.write("summary.json", sealed(summary.dump()));
  }

  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  /// The reported error; empty if there is none.
  [[nodiscard]] std::string error(bool checked = true) const {
    try {
      report_json({folder_.path()}, {.checked = checked});
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::file);
      EXPECT_EQ(error.errors().size(), 1U);
      std::string text = error.what();
      EXPECT_EQ(text.find(folder_.path().string()), 0U) << text;
      return text.substr(folder_.path().string().size());
    }
  }

 private:
  TemporaryFolder folder_;
};

/// The error of a file, the same with and without the comparison of checksums.
std::string error_of(const std::function<void(SmallFile&)>& spoil) {
  SmallFile file;
  spoil(file);
  SmallResult result;
  result.write(file);
  result.write(small_summary());
  std::string error = result.error();
  EXPECT_EQ(result.error(false), error);
  return error;
}

std::string error_of_summary(const json& summary) {
  SmallResult result;
  result.write(SmallFile());
  if (summary.is_object()) {
    result.write(summary);
  } else {
    result.folder().write("summary.json", summary.dump());
  }
  std::string error = result.error();
  EXPECT_EQ(result.error(false), error);
  return error;
}

TEST(DamagedResult, TheSmallFileItselfIsRead) {
  EXPECT_EQ(error_of([](SmallFile&) {}), "");
  EXPECT_EQ(error_of_summary(small_summary()), "");
}

TEST(DamagedResult, StepsThatDoNotFitTheLoops) {
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.dims["few"] = 1;
              file.variables["steps"] = {.type = NC_INT, .dims = {"few"}, .values = {2}};
            }),
            "/result.nc: steps: has the dimensions (few), expected (direction)");
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.dims["none"] = NC_UNLIMITED;
              file.variables["steps"] = {.type = NC_INT, .dims = {"none"}};
            }),
            "/result.nc: steps: has the dimensions (none), expected (direction)");
  for (const double steps : {1e300, -2.0, 0.0, 0.5, 2.5, 3.0}) {
    EXPECT_NE(error_of([&](SmallFile& file) {
                file.variables["steps"] = {.dims = {"direction"}, .values = {2, steps}};
              }).find("/result.nc: steps: is "),
              std::string::npos);
  }
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.variables["steps"].values = {2, NC_FILL_INT};
            }).find("/result.nc: steps: is "),
            0U);
  EXPECT_EQ(error_of([](SmallFile& file) { file.variables.erase("steps"); }), "/result.nc: steps: is missing");
}

TEST(DamagedResult, DimensionsThatAreNotDue) {
  EXPECT_EQ(
      error_of([](SmallFile& file) {
        file.variables["force_direct"] = {.dims = {"direction", "increment", "bump"},
                                          .values = std::vector<double>(30)};
      }),
      "/result.nc: force_direct: has the dimensions (direction, increment, bump), expected (direction, increment)");
  for (const std::string name : {"displacement", "force_direct"}) {
    EXPECT_EQ(error_of([&](SmallFile& file) { file.variables[name] = {.dims = {}, .values = {1.0}}; }),
              "/result.nc: " + name + ": has the dimensions (), expected (direction, increment)");
  }
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.variables["direction"] = {.dims = {"bump"}, .values = {1, 2, 3}};
            }),
            "/result.nc: direction: has the dimensions (bump), expected (direction)");
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.variables["direction"].values = {0.0, std::numeric_limits<double>::infinity()};
            }),
            "/result.nc: direction: has a value that is not numeric");
  EXPECT_EQ(error_of([](SmallFile& file) { file.variables["crest_v"] = {.type = NC_CHAR, .dims = {"bump"}}; }),
            "/result.nc: crest_v: does not contain numbers of a type used in results");
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.dims.erase("foot");
              file.variables.erase("foot");
            }),
            "/result.nc: foot: is missing: it is a dimension of every result");
}

TEST(DamagedResult, SizesThatNoSuchFileHolds) {
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  for (const char* dim : {"direction", "increment", "bump", "foot"}) {
    EXPECT_EQ(
        error_of([&](SmallFile& file) {
          file.dims[dim] = 2'000'000'000;
          file.variables.clear();
          file.variables["crest_v"] = {.dims = {"direction", "increment", "bump"}, .values = {}, .chunk = {1, 1, 1}};
        }).find(std::string("/result.nc: ") + dim + ": is declared with 2000000000 values"),
        0U);
  }
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.dims["increment"] = 2'001;
              file.dims["bump"] = 2'000;
              file.dims["foot"] = 2'000;
              file.variables = {
                  {"direction", {.dims = {"direction"}, .values = {0.0, 90.0}}},
                  {"steps", {.type = NC_INT, .dims = {"direction"}, .values = {1000, 1000}}},
                  {"displacement", {.dims = {"direction", "increment"}, .values = std::vector<double>(4002)}},
                  {"force_direct", {.dims = {"direction", "increment"}, .values = std::vector<double>(4002)}},
                  {"crest_v", {.dims = {"direction", "increment", "bump"}, .values = {}, .chunk = {1, 2'001, 2'000}}}};
            }).find("/result.nc: crest_v: is declared "),
            std::string::npos);  // 32 MB in a file of 40 kB: possible with deflate
  EXPECT_EQ(error_of([](SmallFile& file) {
              file.dims["increment"] = 2'001;
              file.dims["bump"] = 9'000;
              file.variables["increment"] = {.type = NC_INT, .dims = {"bump"}};
              file.variables.erase("displacement");
              file.variables.erase("force_direct");
              file.variables.erase("height_error");
              file.variables["bump"] = {.dims = {"bump"}, .values = std::vector<double>(9'000)};
              file.variables["crest_v"] = {
                  .dims = {"direction", "increment", "bump"}, .values = {}, .chunk = {2, 2'001, 9'000}};
            }).find("/result.nc: crest_v: is declared in chunks of 2 x 2001 x 9000 numbers"),
            0U);
  rusage after{};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 300'000);  // kB; the declared size is many GB
}

TEST(DamagedResult, FillValuesThatAreNotOne) {
  for (const char* name : {"displacement", "force_direct", "crest_v", "bump_rise"}) {
    EXPECT_EQ(error_of([&](SmallFile& file) { file.variables[name].fill.assign(1000, 1.0); }),
              std::string("/result.nc: ") + name +
                  ": has 1000 values of its type in _FillValue, expected one of its own type");
    EXPECT_EQ(error_of([&](SmallFile& file) {
                file.variables[name].fill = {1.0};
                file.variables[name].fill_type = NC_BYTE;
              }),
              std::string("/result.nc: ") + name +
                  ": has 1 values of another type in _FillValue, expected one of its own type");
  }
}

TEST(DamagedResult, FilesThatAreNoResult) {
  EXPECT_EQ(error_of([](SmallFile& file) { file.texts["schema"] = "other/1"; }),
            "/result.nc: is not a result of this program");
  EXPECT_EQ(error_of([](SmallFile& file) { file.texts["schema"] = "bumpfoil-result/9"; }),
            "/result.nc: schema: is \"bumpfoil-result/9\", which this version cannot read: use the one that wrote it");
  EXPECT_EQ(error_of([](SmallFile& file) { file.texts["bumpfoil_command"] = "orbit\x1b[2J"; }),
            "/result.nc: is a result of `bumpfoil orbit\\x1b[2J`, which this version does not have");
  SmallResult result;
  for (const std::string bytes : {"", "CDF\001", "no netCDF at all", "\x89HDF\r\n\x1a\n"}) {
    result.folder().write("result.nc", bytes);
    result.write(small_summary());
    EXPECT_EQ(result.error().find("/result.nc: "), 0U);
    EXPECT_EQ(result.error(false), result.error());
  }
}

TEST(DamagedSummary, TextsThatAreNone) {
  EXPECT_EQ(error_of_summary(nullptr), "/summary.json: is not a summary of this program");
  EXPECT_EQ(error_of_summary(json::array()), "/summary.json: is not a summary of this program");
  EXPECT_EQ(error_of_summary(1.0), "/summary.json: is not a summary of this program");
  EXPECT_EQ(error_of_summary(json::object()), "/summary.json: is not a summary of this program");
  SmallResult result;
  result.write(SmallFile());
  result.folder().write("summary.json", "{\"schema\": ");
  EXPECT_EQ(result.error(), "/summary.json: cannot be read: it is not JSON");
  for (const char bracket : {'[', '{'}) {
    std::string deep(200'000, bracket);
    if (bracket == '{') {
      deep.clear();
      for (int i = 0; i < 200'000; ++i) deep += "{\"a\":";
    }
    result.folder().write("summary.json", deep);
    EXPECT_EQ(result.error(), "/summary.json: is nested more than 16 levels deep");
  }
}

TEST(DamagedSummary, KeysThatAreMissingOrOfAnotherType) {
  for (const char* key : {"command", "case", "version", "commit", "solver", "status", "run_id", "cycles"}) {
    json summary = small_summary();
    summary.erase(key);
    EXPECT_EQ(error_of_summary(summary), std::string("/summary.json: ") + key + ": is missing");
    for (const json& other : {json(1.0), json(nullptr), json{1}}) {
      if (other.is_array() && summary[key].is_array()) continue;
      summary[key] = other;
      EXPECT_EQ(error_of_summary(summary).find(std::string("/summary.json: ")), 0U) << key << other;
    }
  }
  for (const char* key : {"direction_deg", "amplitude_m", "steps", "converged", "max_force_N"}) {
    json summary = small_summary();
    summary["cycles"][1].erase(key);
    EXPECT_EQ(error_of_summary(summary), std::string("/summary.json: ") + key + ": is missing");
    summary["cycles"][1][key] = "text";
    EXPECT_EQ(error_of_summary(summary).find(std::string("/summary.json: ") + key + ": is n"), 0U) << key;
  }
  json summary = small_summary();
  summary["cycles"][1]["status"] = "tired";
  EXPECT_EQ(error_of_summary(summary).find("/summary.json: status: is not one of converged, no_modes, "), 0U);
  summary = small_summary();
  summary["cycles"][1]["amplitude_m"] = nullptr;  // under load control, before it is known
  EXPECT_EQ(error_of_summary(summary), "");
  summary = small_summary();
  summary["schema"] = "bumpfoil-summary/9";
  EXPECT_EQ(
      error_of_summary(summary),
      "/summary.json: schema: is \"bumpfoil-summary/9\", which this version cannot read: use the one that wrote it");
  summary["schema"] = 1;
  EXPECT_EQ(error_of_summary(summary), "/summary.json: schema: is not a string");
  summary = small_summary();
  summary["cycles"][0] = nullptr;
  EXPECT_EQ(error_of_summary(summary), "/summary.json: direction_deg: is missing");
}

TEST(DamagedSummary, OfAnotherRun) {
  const std::string told = ": differs from that of result.nc in the same folder: they are of two runs, or damaged";
  const auto error = [](const std::function<void(json&)>& change) {
    json summary = small_summary();
    change(summary);
    return error_of_summary(summary);
  };
  EXPECT_EQ(error([](json& summary) { summary["run_id"] = "of another"; }), "/summary.json: run_id" + told);
  EXPECT_EQ(error([](json& summary) { summary["run_id"] = ""; }), "/summary.json: run_id: is empty");
  EXPECT_EQ(error([](json& summary) { summary["cycles"][1]["direction_deg"] = 180.0; }),
            "/summary.json: direction_deg" + told);
  EXPECT_EQ(error([](json& summary) { summary["cycles"][1]["steps"] = 3; }), "/summary.json: steps" + told);
  EXPECT_EQ(error([](json& summary) { summary["cycles"].erase(1); }), "/summary.json: cycles" + told);
  EXPECT_EQ(error([](json& summary) { summary["cycles"].push_back(summary["cycles"][0]); }),
            "/summary.json: cycles" + told);
  EXPECT_EQ(error([](json& summary) {
              summary["command"] = "strip";
              summary["case"]["strip"] = json::object();
              for (json& cycle : summary["cycles"]) cycle["cycle"] = 1;
            }),
            "/summary.json: command" + told);
}

TEST(DamagedResult, ChecksumsTellUnlessTheyAreLeftOut) {
  SmallResult result;
  result.write(SmallFile());
  json summary = small_summary();
  summary["files"] = {{"result.nc", {{"bytes", 7}, {"xxh3_128", "0"}}}};
  result.write_as_it_is(summary);
  EXPECT_EQ(result.error().find("/result.nc: is damaged: it has "), 0U);
  EXPECT_EQ(result.error(false), "");
  summary["files"]["result.nc"]["bytes"] = result.folder().read("result.nc").size();
  result.write_as_it_is(summary);
  EXPECT_EQ(result.error().find("/result.nc: is damaged: its checksum "), 0U);
  EXPECT_EQ(result.error(false), "");
  summary["files"] = json::object();
  result.write_as_it_is(summary);
  EXPECT_EQ(result.error().find("/result.nc: is damaged: summary.json does not list it"), 0U);
  EXPECT_EQ(result.error(false), "");
  for (const json& files : {json(nullptr), json{1}, json{{"result.nc", nullptr}}, json{{"result.nc", {{"bytes", -1}}}},
                            json{{"result.nc", {{"bytes", 1}, {"xxh3_128", 2}}}}}) {
    summary["files"] = files;
    result.write_as_it_is(summary);
    EXPECT_EQ(result.error().find("/summary.json: "), 0U) << files;
  }
}

TEST(DamagedResult, OtherSchemasAndSummariesWithoutChecksumsAreRefused) {
  SmallResult result;
  result.write(SmallFile());
  json summary = small_summary();
  summary["schema"] = "bumpfoil-summary/1";
  result.write(summary);
  EXPECT_EQ(result.error().find("/summary.json: schema: is \"bumpfoil-summary/1\""), 0U) << result.error();
  summary = small_summary();
  summary.erase("run_id");
  result.folder().write("summary.json", summary.dump());
  EXPECT_EQ(result.error().find("/summary.json: xxh3_128: "), 0U) << result.error();
  SmallFile file;
  file.texts["schema"] = "bumpfoil-result/1";
  result.write(file);
  result.write(small_summary());
  EXPECT_EQ(result.error().find("/result.nc: "), 0U) << result.error();
}

TEST(DamagedResult, HundredsOfDamagedFilesAreTold) {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0};
  cycle.steps = 3;
  const TemporaryFolder folder;
  std::map<std::string, std::string> files;
  for (const ResultFile& file : test_support::files_of("cycle", input)) {
    if (file.name == "result.nc" || file.name == "summary.json") files[file.name] = file.contents;
  }
  const auto write_all = [&] {
    for (const auto& [name, contents] : files) folder.write(name, contents);
  };
  write_all();
  EXPECT_NO_THROW(report_json({folder.path()}));
  std::mt19937 random(12);  // any seed will do
  const auto below = [&random](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  for (int i = 0; i < 600; ++i) {
    write_all();
    const std::string name = i % 3 == 0 ? "summary.json" : "result.nc";
    std::string damaged = files.at(name);
    if (i % 5 == 0) damaged.resize(below(damaged.size()));
    for (std::size_t flips = i % 5 == 0 ? 0 : 1 + below(4); flips > 0; --flips) {
      damaged[below(damaged.size())] ^= static_cast<char>(1U << below(8));
    }
    if (damaged == files.at(name)) continue;
    folder.write(name, damaged);
    try {
      report_json({folder.path()});
      ADD_FAILURE() << "damage number " << i << " of " << name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::file);
    }
  }
}

}  // namespace
}  // namespace bumpfoil
