#include "bumpfoil/ensemble/ensemble_yield.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "results/quantity_limit.hpp"

namespace bumpfoil {
namespace {

/// @throws Error (input)
EnsembleLimit parse_limit(const std::string& text, const EnsembleLayout& layout) {
  std::vector<std::size_t> columns;
  std::vector<LimitedQuantity> quantities;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const VariableMeaning& meaning = layout.columns[i].meaning;
    if (meaning.form.kind != Form::real) continue;
    columns.push_back(i);
    quantities.push_back({meaning.name, meaning.unit});
  }
  const QuantityLimit limit = parse_quantity_limit(
      text, quantities, {"--limit", "the ensemble", "ensemble.nc has their names", "clearance_5N > 20 um"});
  const std::size_t column = columns[limit.quantity];
  if ((layout.columns[column].meaning.tags & tag::no_limits) != 0) {
    throw Error(ErrorKind::input, {{"", 0, "--limit", text, "is absent both in the best samples and in the worst",
                                    fmt::format("set a limit on {}", layout.target)}});
  }
  return {text, column, limit.above, limit.bound};
}

Yield yield_of(const std::vector<bool>& passes) {
  Yield yield{.passed = static_cast<std::size_t>(std::count(passes.begin(), passes.end(), true)),
              .samples = passes.size()};
  if (passes.empty()) return {.passed = 0, .samples = 0, .low = 0.0, .high = 1.0};
  constexpr double z = 1.959963984540054;  // two-sided 95 % of a normal distribution
  const auto n = static_cast<double>(yield.samples);
  const double part = static_cast<double>(yield.passed) / n;
  const double middle = (part + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(part * (1.0 - part) / n + z * z / (4.0 * n * n));
  yield.low = std::max(0.0, middle - half);
  yield.high = std::min(1.0, middle + half);
  return yield;
}

}  // namespace

std::vector<EnsembleLimit> parse_limits(const std::vector<std::string>& texts, const EnsembleLayout& layout) {
  std::vector<EnsembleLimit> limits;
  std::vector<InputError> errors;
  for (const std::string& text : texts) {
    try {
      limits.push_back(parse_limit(text, layout));
    } catch (const Error& error) {
      errors.insert(errors.end(), error.errors().begin(), error.errors().end());
    }
  }
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
  return limits;
}

EnsembleYields make_yields(std::vector<EnsembleLimit> limits, const EnsembleLayout& layout, const RowLog& log) {
  return make_yields(std::move(limits), layout, log.rows(), [&](std::size_t entry) { return log.column(entry); });
}

EnsembleYields make_yields(std::vector<EnsembleLimit> limits, const EnsembleLayout& layout, std::size_t samples,
                           const std::function<std::vector<double>(std::size_t entry)>& values_of_entry) {
  const auto keep = [&](std::vector<bool>& passes, std::size_t column, const auto& passing) {
    for (std::size_t place = 0; place < layout.places.size(); ++place) {
      const std::vector<double> values = values_of_entry(layout.entry(place, column));
      for (std::size_t i = 0; i < values.size(); ++i) passes[i] = passes[i] && passing(values[i]);
    }
  };
  std::vector<bool> converged(samples, true);
  keep(converged, 0, [](double status) { return status == 0.0; });
  std::vector<bool> all = converged;
  EnsembleYields yields{.limits = std::move(limits), .each = {}, .all = {}};
  for (const EnsembleLimit& limit : yields.limits) {
    const bool largest = layout.columns[limit.column].undefined == Undefined::largest;
    std::vector<bool> passes = converged;
    keep(passes, limit.column, [&](double value) {
      if (std::isnan(value) && largest) value = std::numeric_limits<double>::infinity();
      return limit.above ? value > limit.bound : value < limit.bound;
    });
    for (std::size_t i = 0; i < passes.size(); ++i) all[i] = all[i] && passes[i];
    yields.each.push_back(yield_of(passes));
  }
  yields.all = yield_of(all);
  return yields;
}

std::string yield_text(const EnsembleYields& yields) {
  if (yields.limits.empty()) return "";
  const Yield& all = yields.all;
  const double part = static_cast<double>(all.passed) / static_cast<double>(all.samples);
  return fmt::format("yield: {} of {} bearings, {:.1f} % ({:.1f} to {:.1f} %)\n", all.passed, all.samples, 100.0 * part,
                     100.0 * all.low, 100.0 * all.high);
}

}  // namespace bumpfoil
