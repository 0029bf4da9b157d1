#include "bumpfoil/io/cycle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/io/summary.hpp"
#include "io/number_text.hpp"
#include "io/result_columns.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t columns_per_block = 6;
constexpr std::size_t name_width = 30;
constexpr std::size_t unit_width = 7;
constexpr std::size_t column_width = 13;

std::string direction_name(double direction) {
  const double degrees = to_degrees(direction);
  constexpr std::array axes{"+X", "+Y", "-X", "-Y"};
  const double turns = degrees - 360.0 * std::floor(degrees / 360.0);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (turns == 90.0 * static_cast<double>(i)) return axes[i];
  }
  return fmt::format("{:.6g} deg", degrees);
}

std::optional<double> tangent(const Cycle& cycle, std::optional<double> TangentStiffnesses::*member) {
  if (!cycle.turning_point) return std::nullopt;
  return cycle.turning_point->tangent.*member;
}

/// A foil that bears less is straight but for roundings, Pa.
constexpr double no_stress = 1.0;

/// "crest 3", "weld".
std::string place_text(const StressPeak& peak) {
  if (peak.stress < no_stress) return "-";
  return peak.bump < 0 ? std::string(name_of(peak.place)) : fmt::format("{} {}", name_of(peak.place), peak.bump + 1);
}

std::optional<double> turning(const Cycle& cycle, double TurningPoint::*member) {
  if (!cycle.turning_point) return std::nullopt;
  return (*cycle.turning_point).*member;
}

/// What tells a loop from the others.
std::string loop_name(const CycleResult& result, std::size_t loop) {
  if (result.experiment == Experiment::strip) return std::to_string(loop + 1);
  return direction_name(result.cycles[loop].direction);
}

/// Loops that are shown: all directions; of many cycles of a strip the first and the last, which tell how it settles.
std::vector<std::size_t> shown_loops(const CycleResult& result) {
  std::vector<std::size_t> shown(result.cycles.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  if (result.experiment == Experiment::strip && shown.size() > columns_per_block) {
    shown.erase(shown.begin() + columns_per_block / 2, shown.end() - columns_per_block / 2);
  }
  return shown;
}

struct Row {
  std::string_view name;
  std::string_view unit;
  std::function<std::string(const Cycle&)> cell;
};

/// Number of the bump (from 1) with the largest load, and the load.
std::optional<std::pair<Eigen::Index, double>> highest_bump(const Cycle& cycle) {
  if (!cycle.turning_point) return std::nullopt;
  const Vector& loads = cycle.at_turning_point().top_bump.normal_force;
  if (loads.size() == 0) return std::nullopt;
  Eigen::Index bump = 0;
  const double load = loads.maxCoeff(&bump);
  return std::pair{bump + 1, load};
}

std::vector<Row> rows(Experiment experiment) {
  const auto turning_row = [](std::string_view name, std::string_view unit_name, double TurningPoint::*member,
                              double unit) {
    return Row{name, unit_name, [=](const Cycle& cycle) { return number_text(turning(cycle, member), unit); }};
  };
  const auto tangent_row = [](std::string_view name, std::optional<double> TangentStiffnesses::*member) {
    return Row{name, "MN/m", [=](const Cycle& cycle) { return number_text(tangent(cycle, member), 1e6); }};
  };
  const auto stress_row = [](std::string_view name, std::optional<StressPeak> Cycle::*peak) {
    return Row{name, "MPa", [=](const Cycle& cycle) {
                 if (!(cycle.*peak)) return std::string("-");
                 const double stress = (*(cycle.*peak)).stress;
                 return number_text(stress < no_stress ? 0.0 : stress, 1e6);
               }};
  };
  const auto place_row = [](std::optional<StressPeak> Cycle::*peak) {
    return Row{"  at", "",
               [=](const Cycle& cycle) { return cycle.*peak ? place_text(*(cycle.*peak)) : std::string("-"); }};
  };
  const auto row = [](std::string_view name, std::string_view unit_name, std::optional<double> Cycle::*member,
                      double unit) {
    return Row{name, unit_name, [=](const Cycle& cycle) { return number_text(cycle.*member, unit); }};
  };
  const auto at_start = [](std::string_view name, std::string_view unit_name, double Increment::*member, double unit) {
    return Row{name, unit_name, [=](const Cycle& cycle) {
                 return cycle.increments.empty() ? "-" : number_text(cycle.increments.front().*member, unit);
               }};
  };
  const Row max_force = turning_row("maximum force", "N", &TurningPoint::max_force, 1.0);
  std::vector<Row> out;
  if (experiment == Experiment::strip) {
    out = {max_force,
           {"displacement there", "um",
            [](const Cycle& cycle) {
              return cycle.turning_point ? number_text(cycle.at_turning_point().displacement, 1e-6) : "-";
            }},
           at_start("force at the start", "N", &Increment::force_direct, 1.0),
           at_start("displacement at the start", "um", &Increment::displacement, 1e-6)};
  } else {
    out = {max_force, turning_row("cross force there", "N", &TurningPoint::cross_force, 1.0),
           at_start("force at the centre", "N", &Increment::force_direct, 1.0)};
  }
  const auto add = [&out](const std::vector<Row>& more) { out.insert(out.end(), more.begin(), more.end()); };
  add({
      turning_row("secant stiffness", "MN/m", &TurningPoint::secant_stiffness, 1e6),
      tangent_row("tangent stiffness, loading", &TangentStiffnesses::loading),
      tangent_row("tangent stiffness, unloading", &TangentStiffnesses::unloading),
      row("loop energy", "mJ", &Cycle::loop_energy, 1e-3),
      row("loss factor", "", &Cycle::loss_factor, 1.0),
  });
  if (experiment == Experiment::cycle) {
    add({row("first contact", "um", &Cycle::first_contact, 1e-6),
         row("clearance at 5 N", "um", &Cycle::clearance_5N, 1e-6),
         row("clearance at 10 N", "um", &Cycle::clearance_10N, 1e-6)});
  }
  add({
      {"highest bump load", "N",
       [](const Cycle& cycle) {
         const auto highest = highest_bump(cycle);
         return highest ? number_text(highest->second, 1.0) : "-";
       }},
      {"on bump", "",
       [](const Cycle& cycle) {
         const auto highest = highest_bump(cycle);
         return highest && highest->second > 0.0 ? std::to_string(highest->first) : "-";
       }},
      stress_row("highest stress, top foil", &Cycle::top_foil_stress),
      place_row(&Cycle::top_foil_stress),
      stress_row("highest stress, bump foil", &Cycle::bump_foil_stress),
      place_row(&Cycle::bump_foil_stress),
      {"linear solves", "", [](const Cycle& cycle) { return std::to_string(cycle.total().iterations); }},
      {"factorisations", "", [](const Cycle& cycle) { return std::to_string(cycle.total().factorisations); }},
      {"halved increments", "", [](const Cycle& cycle) { return std::to_string(cycle.substeps()); }},
      {"largest residual", "",
       [](const Cycle& cycle) { return cycle.increments.empty() ? "-" : fmt::format("{:.1e}", cycle.max_residual()); }},
      {"time", "ms", [](const Cycle& cycle) { return number_text(cycle.wall_time, 1e-3); }},
      {"converged", "", [](const Cycle& cycle) { return std::string(cycle.converged ? "yes" : "NO"); }},
  });
  return out;
}

}  // namespace

std::vector<std::string> stress_warnings(const Case& input, const CycleResult& result) {
  std::vector<std::string> warnings;
  for (std::size_t loop = 0; loop < result.cycles.size(); ++loop) {
    const Cycle& cycle = result.cycles[loop];
    for (const StressedFoil& foil : stressed_foils()) {
      if (!above_yield(foil, input, cycle).value_or(false)) continue;
      const StressPeak& peak = *(cycle.*foil.peak);
      warnings.push_back(fmt::format(
          "{}: the {} yields: its bending stress reaches {:.4g} MPa ({}, increment {}), its yield stress is {:.4g} MPa",
          result.experiment == Experiment::strip ? "cycle " + loop_name(result, loop) : loop_name(result, loop),
          foil.long_name, 1e-6 * peak.stress, place_text(peak), peak.increment, 1e-6 * *foil.yield_stress(input)));
    }
  }
  return warnings;
}

std::string cycle_table(const CycleResult& result) {
  const std::vector<std::size_t> shown = shown_loops(result);
  std::string out;
  for (std::size_t first = 0; first < shown.size(); first += columns_per_block) {
    const std::size_t end = std::min(first + columns_per_block, shown.size());
    if (!out.empty()) out += '\n';
    const auto append = [&](std::string_view name, std::string_view unit, const auto& cell) {
      out += fmt::format("{:<{}}{:<{}}", name, name_width, unit, unit_width);
      for (std::size_t i = first; i < end; ++i) out += fmt::format("{:>{}}", cell(shown[i]), column_width);
      out += '\n';
    };
    append(result.experiment == Experiment::strip ? "cycle" : "direction", "",
           [&](std::size_t loop) { return loop_name(result, loop); });
    out += std::string(name_width + unit_width + column_width * (end - first), '-') + '\n';
    for (const Row& row : rows(result.experiment)) {
      append(row.name, row.unit, [&](std::size_t loop) { return row.cell(result.cycles[loop]); });
    }
  }
  if (shown.size() < result.cycles.size()) {
    out += fmt::format("cycles {} to {} are in the files only\n", columns_per_block / 2 + 1,
                       result.cycles.size() - columns_per_block / 2);
  }
  return out;
}

}  // namespace bumpfoil
