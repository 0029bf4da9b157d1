#include "bumpfoil/sweep/sweep_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"
#include "results/result_files.hpp"
#include "sweep/sweep_layout.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Lines of cells of csv_text().
std::vector<std::vector<std::string>> cells_of(std::string_view csv) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& cell = lines.back().back();
    if (csv[i] == '"' && quoted && csv.substr(i + 1).starts_with('"')) {
      cell += csv[i++];
    } else if (csv[i] == '"') {
      quoted = !quoted;
    } else if (csv[i] == ',' && !quoted) {
      lines.back().emplace_back();
    } else if (csv[i] == '\n' && !quoted) {
      lines.push_back({""});
    } else {
      cell += csv[i];
    }
  }
  lines.pop_back();
  return lines;
}

/// Keys of the columns of csv_text().
std::vector<std::string> header_of(std::string_view csv) {
  return cells_of(csv.substr(0, csv.find('\n') + 1)).front();
}

/// Rows of every point preceded by its keys, under the union of all columns; missing values are blank.
/// @param csv_of  point -> its rows
template <typename CsvOf>
Table table_of_points(const Sweep& sweep, const std::vector<SweepPoint>& points, const CsvOf& csv_of) {
  std::vector<std::string> names;
  for (const SweepPoint& point : points) merge_names(header_of(csv_of(point)), names);
  std::vector<std::vector<double>> keys(sweep.axes.size());
  std::vector<std::vector<std::string>> columns(names.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<std::size_t> indices = indices_of(sweep, i);
    std::vector<std::vector<std::string>> lines = cells_of(csv_of(points[i]));
    const auto places = each(names, [&own = lines.front()](const std::string& name) {
      return static_cast<std::size_t>(std::find(own.begin(), own.end(), name) - own.begin());
    });
    for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
      for (std::size_t k = 0; k < keys.size(); ++k) keys[k].push_back(sweep.axes[k].values[indices[k]]);
      for (std::size_t k = 0; k < names.size(); ++k) {
        columns[k].push_back(places[k] < line->size() ? std::move((*line)[places[k]]) : std::string());
      }
    }
  }
  Table table;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    table.add({sweep.axes[k].name, sweep.axes[k].unit, sweep.axes[k].title}, std::move(keys[k]));
  }
  for (std::size_t k = 0; k < names.size(); ++k) table.add({names[k], "", ""}, std::move(columns[k]));
  return table;
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

}  // namespace

std::vector<std::string> sweep_file_names(const Sweep& sweep) {
  std::vector<std::string> names{"summary.json", "sweep.csv", "sweep.nc"};
  const std::vector<std::string>& more = sweep.experiment->sweeping->more_tables;
  names.insert(names.begin() + 2, more.begin(), more.end());
  return names;
}

std::vector<ResultFile> sweep_files(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                    const Provenance& provenance) {
  BUMPFOIL_ASSERT(points.size() == sweep.cases.size());
  return make_result_files(
      {.input = sweep.cases.front(),
       .command = "sweep",
       .status = status_of(points),
       .failures = failure_lines(sweep, points),
       .warnings = warning_lines(sweep, points),
       .provenance = provenance,
       .message = message_of(sweep, points)},
      "sweep.nc", "use fewer points", [&](const std::string& /*run_id*/) {
        std::vector<TableFile> tables{
            {"sweep.csv", table_of_points(sweep, points, [](const SweepPoint& point) { return point.rows; })}};
        const std::vector<std::string>& more = sweep.experiment->sweeping->more_tables;
        for (std::size_t i = 0; i < more.size(); ++i) {
          tables.push_back(
              {more[i], table_of_points(sweep, points, [i](const SweepPoint& point) { return point.more[i]; })});
        }
        return ResultContents{
            .tables = std::move(tables), .lists = sweep_lists(sweep, points), .dataset = sweep_dataset(sweep, points)};
      });
}

}  // namespace bumpfoil
