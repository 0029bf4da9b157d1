#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "bumpfoil/experiments/vibration/vibration_settings.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "case/case_keys.hpp"
#include "case/key_list.hpp"
#include "experiments/cycle/measured_loops_csv.hpp"
#include "experiments/fit/fit_columns.hpp"
#include "experiments/fit/fit_keys.hpp"
#include "experiments/fit/measured_table_csv.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

constexpr int most_fit_points = 10'000;
constexpr int most_starts = 100;
constexpr int fewest_readings = 8;

bool is_of_strip(const FitData& data) {
  return data.experiment == FittedExperiment::strip;
}

/// The loop of a file in this direction; for a strip the last.
void take_loop(FitData& data, const std::string& path) {
  const bool strip = is_of_strip(data);
  const std::vector<MeasuredLoop> loops =
      read_measured_loops(path, strip ? "cycle" : "direction", parse_measured_columns(data.columns, "columns"));
  const auto is_wanted = [&data, strip](const MeasuredLoop& loop) {
    const double turns = loop.at ? (*loop.at - data.direction * 180.0 / std::numbers::pi) / 360.0 : 0.0;
    return strip || std::abs(turns - std::round(turns)) < 1e-9;
  };
  const auto found = std::find_if(loops.rbegin(), loops.rend(), is_wanted);
  if (found == loops.rend()) {
    throw Error(ErrorKind::input, {{path, 0, "", "", "has no loop of the direction of its data",
                                    "give a direction that is in the file"}});
  }
  for (const LoadingCurve::Point& point : found->cycle.points) {
    data.displacements.push_back(point.displacement);
    data.forces.push_back(point.force);
  }
}

Key key_of_readings(const FitColumnInfo& info) {
  return {.name = info.name(),
          .presence = Presence::optional,
          .title = info.title,
          .text = info.text,
          .example = info.example,
          .dimension = info.dimension};
}

Key key_of_std(const FitColumnInfo& info) {
  return {.name = info.std_key,
          .presence = Presence::optional,
          .title = info.std_title,
          .text = "standard deviation of one reading; with it, the column is fitted",
          .example = info.std_example,
          .dimension = info.dimension};
}

void describe(CaseVisitor& keys, FitData& data) {
  using enum Presence;
  using enum Dimension;
  keys.choice({"experiment", defaulted, "Experiment",
               "what was measured: \"cycle\", the journal pushed and pulled back; \"strip\", a strip between plates; "
               "\"vibration\", stiffness and loss factor over amplitude; \"equilibrium\", the running bearing over "
               "speed and load"},
              data.experiment);
  keys.value({"direction", defaulted, "Direction",
              "of a cycle, or of vibrations without a column of it, from X towards Y", "0 deg", angle},
             &data.direction);
  keys.either({"preload", optional, "Preload",
               "load or position of the journal that the cycle goes about, by default that of [cycle]; static load of "
               "vibrations without a column of it, by default the first of [vibration]",
               "[\"0 N\", \"-50 N\"]"},
              Control::displacement, data.preload);
  keys.choice({"contacts", defaulted, "Contacts", "of an equilibrium, in its stiffness and damping; or \"stuck\""},
              data.contacts);
  keys.value({"columns", defaulted, "Columns", "names of columns that are not understood: displacement=NAME,force=NAME",
              "\"displacement=Channel 3 [mm],force=Channel 4 [N]\""},
             &data.columns);
  for (const FitColumnInfo& info : fit_columns()) {
    if (info.measured) keys.value(key_of_std(info), &data.column(info.column).std);
  }
  keys.file(
      {"file", optional, "File of the readings",
       "a CSV file beside this one: a loop as for `report --measured`, or a table with a column for each quantity",
       "\"loop.csv\""},
      data.is_loop() ? "displacements" : "readings",
      [&data](const std::string& path) { data.is_loop() ? take_loop(data, path) : read_measured_table(path, data); });
  keys.value({"displacements", optional, "Displacements",
              "of a loop, the same as a list, of one cycle in the order of measurement",
              "[\"0 um\", \"40 um\", \"80 um\", \"40 um\", \"0 um\"]", length},
             &data.displacements);
  keys.value({"forces", optional, "Forces", "as many", "[\"0 N\", \"80 N\", \"700 N\", \"30 N\", \"0 N\"]", force},
             &data.forces);
  keys.value({"force_std", optional, "Noise of the force",
              "standard deviation of one reading; by default from the scatter of neighbouring readings", "1 N", force},
             &data.force_std);
  keys.value(
      {"displacement_std", defaulted, "Noise of the displacement", "standard deviation of one reading", "0 um", length},
      &data.displacement_std);
  keys.value({"points", defaulted, "Points", "of equal arc length along the loop at which it is compared"},
             &data.points);
  keys.value(
      {"displacement_origin", defaulted, "Origin of the displacement", "reading of the rig at s = 0", "0 um", length},
      &data.rig.displacement_origin);
  keys.value({"force_origin", defaulted, "Origin of the force", "reading of the rig without a force", "0 N", force},
             &data.rig.force_origin);
  keys.value({"displacement_drift", defaulted, "Drift of the displacement", "from the start of the loop to its end",
              "0 um", length},
             &data.rig.displacement_drift);
  keys.value({"force_drift", defaulted, "Drift of the force", "from the start of the loop to its end", "0 N", force},
             &data.rig.force_drift);
  keys.value({"x_origin", defaulted, "Origin of the position, X", "of an equilibrium: reading of the rig at the centre",
              "0 um", length},
             &data.rig.x_origin);
  keys.value({"y_origin", defaulted, "Origin of the position, Y", "the same", "0 um", length}, &data.rig.y_origin);
  keys.value(
      {"torque_origin", defaulted, "Origin of the torque", "reading of the rig without a torque", "0 N mm", moment},
      &data.rig.torque_origin);
  keys.value(
      {"machine_stiffness", optional, "Stiffness of the machine",
       "in series with the foils of a loop or a vibration, in place of fit.machine_stiffness", "50 MN/m", stiffness},
      &data.rig.machine_stiffness);
  const bool given = std::any_of(data.table.begin(), data.table.end(),
                                 [](const FitReadings& readings) { return !readings.values.empty(); });
  keys.table({"readings", optional, "Readings",
              "of vibrations or an equilibrium, as lists instead of a file: operating points and measured values"},
             given, [&data](CaseVisitor& inner) {
               for (const FitColumnInfo& info : fit_columns()) {
                 inner.value(key_of_readings(info), &data.column(info.column).values);
               }
             });
}

void describe(CaseVisitor& keys, FitParameter& parameter) {
  using enum Presence;
  keys.value({"key", required, "Key", "a numeric key of the case, or of the rig such as fit.data[1].force_origin",
              "\"friction.coefficient\""},
             &parameter.key);
  const auto of_key = [&parameter](auto... rest) { return key_in_unit_of(parameter.key, rest...); };
  keys.value(of_key("start", required, "Start", "with the unit of the key", "0.1"), &parameter.start);
  keys.value(of_key("lower", required, "Lower bound", "", "0.0"), &parameter.lower);
  keys.value(of_key("upper", required, "Upper bound", "", "0.5"), &parameter.upper);
  keys.value(of_key("mean", optional, "Prior mean", "prior mean; needs std", "0.1"), &parameter.mean);
  keys.value(of_key("std", optional, "Prior standard deviation", "", "0.05"), &parameter.std);
}

void describe(CaseVisitor& keys, FitSettings& fit) {
  using enum Presence;
  keys.value({"machine_stiffness", optional, "Stiffness of the machine",
              "in series with the foils; without it, the rig is rigid", "50 MN/m", Dimension::stiffness},
             &fit.machine_stiffness);
  keys.value({"starts", defaulted, "Starts", "number of minimisations, the first from the starts of the parameters"},
             &fit.starts);
  keys.value({"huber", optional, "Huber's constant",
              "residuals beyond this number of standard deviations count linearly, not squared", "1.345"},
             &fit.huber);
  keys.value({"profile", defaulted, "Profiles",
              "true: also compute profiles, the rise of the sum of squares with a parameter held near its best value "
              "and the others fitted again; takes many times as long as the fit"},
             &fit.profile);
  list_of_tables(keys, {"data", required, "Measured data", "one for each loop or table"}, fit.data,
                 [](CaseVisitor& inner, FitData& data) { describe(inner, data); });
  list_of_tables(keys, {"parameter", required, "Parameter", "one for each key that is fitted"}, fit.parameters,
                 [](CaseVisitor& inner, FitParameter& parameter) { describe(inner, parameter); });
}

void describe_fit(CaseVisitor& keys, Case& input) {
  settings_table<FitSettings>(
      keys, {"fit", Presence::optional, "Fit", "of keys of the case to measured loops and tables, for the command fit"},
      input.settings, describe);
}

/// Checks a list; reports the first value that is not finite.
bool check_finite(Checks& checks, const std::vector<double>& values, const std::string& key, std::string_view unit) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!checks.finite(fmt::format("{}[{}]", key, i + 1), values[i], unit)) return false;
  }
  return true;
}

void check_loop(Checks& checks, const FitData& data, const std::string& key) {
  const bool finite = check_finite(checks, data.displacements, key + ".displacements", "m") &&
                      check_finite(checks, data.forces, key + ".forces", "N");
  if (!finite) return;
  checks.require_for("fit", data.displacements.size() == data.forces.size(), key + ".forces",
                     std::to_string(data.forces.size()),
                     fmt::format("are not as many as displacements, {}", data.displacements.size()),
                     "give a force for every displacement");
  checks.require_for("fit", std::ssize(data.displacements) >= fewest_readings, key + ".displacements", "",
                     fmt::format("{} readings are too few", data.displacements.size()),
                     fmt::format("give a file, or {} or more readings", fewest_readings));
  const auto top = std::max_element(data.displacements.begin(), data.displacements.end());
  const bool turns = data.displacements.empty() ||
                     (*top > 0.0 && top != data.displacements.begin() && top + 1 != data.displacements.end());
  checks.require_for("fit", turns, key + ".displacements", "", "do not go to a positive displacement and back",
                     "give one cycle in the order of measurement, positive towards the foils");
  const bool same =
      std::adjacent_find(data.forces.begin(), data.forces.end(), std::not_equal_to<>()) == data.forces.end();
  checks.require_for("fit", data.forces.empty() || !same, key + ".forces", "", "are all the same",
                     "give the forces that the rig measured");
}

/// Checks the readings of one column; all columns have the same length.
void check_column(Checks& checks, const FitData& data, const FitColumnInfo& info, const std::string& key) {
  const FitReadings& readings = data.column(info.column);
  const std::string place = fmt::format("{}.readings.{}", key, info.name());
  const bool own = info.is_of(data.experiment);
  checks.require_for("fit", readings.values.empty() || own, place, "",
                     fmt::format("do not apply to data of the experiment \"{}\"", name_of(data.experiment)),
                     "remove them");
  check_finite(checks, readings.values, place, info.unit());
  if (info.measured) {
    const std::string std_place = fmt::format("{}.{}", key, info.std_key);
    if (!checks.require_for("fit", !readings.std || own, std_place, quantity(readings.std.value_or(0.0), info.unit()),
                            fmt::format("does not apply to data of the experiment \"{}\"", name_of(data.experiment)),
                            "remove it")) {
      return;
    }
    checks.require_for("fit", !readings.std || *readings.std > 0.0, std_place,
                       quantity(readings.std.value_or(0.0), info.unit()), "must be positive",
                       "give the standard deviation of one reading");
    checks.require_for("fit", !readings.std || !readings.values.empty(), std_place,
                       quantity(readings.std.value_or(0.0), info.unit()), "applies to a column without readings",
                       fmt::format("give readings.{}, or remove it", info.name()));
  }
  checks.require_for("fit", readings.values.empty() || !own || readings.values.size() == rows_of(data), place,
                     std::to_string(readings.values.size()),
                     fmt::format("are not as many as the rows, {}", rows_of(data)), "give one for every row");
}

void check_table(Checks& checks, const Case& input, const FitData& data, const std::string& key) {
  const bool vibration = data.experiment == FittedExperiment::vibration;
  const FitColumn first = vibration ? FitColumn::amplitude : FitColumn::speed;
  if (!checks.require_for("fit", rows_of(data) > 0, fmt::format("{}.readings.{}", key, name_of(first)), "",
                          "is missing", "give a file, or readings")) {
    return;
  }
  for (const FitColumnInfo& info : fit_columns()) check_column(checks, data, info, key);
  checks.require_for("fit", !fitted_columns(data).empty(), key + (vibration ? ".stiffness_std" : ".h_min_std"), "",
                     "is missing: a column is fitted only if its standard deviation is given",
                     "give one of them or more");
  const auto all_within = [&](FitColumn column, const Range& range) {
    for (const double value : data.column(column).values) {
      if (!checks.within(fmt::format("{}.readings.{}", key, name_of(column)), std::abs(value), range)) return;
    }
  };
  all_within(FitColumn::amplitude, length_range);
  all_within(FitColumn::speed, frequency_range);
  all_within(FitColumn::frequency, frequency_range);
  const bool any_load =
      !data.column(FitColumn::load_x).values.empty() || !data.column(FitColumn::load_y).values.empty();
  if (vibration && !any_load) {
    const VibrationSettings* const of_case = input.settings.find<VibrationSettings>();
    checks.require_for("fit",
                       (data.preload && data.preload->control == Control::load) ||
                           (!data.preload && of_case != nullptr && !of_case->loads.empty()),
                       key + ".preload", "", "is not a load about which the journal can vibrate",
                       "give a load, or readings.load_x and readings.load_y");
  }
  checks.require_for("fit", vibration || any_load, key + ".readings.load_x", "", "is missing",
                     "give the static load along X, Y or both");
}

/// Rig errors that do not apply to this kind of data.
void check_rig(Checks& checks, const FitData& data, const std::string& key) {
  const auto own = rig_keys_of(data.experiment);
  const auto require_effect = [&](bool given, std::string_view name) {
    const bool effect = std::find(own.begin(), own.end(), name) != own.end();
    checks.require_for("fit", !given || effect, fmt::format("{}.{}", key, name), "",
                       fmt::format("has no effect on data of the experiment \"{}\"", name_of(data.experiment)),
                       fmt::format("remove it; these have: {}", fmt::join(own, ", ")));
  };
  for (const auto& [name, member] : rig_numbers()) {
    checks.finite(fmt::format("{}.{}", key, name), data.rig.*member, "");
    require_effect(data.rig.*member != 0.0, name);
  }
  require_effect(data.rig.machine_stiffness.has_value(), "machine_stiffness");
  if (data.rig.machine_stiffness) {
    checks.within(key + ".machine_stiffness", *data.rig.machine_stiffness, stiffness_range);
  }
}

void check_data(Checks& checks, const Case& input, const FitData& data, const std::string& key) {
  checks.require_for("fit", is_of_strip(data) || !input.bearing.is_flat(), key + ".experiment",
                     std::string(name_of(data.experiment)), "needs a bearing with a radius",
                     "give bearing.radius and bearing.radial_clearance");
  data.is_loop() ? check_loop(checks, data, key) : check_table(checks, input, data, key);
  checks.angle(key + ".direction", data.direction);
  checks.count(key + ".points", data.points, "points", {fewest_readings, most_fit_points});
  if (data.force_std) checks.within(key + ".force_std", *data.force_std, load_range);
  checks.within(key + ".displacement_std", data.displacement_std, {0.0, length_range.most, "m"});
  check_rig(checks, data, key);
}

void check_parameter(Checks& checks, const FitParameter& parameter, const FitSettings& fit, const std::string& key) {
  const bool known = checks.require(is_fitted_key(parameter.key), key + ".key", parameter.key,
                                    "is not a numeric key that can be fitted", advice_on_fitted(parameter.key));
  if (!known) return;
  if (const std::optional<std::size_t> data = data_of_key(parameter.key)) {
    const bool there =
        checks.require(*data >= 1 && *data <= fit.data.size(), key + ".key", parameter.key,
                       fmt::format("refers to missing data: there are {}", fit.data.size()), "count from 1");
    if (!there) return;
    const FittedExperiment experiment = fit.data[*data - 1].experiment;
    const auto own = rig_keys_of(experiment);
    checks.require(
        std::any_of(own.begin(), own.end(),
                    [&parameter](std::string_view one) { return parameter.key.ends_with("." + std::string(one)); }),
        key + ".key", parameter.key, fmt::format("has no effect on data of the experiment \"{}\"", name_of(experiment)),
        fmt::format("these have: {}", fmt::join(own, ", ")));
  }
  const std::optional<Dimension> dimension = dimension_of(parameter.key);
  const std::string_view unit = dimension ? si_unit(*dimension) : "";
  bool finite = true;
  const std::array<std::pair<std::string_view, std::optional<double>>, 5> numbers{{{"start", parameter.start},
                                                                                   {"lower", parameter.lower},
                                                                                   {"upper", parameter.upper},
                                                                                   {"mean", parameter.mean},
                                                                                   {"std", parameter.std}}};
  for (const auto& [name, number] : numbers) {
    finite = checks.finite(fmt::format("{}.{}", key, name), number.value_or(0.0), unit) && finite;
  }
  if (!finite) return;
  const bool bounds = checks.require(parameter.lower < parameter.upper, key + ".upper", quantity(parameter.upper, unit),
                                     fmt::format("is not above lower, {}", quantity(parameter.lower, unit)),
                                     "give bounds that leave room between them");
  if (bounds) {
    checks.require(parameter.start >= parameter.lower && parameter.start <= parameter.upper, key + ".start",
                   quantity(parameter.start, unit), "lies outside the bounds", "start between lower and upper");
  }
  checks.require(parameter.mean.has_value() == parameter.std.has_value(), key + (parameter.mean ? ".std" : ".mean"), "",
                 "is missing", "give mean and std, or neither");
  checks.require(!parameter.std || *parameter.std > 0.0, key + ".std", quantity(parameter.std.value_or(0.0), unit),
                 "must be positive", "leave out mean and std if there is no prior knowledge");
}

/// Number of values compared with the model.
std::size_t numbers_of(const FitSettings& fit) {
  std::size_t count = 0;
  for (const FitData& data : fit.data) {
    count += data.is_loop() ? std::min(data.displacements.size(), static_cast<std::size_t>(std::max(data.points, 0)))
                            : rows_of(data) * fitted_columns(data).size();
  }
  for (const FitParameter& parameter : fit.parameters) count += parameter.mean ? 1 : 0;
  return count;
}

void check_fit(Checks& checks, const Case& input, const CheckedBumpFoil& /*foil*/) {
  const FitSettings* const held = input.settings.find<FitSettings>();
  if (held == nullptr) return;
  const FitSettings& fit = *held;
  checks.require_history("fit", input.bump_foil.model != BumpFoilModel::former,
                         "has no history, so that its loops have no area");
  checks.require_for("fit", !fit.data.empty(), "fit.data", "", "is missing", "add [[fit.data]] with a file");
  checks.require_for("fit", !fit.parameters.empty(), "fit.parameter", "", "is missing",
                     "add [[fit.parameter]] with a key");
  checks.count("fit.starts", fit.starts, "minimisations", {1, most_starts});
  checks.require(!fit.huber || *fit.huber > 0.0, "fit.huber", quantity(fit.huber.value_or(0.0), ""), "must be positive",
                 "give about 1.345");
  const std::size_t numbers = numbers_of(fit);
  checks.require_for("fit", fit.data.empty() || numbers == 0 || numbers >= fit.parameters.size(), "fit.parameter",
                     std::to_string(fit.parameters.size()),
                     fmt::format("are more than the measured values, {}", numbers),
                     "fit fewer of them, add data, or give prior values by mean and std");
  for (std::size_t i = 0; i < fit.data.size(); ++i) {
    check_data(checks, input, fit.data[i], fmt::format("fit.data[{}]", i + 1));
  }
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const std::string key = fmt::format("fit.parameter[{}]", i + 1);
    check_parameter(checks, fit.parameters[i], fit, key);
    const auto same = [&](const FitParameter& other) { return other.key == fit.parameters[i].key; };
    const auto self = fit.parameters.begin() + static_cast<std::ptrdiff_t>(i);
    checks.require(std::none_of(fit.parameters.begin(), self, same), key + ".key", fit.parameters[i].key,
                   "is fitted twice", "give it once");
  }
}

}  // namespace

CaseTable fit_settings() {
  return {.experiment = "fit",
          .needs = "fit",
          .describe = describe_fit,
          .check = check_fit,
          .given = gives<FitSettings>,
          .requested_part = [](const Case& input) -> std::string_view {
            const FitSettings* const fit = input.settings.find<FitSettings>();
            const bool strips = fit != nullptr && std::any_of(fit->data.begin(), fit->data.end(), is_of_strip);
            return strips ? name_of(FittedExperiment::strip) : "";
          }};
}

}  // namespace bumpfoil
