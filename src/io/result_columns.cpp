#include "io/result_columns.hpp"

#include <array>

namespace bumpfoil {
namespace {

template <double Increment::*member>
double of_increment(const Increment& increment) {
  return increment.*member;
}

template <double Increment::*member>
std::optional<double> at_start(const Cycle& cycle) {
  return cycle.increments.empty() ? std::nullopt : std::optional(cycle.increments.front().*member);
}

template <double TurningPoint::*member>
std::optional<double> at_turn(const Cycle& cycle) {
  return cycle.turning_point ? std::optional((*cycle.turning_point).*member) : std::nullopt;
}

template <auto Cycle::*member>
std::optional<double> of_cycle(const Cycle& cycle) {
  return cycle.*member;
}

template <std::optional<double> TangentStiffnesses::*member>
std::optional<double> tangent_at_turn(const Cycle& cycle) {
  return cycle.turning_point ? cycle.turning_point->tangent.*member : std::nullopt;
}

template <std::optional<StressPeak> Cycle::*member>
std::optional<double> peak_of(const Cycle& cycle) {
  return cycle.*member ? std::optional((*(cycle.*member)).stress) : std::nullopt;
}

std::optional<double> initial_journal_load(const Cycle& cycle) {
  return cycle.increments.empty() ? std::nullopt : std::optional(cycle.initial_journal_load());
}

std::optional<double> assembly_dissipation(const Cycle& cycle) {
  return cycle.increments.empty() ? std::nullopt : std::optional(cycle.assembly_dissipation);
}

constexpr std::array<IncrementColumn, 11> increment_table{{
    {"displacement", "m", "displacement of the journal along the direction", of_increment<&Increment::displacement>},
    {"x", "m", "journal centre, X", of_increment<&Increment::x>},
    {"y", "m", "journal centre, Y", of_increment<&Increment::y>},
    {"force_x", "N", "force that holds the journal, X", of_increment<&Increment::force_x>},
    {"force_y", "N", "force that holds the journal, Y", of_increment<&Increment::force_y>},
    {"force_direct", "N", "force that holds the journal, along the direction", of_increment<&Increment::force_direct>},
    {"force_cross", "N", "force that holds the journal, 90 degrees ahead of the direction",
     of_increment<&Increment::force_cross>},
    {"elastic_energy", "J", "elastic energy of the foils", of_increment<&Increment::elastic_energy>},
    {"dissipated_energy", "J", "energy dissipated by friction since increment 0",
     of_increment<&Increment::dissipated_energy>},
    {"work", "J", "work of the journal since increment 0", of_increment<&Increment::work>},
    {"residual", "1", "largest unbalanced force over the largest contact force",
     [](const Increment& increment) { return increment.residuals.equilibrium; }},
}};

constexpr std::array<CycleColumn, 21> cycle_table{{
    {"max_force", "N", "direct force at full displacement", at_turn<&TurningPoint::max_force>},
    {"cross_force_at_max", "N", "cross force at full displacement", at_turn<&TurningPoint::cross_force>},
    {"initial_force", "N", "direct force at the centred journal", at_start<&Increment::force_direct>},
    {"initial_force_x", "N", "force at the centred journal, X", at_start<&Increment::force_x>},
    {"initial_force_y", "N", "force at the centred journal, Y", at_start<&Increment::force_y>},
    {"initial_journal_load", "N", "sum of the loads of the journal on the top foil at the centred journal",
     initial_journal_load},
    {"initial_elastic_energy", "J", "elastic energy at the centred journal", at_start<&Increment::elastic_energy>},
    {"assembly_dissipation", "J", "energy dissipated by the assembly", assembly_dissipation},
    {"loop_energy", "J", "closed integral of force over displacement", of_cycle<&Cycle::loop_energy>},
    {"elastic_energy_at_max", "J", "elastic energy at full displacement", at_turn<&TurningPoint::elastic_energy>},
    {"loss_factor", "1", "loop energy over 2 pi times the elastic energy stored", of_cycle<&Cycle::loss_factor>},
    {"tangent_stiffness_loading", "N/m", "tangent stiffness at full displacement, further loading",
     tangent_at_turn<&TangentStiffnesses::loading>},
    {"tangent_stiffness_unloading", "N/m", "tangent stiffness at full displacement, unloading",
     tangent_at_turn<&TangentStiffnesses::unloading>},
    {"secant_stiffness", "N/m", "maximum force over amplitude", at_turn<&TurningPoint::secant_stiffness>},
    {"first_contact", "m", "displacement at which the journal first touches the top foil",
     of_cycle<&Cycle::first_contact>},
    {"clearance_5N", "m", "displacement at which the direct force reaches 5 N", of_cycle<&Cycle::clearance_5N>},
    {"clearance_10N", "m", "displacement at which the direct force reaches 10 N", of_cycle<&Cycle::clearance_10N>},
    {"max_stress_top_foil", "Pa", "largest bending stress of the top foil", peak_of<&Cycle::top_foil_stress>},
    {"max_stress_bump_foil", "Pa", "largest bending stress of the bump foil", peak_of<&Cycle::bump_foil_stress>},
    {"max_residual", "1", "largest residual of all increments",
     [](const Cycle& cycle) { return cycle.increments.empty() ? std::nullopt : std::optional(cycle.max_residual()); }},
    {"wall_time", "s", "time that the cycle took", of_cycle<&Cycle::wall_time>},
}};

constexpr std::array<IncrementColumn, 6> strip_increment_table{{
    {"displacement", "m", "displacement of the plate towards the base", of_increment<&Increment::displacement>},
    {"force_direct", "N", "load on the plate", of_increment<&Increment::force_direct>},
    {"elastic_energy", "J", "elastic energy of the foils", of_increment<&Increment::elastic_energy>},
    {"dissipated_energy", "J", "energy dissipated by friction since the start of the cycle",
     of_increment<&Increment::dissipated_energy>},
    {"work", "J", "work of the plate since the start of the cycle", of_increment<&Increment::work>},
    {"residual", "1", "largest unbalanced force over the largest contact force",
     [](const Increment& increment) { return increment.residuals.equilibrium; }},
}};

constexpr std::array<CycleColumn, 15> strip_table{{
    {"initial_displacement", "m", "displacement at the start", at_start<&Increment::displacement>},
    {"initial_force", "N", "load at the start", at_start<&Increment::force_direct>},
    {"max_force", "N", "load at full displacement", at_turn<&TurningPoint::max_force>},
    {"initial_elastic_energy", "J", "elastic energy at the start", at_start<&Increment::elastic_energy>},
    {"assembly_dissipation", "J", "energy dissipated by the assembly", assembly_dissipation},
    {"loop_energy", "J", "closed integral of load over displacement", of_cycle<&Cycle::loop_energy>},
    {"elastic_energy_at_max", "J", "elastic energy at full displacement", at_turn<&TurningPoint::elastic_energy>},
    {"loss_factor", "1",
     "loop energy over 2 pi times the elastic energy stored, about a preload 1/2 secant stiffness amplitude^2",
     of_cycle<&Cycle::loss_factor>},
    {"tangent_stiffness_loading", "N/m", "tangent stiffness at full displacement, further loading",
     tangent_at_turn<&TangentStiffnesses::loading>},
    {"tangent_stiffness_unloading", "N/m", "tangent stiffness at full displacement, unloading",
     tangent_at_turn<&TangentStiffnesses::unloading>},
    {"secant_stiffness", "N/m", "range of the load over range of the displacement",
     at_turn<&TurningPoint::secant_stiffness>},
    {"max_stress_top_foil", "Pa", "largest bending stress of the top foil", peak_of<&Cycle::top_foil_stress>},
    {"max_stress_bump_foil", "Pa", "largest bending stress of the bump foil", peak_of<&Cycle::bump_foil_stress>},
    {"max_residual", "1", "largest residual of all increments",
     [](const Cycle& cycle) { return cycle.increments.empty() ? std::nullopt : std::optional(cycle.max_residual()); }},
    {"wall_time", "s", "time that the cycle took", of_cycle<&Cycle::wall_time>},
}};

constexpr std::array<StressedFoil, 2> foil_table{{
    {"top_foil", "top foil", &Cycle::top_foil_stress, [](const Case& input) { return input.top_foil.yield_stress; }},
    {"bump_foil", "bump foil", &Cycle::bump_foil_stress,
     [](const Case& input) { return input.bump_foil.yield_stress; }},
}};

}  // namespace

std::span<const StressedFoil> stressed_foils() {
  return foil_table;
}

std::optional<bool> above_yield(const StressedFoil& foil, const Case& input, const Cycle& cycle) {
  const std::optional<StressPeak>& peak = cycle.*foil.peak;
  const std::optional<double> yield_stress = foil.yield_stress(input);
  if (!peak || !yield_stress) return std::nullopt;
  return peak->stress > *yield_stress;
}

std::string_view name_of(StressPlace place) {
  switch (place) {
    case StressPlace::weld:
      return "weld";
    case StressPlace::crest:
      return "crest";
    case StressPlace::foot:
      return "foot";
    case StressPlace::arc:
      return "arc";
  }
  return "";
}

std::span<const IncrementColumn> increment_columns(Experiment experiment) {
  if (experiment == Experiment::strip) return strip_increment_table;
  return increment_table;
}

std::span<const CycleColumn> cycle_columns(Experiment experiment) {
  if (experiment == Experiment::strip) return strip_table;
  return cycle_table;
}

std::string_view name_of(Experiment experiment) {
  return experiment == Experiment::strip ? "strip" : "cycle";
}

std::string name_with_unit(std::string_view name, std::string_view unit) {
  std::string out(name);
  if (unit == "1") return out;
  for (const char letter : '_' + std::string(unit)) {
    if (letter == '/') {
      out += "_per_";
    } else {
      out += letter;
    }
  }
  return out;
}

}  // namespace bumpfoil
