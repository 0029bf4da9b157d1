#include "experiments/fit/fit_model.hpp"

#include <fmt/format.h>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "experiments/fit/fit_keys.hpp"

namespace bumpfoil {
namespace {

std::unique_ptr<const MeasuredData> measured_of(const FitData& data, const Case& input) {
  switch (data.experiment) {
    case FittedExperiment::vibration:
      return measured_vibrations(data, input);
    case FittedExperiment::equilibrium:
      return measured_equilibria(data);
    default:
      return measured_loop(data, input);
  }
}

}  // namespace

FitModel::FitModel(const Case& input) : settings_(input.settings.get<FitSettings>()) {
  Case bare = input;
  bare.settings.remove<FitSettings>();
  text_ = case_to_toml(bare);
  bare.montecarlo.reset();
  for (const FitData& data : settings_.data) {
    data_.push_back(measured_of(data, bare));
    texts_.push_back(case_to_toml(data_.back()->case_for(bare)));
  }
}

std::vector<std::string> FitModel::overrides(const std::vector<double>& values) const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const std::string& key : keys_set_by(settings_.parameters[i].key)) {
      all.push_back(fmt::format("{}={:.17g}", key, values[i]));
    }
  }
  return all;
}

Case FitModel::case_with(const std::vector<double>& values) const {
  return parse_case(text_, "", {.overrides = overrides(values), .commands = {}});
}

Case FitModel::case_of_data(std::size_t i, const std::vector<double>& values) const {
  return parse_case(texts_[i], "",
                    {.overrides = overrides(values), .commands = {std::string(name_of(settings_.data[i].experiment))}});
}

std::optional<std::vector<DataAnswer>> FitModel::answers(const std::vector<double>& values) const {
  FitSettings settings;  // only to set its rigs
  settings.machine_stiffness = settings_.machine_stiffness;
  for (const FitData& data : settings_.data) settings.data.push_back({.rig = data.rig});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& key = settings_.parameters[i].key;
    if (is_of_rig(key)) set_rig(settings, key, values[i]);
  }
  std::vector<DataAnswer> all;
  for (std::size_t i = 0; i < data_.size(); ++i) {
    Rig rig = settings.data[i].rig;
    if (!rig.machine_stiffness) rig.machine_stiffness = settings.machine_stiffness;
    try {
      auto answer = data_[i]->answer(case_of_data(i, values), rig);
      if (!answer) return std::nullopt;
      all.push_back(std::move(*answer));
    } catch (const Error&) {
      return std::nullopt;  // no valid bearing
    }
  }
  return all;
}

}  // namespace bumpfoil
