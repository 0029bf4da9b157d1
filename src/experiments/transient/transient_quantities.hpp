#pragma once

#include <span>
#include <string>
#include <vector>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/table.hpp"

/// Quantities of the command transient, described once for all files.
namespace bumpfoil {

/// A place of the rotor during a revolution.
struct TurnView {
  const TransientTurn& revolution;
  const PlaceTurn& place;
  const BearingRecord* bearing{};  ///< null at other stations
};

using TurnQuantity = Quantity<double (*)(const TurnView&)>;
std::span<const TurnQuantity> turn_quantities();

/// A quantity of a whole revolution.
using WholeTurnQuantity = Quantity<double (*)(const TransientTurn&)>;
std::span<const WholeTurnQuantity> whole_turn_quantities();

/// Quantities derived from all steps of a run after its end.
struct TransientReading {
  explicit TransientReading(TransientResult made);

  TransientResult result;
  std::vector<TransientTurn> turns;
  std::vector<RubEvent> rubs;
  Waterfall waterfall;
  EnergyCheck energy;
};

/// A quantity of a whole run, as listed in sweeps: first the status of the march.
using RunQuantity = Quantity<double (*)(const TransientReading&)>;
std::span<const RunQuantity> run_quantities();

std::vector<std::string> failure_lines(const TransientReading& reading);
std::vector<std::string> warning_lines(const Case& input, const TransientReading& reading);

/// The run as a text table: some of its turns, rubs, and the energy balance.
std::string transient_table(const TransientReading& reading);

/// Quantities of the whole run.
Dataset run_dataset(const TransientReading& reading);

/// The same and the last spectrum of the run, as stored in sweeps.
Dataset swept_dataset(const TransientReading& reading);

/// Quantities of the whole run, and all others over the dimensions step, revolution, station, bearing, spectrum and
/// order. The reading must outlive it.
Dataset transient_dataset(const TransientReading& reading);

/// Rows of transient.csv: one for each station and revolution.
Table revolution_table(const TransientReading& reading);

}  // namespace bumpfoil
