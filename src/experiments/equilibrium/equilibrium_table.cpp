#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/number_text.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t columns_per_block = 6;
constexpr std::size_t most_states_shown = 24;
constexpr std::size_t most_frequencies = 8;
constexpr std::size_t name_width = 26;
constexpr std::size_t unit_width = 6;
constexpr std::size_t column_width = 14;

std::string cell(const FilmBearing& bearing, const RunningQuantity& quantity, double value) {
  if (!std::isfinite(value)) return "-";
  if (quantity.is(tag::is_bump)) return running_bump_text(bearing, static_cast<int>(value) - 1);
  if (!quantity.form.words.empty()) return std::string(quantity.form.words[static_cast<std::size_t>(value)]);
  if (quantity.form.kind == Form::whole) return fmt::format("{}", value);
  // Removes round-off of values that are zero by symmetry or equilibrium.
  if (std::abs(value) < 1e-9 * quantity.shown.size) value = 0.0;
  return number_text(value, quantity.shown.size);
}

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

/// Whether a quantity is known for any of the states.
bool is_known(const EquilibriumResult& result, const RunningQuantity& quantity) {
  return std::any_of(result.states.begin(), result.states.end(), [&](const RunningState& state) {
    return std::isfinite(value_of(quantity, *result.bearing, state));
  });
}

/// Fraction of the force on each of several pads.
std::string pad_rows(const EquilibriumResult& result, std::size_t first, std::size_t end) {
  std::string out;
  const std::size_t pads = result.bearing->pads.size();
  for (std::size_t k = 0; pads > 1 && k < pads; ++k) {
    out += fmt::format("{:<{}}{:<{}}", fmt::format("  of pad {}, magnitude", k + 1), name_width, "N", unit_width);
    for (std::size_t i = first; i < end; ++i) {
      const RunningState& state = result.states[i];
      out += fmt::format(
          "{:>{}}",
          state.found() ? number_text(state.outcome->pad_forces.col(static_cast<Eigen::Index>(k)).norm(), 1.0) : "-",
          column_width);
    }
    out += '\n';
  }
  return out;
}

/// Dynamic stiffness and damping at the frequencies after the first, which is among the quantities.
std::string whirl_rows(const EquilibriumResult& result, std::size_t first, std::size_t end) {
  std::string out;
  std::size_t frequencies = 0;
  for (std::size_t i = first; i < end; ++i) frequencies = std::max(frequencies, result.states[i].whirls.size());
  const auto row = [&](const std::string& label, const ShownUnit& shown, std::size_t k, const auto& value) {
    out += fmt::format("{:<{}}{:<{}}", label, name_width, shown.name, unit_width);
    for (std::size_t i = first; i < end; ++i) {
      const RunningState& state = result.states[i];
      const double number = state.found() && k < state.whirls.size() ? value(state.whirls[k]) : absent;
      out += fmt::format("{:>{}}", std::isfinite(number) ? number_text(number, shown.size) : "-", column_width);
    }
    out += '\n';
  };
  for (std::size_t k = 1; k < std::min(frequencies, most_frequencies); ++k) {
    row("whirl frequency", shown::revolutions, k, [](const FilmWhirl& whirl) { return whirl.frequency; });
    for (const WhirlQuantity& quantity : whirl_quantities(2)) {
      if (!quantity.suffix.empty()) continue;
      row(fmt::format("  {}, {}", quantity.damping ? "damping" : "stiffness", quantity.axes),
          quantity.damping ? shown::damping : shown::stiffness, k, quantity.value);
    }
  }
  if (frequencies > most_frequencies) {
    out += fmt::format("{} more frequencies are in the files only\n", frequencies - most_frequencies);
  }
  return out;
}

std::string spread_lines(const EquilibriumResult& result) {
  std::string out;
  for (const PathSpread& spread : path_spreads(result)) {
    const RunningState& first = result.states[spread.states.front()];
    out += fmt::format("\n{} paths to {}\n", spread.states.size(), name_of_point(first.requested));
    for (const RunningQuantity& quantity : running_quantities(*result.bearing)) {
      if (quantity.label.empty() || quantity.is(tag::requested)) continue;
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (const std::size_t i : spread.states) {
        const double value = value_of(quantity, *result.bearing, result.states[i]);
        least = std::min(least, value);
        most = std::max(most, value);
      }
      if (!std::isfinite(least) || !std::isfinite(most)) continue;
      out += fmt::format("{:<{}}{:<{}}{:>{}} to{:>{}}\n", label_of(quantity, result), name_width, quantity.shown.name,
                         unit_width, cell(*result.bearing, quantity, least), column_width,
                         cell(*result.bearing, quantity, most), column_width);
    }
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
  std::string out;
  const std::size_t shown = std::min(result.states.size(), most_states_shown);
  for (std::size_t first = 0; first < shown; first += columns_per_block) {
    const std::size_t end = std::min(first + columns_per_block, shown);
    if (!out.empty()) out += '\n';
    for (const RunningQuantity& quantity : running_quantities(*result.bearing)) {
      if (quantity.label.empty() || !is_known(result, quantity)) continue;
      out += fmt::format("{:<{}}{:<{}}", label_of(quantity, result), name_width, quantity.shown.name, unit_width);
      for (std::size_t i = first; i < end; ++i) {
        const double value = value_of(quantity, *result.bearing, result.states[i]);
        out += fmt::format("{:>{}}", cell(*result.bearing, quantity, value), column_width);
      }
      out += '\n';
      if (quantity.name == "force_y") out += pad_rows(result, first, end);
    }
    out += whirl_rows(result, first, end);
  }
  if (shown < result.states.size()) {
    out += fmt::format("states {} to {} are in the files only\n", shown + 1, result.states.size());
  }
  return out + spread_lines(result) + limit_lines(result);
}

}  // namespace bumpfoil
