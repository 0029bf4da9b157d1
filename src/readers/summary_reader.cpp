#include "readers/summary_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "readers/result_kinds.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Maximum nesting; summaries have five levels. JSON code may use stack for every level.
constexpr int most_levels = 16;

Experiment experiment_of(std::string_view command) {
  return command == "strip" ? Experiment::strip : Experiment::cycle;
}

/// Verifies the parts of a summary; every error names its key.
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
      refuse("", "cannot be read: it is not JSON");
    }
  }

  [[nodiscard]] const Json& at(const Json& object, const std::string& key) const {
    if (!object.is_object() || !object.contains(key)) refuse(key, "is missing");
    return object[key];
  }

  [[nodiscard]] std::string text(const Json& object, const std::string& key) const {
    const Json& value = at(object, key);
    if (!value.is_string()) refuse(key, "is not a string");
    return value.get<std::string>();
  }

  [[nodiscard]] std::map<std::string, ListedFile> files(const Json& summary) const {
    std::map<std::string, ListedFile> files;
    const Json& listed = at(summary, "files");
    if (!listed.is_object()) refuse("files", "is not a table");
    for (const auto& [name, file] : listed.items()) {
      if (!at(file, "bytes").is_number_unsigned()) refuse("files", "has a size that is not an integer");
      files[name] = {file["bytes"].get<std::size_t>(), text(file, "xxh3_128")};
    }
    return files;
  }

  void check_cycle(const Json& cycle, Experiment experiment) const {
    const std::string place_key(cycle_key(experiment));
    if (!at(cycle, place_key).is_number()) refuse(place_key, "is not a number");
    for (const char* key : {"amplitude_m", "steps", "converged", "max_force_N"}) static_cast<void>(at(cycle, key));
    // Versions have different additional keys; unknown numbers are null.
    for (const CycleQuantity& quantity : cycle_quantities(experiment, true)) {
      const std::string key = key_of(quantity.name, quantity.unit);
      if (cycle.contains(key)) check_value(key, cycle[key], quantity.form);
    }
    for (const char* key : {"clearances", "warnings", "loop_energies_J"}) {
      if (cycle.contains(key) && !cycle[key].is_array()) refuse(key, "is not a list");
    }
    for (const auto& [key, value] : cycle.items()) {
      if (key.starts_with("clearance_")) check_value(key, value, {});
    }
    for (const Json& clearance : cycle.value("clearances", Json::array())) {
      if (!at(clearance, "force_N").is_number()) refuse("clearances", "has a force that is not a number");
    }
    // Known for every cycle that exists.
    if (cycle["steps"].is_null()) refuse("steps", "is not an integer");
    if (cycle["converged"].is_null()) refuse("converged", "is neither true nor false");
  }

  /// Statistics by direction, and the number of samples within which limits.
  void check_ensemble(const Json& summary) const {
    for (const char* key : {"samples", "samples_due"}) {
      if (!at(summary, key).is_number_unsigned()) refuse(key, "is not an integer");
    }
    for (const char* key : {"statistics", "bump_loads", "sensitivities"}) {
      const Json& directions = at(summary, key);
      const bool tables =
          directions.is_object() && std::all_of(directions.begin(), directions.end(), [](const Json& one) {
            return std::all_of(one.begin(), one.end(), [](const Json& part) { return part.is_structured(); });
          });
      if (!tables) refuse(key, "is not a table by direction or state");
    }
    if (!at(summary, "limits").is_array()) refuse("limits", "is not a list");
    for (const Json& limit : summary["limits"]) {
      static_cast<void>(text(limit, "limit"));
      check_yield(limit);
    }
    if (summary.contains("yield")) check_yield(summary["yield"]);
  }

  /// Lift-off speeds and load capacities, each between two points.
  void check_running_limits(const Json& limits) const {
    if (!limits.is_array()) refuse("limits", "is not a list");
    for (const Json& limit : limits) {
      for (const char* key : {"kind", "status"}) static_cast<void>(text(limit, key));
      for (const char* side : {"thick", "thin"}) {
        for (const char* key : {"speed_rad_per_s", "load_x_N", "load_y_N"}) {
          if (!at(at(limit, side), key).is_number()) refuse(key, "is not a number");
        }
      }
      // Absent in earlier versions.
      if (!limit.contains("unstable")) continue;
      if (!at(limit, "bounded_by").is_null()) static_cast<void>(text(limit, "bounded_by"));
      if (!limit["unstable"].is_array()) refuse("unstable", "is not a list");
      const std::string unit = limit["kind"] == "lift_off_speed" ? "speed_rad_per_s" : "load_N";
      for (const Json& range : limit["unstable"]) {
        for (const std::string& key : {"from_" + unit, "to_" + unit}) {
          if (!at(range, key).is_number()) refuse(key, "is not a number");
        }
      }
    }
  }

  /// Onsets and ends of whirl.
  void check_onsets(const Json& onsets) const {
    if (!onsets.is_array()) refuse("onsets", "is not a list");
    for (const Json& onset : onsets) {
      for (const char* key : {"speed_rad_per_s", "whirl_ratio"}) {
        if (!at(onset, key).is_number()) refuse(key, "is not a number");
      }
      static_cast<void>(text(onset, "contacts"));
      for (const char* key : {"by_coefficients", "begins", "of_foils", "jumps"}) {
        if (!at(onset, key).is_boolean()) refuse(key, "is neither true nor false");
      }
    }
  }

  /// Keys of a sweep, with the names of their variables.
  void check_axes(const Json& summary) const {
    if (!at(summary, "axes").is_array()) refuse("axes", "is not a list");
    for (const Json& axis : summary["axes"]) {
      for (const char* key : {"key", "name"}) static_cast<void>(text(axis, key));
    }
  }

  /// Names of the stations of a rotor.
  void check_stations(const Json& summary) const {
    const auto is_text = [](const Json& one) { return one.is_string(); };
    const Json& stations = at(summary, "stations");
    if (!stations.is_array() || !std::all_of(stations.begin(), stations.end(), is_text)) {
      refuse("stations", "is not a list of names");
    }
  }

  /// Maxima of the unbalance response of a rotor.
  void check_peaks(const Json& summary) const {
    if (!at(summary, "peaks").is_array()) refuse("peaks", "is not a list");
    for (const Json& peak : summary["peaks"]) {
      for (const char* key : {"kind", "station"}) static_cast<void>(text(peak, key));
      for (const char* key : {"speed_rad_per_s", "semi_major_m"}) {
        if (!at(peak, key).is_number()) refuse(key, "is not a number");
      }
    }
  }

  /// Best values of parameters; unknown ones are null.
  void check_parameters(const Json& summary) const {
    for (const char* key : {"reduced_chi_square", "degrees_of_freedom", "collinearity"}) {
      check_value(key, at(summary, key), {});
    }
    if (!at(summary, "parameters").is_array()) refuse("parameters", "is not a list");
    for (const Json& parameter : summary["parameters"]) {
      for (const char* key : {"key", "unit"}) static_cast<void>(text(parameter, key));
      if (!at(parameter, "at_bound").is_boolean()) refuse("at_bound", "is neither true nor false");
      for (const char* key : {"start", "fitted_value", "standard_error", "lower_95", "upper_95"}) {
        check_value(key, at(parameter, key), {});
      }
      if (!at(parameter, "correlations").is_array()) refuse("correlations", "is not a list");
      for (const Json& one : parameter["correlations"]) check_value("correlations", one, {});
      if (!parameter.contains("profile")) continue;
      if (!parameter["profile"].is_array()) refuse("profile", "is not a list");
      for (const Json& point : parameter["profile"]) {
        for (const char* key : {"profile_value", "profile_cost"}) check_value(key, at(point, key), {});
      }
    }
  }

  /// Keys, aims and limits of an optimisation, and values of the best point; null if there is none.
  void check_points(const Json& summary) const {
    static_cast<void>(text(summary, "ended_by"));
    const auto& count = at(summary, "point_count");
    if (!count.is_number_unsigned()) refuse("point_count", "is not an integer");
    const auto check_number = [&](const Json& number, const char* key) {
      if (!number.is_number_unsigned() || number >= count) refuse(key, "is not the number of a point");
    };
    if (!at(summary, "best_point").is_null()) check_number(summary["best_point"], "best_point");
    for (const char* list : {"keys", "aims", "limits", "front"}) {
      if (!at(summary, list).is_array()) refuse(list, "is not a list");
    }
    for (const Json& number : summary["front"]) check_number(number, "front");
    const auto check_values = [this](const Json& one, const std::string& name,
                                     std::initializer_list<const char*> keys) {
      for (const std::string& key : {name, std::string("unit")}) static_cast<void>(text(one, key));
      for (const char* key : keys) check_value(key, at(one, key), {});
    };
    for (const Json& one : summary["keys"]) {
      check_values(one, "key", {"lower_bound", "upper_bound", "start", "best_value"});
      if (!at(one, "active_bound").is_null()) static_cast<void>(text(one, "active_bound"));
    }
    for (const Json& one : summary["aims"]) {
      check_values(one, "quantity", {"best_value"});
      if (!at(one, "maximise").is_boolean()) refuse("maximise", "is neither true nor false");
    }
    for (const Json& one : summary["limits"]) {
      check_values(one, "limit", {"value", "margin"});
      static_cast<void>(text(one, "quantity"));
      if (!at(one, "active").is_null() && !one["active"].is_boolean()) refuse("active", "is neither true nor false");
    }
  }

  /// The energy balance of a run in time, and the rubs of its journals.
  void check_revolutions(const Json& summary) const {
    if (!at(summary, "revolutions").is_number_unsigned()) refuse("revolutions", "is not an integer");
    const Json& energy = at(summary, "energy");
    if (!energy.is_object()) refuse("energy", "is not a table");
    for (const auto& [key, value] : energy.items()) {
      if (!value.is_number()) refuse(key, "is not a number");
    }
    if (!at(summary, "rubs").is_array()) refuse("rubs", "is not a list");
    for (const Json& rub : summary["rubs"]) {
      if (!at(rub, "bearing").is_number_unsigned()) refuse("bearing", "is not an integer");
      for (const char* key : {"begin_s", "end_s", "asperity_load_N"}) {
        if (!at(rub, key).is_number()) refuse(key, "is not a number");
      }
    }
  }

 private:
  void check_yield(const Json& yield) const {
    for (const char* key : {"passed", "samples"}) {
      if (!at(yield, key).is_number_unsigned()) refuse(key, "is not an integer");
    }
    const Json& interval = at(yield, "interval_95");
    if (!interval.is_array() || interval.size() != 2) refuse("interval_95", "is not an interval");
  }

  void check_value(const std::string& key, const Json& value, const Form& form) const {
    if (value.is_null()) return;
    switch (form.kind) {
      case Form::real:
        if (!value.is_number()) refuse(key, "is not a number");
        break;
      case Form::whole:
        if (!value.is_number_integer()) refuse(key, "is not an integer");
        break;
      case Form::truth:
        if (!value.is_boolean()) refuse(key, "is neither true nor false");
        break;
      case Form::flag:
        if (!value.is_string() ||
            std::find(form.words.begin(), form.words.end(), value.get<std::string>()) == form.words.end()) {
          refuse(key, fmt::format("is not one of {}", fmt::join(form.words, ", ")));
        }
        break;
    }
  }

  const std::string& name_;
};

}  // namespace

StoredSummary read_summary(std::string_view text, const std::string& name) {
  const SummaryChecker checker(name);
  StoredSummary summary{checker.parse(text), {}, {}, {}};
  const Json& json = summary.json;
  if (!json.is_object() || !json.contains("schema")) checker.refuse("", "is not a summary of this program");
  const std::string schema = checker.text(json, "schema");
  if (schema != "bumpfoil-summary/2") {
    checker.refuse("schema", fmt::format("is \"{}\", which this version cannot read: use the one that wrote it",
                                         printable(schema)));
  }
  for (const char* key : {"version", "commit", "solver", "status"}) static_cast<void>(checker.text(json, key));
  const std::string command = checker.text(json, "command");
  if (!is_known(command)) {
    checker.refuse("command", fmt::format("is \"{}\", a command that this version does not have", printable(command)));
  }
  if (!checker.at(json, "case").is_object()) checker.refuse("case", "is not a table");
  if (has_cycles(command)) {
    if (!checker.at(json["case"], command).is_object()) checker.refuse("case", "does not name its command");
    if (!checker.at(json, "cycles").is_array()) checker.refuse("cycles", "is not a list");
    for (const Json& cycle : json["cycles"]) checker.check_cycle(cycle, experiment_of(command));
  }
  if (has_distributions(command)) checker.check_ensemble(json);
  if (has_states(command) && json.contains("limits")) checker.check_running_limits(json["limits"]);
  if (has_axes(command)) checker.check_axes(json);
  if (has_onsets(command)) checker.check_onsets(checker.at(json, "onsets"));
  if (has_peaks(command) || has_revolutions(command)) checker.check_stations(json);
  if (has_peaks(command)) checker.check_peaks(json);
  if (has_revolutions(command)) checker.check_revolutions(json);
  if (has_parameters(command)) checker.check_parameters(json);
  if (has_points(command)) checker.check_points(json);
  summary.xxh3_128 = checker.text(json, "xxh3_128");
  summary.run_id = checker.text(json, "run_id");
  if (summary.run_id.empty()) checker.refuse("run_id", "is empty");
  summary.files = checker.files(json);
  return summary;
}

void match_runs(const StoredSummary& summary, Json& result, const std::string& name, std::string_view result_name) {
  const SummaryChecker checker(name);
  const auto require = [&](bool same, const std::string& key) {
    if (!same) {
      checker.refuse(key, fmt::format("differs from that of {} in the same folder: they are of two runs, or damaged",
                                      result_name));
    }
  };
  require(summary.json["command"] == result["kind"], "command");
  require(summary.run_id == result["attributes"].value("run_id", ""), "run_id");
  const auto kind = result["kind"].get<std::string>();
  if (has_distributions(kind)) {
    require(summary.json["statistics"].size() == result["directions"].size() + result["states"].size(), "statistics");
    require(summary.json["samples"] == result["sample_count"], "samples");
  }
  if (!has_cycles(kind)) return;
  const std::string place_key(cycle_key(experiment_of(kind)));
  const Json& cycles = summary.json["cycles"];
  Json& stored = result["cycles"];
  require(cycles.size() <= stored.size(), "cycles");
  require(summary.json["status"] != "complete" || cycles.size() == stored.size(), "cycles");
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    // Directions are sorted in result.nc, but in the order of the case here.
    const auto first = stored.begin() + static_cast<std::ptrdiff_t>(i);
    const auto same =
        std::find_if(first, stored.end(), [&](const Json& one) { return one["at"] == cycles[i][place_key]; });
    require(same != stored.end(), place_key);
    std::rotate(first, same, same + 1);
    // Loading and unloading; fully reversed cycles also on the other side.
    const Json& last = result["last_increment"];
    const auto steps = cycles[i]["steps"].get<double>();
    require(2.0 * steps == last.get<double>() || 4.0 * steps == last.get<double>(), "steps");
  }
}

}  // namespace bumpfoil
