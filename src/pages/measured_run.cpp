#include "pages/measured_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/measured_loop.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/base64.hpp"
#include "experiments/cycle/measured_loops_csv.hpp"
#include "pages/shown_run.hpp"
#include "readers/result_kinds.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& path, std::string what, std::string advice) {
  throw Error(ErrorKind::input, {{path, 0, "", "", std::move(what), std::move(advice)}});
}

Json increments_json(const Cycle& cycle, double at) {
  const std::vector<Increment>& increments = cycle.increments;
  std::vector<std::size_t> numbers(increments.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto series = [&increments](double Increment::*member) {
    std::vector<double> values;
    values.reserve(increments.size());
    for (const Increment& increment : increments) values.push_back(increment.*member);
    return base64_of(values);
  };
  std::vector<signed char> branches;
  branches.reserve(increments.size());
  for (const Increment& increment : increments) branches.push_back(static_cast<signed char>(increment.branch));
  return {{"at", at},
          {"increments", numbers},
          {"series",
           {{"branch", base64_of(branches)},
            {"displacement", series(&Increment::displacement)},
            {"force_direct", series(&Increment::force_direct)},
            {"work", series(&Increment::work)}}},
          {"fields", Json::object()}};
}

Json summary_of(const Cycle& cycle, double at, Experiment experiment, const std::vector<double>& clearance_forces) {
  Json json{{"at", at}, {"steps", cycle.steps}, {"amplitude_m", cycle.amplitude}, {"converged", true}};
  static const Case unknown;
  for (const CycleQuantity& quantity : cycle_quantities(experiment)) {
    if (quantity.is(tag::measured)) {
      json[quantity.key()] = value_json(quantity.value(cycle, unknown), quantity.form);
    }
  }
  const std::vector<VariableMeaning> clearances = clearance_quantities(clearance_forces);
  for (std::size_t i = 0; i < clearances.size(); ++i) json[clearances[i].key()] = value_json(clearance_of(cycle, i));
  return json;
}

std::string cycle_name(double at, bool strip) {
  return strip ? fmt::format("{}", at) : direction_name(at * std::numbers::pi / 180.0);
}

/// Remarks on a loop, a sentence each.
std::vector<std::string> remarks_on(const LastCycle& loop) {
  std::vector<std::string> remarks;
  if (loop.found > 1) remarks.push_back(fmt::format("{} cycles found, the last is used", loop.found));
  if (loop.rest) remarks.emplace_back("continues after its last complete cycle; the rest is ignored");
  if (loop.gap) {
    remarks.push_back(
        fmt::format("does not close: it ends {:.3g} um and {:.3g} N from its start; a straight line closes it",
                    1e6 * std::abs(loop.gap->displacement), std::abs(loop.gap->force)));
  }
  return remarks;
}

/// The cycle to which a loop belongs.
double cycle_of(const std::string& path, const MeasuredLoop& loop, const std::vector<double>& cycles, bool strip) {
  const std::string_view column = strip ? "cycle" : "direction";
  std::vector<std::string> names;
  names.reserve(cycles.size());
  for (const double at : cycles) names.push_back(cycle_name(at, strip));
  if (!loop.at) {
    if (cycles.size() == 1) return cycles.front();
    refuse(path, fmt::format("does not give the {} of its loop", column),
           fmt::format("add a column {0}, or name it after the file, FILE:{1}: the results have {2}", column,
                       names.front(), fmt::join(names, ", ")));
  }
  // Directions are equal modulo a full turn.
  const auto same = [&loop, strip](double at) {
    const double turns = (*loop.at - at) / 360.0;
    return at == *loop.at || (!strip && std::abs(turns - std::round(turns)) < 1e-9);
  };
  const auto found = std::find_if(cycles.begin(), cycles.end(), same);
  if (found == cycles.end()) {
    refuse(path, fmt::format("has a loop of the {} {}, which the results do not have", column, *loop.at),
           fmt::format("they have {}", fmt::join(names, ", ")));
  }
  return *found;
}

}  // namespace

Json measured_run(const MeasuredFile& file, const std::string& columns, const std::string& name, const Json& runs,
                  const std::function<void(const std::string&)>& warn) {
  const std::string path = file.path.string();
  const auto like = std::find_if(runs.begin(), runs.end(),
                                 [](const Json& run) { return has_cycles(run["kind"].get<std::string>()); });
  if (like == runs.end()) {
    refuse(path, "cannot be compared with results that have no loops", "give the folder of a cycle or a strip");
  }
  const auto kind = (*like)["kind"].get<std::string>();
  const bool strip = kind == name_of(Experiment::strip);
  std::vector<double> cycles;  // in the order of the runs
  for (const Json& run : runs) {
    if (run["kind"] != kind) continue;
    for (const Json& cycle : run["cycles"]) {
      const auto at = cycle["at"].get<double>();
      if (std::find(cycles.begin(), cycles.end(), at) == cycles.end()) cycles.push_back(at);
    }
  }
  std::vector<double> clearance_forces;
  for (const Json& cycle : (*like)["summary"]["cycles"]) {
    if (!clearance_forces.empty() || !cycle.contains("clearances")) continue;
    for (const Json& clearance : cycle["clearances"]) clearance_forces.push_back(clearance["force_N"].get<double>());
  }

  Json quantities = Json::array();
  for (const CycleQuantity& quantity : cycle_quantities(strip ? Experiment::strip : Experiment::cycle)) {
    if (!quantity.is(tag::measured)) continue;
    for (const Json& shown : (*like)["quantities"]) {
      if (shown["name"] == quantity.name) quantities.push_back(shown);
    }
  }
  add_clearances(clearance_forces, quantities);
  std::size_t most = 0;
  Json loops = Json::array();
  Json summaries = Json::array();
  for (const MeasuredLoop& loop :
       read_measured_loops(path, strip ? "cycle" : "direction", parse_measured_columns(columns), file.at)) {
    const double at = cycle_of(path, loop, cycles, strip);
    const Cycle cycle = measured_cycle(loop.cycle.points, clearance_forces);
    most = std::max(most, cycle.increments.size());
    loops.push_back(increments_json(cycle, at));
    summaries.push_back(summary_of(cycle, at, strip ? Experiment::strip : Experiment::cycle, clearance_forces));
    summaries.back()["warnings"] = remarks_on(loop.cycle);
    for (const std::string& remark : remarks_on(loop.cycle)) {
      if (warn) warn(fmt::format("{}: {}: {}", printable(path, longest_path), cycle_name(at, strip), remark));
    }
  }
  return {{"name", name},
          {"kind", kind},
          {"measured", true},
          {"attributes", Json::object()},
          {"summary",
           {{"case", Json::object()},
            {"version", ""},
            {"commit", ""},
            {"solver", ""},
            {"status", "complete"},
            {"cycles", summaries}}},
          {"quantities", quantities},
          {"meanings", (*like)["meanings"]},
          {"geometry", Json::object()},
          {"nodes", {{"bump", 0}, {"foot", 0}}},
          {"last_increment", most - 1},
          {"cycles", loops}};
}

}  // namespace bumpfoil
