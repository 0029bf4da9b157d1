#include "bumpfoil/sweep/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "case/case_json.hpp"
#include "case/key_list.hpp"
#include "case/toml_document.hpp"
#include "core/collect_errors.hpp"
#include "core/number_text.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view over_option = "--over";
/// Further errors are counted, not listed.
constexpr std::size_t most_sweep_errors = 50;
/// The list of which each point takes one value.
constexpr std::string_view swept_list = "equilibrium.speeds";
/// Must be equal at all points: their spectra share an axis.
constexpr std::string_view never_swept = "transient.revolutions_per_spectrum";

/// The dimension of a value of a key that accepts two.
std::optional<Dimension> dimension_of_either(const std::string& value) {
  for (const Dimension dimension : {Dimension::length, Dimension::force}) {
    if (std::holds_alternative<double>(parse_quantity(value, dimension))) return dimension;
  }
  return std::nullopt;
}

/// Checks the options, individually and in combination.
class OptionReader {
 public:
  explicit OptionReader(const SweepRequest& request) : request_(request) {}

  std::vector<SweepAxis> read() {
    for (const std::string& argument : request_.over) {
      collect_errors(errors_, [&] { add(parse_swept_key(argument)); });
    }
    double points = 1.0;
    for (const SweepAxis& axis : axes_) points *= static_cast<double>(axis.swept.values.size());
    if (points > static_cast<double>(most_sweep_points)) {
      error("", fmt::format("make a grid of {:.0f} points", points),
            fmt::format("a sweep takes at most {}", most_sweep_points));
    }
    if (!errors_.empty()) throw Error(ErrorKind::input, std::move(errors_));
    return std::move(axes_);
  }

 private:
  void error(const std::string& key, std::string what, std::string advice) {
    errors_.push_back({std::string(over_option), 0, key, "", std::move(what), std::move(advice)});
  }

  void add(SweptKey swept) {
    const std::string& key = swept.key;
    const ListedKey* listed = find_key(keys_, key);
    if (listed == nullptr || listed->is_table()) return error(key, "unknown key", advice_on_number(keys_, key));
    if (listed->path == never_swept) return error(key, "is the same at all points", "set it by --set");
    const bool is_list = listed->path == swept_list;
    if (!is_list && !listed->holds_number()) return error(key, "is not numeric", "sweep over numeric keys");
    const auto same = [&key](const SweepAxis& axis) { return axis.swept.key == key; };
    if (std::any_of(axes_.begin(), axes_.end(), same)) return error(key, "is swept twice", "give it once");
    for (const std::string& one : request_.overrides) {
      if (one.starts_with(key + '=')) error(key, "is swept, and set by --set", "give one of the two");
    }
    const std::string title = fmt::format("{}: {}", find_key(keys_, listed->table())->key.title, listed->key.title);
    SweepAxis axis{.swept = {}, .is_list = is_list, .name = key, .title = title, .unit = "1", .values = {}};
    std::erase(axis.name, ']');
    std::replace_if(
        axis.name.begin(), axis.name.end(), [](char c) { return c == '.' || c == '['; }, '_');
    if (listed->key.dimension) axis.unit = si_unit(*listed->key.dimension);
    if (listed->is_either()) axis.unit = unit_of_either(swept);
    axis.swept = std::move(swept);
    axes_.push_back(std::move(axis));
  }

  std::string unit_of_either(const SweptKey& swept) {
    const std::optional<Dimension> first = dimension_of_either(swept.values.front());
    for (const std::string& value : swept.values) {
      const std::optional<Dimension> dimension = dimension_of_either(value);
      if (dimension && dimension == first) continue;
      error(swept.key,
            fmt::format("is \"{}\", {}", value, first ? "but others are of another kind" : "expected a unit"),
            "write lengths or forces, all with their units: 10 um:50 um:10 um");
      return {};
    }
    return std::string(si_unit(*first));
  }

  const SweepRequest& request_;
  std::vector<ListedKey> keys_{list_keys()};
  std::vector<SweepAxis> axes_;
  std::vector<InputError> errors_;
};

/// Errors of all points: each is reported once, with the first point that has it.
class GridErrors {
 public:
  GridErrors(const Sweep& sweep, std::size_t points) : sweep_(sweep), points_(points) {}

  void add(std::size_t point, const Error& error) {
    input_ = input_ || error.kind() == ErrorKind::input;
    for (const InputError& one : error.errors()) {
      const auto [place, is_new] = places_.try_emplace(format_error(one), errors_.size());
      if (is_new) errors_.push_back({one, point, 0});
      ++errors_[place->second].count;
    }
  }

  void throw_if_any() const {
    if (errors_.empty()) return;
    std::vector<InputError> listed;
    for (const Found& found : errors_) {
      if (listed.size() == most_sweep_errors) {
        listed.push_back({"", 0, "", "", fmt::format("and {} more errors", errors_.size() - most_sweep_errors),
                          "fix the first ones"});
        break;
      }
      InputError& error = listed.emplace_back(found.error);
      const auto swept = [&error](const SweepAxis& axis) {
        return error.key == axis.swept.key + (axis.is_list ? "[1]" : "");
      };
      if (error.file == command_line && std::any_of(sweep_.axes.begin(), sweep_.axes.end(), swept))
        error.file = over_option;
      if (found.count == points_) continue;  // independent of the grid
      error.what += fmt::format(" (at {}{})", point_name(sweep_, found.first),
                                found.count > 1 ? fmt::format(" and {} more points", found.count - 1) : "");
    }
    throw Error(input_ ? ErrorKind::input : ErrorKind::file, std::move(listed));
  }

 private:
  struct Found {
    InputError error;
    std::size_t first;
    std::size_t count;
  };

  const Sweep& sweep_;
  std::size_t points_;
  std::vector<Found> errors_;
  std::map<std::string, std::size_t> places_;
  bool input_{};
};

/// Value of a key in a case, SI.
double value_in(const Case& input, const std::string& key) {
  const std::vector<ListedKey> keys = list_keys(input);
  const nlohmann::ordered_json& held = find_key(keys, key)->value;
  const nlohmann::ordered_json& value = held.is_array() ? held.front() : held;
  if (value.is_number()) return value.get<double>();
  double number = 0.0;  // number before the unit that determines the kind
  read_number(value.get<std::string>(), number);
  return number;
}

/// A list of one value, in TOML.
std::string list_of(const std::string& value) {
  double number = 0.0;
  const auto [end, status] = read_number(value, number);
  const bool plain = status == std::errc{} && end == value.data() + value.size();
  return plain ? fmt::format("[{}]", value) : fmt::format("[\"{}\"]", value);
}

std::size_t points_of(const std::vector<SweepAxis>& axes) {
  std::size_t points = 1;
  for (const SweepAxis& axis : axes) points *= axis.swept.values.size();
  return points;
}

/// Reads the values of an axis from the cases along it, with all other keys at their first values.
void take_values(Sweep& sweep) {
  std::size_t stride = sweep.cases.size();
  std::vector<InputError> errors;
  for (SweepAxis& axis : sweep.axes) {
    const std::size_t count = axis.swept.values.size();
    stride /= count;
    std::map<double, std::size_t> known;
    for (std::size_t i = 0; i < count; ++i) {
      const double value = value_in(sweep.cases[i * stride], axis.swept.key);
      axis.values.push_back(value);
      const auto [first, is_new] = known.try_emplace(value, i);
      if (is_new) continue;
      errors.push_back({std::string(over_option), 0, axis.swept.key, axis.swept.values[i],
                        fmt::format("is the same value as {}", axis.swept.values[first->second]),
                        "give every value once"});
    }
  }
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

/// Whether the number of loops is small enough to store them.
bool keeps_loops(const Sweep& sweep) {
  const auto& loop_values = sweep.experiment->sweeping->loop_values;
  std::size_t values = 0;
  for (const Case& input : sweep.cases) values += loop_values ? loop_values(input) : 0;
  return values <= most_loop_values;
}

const ExperimentInfo& swept_experiment(const std::string& command) {
  const CaseTable* const table = case_table_of(command);
  if (table != nullptr && table->swept) return experiment_named(command);
  throw Error(ErrorKind::input, {{"", 0, "command", command, "is not swept",
                                  fmt::format("give one of {}", fmt::join(swept_experiments(), ", "))}});
}

}  // namespace

Sweep parse_sweep(std::string_view text, const std::string& name, const SweepRequest& request) {
  const ExperimentInfo& experiment = swept_experiment(request.command);
  if (request.limits && request.command != "equilibrium") {
    throw Error(ErrorKind::input,
                {{"", 0, "--limits", "", "are those of running bearings", "add --command equilibrium"}});
  }
  Sweep sweep{.experiment = &experiment, .axes = OptionReader(request).read(), .cases = {}};
  const std::size_t points = points_of(sweep.axes);
  GridErrors errors(sweep, points);
  for (std::size_t point = 0; point < points; ++point) {
    CaseRequest one{.overrides = request.overrides, .commands = {request.command}};
    if (request.limits) one.overrides.emplace_back("equilibrium.limits=true");
    const std::vector<std::size_t> indices = indices_of(sweep, point);
    for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
      const SweptKey& swept = sweep.axes[i].swept;
      const std::string& value = swept.values[indices[i]];
      one.overrides.push_back(swept.key + '=' + (sweep.axes[i].is_list ? list_of(value) : value));
    }
    try {
      sweep.cases.push_back(parse_case(text, name, one));
    } catch (const Error& error) {
      errors.add(point, error);
    }
  }
  errors.throw_if_any();
  take_values(sweep);
  sweep.with_loops = keeps_loops(sweep);
  return sweep;
}

std::vector<std::size_t> indices_of(const Sweep& sweep, std::size_t point) {
  std::vector<std::size_t> indices(sweep.axes.size());
  for (std::size_t i = indices.size(); i-- > 0;) {
    const std::size_t count = sweep.axes[i].swept.values.size();
    indices[i] = point % count;
    point /= count;
  }
  return indices;
}

std::string point_name(const Sweep& sweep, std::size_t point) {
  const std::vector<std::size_t> indices = indices_of(sweep, point);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const SweptKey& swept = sweep.axes[i].swept;
    words.push_back(swept.key + '=' + swept.values[indices[i]]);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::vector<std::string> swept_commands() {
  return {swept_experiments().begin(), swept_experiments().end()};
}

SweepPoint sweep_point(const Sweep& sweep, const Outcome& outcome) {
  SweptResult swept = outcome.swept(sweep.with_loops);
  return {.status = outcome.status,
          .dims = each(swept.dataset.dims, [](const DataDimension& dim) { return dim.name; }),
          .extents = each(swept.dataset.dims, [](const DataDimension& dim) { return dim.size; }),
          .variables = each(swept.dataset.variables, [](const Variable& variable) { return variable.meaning.name; }),
          .values = each(swept.dataset.variables, [](const Variable& variable) { return variable.values(); }),
          .rows = csv_text(swept.rows),
          .more = each(swept.more, csv_text),
          .lists = std::move(swept.lists),
          .failures = outcome.failures,
          .warnings = outcome.warnings};
}

SweepPoint run_point(const Sweep& sweep, std::size_t point, const ProgressCallback& progress) {
  return sweep_point(sweep, sweep.experiment->sweeping->run(sweep.cases[point], progress));
}

std::string bytes_of(const SweepPoint& point) {
  const auto all = nlohmann::json::array({point.status, point.extents, point.values, point.rows, point.more,
                                          point.lists, point.failures, point.warnings, point.dims, point.variables});
  std::string bytes;
  nlohmann::json::to_msgpack(all, bytes);  // bit-exact numbers, including NaN
  return bytes;
}

SweepPoint point_of_bytes(const std::string& bytes) {
  const nlohmann::json all = nlohmann::json::from_msgpack(bytes);
  SweepPoint point;
  all.at(0).get_to(point.status);
  all.at(1).get_to(point.extents);
  all.at(2).get_to(point.values);
  all.at(3).get_to(point.rows);
  all.at(4).get_to(point.more);
  all.at(5).get_to(point.lists);
  all.at(6).get_to(point.failures);
  all.at(7).get_to(point.warnings);
  all.at(8).get_to(point.dims);
  all.at(9).get_to(point.variables);
  return point;
}

void complete(const Sweep& sweep, std::vector<SweepPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].values.empty()) {
      points[i] = sweep_point(sweep, sweep.experiment->sweeping->not_begun(sweep.cases[i]));
    }
  }
}

RunStatus status_of(const std::vector<SweepPoint>& points) {
  RunStatus status = RunStatus::complete;
  for (const SweepPoint& point : points) status = std::max(status, point.status);
  return status;
}

}  // namespace bumpfoil
