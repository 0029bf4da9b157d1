#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/results/quantity.hpp"

/// The numbers of a step, described once: rows of a StepTable and variables of result.nc.
namespace bumpfoil {

/// The end of a step.
struct StepView {
  const Machine& machine;
  const MachineState& state;
  const WorkBalance& energy;
  int iterations{};
};

/// A bearing at the end of a step.
struct BearingView {
  const BearingModel& bearing;
  const BearingState& state;
};

using StepQuantity = Quantity<double (*)(const StepView&)>;
using PlaceQuantity = Quantity<double (*)(const Eigen::Vector2d& place)>;
using BearingQuantity = Quantity<double (*)(const BearingView&)>;

/// In the order of a row: these, then those of each place and of each bearing.
std::span<const StepQuantity> step_quantities();
std::span<const PlaceQuantity> place_quantities();
std::span<const BearingQuantity> bearing_quantities();

/// Columns of a row that other code reads.
enum class StepColumn : std::size_t { time, angle, speed, iterations, energy };
inline constexpr std::size_t energy_columns = 8;
enum class BearingColumn : std::size_t { thinnest, power, asperity_load, loaded_bumps };

std::size_t column_of(StepColumn column);
/// @param axis  0 or 1
std::size_t place_column(std::size_t place, std::size_t axis);
std::size_t bearing_column(const StepLayout& layout, std::size_t bearing, BearingColumn column);

/// The row of a step.
std::vector<double> step_row(const StepView& step);

/// Terms of a balance in the order of their columns.
std::array<double WorkBalance::*, energy_columns> energy_terms();

}  // namespace bumpfoil
