#include "pages/shown_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "case/case_json.hpp"
#include "core/base64.hpp"
#include "experiments/cycle/cycle_json.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "pages/shown_deviations.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;
using Flag = signed char;

constexpr Flag absent_flag = -127;

std::string encoded(const Form& form, const std::vector<double>& numbers) {
  if (form.kind != Form::flag && form.kind != Form::truth) return base64_of(numbers);
  std::vector<Flag> flags(numbers.size());
  std::transform(numbers.begin(), numbers.end(), flags.begin(),
                 [](double number) { return std::isnan(number) ? absent_flag : static_cast<Flag>(number); });
  return base64_of(flags);
}

void add_field(Json& json, const FieldQuantity& quantity, const FoilFields& fields, Eigen::Index reached) {
  if (is_left_out(quantity.name) || quantity.node == Node::pad || quantity.node == Node::strip ||
      quantity.is(tag::of_width_alone))
    return;
  const FieldMatrix values = quantity.value(fields);
  const bool reduced = is_reduced(quantity.name);
  if (values.cols() == 0 && reduced) return;
  const std::string name(quantity.name);
  if (reduced) {
    const Vector most = values.topRows(reached).rowwise().maxCoeff();
    json["series"][name] = encoded(quantity.form, {most.begin(), most.end()});
    return;
  }
  const Eigen::Index known = values.cols() == 0 ? 0 : reached * values.cols();
  json["fields"][name] = {{"at", quantity.node == Node::foot ? "foot" : "bump"},
                          {"values", encoded(quantity.form, {values.data(), values.data() + known})}};
}

Json cycle_data(const Cycle& cycle, const std::vector<IncrementQuantity>& quantities) {
  Json json{{"at", to_degrees(cycle.direction)},
            {"increments", Json::array()},
            {"series", Json::object()},
            {"fields", Json::object()}};
  const std::vector<Increment>& increments = cycle.increments;
  const auto failed = std::find_if(increments.begin(), increments.end(),
                                   [](const Increment& one) { return std::isnan(one.force_direct); });
  const auto reached = static_cast<std::size_t>(failed - increments.begin());
  for (std::size_t i = 0; i < reached; ++i) json["increments"].push_back(i);
  for (const IncrementQuantity& quantity : quantities) {
    std::vector<double> values(reached);
    std::transform(increments.begin(), failed, values.begin(), quantity.value);
    json["series"][std::string(quantity.name)] = encoded(quantity.form, values);
  }
  for (const FieldQuantity& quantity : field_quantities())
    add_field(json, quantity, cycle.fields, static_cast<Eigen::Index>(reached));
  return json;
}

Json summary_of(const Case& input, const CycleResult& result) {
  Json summary = summary_head(name_of(result.experiment), input, status_of(result), {});
  summary["cycles"] = Json::array();
  for (std::size_t i = 0; i < result.cycles.size(); ++i) summary["cycles"].push_back(cycle_json(input, result, i));
  return summary;
}

Json geometry_of(const ResultLayout& layout) {
  Json geometry = Json::object();
  for (const NamedNumbers& one : layout.scalars) geometry[one.name] = one.values.front();
  for (const NamedNumbers& one : layout.at_bumps) geometry[one.name] = one.values;
  for (const NamedNumbers& one : layout.at_feet) geometry[one.name] = one.values;
  for (const NamedNumbers& one : layout.at_pads) geometry[one.name] = one.values;
  return geometry;
}

/// Sizes of the dimensions of nodes.
Json nodes_of(const ResultLayout& layout) {
  Json nodes{{"bump", layout.bumps}, {"foot", layout.feet}};
  if (layout.pads > 1) nodes["pad"] = layout.pads;
  return nodes;
}

}  // namespace

bool is_left_out(std::string_view field) {
  return field.starts_with("gap_") || field == "friction_force_journal_top" || field == "compression";
}

bool is_reduced(std::string_view field) {
  return field.starts_with("stress_");
}

Json shown_quantity(const VariableMeaning& meaning) {
  return {{"name", meaning.name},
          {"key", meaning.key()},
          {"label", meaning.label},
          {"unit", meaning.unit == "1" ? "" : meaning.unit},
          {"whole", meaning.form.kind == Form::whole},
          {"of_solver", (meaning.tags & tag::of_solver) != 0},
          {"first", (meaning.tags & (tag::headline | tag::shown_first)) != 0},
          {"leads", (meaning.tags & tag::leading) != 0},
          {"key_figure", (meaning.tags & tag::key_figure) != 0},
          {"listed", (meaning.tags & (tag::csv | tag::of_solver)) != 0 || meaning.shown.size > 0.0},
          {"meaning", meaning.long_name}};
}

VariableMeaning labelled(VariableMeaning meaning) {
  meaning.label = shown_label(meaning.label, meaning.name);
  return meaning;
}

std::string shown_label(std::string_view label, std::string_view name) {
  if (!label.empty()) return std::string(label);
  if (name.starts_with("kx") || name.starts_with("ky") || name.starts_with("cx") || name.starts_with("cy")) {
    return fmt::format("{}{}, {}{}", name.find("_whirl") == std::string_view::npos ? "" : "whirl ",
                       name.front() == 'k' ? "stiffness" : "damping", name.substr(1, 2),
                       name.ends_with("_stuck") ? ", full stick" : "");
  }
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

void add_clearances(const std::vector<double>& forces, Json& quantities) {
  auto place = quantities.end();
  for (auto one = quantities.begin(); one != quantities.end(); ++one) {
    if ((*one)["name"] == "first_contact" || (*one)["name"] == "take_up") place = std::next(one);
  }
  for (const VariableMeaning& clearance : clearance_quantities(forces)) {
    place = std::next(quantities.insert(place, shown_quantity(clearance)));
  }
}

Json shown_run(const Case& input, const CycleResult& result) {
  BUMPFOIL_ASSERT(result.experiment == Experiment::cycle);
  const ResultLayout layout = make_result_layout(input, result.experiment);
  const Wording wording = wording_of(input, result.experiment);
  Json run{{"kind", name_of(result.experiment)},
           {"attributes", {{"title", input.title}}},
           {"summary", summary_of(input, result)},
           {"meanings", Json::object()},
           {"geometry", geometry_of(layout)},
           {"nodes", nodes_of(layout)},
           {"last_increment", layout.increments - 1},
           {"cycles", Json::array()},
           {"quantities", Json::array()}};
  if (Json deviations = shown_deviations(input); !deviations.is_null()) run["deviations"] = std::move(deviations);
  const std::vector<IncrementQuantity> quantities = increment_quantities(result.experiment, result.over_width);
  for (const Cycle& cycle : result.cycles) run["cycles"].push_back(cycle_data(cycle, quantities));
  const auto explain = [&](const auto& quantity) {
    run["meanings"][std::string(quantity.name)] = {{"unit", quantity.unit == "1" ? "" : quantity.unit},
                                                   {"text", spelled(quantity.long_name, wording)}};
  };
  for (const IncrementQuantity& quantity : quantities) explain(quantity);
  for (const FieldQuantity& quantity : field_quantities()) {
    if (!quantity.is(tag::of_width_alone)) explain(quantity);
  }
  for (const CycleQuantity& quantity : cycle_quantities(result.experiment, result.over_width)) {
    explain(quantity);
    if (quantity.label.empty()) continue;
    VariableMeaning meaning = quantity.meaning();
    meaning.long_name = spelled(quantity.long_name, wording);
    run["quantities"].push_back(shown_quantity(meaning));
  }
  add_clearances(input.settings.get<CycleSettings>().clearance_forces, run["quantities"]);
  return run;
}

}  // namespace bumpfoil
