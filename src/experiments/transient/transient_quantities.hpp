#pragma once

#include <span>
#include <string>
#include <vector>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/quantity.hpp"

/// Quantities of the command transient, described once for all files.
namespace bumpfoil {

/// A place of the rotor in a revolution.
struct TurnView {
  const TransientTurn& revolution;
  const PlaceTurn& place;
  const BearingRecord* bearing{};  ///< none at other stations
};

using TurnQuantity = Quantity<double (*)(const TurnView&)>;
std::span<const TurnQuantity> turn_quantities();

/// Of a revolution as a whole.
using WholeTurnQuantity = Quantity<double (*)(const TransientTurn&)>;
std::span<const WholeTurnQuantity> whole_turn_quantities();

/// What is read off all steps of a run once it has ended.
struct TransientReading {
  explicit TransientReading(TransientResult made);

  TransientResult result;
  std::vector<TransientTurn> turns;
  std::vector<RubEvent> rubs;
  Waterfall waterfall;
  EnergyCheck energy;
};

/// Of a run as a whole, as sweeps list it: first how the march ended.
using RunQuantity = Quantity<double (*)(const TransientReading&)>;
std::span<const RunQuantity> run_quantities();

std::vector<std::string> failure_lines(const TransientReading& reading);
std::vector<std::string> warning_lines(const Case& input, const TransientReading& reading);

/// The run as a text table: a line for some of its turns, rubs, and the balance of energy.
std::string transient_table(const TransientReading& reading);

/// The run as a whole.
Dataset run_dataset(const TransientReading& reading);

/// The same in a line under its header.
std::string run_csv(const TransientReading& reading);

/// The same and the last spectrum of the run, as sweeps keep them.
Dataset swept_dataset(const TransientReading& reading);

/// The run as a whole and all else over the dimensions step, revolution, station, bearing, spectrum and order. It lives
/// as long as the reading.
Dataset transient_dataset(const TransientReading& reading);

/// Contents of transient.csv: a line for each station and revolution.
std::string transient_csv(const TransientReading& reading);

}  // namespace bumpfoil
