#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A quantity of every increment: a column of cycle.csv or strip.csv, a variable of result.nc.
struct IncrementColumn {
  std::string_view name;
  std::string_view unit;  ///< as UDUNITS spells it; "1" where there is none
  std::string_view long_name;
  double (*value)(const Increment&);
};

/// Real quantities of an increment, in the order of the columns of cycle.csv or strip.csv.
std::span<const IncrementColumn> increment_columns(Experiment experiment = Experiment::cycle);

/// A quantity of a whole cycle: a key of summary.json, a variable of result.nc.
struct CycleColumn {
  std::string_view name;
  std::string_view unit;
  std::string_view long_name;
  std::optional<double> (*value)(const Cycle&);  ///< absent where it is not known
};

/// Real quantities of a cycle, in the order of the keys of summary.json.
std::span<const CycleColumn> cycle_columns(Experiment experiment = Experiment::cycle);

/// "cycle" or "strip": the command that an experiment is run by.
std::string_view name_of(Experiment experiment);

/// A foil whose stress is compared with its yield stress.
struct StressedFoil {
  std::string_view name;
  std::string_view long_name;
  std::optional<StressPeak> Cycle::*peak;
  std::optional<double> (*yield_stress)(const Case&);
};
std::span<const StressedFoil> stressed_foils();

/// Whether the stress of a foil exceeds its yield stress in a cycle; absent where one of them is not known.
std::optional<bool> above_yield(const StressedFoil& foil, const Case& input, const Cycle& cycle);

std::string_view name_of(StressPlace place);

/// Name of a column or key that carries its unit at the end: "force_x_N", "secant_stiffness_N_per_m", "loss_factor".
std::string name_with_unit(std::string_view name, std::string_view unit);

}  // namespace bumpfoil
