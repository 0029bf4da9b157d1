#include "bumpfoil/io/cycle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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
constexpr int name_width = 30;
constexpr int unit_width = 7;
constexpr int column_width = 13;

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

/// "crest 3", "weld".
std::string place_text(const StressPeak& peak) {
  return peak.bump < 0 ? std::string(name_of(peak.place)) : fmt::format("{} {}", name_of(peak.place), peak.bump + 1);
}

std::optional<double> turning(const Cycle& cycle, double TurningPoint::*member) {
  if (!cycle.turning_point) return std::nullopt;
  return (*cycle.turning_point).*member;
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

std::vector<Row> rows() {
  const auto turning_row = [](std::string_view name, std::string_view unit_name, double TurningPoint::*member,
                              double unit) {
    return Row{name, unit_name, [=](const Cycle& cycle) { return number_text(turning(cycle, member), unit); }};
  };
  const auto tangent_row = [](std::string_view name, std::optional<double> TangentStiffnesses::*member) {
    return Row{name, "MN/m", [=](const Cycle& cycle) { return number_text(tangent(cycle, member), 1e6); }};
  };
  const auto stress_row = [](std::string_view name, std::optional<StressPeak> Cycle::*peak) {
    return Row{name, "MPa",
               [=](const Cycle& cycle) { return cycle.*peak ? number_text((*(cycle.*peak)).stress, 1e6) : "-"; }};
  };
  const auto place_row = [](std::optional<StressPeak> Cycle::*peak) {
    return Row{"  at", "", [=](const Cycle& cycle) { return cycle.*peak ? place_text(*(cycle.*peak)) : "-"; }};
  };
  const auto row = [](std::string_view name, std::string_view unit_name, std::optional<double> Cycle::*member,
                      double unit) {
    return Row{name, unit_name, [=](const Cycle& cycle) { return number_text(cycle.*member, unit); }};
  };
  return {
      turning_row("maximum force", "N", &TurningPoint::max_force, 1.0),
      turning_row("cross force there", "N", &TurningPoint::cross_force, 1.0),
      {"force at the centre", "N",
       [](const Cycle& cycle) {
         return cycle.increments.empty() ? "-" : number_text(cycle.increments.front().force_direct, 1.0);
       }},
      turning_row("secant stiffness", "MN/m", &TurningPoint::secant_stiffness, 1e6),
      tangent_row("tangent stiffness, loading", &TangentStiffnesses::loading),
      tangent_row("tangent stiffness, unloading", &TangentStiffnesses::unloading),
      row("loop energy", "mJ", &Cycle::loop_energy, 1e-3),
      row("loss factor", "", &Cycle::loss_factor, 1.0),
      row("first contact", "um", &Cycle::first_contact, 1e-6),
      row("clearance at 5 N", "um", &Cycle::clearance_5N, 1e-6),
      row("clearance at 10 N", "um", &Cycle::clearance_10N, 1e-6),
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
      {"largest residual", "", [](const Cycle& cycle) { return fmt::format("{:.1e}", cycle.max_residual()); }},
      {"time", "ms", [](const Cycle& cycle) { return number_text(cycle.wall_time, 1e-3); }},
      {"converged", "", [](const Cycle& cycle) { return std::string(cycle.converged ? "yes" : "NO"); }},
  };
}

}  // namespace

std::vector<std::string> stress_warnings(const Case& input, const CycleResult& result) {
  std::vector<std::string> warnings;
  for (const Cycle& cycle : result.cycles) {
    for (const StressedFoil& foil : stressed_foils()) {
      if (!above_yield(foil, input, cycle).value_or(false)) continue;
      const StressPeak& peak = *(cycle.*foil.peak);
      warnings.push_back(fmt::format(
          "{}: the {} yields: its bending stress reaches {:.4g} MPa ({}, increment {}), its yield stress is {:.4g} MPa",
          direction_name(cycle.direction), foil.long_name, 1e-6 * peak.stress, place_text(peak), peak.increment,
          1e-6 * *foil.yield_stress(input)));
    }
  }
  return warnings;
}

std::string cycle_table(const CycleResult& result) {
  std::string out;
  for (std::size_t first = 0; first < result.cycles.size(); first += columns_per_block) {
    const auto begin = result.cycles.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(columns_per_block, result.cycles.size() - first));
    if (!out.empty()) out += '\n';
    const auto append = [&](const Row& row) {
      out += fmt::format("{:<{}}{:<{}}", row.name, name_width, row.unit, unit_width);
      for (auto cycle = begin; cycle != end; ++cycle) out += fmt::format("{:>{}}", row.cell(*cycle), column_width);
      out += '\n';
    };
    append({"direction", "", [](const Cycle& cycle) { return direction_name(cycle.direction); }});
    out += std::string(static_cast<std::size_t>(name_width + unit_width + column_width * (end - begin)), '-') + '\n';
    for (const Row& row : rows()) append(row);
  }
  return out;
}

}  // namespace bumpfoil
