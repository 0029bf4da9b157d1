#include "bumpfoil/io/sweep_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <new>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "io/csv_value.hpp"
#include "io/manifest.hpp"
#include "io/summary_json.hpp"
#include "io/sweep_netcdf.hpp"
#include "io/sweep_values.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// A row for each point and cycle, begun or not.
std::string sweep_csv(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const std::vector<CycleQuantity> quantities = cycle_quantities(sweep.experiment);
  std::string out;
  for (const SweepAxis& axis : sweep.axes) out += key_of(axis.name, axis.unit) + ',';
  out += cycle_key(sweep.experiment);
  for (const CycleQuantity& quantity : quantities) out += ',' + key_of(quantity.name, quantity.unit);
  for (std::size_t point = 0; point < points.size(); ++point) {
    const Case& input = sweep.cases[point];
    const std::vector<std::size_t> indices = indices_of(sweep, point);
    const ResultLayout layout = make_result_layout(input, sweep.experiment);
    for (std::size_t cycle = 0; cycle < layout.places.size(); ++cycle) {
      out += '\n';
      for (std::size_t i = 0; i < indices.size(); ++i) {
        fmt::format_to(std::back_inserter(out), "{:.17g},", sweep.axes[i].values[indices[i]]);
      }
      fmt::format_to(std::back_inserter(out), "{:.17g}", layout.cycles.values[layout.places[cycle]]);
      for (const CycleQuantity& quantity : quantities) {
        append_csv(out += ',', value_at(quantity, input, points[point], cycle), quantity.form);
      }
    }
  }
  return out + '\n';
}

std::string sweep_summary(const Sweep& sweep, const std::vector<SweepPoint>& points, const Manifest& manifest) {
  Json json = summary_head("sweep", sweep.cases.front(), status_of(points), manifest);
  json["swept_command"] = name_of(sweep.experiment);
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
    Json point{{"values", values}, {"status", name_of(points[i].status)}, {"cycles", Json::array()}};
    for (std::size_t cycle = 0; cycle < points[i].result.cycles.size(); ++cycle) {
      point["cycles"].push_back(cycle_json(sweep.cases[i], points[i].result, cycle));
    }
    json["points"].push_back(std::move(point));
  }
  return sealed_summary(json);
}

}  // namespace

std::vector<std::string> sweep_file_names() {
  return {"sweep.csv", "sweep.nc", "summary.json"};
}

std::vector<ResultFile> sweep_files(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                    const Provenance& provenance) try {
  BUMPFOIL_ASSERT(points.size() == sweep.cases.size());
  const std::string run_id = make_run_id();
  std::vector<ResultFile> files;
  files.push_back({"sweep.csv", sweep_csv(sweep, points)});
  files.push_back({"sweep.nc", sweep_netcdf(sweep, points, provenance, run_id)});
  files.push_back({"summary.json", sweep_summary(sweep, points, make_manifest(run_id, files))});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file,
              {{"summary.json", 0, "", "", "cannot be built: the memory does not suffice", "fewer points take less"}});
}

}  // namespace bumpfoil
