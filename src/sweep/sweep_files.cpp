#include "bumpfoil/sweep/sweep_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
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

/// What keeps the sweep from being complete.
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

/// Running bearings have coefficients of their own.
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
