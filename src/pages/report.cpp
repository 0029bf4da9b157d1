#include "bumpfoil/pages/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "case/case_json.hpp"
#include "pages/ensemble_reader.hpp"
#include "pages/measured_run.hpp"
#include "pages/report_names.hpp"
#include "pages/result_reader.hpp"
#include "pages/shown_deviations.hpp"
#include "pages/shown_run.hpp"
#include "pages/shown_samples.hpp"
#include "readers/result_kinds.hpp"
#include "readers/stored_result.hpp"
#include "readers/summary_reader.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* folder_advice = "give the folder of a run, such as `bumpfoil cycle CASE -o DIR` writes";

/// Keys of the summary of result.nc or sweep.nc that a report shows.
constexpr std::array shown_of_summary{"schema", "command", "case", "version", "commit", "solver", "status"};
/// Also those of an ensemble, whose statistics are only in the summary.
constexpr std::array ensemble_summary_parts{"samples_due",   "samples", "statistics", "bump_loads",
                                            "sensitivities", "limits",  "yield"};

constexpr const char* advice_on_damage = "restore it from a backup or rerun; --unchecked reads what is readable";

/// Description of a variable in its file.
std::string meaning_of(const Json& result, const std::string& name) {
  const Json& variables = result.contains("meanings") ? result["meanings"] : result["variables"];
  return variables.contains(name) ? variables[name]["text"].get<std::string>() : "";
}

/// The case of a result; nothing for one of a version with other keys.
std::optional<Case> case_of(const Json& result) {
  try {
    return parse_case(result["attributes"].value("case_understood", ""), "");
  } catch (const Error&) {
    return {};
  }
}

/// A quantity as described in its file.
Json quantity_json(VariableMeaning meaning, const Json& result) {
  meaning.long_name = meaning_of(result, meaning.name);
  return shown_quantity(meaning);
}

/// Maximum number of rubs in a report; a rotor that rubs in every revolution has many.
constexpr std::size_t most_shown_rubs = 1000;

/// Table quantities of an experiment, and of its parts.
std::vector<VariableMeaning> meanings_in_tables(const ExperimentInfo& experiment) {
  std::vector<VariableMeaning> meanings = experiment.quantities;
  meanings.insert(meanings.end(), experiment.part_quantities.begin(), experiment.part_quantities.end());
  return meanings;
}

/// Those of the experiment of a result; a sweep has those of its command.
Json quantities_json(const Json& result, const std::optional<Case>& input) {
  const std::string command = result["attributes"].value("swept_command", result["kind"].get<std::string>());
  const auto found = std::find_if(experiments().begin(), experiments().end(),
                                  [&](const ExperimentInfo& experiment) { return experiment.name == command; });
  const ExperimentInfo& experiment = found == experiments().end() ? experiments().front() : *found;
  const bool of_cycles = has_cycles(experiment.name) || experiment.name == name_of(Experiment::path);
  Json json = Json::array();
  for (const VariableMeaning& meaning : meanings_in_tables(experiment)) {
    // For cycles, shows labelled quantities; for others, all in the result.
    if (of_cycles ? meaning.label.empty() : !result.at("variables").contains(meaning.name)) continue;
    // Quantities that vary over the width are explained if the result has them.
    if (of_cycles && (meaning.tags & tag::of_width_alone) != 0 && meaning_of(result, meaning.name).empty()) continue;
    json.push_back(quantity_json(of_cycles ? meaning : labelled(meaning), result));
  }
  const CycleSettings* const cycle = input ? input->settings.find<CycleSettings>() : nullptr;
  if (experiment.name == name_of(Experiment::cycle) && cycle != nullptr) add_clearances(cycle->clearance_forces, json);
  return json;
}

/// Quantities with aims or limits in an optimisation; for an ensemble, without the statistic.
Json optimised_quantities_json(const Json& summary) {
  Json json = Json::array();
  for (const char* list : {"aims", "limits"}) {
    for (const Json& one : summary[list]) {
      const auto name = one["quantity"].get<std::string>();
      VariableMeaning shown{name.substr(0, name.find('.')), one["unit"].get<std::string>(), ""};
      for (const ExperimentInfo& experiment : experiments()) {
        for (const VariableMeaning& meaning : meanings_in_tables(experiment)) {
          if (meaning.name == shown.name && shown.label.empty()) shown = meaning;
        }
      }
      json.push_back(shown_quantity(labelled(shown)));
    }
  }
  return json;
}

/// Fraction of the size of a report for the bearings of an ensemble: the page should stay small.
constexpr std::size_t part_of_samples = 4;

/// The quantities and the first samples of an ensemble.
/// @param name  of ensemble.nc in messages
Json ensemble_json(const Json& result, const std::string& name, std::size_t samples, std::size_t most_values) {
  const auto input = [&] {
    try {
      return parse_case(result["attributes"].value("case_understood", ""), name,
                        {.overrides = {}, .commands = {"montecarlo"}});
    } catch (const Error&) {
      refuse_damaged(name, "the case in it cannot be read", advice_on_damage);
    }
  }();
  Json quantities = Json::array();
  const EnsembleLayout layout = make_ensemble_layout(input);
  for (const EnsembleColumn& column : layout.columns) {
    if (column.meaning.shown.size > 0.0 && column.meaning.form.kind == Form::real)
      quantities.push_back(shown_quantity(labelled(column.meaning)));
  }
  Json json{{"quantities", quantities}, {"samples", Json::array()}};
  if (has_cycles(input.montecarlo->command)) {
    json["samples"] = run_shown_samples(input, std::min(samples, most_shown_samples), most_values / part_of_samples);
  } else {
    // Not run again, as this would take minutes.
    json["states"] = Json::array();
    for (const EnsemblePlace& place : layout.places) json["states"].push_back(place.name);
  }
  return json;
}

/// Deviations of the bearing of a result; null if it is round, for a strip, and where its case is not known.
Json deviations_json(const Json& result, const std::optional<Case>& input) {
  const Json& attributes = result["attributes"];
  for (const std::string& command : {result["kind"].get<std::string>(), attributes.value("swept_command", "")}) {
    if (command == name_of(Experiment::strip)) return nullptr;
  }
  return input ? shown_deviations(*input) : Json();
}

/// The part of a summary that a report shows.
Json summary_shown(const Json& summary, const std::string& kind) {
  if (has_cycles(kind) || has_parameters(kind) || has_points(kind)) return summary;
  Json shown = Json::object();
  for (const char* key : shown_of_summary) shown[key] = summary[key];
  if (has_states(kind) && summary.contains("limits")) shown["limits"] = summary["limits"];
  if (has_axes(kind)) shown["axes"] = summary["axes"];
  if (has_onsets(kind)) shown["onsets"] = summary["onsets"];
  if (has_peaks(kind)) {
    for (const char* key : {"stations", "peaks"}) shown[key] = summary[key];
  }
  if (has_revolutions(kind)) {
    for (const char* key : {"stations", "revolutions", "energy"}) shown[key] = summary[key];
    const Json& rubs = summary["rubs"];
    shown["rub_count"] = rubs.size();
    shown["rubs"] = Json::array();
    for (std::size_t i = 0; i < std::min(rubs.size(), most_shown_rubs); ++i) shown["rubs"].push_back(rubs[i]);
  }
  if (!has_distributions(kind)) return shown;
  for (const char* key : ensemble_summary_parts) {
    if (summary.contains(key)) shown[key] = summary[key];
  }
  return shown;
}

/// The data file in a folder: each command has one, most of them result.nc.
std::string result_name_in(const fs::path& folder) {
  std::error_code code;
  for (const std::string& name : result_names()) {
    if (name.ends_with(".nc") && fs::exists(published_file(folder, name), code)) return name;
  }
  return "result.nc";
}

/// Contents of a folder for the report. @throws Error (file)
Json read_run(const fs::path& folder, std::size_t most_values, const ReadingOptions& options) {
  const auto refuse = [&folder](std::string what) {
    throw Error(ErrorKind::file, {{folder.string(), 0, "", "", std::move(what), folder_advice}});
  };
  std::error_code code;
  if (!fs::exists(folder, code)) refuse("does not exist");
  if (!fs::is_directory(folder, code)) refuse("is not a folder");
  const std::string result_name = result_name_in(folder);
  const fs::path result_path = folder / result_name;
  auto [summary, bytes] = read_stored_result(folder, result_name, {options.checked, advice_on_damage});
  Json result = read_result(std::move(bytes), result_path.string(), most_values);
  match_runs(summary, result, (folder / "summary.json").string(), result_name);
  Json& attributes = result["attributes"];
  attributes.erase("history");  // duplicates the date and the command line
  attributes["command_line"] = without_machine_paths(attributes.value("command_line", ""));
  const auto kind = result["kind"].get<std::string>();
  Json run{{"summary", summary_shown(summary.json, kind)}};
  run.update(result);
  const std::optional<Case> input = case_of(result);
  if (Json deviations = deviations_json(result, input); !deviations.is_null())
    run["deviations"] = std::move(deviations);
  if (has_distributions(kind)) {
    run.update(ensemble_json(result, result_path.string(), summary.json["samples"].get<std::size_t>(), most_values));
  } else {
    run["quantities"] = has_points(kind) ? optimised_quantities_json(summary.json) : quantities_json(result, input);
  }
  return run;
}

}  // namespace

std::string report_json(const std::vector<fs::path>& folders, const ReadingOptions& options) {
  BUMPFOIL_ASSERT(!folders.empty());
  Json runs = Json::array();
  std::vector<InputError> errors;
  std::vector<fs::path> sources = folders;
  for (const MeasuredFile& file : options.measured) sources.push_back(file.path);
  const std::vector<std::string> names = names_of(sources);
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const fs::path& folder = folders[i];
    try {
      Json run{{"name", names[i]}};
      run.update(read_run(folder, std::max<std::size_t>(1, options.most_values / folders.size()), options));
      runs.push_back(std::move(run));
    } catch (const Error& error) {
      errors.insert(errors.end(), error.errors().begin(), error.errors().end());
    } catch (const std::bad_alloc&) {
      errors.push_back({folder.string(), 0, "", "", "needs more than the available memory", ""});
    }
  }
  if (!errors.empty()) throw Error(ErrorKind::file, std::move(errors));
  for (std::size_t i = 0; i < options.measured.size(); ++i) {
    runs.push_back(measured_run(options.measured[i], options.columns, names[folders.size() + i], runs, options.warn));
  }
  return dump_json({{"schema", "bumpfoil-report/1"},
                    {"version", version()},
                    {"commit", commit()},
                    {"keys", case_labels()},
                    {"runs", runs}},
                   -1);
}

std::string fill_report(std::string_view page, std::string_view json) {
  const std::size_t place = page.find(report_placeholder);
  BUMPFOIL_ASSERT(place != std::string_view::npos);
  BUMPFOIL_ASSERT(page.find(report_placeholder, place + 1) == std::string_view::npos);
  std::string out(page.substr(0, place));
  out.reserve(page.size() + json.size());
  for (const char letter : json) {
    // In JSON, this character only occurs in texts, where an escape is equivalent.
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
