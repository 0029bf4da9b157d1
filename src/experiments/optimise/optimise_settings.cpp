#include "bumpfoil/experiments/optimise/optimise_settings.hpp"

#include <algorithm>
#include <string>

#include "case/case_keys.hpp"
#include "experiments/fit/fit_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

constexpr int most_evaluations = 100'000;
constexpr int most_searches = 100;
constexpr int most_between = 100;
constexpr Range tolerance_range{1e-6, 0.1, ""};

void describe(CaseVisitor& keys, OptimisedKey& one) {
  using enum Presence;
  keys.value({"key", required, "Key", "a real-valued key of the case", "\"bearing.radial_clearance\""}, &one.key);
  const auto of_key = [&one](auto... rest) { return key_in_unit_of(one.key, rest...); };
  keys.value(of_key("lower", required, "Lower bound", "with the unit of the key", "\"20 um\""), &one.lower);
  keys.value(of_key("upper", required, "Upper bound", "", "\"40 um\""), &one.upper);
  keys.value(of_key("start", optional, "Start", "by default the value in the case", "\"30 um\""), &one.start);
  keys.value({"log", defaulted, "Logarithmic", "true: steps in the logarithm, between positive bounds"}, &one.log);
}

void describe(CaseVisitor& keys, OptimiseSettings& optimise) {
  using enum Presence;
  static const std::vector<std::string_view> commands = [] {
    std::vector<std::string_view> names = swept_experiments();
    names.emplace_back("montecarlo");
    return names;
  }();
  keys.choice({"command", defaulted, "Command", "command that is run at every point; \"montecarlo\": an ensemble"},
              commands, optimise.command);
  keys.value({"maximise", optional, "Maximise",
              "quantity of result.nc whose smallest value over all directions or states is maximised; of an ensemble "
              "\"yield\", or one with a statistic, such as \"h_min.p5\"",
              "[\"h_min\"]"},
             &optimise.maximise);
  keys.value({"minimise", optional, "Minimise",
              "quantity whose largest value is minimised; two aims in all make a front", "[\"power\"]"},
             &optimise.minimise);
  keys.value({"limits", optional, "Limits", "limits that the result must meet in every direction or state",
              "[\"h_min > 5 um\"]"},
             &optimise.limits);
  keys.value({"bearing_limits", optional, "Limits of a bearing",
              "of an ensemble: limits that a bearing must meet to count in the yield", "[\"h_min > 5 um\"]"},
             &optimise.bearing_limits);
  keys.value({"evaluations", defaulted, "Evaluations", "maximum number of points"}, &optimise.evaluations);
  keys.value(
      {"starts", defaulted, "Starts",
       "number of searches, the first from the starts of the keys, the others from the best of evenly spread points"},
      &optimise.starts);
  keys.value({"tolerance", defaulted, "Tolerance",
              "of the keys, relative to the distance between their bounds, at which a search ends"},
             &optimise.tolerance);
  keys.value({"front", defaulted, "Points of the front", "between its ends, of two aims"}, &optimise.front);
  keys.value({"seed", defaulted, "Seed",
              "of the evenly spread points; ensembles draw by montecarlo.seed, the same at all points"},
             &optimise.seed);
  list_of_tables(keys, {"key", required, "Key", "one for each key that is chosen, at most five"}, optimise.keys,
                 [](CaseVisitor& inner, OptimisedKey& one) { describe(inner, one); });
}

void describe_optimise(CaseVisitor& keys, Case& input) {
  settings_table<OptimiseSettings>(
      keys, {"optimise", Presence::optional, "Optimisation", "of keys of the case, for the command optimise"},
      input.settings, describe);
}

void check_key(Checks& checks, const OptimisedKey& one, const std::string& key) {
  const bool of_table = one.key.starts_with("optimise.") || is_of_rig(one.key);
  if (!checks.require(!of_table && is_fitted_key(one.key), key + ".key", one.key,
                      "is not a real-valued key that can be chosen", advice_on_fitted(one.key))) {
    return;
  }
  const std::optional<Dimension> dimension = dimension_of(one.key);
  const std::string_view unit = dimension ? si_unit(*dimension) : "";
  checks.finite(key + ".lower", one.lower, unit);
  checks.finite(key + ".upper", one.upper, unit);
  if (!checks.require(one.lower < one.upper, key + ".upper", quantity(one.upper, unit),
                      fmt::format("is not above lower, {}", quantity(one.lower, unit)),
                      "give bounds that leave room between them")) {
    return;
  }
  checks.require(!one.log || one.lower > 0.0, key + ".lower", quantity(one.lower, unit),
                 "is not positive, but steps are in the logarithm",
                 "give a positive lower bound, or remove log = true");
  checks.require(!one.start || (*one.start >= one.lower && *one.start <= one.upper), key + ".start",
                 quantity(one.start.value_or(0.0), unit), "lies outside the bounds", "start between lower and upper");
}

void check_optimise(Checks& checks, const Case& input, const CheckedBumpFoil& /*foil*/) {
  const OptimiseSettings* const held = input.settings.find<OptimiseSettings>();
  if (held == nullptr) return;
  const OptimiseSettings& optimise = *held;
  const CaseTable* const run = case_table_of(optimise.command);
  checks.require(optimise.runs_ensembles() || (run != nullptr && run->swept), "optimise.command", optimise.command,
                 "is not a command that can be optimised",
                 fmt::format("give montecarlo, or one of {}", fmt::join(swept_experiments(), ", ")));
  const std::size_t aims = optimise.maximise.size() + optimise.minimise.size();
  checks.require_for("optimise", aims > 0, "optimise.maximise", "", "is missing",
                     "give a quantity to maximise, or one to minimise");
  checks.require(aims <= 2, "optimise.minimise", "", fmt::format("makes {} aims", aims),
                 "give one or two aims, and limits in place of others");
  checks.require_for("optimise", optimise.bearing_limits.empty() || optimise.runs_ensembles(),
                     "optimise.bearing_limits", "", "are those of an ensemble",
                     "set command = \"montecarlo\", or write them into limits");
  checks.require_for("optimise", !optimise.keys.empty(), "optimise.key", "", "is missing",
                     "add [[optimise.key]] with a key and its bounds");
  checks.require(std::ssize(optimise.keys) <= most_optimised_keys, "optimise.key", "",
                 fmt::format("names {} keys", optimise.keys.size()),
                 fmt::format("give at most {}, those that matter most", most_optimised_keys));
  checks.count("optimise.evaluations", optimise.evaluations, "points", {1, most_evaluations});
  checks.count("optimise.starts", optimise.starts, "searches", {1, most_searches});
  checks.within("optimise.tolerance", optimise.tolerance, tolerance_range);
  checks.count("optimise.front", optimise.front, "points", {0, most_between});
  for (std::size_t i = 0; i < optimise.keys.size(); ++i) {
    const std::string key = fmt::format("optimise.key[{}]", i + 1);
    check_key(checks, optimise.keys[i], key);
    const auto same = [&](const OptimisedKey& other) { return other.key == optimise.keys[i].key; };
    const auto self = optimise.keys.begin() + static_cast<std::ptrdiff_t>(i);
    checks.require(std::none_of(optimise.keys.begin(), self, same), key + ".key", optimise.keys[i].key,
                   "is chosen twice", "give it once");
  }
}

}  // namespace

CaseTable optimise_settings() {
  return {.experiment = "optimise",
          .needs = "optimise",
          .describe = describe_optimise,
          .check = check_optimise,
          .given = gives<OptimiseSettings>,
          .requested_part = [](const Case& input) -> std::string_view {
            const OptimiseSettings* const held = input.settings.find<OptimiseSettings>();
            return held == nullptr ? std::string_view() : held->command;
          }};
}

}  // namespace bumpfoil
