#include "bumpfoil/io/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <netcdf>
#include <optional>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/io/result_folder.hpp"
#include "io/case_json.hpp"
#include "io/result_reader.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view advice = "give the folder of a run, such as `bumpfoil cycle CASE -o DIR` writes";

Json read_summary(const fs::path& path) {
  std::ifstream file(path);
  return Json::parse(file);
}

/// What a folder shows, or what is wrong with it.
std::pair<Json, std::optional<Fault>> read_run(const fs::path& folder, std::size_t most_values) {
  const auto fault = [&](const fs::path& path, std::string what) {
    return std::pair(Json(), std::optional(Fault{path.string(), 0, "", "", std::move(what), std::string(advice)}));
  };
  std::error_code code;
  if (!fs::exists(folder, code)) return fault(folder, "does not exist");
  if (!fs::is_directory(folder, code)) return fault(folder, "is no folder");
  complete_publication_quietly(folder);
  for (const char* name : {"result.nc", "summary.json"}) {
    if (!fs::exists(published_file(folder, name), code))
      return fault(folder, fmt::format("holds no results: {} is missing", name));
  }
  try {
    Json run{{"name", fs::absolute(folder).lexically_normal().string()}};
    run["summary"] = read_summary(published_file(folder, "summary.json"));
    run.update(read_result(published_file(folder, "result.nc"), most_values));
    return {run, std::nullopt};
  } catch (const Json::exception&) {
    return fault(folder / "summary.json", "cannot be read: it is no JSON");
  } catch (const NotAResult& error) {
    return fault(folder / "result.nc", error.what());
  } catch (const netCDF::exceptions::NcException& error) {
    // The first line says what went wrong, the second where in the library.
    const std::string_view reason = error.what();
    return fault(folder / "result.nc", fmt::format("cannot be read: {}", reason.substr(0, reason.find('\n'))));
  }
}

}  // namespace

std::string report_json(const std::vector<fs::path>& folders, std::size_t most_values) {
  BUMPFOIL_ASSERT(!folders.empty());
  Json runs = Json::array();
  std::vector<Fault> faults;
  for (const fs::path& folder : folders) {
    auto [run, fault] = read_run(folder, std::max<std::size_t>(1, most_values / folders.size()));
    if (fault) faults.push_back(*std::move(fault));
    runs.push_back(std::move(run));
  }
  if (!faults.empty()) throw Error(ErrorKind::file, std::move(faults));
  return dump_json({{"schema", "bumpfoil-report/1"}, {"version", version()}, {"commit", commit()}, {"runs", runs}}, -1);
}

std::string fill_report(std::string_view page, std::string_view json) {
  const std::size_t place = page.find(report_placeholder);
  BUMPFOIL_ASSERT(place != std::string_view::npos);
  BUMPFOIL_ASSERT(page.find(report_placeholder, place + 1) == std::string_view::npos);
  std::string out(page.substr(0, place));
  out.reserve(page.size() + json.size());
  for (const char letter : json) {
    // In JSON it stands in texts alone, where an escape means the same.
    if (letter == '<') {
      out += "\\u003c";
    } else {
      out += letter;
    }
  }
  out += page.substr(place + report_placeholder.size());
  return out;
}

}  // namespace bumpfoil
