#include "ensemble/ensemble_summary.hpp"

#include <fmt/format.h>

#include <utility>

#include "bumpfoil/ensemble/ensemble_table.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "ensemble/statistics_json.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json place_json(const EnsembleLayout& layout, const PlaceStatistics& found) {
  Json json;
  for (std::size_t k = 1; k < layout.columns.size(); ++k) {
    const EnsembleColumn& column = layout.columns[k];
    json[column.meaning.key()] = statistics_json(found.columns[k]);
  }
  return json;
}

Json loads_json(const PlaceStatistics& found) {
  Json json{{"mean_N", Json::array()}, {"std_N", Json::array()}};
  for (const Statistics& load : found.bump_loads) {
    json["mean_N"].push_back(value_json(load.mean));
    json["std_N"].push_back(value_json(load.deviation));
  }
  return json;
}

/// Sensitivities of a quantity, by the factor names of [montecarlo].
Json sensitivities_json(const Case& input, const std::vector<double>& found) {
  Json json;
  std::size_t next = 0;
  if (input.montecarlo->bump_height) {
    const std::size_t strips = strips_drawn_apart(input);
    Json heights = Json::array();
    for (std::size_t strip = 0; strip < strips; ++strip) {
      Json of_strip = Json::array();
      for (int bump = 0; bump < total_bumps(input); ++bump) of_strip.push_back(value_json(found[next++]));
      heights.push_back(std::move(of_strip));
    }
    json["bump_height"] = strips == 1 ? heights.front() : heights;
  }
  for (const ScatteredNumber& number : scattered_numbers()) {
    if ((*input.montecarlo).*number.distribution) json[std::string(number.name)] = value_json(found[next++]);
  }
  return json;
}

Json sensitivities_json(const Case& input, const EnsembleLayout& layout, const PlaceStatistics& found) {
  Json json = Json::object();
  for (std::size_t k = 1; k < layout.columns.size(); ++k) {
    if (found.sensitivities[k].empty()) continue;
    json[layout.columns[k].meaning.name] = sensitivities_json(input, found.sensitivities[k]);
  }
  return json;
}

Json yield_json(const Yield& yield) {
  return {{"passed", yield.passed}, {"samples", yield.samples}, {"interval_95", {yield.low, yield.high}}};
}

}  // namespace

Json ensemble_lists(const Case& input, const EnsembleLayout& layout, const EnsembleStatistics& statistics,
                    const EnsembleYields& yields) {
  Json json;
  json["sampled_command"] = input.montecarlo->command;
  json["seed"] = input.montecarlo->seed;
  json["samples_due"] = input.montecarlo->samples;
  json["samples"] = statistics.samples;
  json["statistics"] = Json::object();
  json["bump_loads"] = Json::object();
  json["sensitivities"] = Json::object();
  for (std::size_t i = 0; i < layout.places.size(); ++i) {
    const std::string& name = layout.places[i].name;
    json["statistics"][name] = place_json(layout, statistics.places[i]);
    if (layout.loads() > 0) json["bump_loads"][name] = loads_json(statistics.places[i]);
    json["sensitivities"][name] = sensitivities_json(input, layout, statistics.places[i]);
  }
  json["limits"] = Json::array();
  for (std::size_t i = 0; i < yields.limits.size(); ++i) {
    Json limit = yield_json(yields.each[i]);
    limit["limit"] = yields.limits[i].text;
    json["limits"].push_back(std::move(limit));
  }
  if (!yields.limits.empty()) json["yield"] = yield_json(yields.all);
  json["failed"] = Json::array();
  for (const SampleFailure& failure : statistics.failures) {
    Json failed{{"sample", failure.sample}};
    const EnsemblePlace& place = layout.places[failure.place];
    // Directions by their angle, states by their name; there is only one rotor.
    if (layout.place.form.kind == Form::real) {
      failed[layout.place.key()] = place.at;
    } else if (place.name != layout.place.name) {
      failed[layout.place.name] = place.name;
    }
    failed["status"] = layout.status_name(failure.status);
    failed["reason"] = layout.status_reason(failure.status);
    json["failed"].push_back(std::move(failed));
  }
  return json;
}

}  // namespace bumpfoil
