#include "optimise/optimise_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/key_list.hpp"
#include "core/collect_errors.hpp"
#include "experiments/fit/fit_keys.hpp"
#include "optimise/point_runner.hpp"

namespace bumpfoil {
namespace {

OptimisedQuantity quantity_of(const PointRunner& runner, std::size_t number, bool largest) {
  const LimitedQuantity named = runner.quantities()[number];
  const ShownUnit shown = runner.shown(number);
  return {named.name, named.unit, shown.size > 0.0 ? shown : ShownUnit{}, largest};
}

LimitWords words_for(const std::string& key, const OptimiseSettings& settings) {
  if (settings.runs_ensembles()) {
    return {
        key, "the ensemble",
        settings.bearing_limits.empty()
            ? "give a quantity with a statistic, such as \"h_min.mean\" or \"h_min.p5\"; a yield needs bearing_limits"
            : "give \"yield\", or a quantity with a statistic, such as \"h_min.mean\" or \"h_min.p5\"",
        "yield > 0.95"};
  }
  return {key, fmt::format("`bumpfoil {}`", settings.command),
          "its result.nc, and sweep.nc of its sweeps, have their names", "h_min > 5 um"};
}

std::vector<InputError> errors_of_model(Case input, OptimiseSettings settings) {
  input.settings.set(std::move(settings));
  std::vector<InputError> errors;
  collect_errors(errors, [&] { const OptimiseModel model(input); });
  return errors;
}

/// Errors in quantities and limits that no result of the command has for any bearing: a small run already has all.
std::vector<InputError> errors_whatever_the_bearing(const Case& input, OptimiseSettings settings) {
  const bool ensemble = settings.runs_ensembles();
  if (ensemble && !input.montecarlo) return {};
  const std::string& command = ensemble ? input.montecarlo->command : settings.command;
  settings.keys.clear();
  std::optional<std::vector<InputError>> all;
  for (const std::vector<std::string>& keys : experiment_named(command).small_runs) {
    Case reference = parse_case(case_template("gen1"), "", {.overrides = keys, .commands = {command}});
    reference.montecarlo = input.montecarlo;
    const std::vector<InputError> own = errors_of_model(std::move(reference), settings);
    if (!all) all = own;
    std::erase_if(*all, [&own](const InputError& error) {
      return std::none_of(own.begin(), own.end(), [&error](const InputError& other) { return other.key == error.key; });
    });
  }
  return all.value_or(std::vector<InputError>{});
}

}  // namespace

OptimiseModel::OptimiseModel(const Case& input) : settings_(input.settings.get<OptimiseSettings>()) {
  Case bare = input;
  bare.settings.remove<OptimiseSettings>();
  text_ = case_to_toml(bare);
  std::vector<InputError> errors;
  runner_ = make_point_runner(bare, settings_, errors);
  read_aims(errors);
  read_limits(errors);
  find_start(bare, errors);
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

OptimiseModel::~OptimiseModel() = default;

void OptimiseModel::read_aims(std::vector<InputError>& errors) {
  const std::vector<LimitedQuantity> quantities = runner_->quantities();
  const auto read = [&](const std::vector<std::string>& names, bool maximise) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string key = fmt::format("optimise.{}[{}]", maximise ? "maximise" : "minimise", i + 1);
      collect_errors(errors, [&] {
        const std::size_t number = parse_quantity_name(names[i], quantities, words_for(key, settings_));
        aims_.push_back({quantity_of(*runner_, number, !maximise), maximise});
      });
    }
  };
  read(settings_.maximise, true);
  read(settings_.minimise, false);
}

void OptimiseModel::read_limits(std::vector<InputError>& errors) {
  const std::vector<LimitedQuantity> quantities = runner_->quantities();
  for (std::size_t i = 0; i < settings_.limits.size(); ++i) {
    collect_errors(errors, [&] {
      const std::string& text = settings_.limits[i];
      const QuantityLimit limit =
          parse_quantity_limit(text, quantities, words_for(fmt::format("optimise.limits[{}]", i + 1), settings_));
      limits_.push_back({text, quantity_of(*runner_, limit.quantity, !limit.above), limit.above, limit.bound});
    });
  }
}

void OptimiseModel::find_start(const Case& bare, std::vector<InputError>& errors) {
  const std::vector<ListedKey> held = list_keys(bare);
  for (const OptimisedKey& one : settings_.keys) {
    const std::optional<Dimension> dimension = dimension_of(one.key);
    key_units_.emplace_back(dimension ? si_unit(*dimension) : "1");
    const ListedKey* const listed = find_key(held, keys_set_by(one.key).front());
    const bool known = listed != nullptr && listed->value.is_number();
    const double own = known ? listed->value.get<double>() : 0.5 * (one.lower + one.upper);
    start_.push_back(one.start.value_or(std::clamp(own, one.lower, one.upper)));
  }
  collect_errors(errors, [&] { static_cast<void>(case_with(start_)); });
}

Case OptimiseModel::case_with(const std::vector<double>& values) const {
  CaseRequest request{.overrides = {}, .commands = {settings_.command}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const std::string& key : keys_set_by(settings_.keys[i].key)) {
      request.overrides.push_back(fmt::format("{}={:.17g}", key, values[i]));
    }
  }
  return parse_case(text_, "", request);
}

std::optional<OptimisePoint> OptimiseModel::evaluate(const std::vector<double>& values,
                                                     const ProgressCallback& progress,
                                                     std::vector<std::string>* warnings) const {
  OptimisePoint point{.values = values};
  std::vector<OptimisedQuantity> wanted;
  wanted.reserve(aims_.size() + limits_.size());
  for (const OptimiseAim& aim : aims_) wanted.push_back(aim.quantity);
  for (const OptimiseLimit& limit : limits_) wanted.push_back(limit.quantity);
  PointRun run;
  try {
    run = runner_->run(case_with(values), wanted, progress);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    point.status = PointStatus::not_physical;
    point.message = format_error(error.errors().front());
    return point;
  }
  if (run.status == RunStatus::interrupted) return std::nullopt;
  if (warnings != nullptr) *warnings = run.warnings;
  if (run.status == RunStatus::failed) {
    point.status = PointStatus::failed;
    point.message = run.failures.empty() ? "" : run.failures.front();
    return point;
  }
  const auto missing =
      std::find_if(run.values.begin(), run.values.end(), [](double one) { return !std::isfinite(one); });
  if (missing != run.values.end()) {
    point.status = PointStatus::no_value;
    point.message = fmt::format("{} has no value", wanted[static_cast<std::size_t>(missing - run.values.begin())].name);
    return point;
  }
  const auto end_of_aims = run.values.begin() + std::ssize(aims_);
  point.aims.assign(run.values.begin(), end_of_aims);
  point.limits.assign(end_of_aims, run.values.end());
  return point;
}

std::vector<InputError> optimise_errors(const Case& input) {
  OptimiseSettings settings = input.settings.get<OptimiseSettings>();
  Case bare = input;
  bare.settings.remove<OptimiseSettings>();
  if (!find_errors(bare).empty()) return errors_whatever_the_bearing(input, std::move(settings));
  // Errors of keys are reported by [optimise] itself; the quantities do not depend on them.
  std::erase_if(settings.keys,
                [](const OptimisedKey& one) { return !is_fitted_key(one.key) || !(one.lower < one.upper); });
  return errors_of_model(std::move(bare), std::move(settings));
}

}  // namespace bumpfoil
