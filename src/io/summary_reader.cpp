#include "io/summary_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "bumpfoil/core/error.hpp"
#include "io/result_columns.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Summaries have five levels. Some of what walks through JSON takes stack for every level.
constexpr int most_levels = 16;

Experiment experiment_of(std::string_view command) {
  return command == "strip" ? Experiment::strip : Experiment::cycle;
}

/// Verifies the parts of a summary; every failure is an Error that names its key.
class SummaryChecker {
 public:
  explicit SummaryChecker(const std::string& name) : name_(name) {}

  [[noreturn]] void refuse(const std::string& key, std::string what) const {
    throw Error(ErrorKind::file, {{name_, 0, key, "", std::move(what), ""}});
  }

  [[nodiscard]] Json parse(std::string_view text) const {
    try {
      return Json::parse(text, [this](int depth, Json::parse_event_t, Json&) {
        if (depth > most_levels) refuse("", fmt::format("is nested more than {} levels deep", most_levels));
        return true;
      });
    } catch (const Json::exception&) {
      refuse("", "cannot be read: it is no JSON");
    }
  }

  [[nodiscard]] const Json& at(const Json& object, const std::string& key) const {
    if (!object.is_object() || !object.contains(key)) refuse(key, "is missing");
    return object[key];
  }

  [[nodiscard]] std::string text(const Json& object, const std::string& key) const {
    const Json& value = at(object, key);
    if (!value.is_string()) refuse(key, "is no text");
    return value.get<std::string>();
  }

  [[nodiscard]] std::map<std::string, ListedFile> files(const Json& summary) const {
    std::map<std::string, ListedFile> files;
    const Json& listed = at(summary, "files");
    if (!listed.is_object()) refuse("files", "is no table");
    for (const auto& [name, file] : listed.items()) {
      if (!at(file, "bytes").is_number_unsigned()) refuse("files", "has a size that is no whole number");
      files[name] = {file["bytes"].get<std::size_t>(), text(file, "xxh3_128")};
    }
    return files;
  }

  void check_cycle(const Json& cycle, Experiment experiment) const {
    if (!at(cycle, loop_key(experiment)).is_number()) refuse(loop_key(experiment), "is no number");
    if (!at(cycle, "amplitude_m").is_number()) refuse("amplitude_m", "is no number");
    if (!at(cycle, "steps").is_number_integer()) refuse("steps", "is no whole number");
    if (!at(cycle, "converged").is_boolean()) refuse("converged", "is neither true nor false");
    // Versions differ in what they have; what is there is a number, or null where it is not known.
    for (const CycleColumn& column : cycle_columns(experiment)) {
      const std::string key = name_with_unit(column.name, column.unit);
      if (!cycle.contains(key)) continue;
      if (!cycle[key].is_number() && !cycle[key].is_null()) refuse(key, "is no number");
    }
    if (!cycle.contains("max_force_N")) refuse("max_force_N", "is missing");
  }

  /// What a summary calls the coordinate of its loops.
  [[nodiscard]] static std::string loop_key(Experiment experiment) {
    return experiment == Experiment::strip ? "cycle" : "direction_deg";
  }

 private:
  const std::string& name_;
};

}  // namespace

StoredSummary read_summary(std::string_view text, const std::string& name) {
  const SummaryChecker checker(name);
  StoredSummary summary{checker.parse(text), {}, {}, {}};
  const Json& json = summary.json;
  if (!json.is_object() || !json.contains("schema")) checker.refuse("", "is no summary of this program");
  if (checker.text(json, "schema") != "bumpfoil-summary/1") {
    checker.refuse("schema",
                   fmt::format("is \"{}\", which this version cannot read", printable(checker.text(json, "schema"))));
  }
  for (const char* key : {"version", "commit", "solver", "status"}) static_cast<void>(checker.text(json, key));
  const std::string command = checker.text(json, "command");
  if (command != "cycle" && command != "strip") {
    checker.refuse("command", fmt::format("is \"{}\", whose results reports cannot show", printable(command)));
  }
  if (!checker.at(json, "case").is_object()) checker.refuse("case", "is no table");
  if (!checker.at(json["case"], command).is_object()) checker.refuse("case", "does not say what was run");
  if (!checker.at(json, "cycles").is_array()) checker.refuse("cycles", "is no list");
  for (const Json& cycle : json["cycles"]) checker.check_cycle(cycle, experiment_of(command));
  // Version 0.1 had none of them.
  if (json.contains("run_id") || json.contains("files") || json.contains("xxh3_128")) {
    summary.xxh3_128 = checker.text(json, "xxh3_128");
    summary.run_id = checker.text(json, "run_id");
    if (summary.run_id.empty()) checker.refuse("run_id", "is empty");
    summary.files = checker.files(json);
  }
  return summary;
}

void require_same_run(const StoredSummary& summary, const Json& result, const std::string& name) {
  const SummaryChecker checker(name);
  const auto require = [&](bool same, const std::string& key) {
    if (!same) checker.refuse(key, "is not that of result.nc beside it: they are of two runs, or damaged");
  };
  require(summary.json["command"] == result["kind"], "command");
  require(summary.run_id == result["attributes"].value("run_id", ""), "run_id");
  const std::string loop_key = SummaryChecker::loop_key(experiment_of(result["kind"].get<std::string>()));
  const Json& cycles = summary.json["cycles"];
  const Json& loops = result["loops"];
  require(cycles.size() <= loops.size(), "cycles");
  require(summary.json["status"] != "complete" || cycles.size() == loops.size(), "cycles");
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    require(cycles[i][loop_key] == loops[i]["at"], loop_key);
    // Out and back; a strip about a preload also to the other side and back.
    const Json& last = result["last_increment"];
    const auto steps = cycles[i]["steps"].get<double>();
    const bool strip = result["kind"] == "strip";
    require(2.0 * steps == last.get<double>() || (strip && 4.0 * steps == last.get<double>()), "steps");
  }
}

}  // namespace bumpfoil
