#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_states_shown = 24;
constexpr std::size_t most_frequencies = 8;

/// Dynamic coefficients at the rotation frequency are the synchronous ones.
std::string label_of(const RunningQuantity& quantity, const EquilibriumResult& result) {
  constexpr std::string_view dynamic = "dynamic";
  const bool synchronous = std::all_of(result.states.begin(), result.states.end(), [](const RunningState& state) {
    return std::all_of(state.whirls.begin(), state.whirls.end(),
                       [&](const FilmWhirl& whirl) { return whirl.frequency == std::abs(state.requested.speed); });
  });
  if (!synchronous || !quantity.label.starts_with(dynamic)) return std::string(quantity.label);
  return fmt::format("synchronous{}", quantity.label.substr(dynamic.size()));
}

/// Values of a quantity of some states for people: zero where only round-off is left of symmetry or equilibrium, and
/// bumps as tables call them.
void add_quantity(const EquilibriumResult& result, const RunningQuantity& quantity, std::vector<double> values,
                  Table& table) {
  VariableMeaning meaning = quantity.meaning();
  meaning.label = label_of(quantity, result);
  for (double& value : values) {
    if (std::abs(value) < 1e-9 * quantity.shown.size) value = 0.0;
  }
  const bool known = std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (!known) return;
  if (!quantity.is(tag::is_bump)) {
    table.add(std::move(meaning), std::move(values));
    return;
  }
  table.add(std::move(meaning), each(values, [&](double value) -> std::string {
              return std::isfinite(value) ? running_bump_text(*result.bearing, static_cast<int>(value) - 1) : "-";
            }));
}

/// Fraction of the force on each of several pads.
void add_pads(const EquilibriumResult& result, std::span<const RunningState> states, Table& table) {
  const std::size_t pads = result.bearing->film->pads.size();
  for (std::size_t k = 0; pads > 1 && k < pads; ++k) {
    table.add(shown_column(fmt::format("force of pad {}", k + 1), shown::newtons),
              each(states, [k](const RunningState& state) {
                return state.found() ? state.outcome->pad_forces.col(static_cast<Eigen::Index>(k)).norm() : absent;
              }));
  }
}

/// Dynamic stiffness and damping at the frequencies after the first, which is among the quantities.
/// @return the number of frequencies
std::size_t add_whirls(std::span<const RunningState> states, Table& table) {
  std::size_t frequencies = 0;
  for (const RunningState& state : states) frequencies = std::max(frequencies, state.whirls.size());
  const auto add = [&](VariableMeaning meaning, std::size_t k, const auto& value) {
    table.add(std::move(meaning), each(states, [k, &value](const RunningState& state) {
                return state.found() && k < state.whirls.size() ? value(state.whirls[k]) : absent;
              }));
  };
  for (std::size_t k = 1; k < std::min(frequencies, most_frequencies); ++k) {
    add(shown_column("whirl frequency", shown::revolutions), k, [](const FilmWhirl& whirl) { return whirl.frequency; });
    for (const WhirlQuantity& quantity : whirl_quantities(2)) {
      if (!quantity.suffix.empty()) continue;
      add({quantity.name(),
           quantity.unit,
           "",
           {},
           fmt::format("whirl frequency: {}, {}", quantity.damping ? "damping" : "stiffness", quantity.axes),
           quantity.damping ? shown::damping : shown::stiffness},
          k, quantity.value);
    }
  }
  return frequencies;
}

std::string spread_lines(const EquilibriumResult& result) {
  std::string out;
  for (const PathSpread& spread : path_spreads(result)) {
    const RunningState& first = result.states[spread.states.front()];
    Table table;
    table.add(shown_column(""), std::vector<std::string>{"smallest", "largest"});
    for (const RunningQuantity& quantity : running_quantities(*result.bearing)) {
      if (quantity.shown.size == 0.0 || quantity.is(tag::requested)) continue;
      std::vector<double> values =
          each(spread.states, [&](std::size_t i) { return value_of(quantity, *result.bearing, result.states[i]); });
      std::erase_if(values, [](double value) { return !std::isfinite(value); });
      if (values.empty()) continue;
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      add_quantity(result, quantity, {*least, *most}, table);
    }
    out +=
        fmt::format("\n{} paths to {}\n{}", spread.states.size(), name_of_point(first.requested), table_blocks(table));
  }
  return out;
}

std::string limit_lines(const EquilibriumResult& result) {
  const auto bound = [](const FilmLimit& limit) {
    std::string word(name_of(limit.bounded_by));
    std::replace(word.begin(), word.end(), '_', ' ');
    return word;
  };
  std::string out;
  for (const FilmLimit& limit : result.limits) {
    if (!limit.found()) continue;
    const bool speed = limit.kind == FilmLimitKind::lift_off_speed;
    const auto neighbour = [&](const OperatingPoint& point, double h) {
      return fmt::format("{} at {}", std::isnan(h) ? "none" : fmt::format("{:.4g} um", 1e6 * h),
                         shown_limit_value(limit, speed ? std::abs(point.speed) : point.journal.norm()));
    };
    out += fmt::format("\n{}: {}, bounded by {} (minimum film thickness {}, {})", name_of_limit(limit),
                       std::isnan(limit.value) ? "none" : shown_limit_value(limit, limit.value), bound(limit),
                       neighbour(limit.thick, limit.h_thick), neighbour(limit.thin, limit.h_thin));
  }
  return out.empty() ? out : out + '\n';
}

}  // namespace

std::string equilibrium_table(const EquilibriumResult& result) {
  const std::span states = std::span(result.states).first(std::min(result.states.size(), most_states_shown));
  Table table;
  for (const RunningQuantity& quantity : running_quantities(*result.bearing)) {
    if (quantity.shown.size == 0.0) continue;
    add_quantity(result, quantity,
                 each(states, [&](const RunningState& state) { return value_of(quantity, *result.bearing, state); }),
                 table);
    if (quantity.name == "force_y") add_pads(result, states, table);
  }
  const std::size_t frequencies = add_whirls(states, table);
  std::string out = table_blocks(table) + left_out("frequencies", most_frequencies, frequencies) +
                    left_out("states", states.size(), result.states.size());
  return out + spread_lines(result) + limit_lines(result);
}

}  // namespace bumpfoil
