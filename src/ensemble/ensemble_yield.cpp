#include "bumpfoil/ensemble/ensemble_yield.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/nearest_name.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "case/csv_lines.hpp"
#include "case/units.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view limit_option = "--limit";

/// The dimension of a quantity in this unit; absent where it has none, or one that cases know not.
std::optional<Dimension> dimension_in(std::string_view unit) {
  for (const Dimension dimension :
       {Dimension::length, Dimension::force, Dimension::stiffness, Dimension::pressure, Dimension::frequency}) {
    if (si_unit(dimension) == unit) return dimension;
  }
  return std::nullopt;
}

/// @throws Error (input)
EnsembleLimit parse_limit(const std::string& text, const EnsembleLayout& layout) {
  const auto refuse = [&text](std::string what, std::string advice) {
    throw Error(ErrorKind::input, {{"", 0, std::string(limit_option), text, std::move(what), std::move(advice)}});
  };
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos) refuse("has no < and no >", "write a limit such as \"clearance_5N > 20 um\"");
  const std::string name(trimmed(std::string_view(text).substr(0, sign)));
  const std::string value(trimmed(std::string_view(text).substr(sign + 1)));
  const auto found = std::find_if(layout.columns.begin(), layout.columns.end(),
                                  [&name](const EnsembleColumn& column) { return column.meaning.name == name; });
  if (found == layout.columns.end() || found->meaning.form.kind != Form::real) {
    std::vector<std::string> names;
    for (const EnsembleColumn& column : layout.columns) {
      if (column.meaning.form.kind == Form::real) names.push_back(column.meaning.name);
    }
    const auto nearest = nearest_name(name, names);
    refuse("does not name a quantity of the ensemble",
           nearest ? fmt::format("did you mean \"{}\"?", *nearest) : "ensemble.nc has their names");
  }
  if (!found->limitable) {
    refuse("does not exist for rotors that whirl nowhere, nor for those that whirl at all speeds",
           "write the limit for stable_up_to: \"stable_up_to > 12000 rpm\"");
  }
  EnsembleLimit limit{text, static_cast<std::size_t>(found - layout.columns.begin()), text[sign] == '>', 0.0};
  if (const std::optional<double> number = parse<double>(value)) {
    limit.bound = *number;
  } else if (const std::optional<Dimension> dimension = dimension_in(found->meaning.unit)) {
    const auto quantity = parse_quantity(value, *dimension);
    if (const auto* fault = std::get_if<QuantityFault>(&quantity)) refuse(fault->what, fault->advice);
    limit.bound = std::get<double>(quantity);
  } else {
    refuse("does not end with a number", found->meaning.unit == "1"
                                             ? "write a number without a unit"
                                             : fmt::format("write a number in {}", found->meaning.unit));
  }
  if (!std::isfinite(limit.bound)) refuse("is not finite", "give a finite number");
  return limit;
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
  std::vector<Fault> faults;
  for (const std::string& text : texts) {
    try {
      limits.push_back(parse_limit(text, layout));
    } catch (const Error& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw Error(ErrorKind::input, std::move(faults));
  return limits;
}

EnsembleYields make_yields(std::vector<EnsembleLimit> limits, const EnsembleLayout& layout, const RowLog& log) {
  const auto keep = [&](std::vector<bool>& passes, std::size_t column, const auto& passing) {
    for (std::size_t place = 0; place < layout.places.size(); ++place) {
      const std::vector<double> values = log.column(layout.entry(place, column));
      for (std::size_t i = 0; i < values.size(); ++i) passes[i] = passes[i] && passing(values[i]);
    }
  };
  std::vector<bool> converged(log.rows(), true);
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
