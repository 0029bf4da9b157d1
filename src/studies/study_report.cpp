#include "bumpfoil/studies/study_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json cell_json(const TableCell& cell) {
  if (const auto* whole = std::get_if<int>(&cell)) return *whole;
  if (const auto* number = std::get_if<double>(&cell); number != nullptr && std::isfinite(*number)) return *number;
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  return {};
}

Json table_json(const StudyTable& table) {
  Json json = Json::object();
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    Json& values = json[table.columns[column]] = Json::array();
    for (const auto& row : table.rows) values.push_back(cell_json(row[column]));
  }
  return json;
}

}  // namespace

StudyOutcome outcome_of(const Study& study, const std::vector<StudyRunResult>& results) {
  StudyOutcome outcome{.name = study.name, .title = study.title, .runs = results.size()};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const StudyRunResult& run = results[i];
    outcome.converged = outcome.converged && run.result.converged();
    for (const std::string& line : failure_lines(run.input, run.result)) {
      outcome.failures.push_back(fmt::format("{}/{}: {}", study.name, study.runs[i].name, line));
    }
    for (const Cycle& cycle : run.result.cycles) {
      outcome.increments += cycle.increments.size();
      const double residual = cycle.max_residual;
      if (!std::isnan(outcome.max_residual) && !(residual <= outcome.max_residual)) outcome.max_residual = residual;
    }
  }
  return outcome;
}

std::string study_outcomes_table(const std::vector<StudyOutcome>& outcomes) {
  const std::string header = fmt::format("{:<16} {:>4} {:>10} {:>9} {:>9} {:>7}   {}\n", "study", "runs", "increments",
                                         "residual", "converged", "time s", "what");
  std::string out = header + std::string(105, '-') + '\n';
  for (const StudyOutcome& one : outcomes) {
    fmt::format_to(std::back_inserter(out), "{:<16} {:>4} {:>10} {:>9.1e} {:>9} {:>7.2f}   {}\n", one.name, one.runs,
                   one.increments, one.max_residual, one.converged ? "yes" : "no", one.wall_time, one.title);
  }
  return out;
}

std::string study_json(const Study& study, const std::vector<StudyRunResult>& results,
                       const std::vector<StudyTable>& tables) {
  Json json;
  json["schema"] = "bumpfoil-study/1";
  json["study"] = study.name;
  json["title"] = study.title;
  json["version"] = version();
  json["commit"] = commit();
  json["converged"] = outcome_of(study, results).converged;
  json["runs"] = Json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const StudyRun& run = study.runs[i];
    json["runs"].push_back({{"name", run.name},
                            {"label", run.label},
                            {"set", run.overrides},
                            {"status", name_of(results[i].status)},
                            {"results", run.name + "/summary.json"}});
  }
  json["tables"] = Json::object();
  for (const StudyTable& table : tables) json["tables"][table.name] = table_json(table);
  return printable_json(json.dump(1)) + '\n';
}

}  // namespace bumpfoil
