#include "experiments/fit/fit_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/number_text.hpp"
#include "experiments/fit/fit_columns.hpp"
#include "experiments/fit/fit_statistics.hpp"
#include "results/read_unit.hpp"
#include "results/summary_json.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

template <typename Result>
using FitQuantity = Quantity<double (*)(const Result&)>;

double cell(const std::optional<double>& value) {
  return value.value_or(absent);
}

constexpr std::array fit_quantities{
    FitQuantity<FitResult>{"status", "", "how the minimisation ended",
                           [](const FitResult& fit) { return static_cast<double>(fit.status); }, tag::none, "status",
                           shown::unitless, flags<Status>},
    FitQuantity<FitResult>{"chi_square", "1",
                           "sum of the squares of measured minus fitted over their standard deviations",
                           [](const FitResult& fit) { return fit.chi_square; }},
    FitQuantity<FitResult>{"degrees_of_freedom", "1", "points and priors minus parameters",
                           [](const FitResult& fit) { return static_cast<double>(fit.degrees_of_freedom); }, tag::none,
                           "", shown::in_files, whole_number},
    FitQuantity<FitResult>{"reduced_chi_square", "1", "chi-square per degree of freedom: 1 where noise explains all",
                           [](const FitResult& fit) { return fit.reduced_chi_square(); }, tag::headline,
                           "chi-square per degree of freedom", shown::unitless},
    FitQuantity<FitResult>{
        "collinearity", "1", "1 over the smallest singular value of the sensitivities, each scaled to length 1",
        [](const FitResult& fit) { return fit.collinearity; }, tag::none, "collinearity", shown::unitless},
    FitQuantity<FitResult>{"model_runs", "1", "evaluations of the model",
                           [](const FitResult& fit) { return static_cast<double>(fit.runs); }, tag::of_solver, "",
                           shown::in_files, whole_number}};

/// In the SI unit of the parameter.
constexpr std::array parameter_quantities{
    FitQuantity<FittedValue>{"fitted_value", "1", "best value, in the SI unit of the parameter",
                             [](const FittedValue& one) { return one.value; }},
    FitQuantity<FittedValue>{"standard_error", "1", "standard error, in the SI unit of the parameter",
                             [](const FittedValue& one) { return cell(one.standard_error); }},
    FitQuantity<FittedValue>{"lower_95", "1", "lower end of the 95 % interval, in the SI unit of the parameter",
                             [](const FittedValue& one) { return cell(one.lower_95); }},
    FitQuantity<FittedValue>{"upper_95", "1", "upper end of the 95 % interval, in the SI unit of the parameter",
                             [](const FittedValue& one) { return cell(one.upper_95); }},
    FitQuantity<FittedValue>{"at_bound", "1", "whether the best value lies at a bound",
                             [](const FittedValue& one) { return one.at_bound ? 1.0 : 0.0; }, tag::none, "",
                             shown::in_files, yes_or_no},
    FitQuantity<FittedValue>{"at_jump", "1", "whether the model jumps beside the best value",
                             [](const FittedValue& one) { return one.at_jump ? 1.0 : 0.0; }, tag::none, "",
                             shown::in_files, yes_or_no},
    FitQuantity<FittedValue>{"profile_lower_95", "1",
                             "lower end of the 95 % interval by the profile, in the SI unit of the parameter",
                             [](const FittedValue& one) { return cell(one.profile_lower_95); }},
    FitQuantity<FittedValue>{"profile_upper_95", "1",
                             "upper end of the 95 % interval by the profile, in the SI unit of the parameter",
                             [](const FittedValue& one) { return cell(one.profile_upper_95); }}};

constexpr std::array profile_quantities{
    FitQuantity<FitProfilePoint>{"profile_value", "1", "value that a parameter is held at, in its SI unit",
                                 [](const FitProfilePoint& point) { return point.value; }},
    FitQuantity<FitProfilePoint>{
        "profile_cost", "1",
        "increase of the squares where the others are fitted again; 1 at a standard error of a linear model",
        [](const FitProfilePoint& point) { return point.cost; }}};

/// In the SI unit of what was measured.
constexpr std::array measured_quantities{
    FitQuantity<FittedQuantity>{"data_quantity", "", "what was measured",
                                [](const FittedQuantity& one) { return static_cast<double>(one.column); }, tag::none,
                                "", shown::in_files, flags<FitColumn>},
    FitQuantity<FittedQuantity>{"reading_noise", "1",
                                "standard deviation of one reading, in the SI unit of the quantity: given, or of the "
                                "force in a loop from the scatter of neighbours",
                                [](const FittedQuantity& one) { return one.noise; }},
    FitQuantity<FittedQuantity>{"residual_rms", "1",
                                "root mean square of measured minus fitted, in the SI unit of the quantity",
                                [](const FittedQuantity& one) { return one.residual; }}};

constexpr std::array fit_point_quantities{
    FitQuantity<FittedPoint>{"point_series", "1", "curve that the point belongs to, as `series` names them, from 1",
                             [](const FittedPoint& point) { return static_cast<double>(point.series + 1); }, tag::none,
                             "", shown::in_files, whole_number},
    FitQuantity<FittedPoint>{"point_place", "1",
                             "place on the axis of the data, in its SI unit; of a loop, mean of the displacements",
                             [](const FittedPoint& point) { return point.at; }},
    FitQuantity<FittedPoint>{"measured_value", "1", "in the SI unit of the quantity; of a loop, mean of the forces",
                             [](const FittedPoint& point) { return point.measured; }},
    FitQuantity<FittedPoint>{"model_value", "1", "value of the fitted model there, in the SI unit of the quantity",
                             [](const FittedPoint& point) { return point.fitted; }},
    FitQuantity<FittedPoint>{"value_residual", "1", "measured minus fitted, in the SI unit of the quantity",
                             [](const FittedPoint& point) { return point.measured - point.fitted; }},
    FitQuantity<FittedPoint>{"value_deviation", "1",
                             "standard deviation of the measured value, in the SI unit of the quantity",
                             [](const FittedPoint& point) { return point.std; }},
    FitQuantity<FittedPoint>{"readings", "1", "number of readings",
                             [](const FittedPoint& point) { return static_cast<double>(point.readings); }, tag::none,
                             "", shown::in_files, whole_number}};

/// The measured column of each point.
std::vector<double> columns_of_points(const FittedData& data) {
  return each(data.points, [&data](const FittedPoint& point) {
    return static_cast<double>(data.quantities[point.quantity].column);
  });
}

/// Numbers of each parameter, in its unit. @param columns  labels and members
std::string parameter_lines(
    const FitResult& result,
    const std::vector<std::pair<std::string, std::function<double(const FittedValue&)>>>& columns) {
  const std::size_t count = result.parameters.size();
  const std::vector<ReadUnit> units = each(result.units, read_unit_of);
  Table table;
  table.add(shown_column("parameter"),
            each(result.settings.parameters, [](const FitParameter& one) { return one.key; }));
  for (const auto& [label, value] : columns) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) texts.push_back(number_text(value(result.parameters[i]), units[i].size));
    table.add(shown_column(label), std::move(texts));
  }
  table.add(shown_column("unit"), each(units, [](const ReadUnit& unit) { return unit.name; }));
  table.add(shown_column(""), each(result.parameters, [](const FittedValue& found) -> std::string {
              return found.at_bound ? "at a bound" : found.at_jump ? "at a jump" : "";
            }));
  return table_lines(table);
}

std::string values_text(const FitResult& result, const std::vector<double>& values) {
  std::vector<std::string> parts;
  parts.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ReadUnit unit = read_unit_of(result.units[i]);
    parts.push_back(fmt::format("{} = {}{}{}", result.settings.parameters[i].key, number_text(values[i], unit.size),
                                unit.name.empty() ? "" : " ", unit.name));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<std::string> fit_warnings(const FitResult& result) {
  std::vector<std::string> lines;
  if (result.parameters.empty()) return lines;
  if (is_excessive(result.chi_square, result.degrees_of_freedom)) {
    lines.push_back(fmt::format(
        "the model does not explain the data: chi-square per degree of freedom is {:.3g}, 1 where noise explains all; "
        "standard errors are multiplied by its square root, and still too small where neighbouring residuals are "
        "correlated",
        result.reduced_chi_square()));
  }
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    if (!result.parameters[i].at_bound) continue;
    lines.push_back(
        fmt::format("{} lies at a bound: its standard error is not known, and those of the others hold for "
                    "this value",
                    result.settings.parameters[i].key));
  }
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    if (!result.parameters[i].at_jump) continue;
    lines.push_back(fmt::format(
        "the model jumps near the value of {}, as other contacts slide there: its standard error is not known, and "
        "those of the others hold for this value; more fit.starts may find a deeper minimum beyond the jump, and "
        "fit.profile = true shows what the data say about it",
        result.settings.parameters[i].key));
  }
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    const std::vector<FitProfilePoint>& profile = result.parameters[i].profile;
    const bool lower =
        std::any_of(profile.begin(), profile.end(), [&](const FitProfilePoint& point) { return point.cost < -1.0; });
    if (!lower) continue;
    lines.push_back(fmt::format(
        "the profile of {} leads to a lower sum of squares than the minimum that was found: give more fit.starts",
        result.settings.parameters[i].key));
  }
  lines.insert(lines.end(), result.directions.begin(), result.directions.end());
  for (std::size_t i = 1; i < result.minima.size(); ++i) {
    lines.push_back(fmt::format("another minimum is nearly as deep (chi-square larger by {:.3g}): {}",
                                result.minima[i].cost - result.minima.front().cost,
                                values_text(result, result.minima[i].values)));
  }
  return lines;
}

std::string fit_table(const FitResult& result) {
  if (result.parameters.empty()) return "no minimum was found\n";
  std::string out =
      parameter_lines(result, {{"value", [](const FittedValue& one) { return one.value; }},
                               {"standard error", [](const auto& one) { return cell(one.standard_error); }},
                               {"95 %: from", [](const auto& one) { return cell(one.lower_95); }},
                               {"to", [](const auto& one) { return cell(one.upper_95); }}});
  if (result.settings.profile) {
    out += "\n95 % by profiles\n" +
           parameter_lines(result, {{"from", [](const auto& one) { return cell(one.profile_lower_95); }},
                                    {"to", [](const auto& one) { return cell(one.profile_upper_95); }}});
  }
  out += '\n';
  for (std::size_t i = 0; i < result.data.size(); ++i) {
    const FittedData& data = result.data[i];
    for (std::size_t q = 0; q < data.quantities.size(); ++q) {
      const FittedQuantity& one = data.quantities[q];
      const auto points = std::count_if(data.points.begin(), data.points.end(),
                                        [q](const FittedPoint& point) { return point.quantity == q; });
      const std::string unit(unit_of(one.column));
      const ReadUnit shown_in = read_unit_of(unit);
      out += fmt::format("{} {}, {}: residual {} {}at {} points, noise of one reading {}{}{}\n",
                         name_of(data.experiment), i + 1, name_of(one.column), number_text(one.residual, shown_in.size),
                         shown_in.name.empty() ? "" : shown_in.name + ' ', points,
                         number_text(one.noise, shown_in.size), shown_in.name.empty() ? "" : " ", shown_in.name);
    }
  }
  out += fmt::format("chi-square per degree of freedom: {:.4g} ({} degrees of freedom)\n", result.reduced_chi_square(),
                     result.degrees_of_freedom);
  bool any = false;
  for (Eigen::Index a = 0; a < result.correlation.rows(); ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      constexpr double strong = 0.9;
      const double rho = result.correlation(a, b);
      if (!(std::abs(rho) > strong)) continue;
      out += fmt::format("{}correlation {:+.3f}: {}, {}\n", any ? "" : "\n", rho,
                         result.settings.parameters[static_cast<std::size_t>(b)].key,
                         result.settings.parameters[static_cast<std::size_t>(a)].key);
      any = true;
    }
  }
  return out;
}

Dataset fit_dataset(const FitResult& result) {
  Dataset data;
  const std::size_t count = result.settings.parameters.size();
  for (const auto& quantity : fit_quantities) {
    data.add(
        quantity.meaning(), {},
        std::vector<double>{result.parameters.empty() && quantity.name != "status" ? absent : quantity.value(result)});
  }
  data.add_dimension({"parameter", "1", "fitted parameter, named by the attribute parameters", whole_number},
                     numbers_from(1.0, count));
  std::map<std::string, std::string>& names = data.coordinates.back().attributes;
  names["parameters"] = fmt::format(
      "{}", fmt::join(each(result.settings.parameters, [](const FitParameter& one) { return one.key; }), ", "));
  names["parameter_units"] = fmt::format("{}", fmt::join(result.units, ", "));
  const auto add_over_parameters = [&](VariableMeaning meaning, const auto& value) {
    data.add(std::move(meaning), {"parameter"}, each(result.settings.parameters, value));
  };
  add_over_parameters({"start_value", "1", "given start, in the SI unit of the parameter"},
                      [](const FitParameter& one) { return one.start; });
  add_over_parameters({"lower_bound", "1", "in the SI unit of the parameter"},
                      [](const FitParameter& one) { return one.lower; });
  add_over_parameters({"upper_bound", "1", "in the SI unit of the parameter"},
                      [](const FitParameter& one) { return one.upper; });
  for (const auto& quantity : parameter_quantities) {
    std::vector<double> values = each(result.parameters, quantity.value);
    values.resize(count, absent);
    data.add(quantity.meaning(), {"parameter"}, std::move(values));
  }
  data.add_dimension({"other_parameter", "1", "the other of two parameters", whole_number}, numbers_from(1.0, count));
  std::vector<double> correlation(result.correlation.data(), result.correlation.data() + result.correlation.size());
  correlation.resize(count * count, absent);
  data.add({"correlation", "1", "of two parameters"}, {"parameter", "other_parameter"}, std::move(correlation));

  if (result.settings.profile && !result.parameters.empty()) {
    std::size_t widest = 0;
    for (const FittedValue& found : result.parameters) widest = std::max(widest, found.profile.size());
    data.add_dimension({"profile_point", "1", "place of a profile, in rising order of values", whole_number},
                       numbers_from(0.0, widest));
    for (const auto& quantity : profile_quantities) {
      data.add(quantity.meaning(), {"parameter", "profile_point"}, padded_rows(count, widest, [&](std::size_t i) {
                 return each(result.parameters[i].profile, quantity.value);
               }));
    }
  }

  data.add_dimension({"minimum", "1", "minima that are nearly as deep as the best, which is the first", whole_number},
                     numbers_from(1.0, result.minima.size()));
  data.add({"minimum_cost", "1", "squares of residuals in standard deviations"}, {"minimum"},
           each(result.minima, [](const FitMinimum& one) { return one.cost; }));
  data.add({"minimum_value", "1", "of the parameters at the minimum, in their SI units"}, {"minimum", "parameter"},
           padded_rows(result.minima.size(), count,
                       [&](std::size_t i) -> const std::vector<double>& { return result.minima[i].values; }));

  const std::vector<FittedData>& fitted = result.data;
  data.add_dimension({"data", "1", "measured loop or table, from 1", whole_number}, numbers_from(1.0, fitted.size()));
  std::map<std::string, std::string>& words = data.coordinates.back().attributes;
  words["series"] = fmt::format(
      "{}",
      fmt::join(each(fitted, [](const FittedData& one) { return fmt::format("{}", fmt::join(one.series, "; ")); }),
                " | "));
  words["axes"] = fmt::format(
      "{}",
      fmt::join(each(fitted, [](const FittedData& one) { return fmt::format("{} ({})", one.axis, one.axis_unit); }),
                " | "));
  data.add({"data_experiment", "", "what was done to the foils", flags<FittedExperiment>}, {"data"},
           each(fitted, [](const FittedData& one) { return static_cast<double>(one.experiment); }));
  const auto widest_of = [&fitted](const auto& list_of) {
    std::size_t widest = 0;
    for (const FittedData& one : fitted) widest = std::max(widest, list_of(one).size());
    return widest;
  };
  const std::size_t most_quantities = widest_of([](const FittedData& one) { return one.quantities; });
  data.add_dimension({"measurand", "1", "what was measured in the data, from 1", whole_number},
                     numbers_from(1.0, most_quantities));
  for (const auto& quantity : measured_quantities) {
    data.add(quantity.meaning(), {"data", "measurand"}, padded_rows(fitted.size(), most_quantities, [&](std::size_t i) {
               return each(fitted[i].quantities, quantity.value);
             }));
  }
  const std::size_t longest = widest_of([](const FittedData& one) { return one.points; });
  data.add_dimension(
      {"point", "1", "what was measured at a place, or in a part of equal arc length of a loop", whole_number},
      numbers_from(0.0, longest));
  data.add({"point_quantity", "", "what was measured", flags<FitColumn>}, {"data", "point"},
           padded_rows(fitted.size(), longest, [&](std::size_t i) { return columns_of_points(fitted[i]); }));
  for (const auto& quantity : fit_point_quantities) {
    data.add(quantity.meaning(), {"data", "point"}, padded_rows(fitted.size(), longest, [&](std::size_t i) {
               return each(fitted[i].points, quantity.value);
             }));
  }
  return data;
}

Table fitted_points(const FitResult& result) {
  struct Row {
    std::size_t number;  ///< of the data, from 0
    std::size_t place;   ///< among its points
    const FittedData& data;
    const FittedPoint& point;

    [[nodiscard]] FitColumn column() const { return data.quantities[point.quantity].column; }
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < result.data.size(); ++i) {
    const FittedData& data = result.data[i];
    for (std::size_t k = 0; k < data.points.size(); ++k) rows.push_back({i, k, data, data.points[k]});
  }
  Table table;
  table.add({"data", "1", ""}, each(rows, [](const Row& row) { return static_cast<double>(row.number + 1); }));
  table.add({"point", "1", ""}, each(rows, [](const Row& row) { return static_cast<double>(row.place); }));
  table.add({"series", "", ""}, each(rows, [](const Row& row) { return row.data.series[row.point.series]; }));
  table.add({"quantity", "", ""}, each(rows, [](const Row& row) { return std::string(name_of(row.column())); }));
  table.add({"unit", "", ""}, each(rows, [](const Row& row) { return std::string(unit_of(row.column())); }));
  table.add({"axis", "", ""}, each(rows, [](const Row& row) { return std::string(row.data.axis); }));
  table.add({"axis_unit", "", ""}, each(rows, [](const Row& row) { return std::string(row.data.axis_unit); }));
  for (const auto& quantity : fit_point_quantities) {
    table.add(quantity.meaning(), each(rows, [&quantity](const Row& row) { return quantity.value(row.point); }));
  }
  return table;
}

Json fit_lists(const FitResult& result) {
  Json json;
  for (const auto& quantity : fit_quantities) {
    if (quantity.name == "status") continue;
    json[quantity.key()] = result.parameters.empty() ? Json() : value_json(quantity.value(result), quantity.form);
  }
  json["parameters"] = Json::array();
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    const FitParameter& parameter = result.settings.parameters[i];
    Json& entry = json["parameters"].emplace_back(
        Json{{"key", parameter.key}, {"unit", result.units[i]}, {"start", parameter.start}});
    entry.update(values_json(parameter_quantities, result.parameters[i]));
    entry["correlations"] = Json::array();
    for (Eigen::Index k = 0; k < result.correlation.cols(); ++k) {
      entry["correlations"].push_back(value_json(result.correlation(static_cast<Eigen::Index>(i), k)));
    }
    if (!result.settings.profile) continue;
    entry["profile"] = each(result.parameters[i].profile,
                            [](const FitProfilePoint& point) { return values_json(profile_quantities, point); });
  }
  json["data"] = Json::array();
  for (const FittedData& data : result.data) {
    Json& entry = json["data"].emplace_back(Json{{"experiment", name_of(data.experiment)},
                                                 {"points", data.points.size()},
                                                 {"axis", data.axis},
                                                 {"axis_unit", data.axis_unit},
                                                 {"series", data.series},
                                                 {"quantities", Json::array()}});
    for (const FittedQuantity& one : data.quantities) {
      entry["quantities"].push_back({{"title", title_of(one.column)}, {"unit", unit_of(one.column)}});
      entry["quantities"].back().update(values_json(measured_quantities, one));
    }
  }
  json["minima"] = Json::array();
  for (const FitMinimum& minimum : result.minima) {
    json["minima"].push_back({{"minimum_cost", minimum.cost}, {"fitted_values", minimum.values}});
  }
  return json;
}

std::string fitted_case_text(const FitResult& result) {
  std::string out = "# A case with values that `bumpfoil fit` found from measured data; all numbers are in SI.\n";
  if (result.status != Status::converged) {
    out += fmt::format("# The fit did not converge ({}): these values are not final.\n", name_of(result.status));
  }
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    const FittedValue& found = result.parameters[i];
    const std::string unit = result.units[i] == "1" ? "" : " " + result.units[i];
    out += fmt::format("#   {} = {:.6g}{}", result.settings.parameters[i].key, found.value, unit);
    if (found.standard_error) {
      out += fmt::format(", standard error {:.2g}{}, 95 %: {:.6g} to {:.6g}{}", *found.standard_error, unit,
                         *found.lower_95, *found.upper_95, unit);
    }
    out += found.at_bound ? ", at a bound\n" : found.at_jump ? ", at a jump\n" : "\n";
  }
  return out + fmt::format("# Chi-square per degree of freedom: {:.4g}.\n\n{}", result.reduced_chi_square(),
                           case_to_toml(result.fitted));
}

}  // namespace bumpfoil
