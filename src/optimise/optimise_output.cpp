#include "optimise/optimise_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/case/case_writer.hpp"
#include "core/number_text.hpp"
#include "results/read_unit.hpp"
#include "results/summary_json.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

constexpr Form of_optimisation = flags<OptimiseStatus>;
constexpr Form of_point = flags<PointStatus>;

std::string number_with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + ' ' + unit;
}

ReadUnit unit_of_quantity(const OptimisedQuantity& quantity) {
  if (quantity.shown.size > 0.0) return {std::string(quantity.shown.name), quantity.shown.size};
  return {quantity.unit == "1" ? "" : quantity.unit, 1.0};
}

std::string quantity_text(double value, const OptimisedQuantity& quantity) {
  const ReadUnit unit = unit_of_quantity(quantity);
  return number_with_unit(number_text(value, unit.size), unit.name);
}

std::string value_text(const OptimiseResult& result, std::size_t key, double value) {
  const ReadUnit unit = read_unit_of(result.key_units[key]);
  return number_with_unit(number_text(value, unit.size), unit.name);
}

std::string keys_text(const OptimiseResult& result, const OptimisePoint& point) {
  std::vector<std::string> parts;
  parts.reserve(point.values.size());
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    parts.push_back(fmt::format("{} = {}", result.settings.keys[i].key, value_text(result, i, point.values[i])));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// "maximise h_min"
std::string aim_name(const OptimiseAim& aim) {
  return fmt::format("{} {}", aim.maximise ? "maximise" : "minimise", aim.quantity.name);
}

std::vector<std::string> missed_limits(const OptimiseResult& result, const OptimisePoint& point) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    const OptimiseLimit& limit = result.limits[i];
    const double margin = limit.margin(point.limits[i]);
    if (margin > 0.0) continue;
    parts.push_back(fmt::format("\"{}\" by {} ({} is {})", limit.text, quantity_text(-margin, limit.quantity),
                                limit.quantity.name, quantity_text(point.limits[i], limit.quantity)));
  }
  return parts;
}

std::size_t count_status(const OptimiseResult& result, PointStatus status) {
  return static_cast<std::size_t>(std::count_if(result.points.begin(), result.points.end(),
                                                [=](const OptimisePoint& point) { return point.status == status; }));
}

std::size_t count_feasible(const OptimiseResult& result) {
  return static_cast<std::size_t>(std::count_if(result.points.begin(), result.points.end(),
                                                [&](const OptimisePoint& point) { return result.is_feasible(point); }));
}

std::string first_message(const OptimiseResult& result, PointStatus status) {
  for (const OptimisePoint& point : result.points) {
    if (point.status == status) return fmt::format("{}: {}", keys_text(result, point), point.message);
  }
  return {};
}

std::string limits_text(const OptimiseResult& result, const OptimisePoint& point, bool best) {
  if (result.limits.empty()) return {};
  std::vector<std::string> values, margins, remarks;
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    const OptimiseLimit& limit = result.limits[i];
    const double margin = limit.margin(point.limits[i]);
    values.push_back(quantity_text(point.limits[i], limit.quantity));
    margins.push_back(quantity_text(margin, limit.quantity));
    remarks.emplace_back(margin <= 0.0 ? "missed" : best && result.is_active(i) ? "active" : "");
  }
  Table table;
  table.add(shown_column("limit"), each(result.limits, [](const OptimiseLimit& limit) { return limit.text; }));
  table.add(shown_column("value"), std::move(values));
  table.add(shown_column("margin"), std::move(margins));
  table.add(shown_column(""), std::move(remarks));
  return '\n' + table_lines(table);
}

std::string key_lines(const OptimiseResult& result, const OptimisePoint& point, bool best) {
  const std::vector<OptimisedKey>& keys = result.settings.keys;
  const std::vector<ReadUnit> units = each(result.key_units, read_unit_of);
  Table table;
  table.add(shown_column("key"), each(keys, [](const OptimisedKey& key) { return key.key; }));
  const auto add = [&](const std::string& label, const auto& text_of) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < keys.size(); ++i) texts.push_back(text_of(i));
    table.add(shown_column(label), std::move(texts));
  };
  add("value", [&](std::size_t i) { return number_text(point.values[i], units[i].size); });
  add("start", [&](std::size_t i) { return number_text(result.points[0].values[i], units[i].size); });
  add("lower bound", [&](std::size_t i) { return number_text(keys[i].lower, units[i].size); });
  add("upper bound", [&](std::size_t i) { return number_text(keys[i].upper, units[i].size); });
  add("unit", [&](std::size_t i) { return units[i].name; });
  add("", [&](std::size_t i) {
    const int bound = best ? result.bound_of(i) : 0;
    return bound == 0 ? "" : bound < 0 ? "at its lower bound" : "at its upper bound";
  });
  return table_lines(table) + '\n';
}

std::string front_lines(const OptimiseResult& result) {
  if (result.front.empty()) return {};
  Table table;
  const auto add = [&](const std::string& name, const ReadUnit& unit, const auto& value) {
    table.add(shown_column(name, {unit.name, unit.size}),
              each(result.front, [&](std::size_t number) { return value(result.points[number]); }));
  };
  const std::vector<ReadUnit> aim_units =
      each(result.aims, [](const OptimiseAim& aim) { return unit_of_quantity(aim.quantity); });
  const std::vector<ReadUnit> key_units = each(result.key_units, read_unit_of);
  for (std::size_t i = 0; i < result.aims.size(); ++i) {
    add(result.aims[i].quantity.name, aim_units[i], [i](const OptimisePoint& point) { return point.aims[i]; });
  }
  for (std::size_t i = 0; i < result.settings.keys.size(); ++i) {
    add(result.settings.keys[i].key, key_units[i], [i](const OptimisePoint& point) { return point.values[i]; });
  }
  table.add(shown_column(""),
            each(result.front, [&](std::size_t number) -> std::string { return result.best == number ? "best" : ""; }));
  return "\nfront\n" + table_lines(table);
}

std::vector<double> over_points(const OptimiseResult& result, std::size_t width, const auto& numbers) {
  return padded_rows(result.points.size(), width, [&](std::size_t i) { return numbers(result.points[i]); });
}

std::vector<double> margins_of(const OptimiseResult& result, const OptimisePoint& point) {
  std::vector<double> margins;
  margins.reserve(point.limits.size());
  for (std::size_t i = 0; i < point.limits.size(); ++i) margins.push_back(result.limits[i].margin(point.limits[i]));
  return margins;
}

/// Adds the names of a list that may be empty.
void add_names(Dataset& data, const std::string& dim, std::string meaning, const std::vector<std::string>& names,
               const std::vector<std::string>& units) {
  data.add_dimension({dim, "1", std::move(meaning), whole_number}, numbers_from(1.0, names.size()));
  data.coordinates.back().attributes = {{"names", fmt::format("{}", fmt::join(names, ", "))},
                                        {"units_of_names", fmt::format("{}", fmt::join(units, ", "))}};
}

}  // namespace

std::vector<std::string> optimise_failures(const OptimiseResult& result) {
  switch (result.status) {
    case OptimiseStatus::converged:
    case OptimiseStatus::interrupted:
      return {};
    case OptimiseStatus::evaluations_spent:
      return {
          "the search of the best point had no evaluations left: give more optimise.evaluations, or a larger "
          "optimise.tolerance"};
    case OptimiseStatus::rounding_limited:
      return {"the search of the best point ended by round-off before its tolerance"};
    case OptimiseStatus::not_confirmed:
      return {"the result of the best point differs when it is evaluated again"};
    case OptimiseStatus::infeasible: {
      const OptimisePoint& nearest = result.points[*result.nearest];
      return {fmt::format("no point meets all limits; the nearest misses {}, at {}",
                          fmt::join(missed_limits(result, nearest), " and "), keys_text(result, nearest))};
    }
    case OptimiseStatus::no_result:
      break;
  }
  return {result.points.empty() ? "no point was evaluated"
                                : fmt::format("no point has a result; the first, {}: {}",
                                              keys_text(result, result.points.front()), result.points.front().message)};
}

std::vector<std::string> optimise_warnings(const OptimiseResult& result) {
  std::vector<std::string> lines;
  if (result.status == OptimiseStatus::no_result) return lines;
  constexpr std::array<std::string_view, 4> words{"", "failed", "are invalid", "lack a quantity"};
  for (const PointStatus status : {PointStatus::failed, PointStatus::not_physical, PointStatus::no_value}) {
    const std::size_t count = count_status(result, status);
    if (count == 0) continue;
    lines.push_back(fmt::format("{} of {} points {}, the first {}", count, result.points.size(),
                                words.at(static_cast<std::size_t>(status)), first_message(result, status)));
  }
  for (const std::string& warning : result.warnings) lines.push_back("best point: " + warning);
  return lines;
}

std::string optimise_table(const OptimiseResult& result) {
  const std::string counts = fmt::format("{} points, {} with a result, {} that meet all limits", result.points.size(),
                                         count_status(result, PointStatus::converged), count_feasible(result));
  if (!result.best && !result.nearest) return counts + '\n';
  const OptimisePoint& shown = result.points[result.best ? *result.best : *result.nearest];
  std::string out =
      fmt::format("{} ({}): {}\n\n", result.best ? "best point" : "nearest point", name_of(result.status), counts);
  out += key_lines(result, shown, result.best.has_value());
  const OptimisePoint& start = result.points.front();
  for (std::size_t i = 0; i < result.aims.size(); ++i) {
    const OptimiseAim& aim = result.aims[i];
    out += fmt::format("{}: {}{}\n", aim_name(aim), quantity_text(shown.aims[i], aim.quantity),
                       start.aims.empty() ? "" : fmt::format(", start {}", quantity_text(start.aims[i], aim.quantity)));
  }
  return out + limits_text(result, shown, result.best.has_value()) + front_lines(result);
}

Dataset optimise_dataset(const OptimiseResult& result) {
  const std::size_t keys = result.settings.keys.size();
  const std::size_t aims = result.aims.size();
  const std::size_t limits = result.limits.size();
  Dataset data;
  data.add({"status", "", "how the optimisation ended", of_optimisation}, {},
           std::vector<double>{static_cast<double>(result.status)});
  data.add(
      {"best_point", "1", "number of the best point; of two aims of the one nearest to the best of both", whole_number},
      {}, std::vector<double>{result.best ? static_cast<double>(*result.best) : absent});
  add_names(data, "key", "key that is chosen, named by the attribute names",
            each(result.settings.keys, [](const OptimisedKey& one) { return one.key; }), result.key_units);
  const auto over_keys = [&](VariableMeaning meaning, const auto& value) {
    data.add(std::move(meaning), {"key"}, each(result.settings.keys, value));
  };
  over_keys({"lower_bound", "1", "in the SI unit of the key"}, [](const OptimisedKey& one) { return one.lower; });
  over_keys({"upper_bound", "1", "in the SI unit of the key"}, [](const OptimisedKey& one) { return one.upper; });
  std::vector<double> best = result.best ? result.points[*result.best].values : std::vector<double>(keys, absent);
  data.add({"best_value", "1", "value at the best point, in the SI unit of the key"}, {"key"}, std::move(best));
  add_names(data, "aim", "aim, named by the attribute names", each(result.aims, aim_name),
            each(result.aims, [](const OptimiseAim& one) { return one.quantity.unit; }));
  if (limits > 0) {
    add_names(data, "limit", "limit, named by the attribute names",
              each(result.limits, [](const OptimiseLimit& one) { return one.text; }),
              each(result.limits, [](const OptimiseLimit& one) { return one.quantity.unit; }));
  }
  if (!result.front.empty()) {
    data.add_dimension({"front", "1", "point of the front, from the best of the first aim on", whole_number},
                       numbers_from(1.0, result.front.size()));
    data.add({"front_point", "1", "number of the point", whole_number}, {"front"},
             each(result.front, [](std::size_t number) { return static_cast<double>(number); }));
  }
  if (result.points.empty()) return data;
  data.add_dimension({"point", "1", "point that was evaluated", whole_number}, numbers_from(0.0, result.points.size()));
  data.add({"key_value", "1", "value of the key, in its SI unit"}, {"point", "key"},
           over_points(result, keys, [](const OptimisePoint& point) { return point.values; }));
  data.add({"point_status", "", "how the run of the point ended", of_point}, {"point"},
           each(result.points, [](const OptimisePoint& point) { return static_cast<double>(point.status); }));
  data.add({"feasible", "1", "whether the point meets all limits", yes_or_no}, {"point"},
           each(result.points, [&](const OptimisePoint& point) { return result.is_feasible(point) ? 1.0 : 0.0; }));
  data.add(
      {"search", "1", "search that evaluated the point, from 1; 0: a place that searches may start from", whole_number},
      {"point"}, each(result.points, [](const OptimisePoint& point) { return static_cast<double>(point.search); }));
  data.add({"aim_value", "1", "quantity of the aim, in its SI unit, where it is worst"}, {"point", "aim"},
           over_points(result, aims, [](const OptimisePoint& point) { return point.aims; }));
  if (limits == 0) return data;
  data.add({"limit_value", "1", "quantity of the limit, in its SI unit, where it is worst"}, {"point", "limit"},
           over_points(result, limits, [](const OptimisePoint& point) { return point.limits; }));
  data.add({"limit_margin", "1", "of the quantity to the bound of the limit, in its SI unit; positive where it is met"},
           {"point", "limit"},
           over_points(result, limits, [&](const OptimisePoint& point) { return margins_of(result, point); }));
  return data;
}

Table point_table(const OptimiseResult& result) {
  const std::vector<OptimisePoint>& points = result.points;
  Table table;
  table.add({"point", "1", ""}, numbers_from(0.0, points.size()));
  table.add({"search", "1", ""},
            each(points, [](const OptimisePoint& one) { return static_cast<double>(one.search); }));
  table.add({"status", "", "", of_point},
            each(points, [](const OptimisePoint& one) { return static_cast<double>(one.status); }));
  table.add({"feasible", "1", "", yes_or_no},
            each(points, [&](const OptimisePoint& one) { return result.is_feasible(one) ? 1.0 : 0.0; }));
  const auto add = [&](std::string name, const std::string& unit, std::vector<double> OptimisePoint::*list,
                       std::size_t i) {
    std::erase(name, ']');
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '.' || c == '['; }, '_');
    table.add({std::move(name), unit, ""}, each(points, [list, i](const OptimisePoint& one) {
                return (one.*list).empty() ? absent : (one.*list)[i];
              }));
  };
  for (std::size_t i = 0; i < result.settings.keys.size(); ++i) {
    add(result.settings.keys[i].key, result.key_units[i], &OptimisePoint::values, i);
  }
  for (std::size_t i = 0; i < result.aims.size(); ++i) {
    add(result.aims[i].quantity.name, result.aims[i].quantity.unit, &OptimisePoint::aims, i);
  }
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    const OptimisedQuantity& quantity = result.limits[i].quantity;
    add(fmt::format("limit_{}_{}", i + 1, key_of(quantity.name, quantity.unit)), "", &OptimisePoint::limits, i);
  }
  return table;
}

Json optimise_lists(const OptimiseResult& result) {
  const OptimisePoint* const best = result.best ? &result.points[*result.best] : nullptr;
  Json json{{"ended_by", name_of(result.status)},
            {"optimised_command", result.settings.command},
            {"point_count", result.points.size()},
            {"best_point", best == nullptr ? Json() : Json(*result.best)}};
  json["keys"] = Json::array();
  for (std::size_t i = 0; i < result.settings.keys.size(); ++i) {
    const OptimisedKey& key = result.settings.keys[i];
    const int bound = best == nullptr ? 0 : result.bound_of(i);
    json["keys"].push_back({{"key", key.key},
                            {"unit", result.key_units[i]},
                            {"lower_bound", key.lower},
                            {"upper_bound", key.upper},
                            {"start", result.points.empty() ? Json() : Json(result.points[0].values[i])},
                            {"best_value", best == nullptr ? Json() : Json(best->values[i])},
                            {"active_bound", bound == 0  ? Json()
                                             : bound < 0 ? Json("lower")
                                                         : Json("upper")}});
  }
  json["aims"] = Json::array();
  for (std::size_t i = 0; i < result.aims.size(); ++i) {
    const OptimiseAim& aim = result.aims[i];
    json["aims"].push_back({{"quantity", aim.quantity.name},
                            {"unit", aim.quantity.unit},
                            {"maximise", aim.maximise},
                            {"best_value", best == nullptr ? Json() : value_json(best->aims[i])}});
  }
  json["limits"] = Json::array();
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    const OptimiseLimit& limit = result.limits[i];
    json["limits"].push_back({{"limit", limit.text},
                              {"quantity", limit.quantity.name},
                              {"unit", limit.quantity.unit},
                              {"bound", limit.bound},
                              {"value", best == nullptr ? Json() : value_json(best->limits[i])},
                              {"margin", best == nullptr ? Json() : value_json(limit.margin(best->limits[i]))},
                              {"active", best == nullptr ? Json() : Json(result.is_active(i))}});
  }
  json["front"] = result.front;
  json["searches"] = Json::array();
  for (const OptimiseSearch& one : result.searches) {
    json["searches"].push_back({{"aim", result.aims[one.aim].quantity.name},
                                {"evaluations", one.evaluations},
                                {"ended_by", one.by_tolerance   ? "tolerance"
                                             : one.by_round_off ? "round-off"
                                                                : "evaluations"}});
  }
  return json;
}

std::string optimised_case_text(const OptimiseResult& result) {
  const OptimisePoint& best = result.points[*result.best];
  std::string out = "# A case with values that `bumpfoil optimise` chose; all numbers are in SI.\n";
  if (result.status != OptimiseStatus::converged) {
    out +=
        fmt::format("# The optimisation did not converge ({}): these values are not final.\n", name_of(result.status));
  }
  for (std::size_t i = 0; i < best.values.size(); ++i) {
    out += fmt::format("#   {} = {}\n", result.settings.keys[i].key, value_text(result, i, best.values[i]));
  }
  for (std::size_t i = 0; i < result.aims.size(); ++i) {
    out += fmt::format("# {}: {}\n", aim_name(result.aims[i]), quantity_text(best.aims[i], result.aims[i].quantity));
  }
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    out += fmt::format("# {}: {}\n", result.limits[i].text, quantity_text(best.limits[i], result.limits[i].quantity));
  }
  return out + '\n' + case_to_toml(result.optimised);
}

}  // namespace bumpfoil
