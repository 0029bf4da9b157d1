#include "bumpfoil/experiments/result_schema.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "case/case_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> form_names{"real", "whole", "truth", "flag"};

constexpr std::array<std::pair<Tags, std::string_view>, 8> tag_names{{{tag::csv, "csv"},
                                                                      {tag::headline, "headline"},
                                                                      {tag::shown_first, "shown_first"},
                                                                      {tag::sampled, "sampled"},
                                                                      {tag::of_solver, "of_solver"},
                                                                      {tag::measured, "measured"},
                                                                      {tag::leading, "leading"},
                                                                      {tag::key_figure, "key_figure"}}};

Json variable_json(const Variable& variable, bool coordinate) {
  const VariableMeaning& meaning = variable.meaning;
  Json json{{"name", meaning.name},
            {"key", meaning.key()},
            {"unit", meaning.unit},
            {"long_name", meaning.long_name},
            {"form", form_names[meaning.form.kind]},
            {"dims", variable.dims},
            {"coordinate", coordinate}};
  if (!meaning.form.words.empty()) json["words"] = meaning.form.words;
  if (!meaning.label.empty()) json["label"] = meaning.label;
  if (meaning.shown.size > 0.0) json["shown"] = {{"unit", meaning.shown.name}, {"size", meaning.shown.size}};
  json["tags"] = Json::array();
  for (const auto& [tag, name] : tag_names) {
    if ((meaning.tags & tag) != 0) json["tags"].push_back(name);
  }
  return json;
}

Json runs_json(const ExperimentInfo& experiment) {
  const std::string text = case_template("gen1");
  Json runs = Json::array();
  std::set<std::string> listed;
  for (const std::vector<std::string>& keys : experiment.small_runs) {
    const Case input = parse_case(text, "", {.overrides = keys, .commands = {std::string(experiment.name)}});
    const Outcome outcome = experiment.run(input, {});
    const Dataset dataset = outcome.dataset();
    Json variables = Json::array();
    for (const std::vector<Variable>* some : {&dataset.coordinates, &dataset.variables}) {
      for (const Variable& variable : *some) {
        if (!listed.insert(variable.meaning.name).second) continue;
        variables.push_back(variable_json(variable, some == &dataset.coordinates));
      }
    }
    runs.push_back({{"set", keys}, {"variables", std::move(variables)}});
  }
  return runs;
}

}  // namespace

std::string result_schema() {
  Json json{{"schema", "bumpfoil-variables/1"}, {"experiments", Json::object()}};
  for (const ExperimentInfo& experiment : experiments()) {
    json["experiments"][std::string(experiment.name)] = runs_json(experiment);
  }
  return dump_json(json, 1) + '\n';
}

}  // namespace bumpfoil
