#include "bumpfoil/sweep/sweep_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"
#include "results/result_files.hpp"
#include "sweep/sweep_layout.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(std::move(cell));
  return cells;
}

/// Rows of every point preceded by its keys, under the union of all columns; missing values are blank.
std::string sweep_csv(const Sweep& sweep, const std::vector<SweepPoint>& points, std::string SweepPoint::*lines) {
  std::string out;
  for (const SweepAxis& axis : sweep.axes) out += key_of(axis.name, axis.unit) + ',';
  std::set<std::string> headers;
  std::vector<std::string> columns;
  for (const SweepPoint& point : points) {
    const std::string header = (point.*lines).substr(0, (point.*lines).find('\n'));
    if (headers.insert(header).second) merge_names(cells_of(header), columns);
  }
  out += fmt::format("{}\n", fmt::join(columns, ","));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<std::size_t> indices = indices_of(sweep, i);
    std::string keys;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      fmt::format_to(std::back_inserter(keys), "{:.17g},", sweep.axes[k].values[indices[k]]);
    }
    std::istringstream rows(points[i].*lines);
    std::string row;
    std::getline(rows, row);  // the header
    const std::vector<std::string> names = headers.size() > 1 ? cells_of(row) : columns;
    while (std::getline(rows, row)) {
      if (names != columns) {
        const std::vector<std::string> cells = cells_of(row);
        row = fmt::format("{}", fmt::join(each(columns,
                                               [&](const std::string& column) {
                                                 const auto place = static_cast<std::size_t>(
                                                     std::find(names.begin(), names.end(), column) - names.begin());
                                                 return place < cells.size() ? cells[place] : std::string();
                                               }),
                                          ","));
      }
      out += keys + row + '\n';
    }
  }
  return out;
}

Json sweep_lists(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  Json json{{"swept_command", sweep.experiment->name}};
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
  return json;
}

/// The reason why the sweep is incomplete.
std::string message_of(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const auto count = [&points](RunStatus status) {
    return std::count_if(points.begin(), points.end(), [=](const SweepPoint& point) { return point.status == status; });
  };
  std::string message;
  if (const auto failed = count(RunStatus::failed); failed > 0) {
    message =
        fmt::format("{} of {} points failed: {}", failed, points.size(), fmt::join(failure_lines(sweep, points), "; "));
  }
  if (const auto missing = count(RunStatus::interrupted); missing > 0) {
    message += fmt::format("{}the sweep was interrupted by the user or the system: {} of {} points are missing",
                           message.empty() ? "" : "; ", missing, points.size());
  }
  return message;
}

/// Whether separate coefficients are written: running bearings have their own.
bool has_coefficients(const Sweep& sweep) {
  return sweep.experiment->name == "equilibrium";
}

}  // namespace

std::vector<std::string> sweep_file_names(const Sweep& sweep) {
  if (has_coefficients(sweep)) return {"summary.json", "sweep.csv", "coefficients.csv", "sweep.nc"};
  return {"summary.json", "sweep.csv", "sweep.nc"};
}

std::vector<ResultFile> sweep_files(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                    const Provenance& provenance) {
  BUMPFOIL_ASSERT(points.size() == sweep.cases.size());
  return make_result_files(
      {.input = sweep.cases.front(),
       .command = "sweep",
       .status = status_of(points),
       .message = message_of(sweep, points),
       .warnings = warning_lines(sweep, points),
       .provenance = provenance},
      "sweep.nc", "use fewer points", [&](const std::string& /*run_id*/) {
        std::vector<ResultFile> texts{{"sweep.csv", sweep_csv(sweep, points, &SweepPoint::rows)}};
        if (has_coefficients(sweep)) {
          texts.push_back({"coefficients.csv", sweep_csv(sweep, points, &SweepPoint::coefficients)});
        }
        return ResultContents{.texts = std::move(texts), .dataset = sweep_dataset(sweep, points), .lists = [&] {
                                return sweep_lists(sweep, points);
                              }};
      });
}

}  // namespace bumpfoil
