#include "bumpfoil/sweep/sweep_files.hpp"

#include <fmt/format.h>

#include <iterator>
#include <new>
#include <sstream>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "results/manifest.hpp"
#include "results/summary_json.hpp"
#include "sweep/sweep_netcdf.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Rows of every point behind its keys.
std::string sweep_csv(const Sweep& sweep, const std::vector<SweepPoint>& points, std::string SweepPoint::*lines) {
  std::string out;
  for (const SweepAxis& axis : sweep.axes) out += key_of(axis.name, axis.unit) + ',';
  const std::string& first = points.front().*lines;
  out += first.substr(0, first.find('\n') + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<std::size_t> indices = indices_of(sweep, i);
    std::string keys;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      fmt::format_to(std::back_inserter(keys), "{:.17g},", sweep.axes[k].values[indices[k]]);
    }
    std::istringstream rows(points[i].*lines);
    std::string row;
    std::getline(rows, row);  // the header
    while (std::getline(rows, row)) out += keys + row + '\n';
  }
  return out;
}

std::string sweep_summary(const Sweep& sweep, const std::vector<SweepPoint>& points, const Manifest& manifest) {
  Json json = summary_head("sweep", sweep.cases.front(), status_of(points), manifest);
  json["swept_command"] = name_of(sweep.command);
  json["axes"] = Json::array();
  for (const SweepAxis& axis : sweep.axes) {
    json["axes"].push_back({{"key", axis.swept.key},
                            {"name", axis.name},
                            {"title", axis.title},
                            {"unit", axis.unit},
                            {"values", axis.values},
                            {"written", axis.swept.values}});
  }
  json["points"] = Json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<std::size_t> indices = indices_of(sweep, i);
    Json values = Json::object();
    for (std::size_t k = 0; k < indices.size(); ++k) {
      values[sweep.axes[k].swept.key] = sweep.axes[k].values[indices[k]];
    }
    Json point{{"values", values}, {"status", name_of(points[i].status)}};
    point.update(Json::parse(points[i].lists));
    json["points"].push_back(std::move(point));
  }
  return sealed_summary(json);
}

}  // namespace

std::vector<std::string> sweep_file_names(SweptCommand command) {
  if (command == SweptCommand::equilibrium) return {"summary.json", "sweep.csv", "coefficients.csv", "sweep.nc"};
  return {"summary.json", "sweep.csv", "sweep.nc"};
}

std::vector<ResultFile> sweep_files(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                    const Provenance& provenance) try {
  BUMPFOIL_ASSERT(points.size() == sweep.cases.size());
  const std::string run_id = make_run_id();
  std::vector<ResultFile> files;
  files.push_back({"sweep.csv", sweep_csv(sweep, points, &SweepPoint::rows)});
  if (sweep.command == SweptCommand::equilibrium) {
    files.push_back({"coefficients.csv", sweep_csv(sweep, points, &SweepPoint::coefficients)});
  }
  files.push_back({"sweep.nc", sweep_netcdf(sweep, points, provenance, run_id)});
  files.push_back({"summary.json", sweep_summary(sweep, points, make_manifest(run_id, files))});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file,
              {{"summary.json", 0, "", "", "cannot be built: the memory does not suffice", "fewer points take less"}});
}

}  // namespace bumpfoil
