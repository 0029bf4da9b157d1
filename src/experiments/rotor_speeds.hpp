#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/bearing/bearing_state.hpp"
#include "bumpfoil/core/status.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/rotor/rotor.hpp"

/// Common to all results over the speeds of a rotor.
namespace bumpfoil {

/// How a search for equilibria ended.
inline constexpr Form search_status{Form::flag, enum_names<Status>};

/// How the search at one speed ended.
struct SpeedStatus {
  double speed{};  ///< Omega, rad/s
  Status status{};
};

/// Adds the dimension `speed`.
void add_speeds(std::vector<double> speeds, Dataset& data);

/// Adds the dimension `bearing`.
void add_bearing_numbers(std::size_t count, Dataset& data);

/// Quantities of a journal in equilibrium.
struct JournalQuantity {
  VariableMeaning meaning;
  std::function<double(const BearingModel& bearing, const BearingState& state)> value;
};

/// Journal position, and its tilt and the required moments if any bearing resists tilt.
std::vector<JournalQuantity> journal_quantities(const Machine& machine);

/// Adds the dimension `bearing`, and the journals over speed and bearing.
/// @param points   with the states of the bearings in equilibrium; they and the machine must outlive the data
template <typename Point>
void add_journals(const std::vector<Point>& points, const Machine& machine, Dataset& data) {
  add_bearing_numbers(machine.bearings.size(), data);
  for (JournalQuantity& quantity : journal_quantities(machine)) {
    data.add(quantity.meaning, {"speed", "bearing"}, [&points, &machine, value = std::move(quantity.value)] {
      return padded_rows(points.size(), machine.bearings.size(), [&](std::size_t i) {
        std::vector<double> row;
        row.reserve(points[i].states.size());
        for (std::size_t k = 0; k < points[i].states.size(); ++k)
          row.push_back(value(*machine.bearings[k], points[i].states[k]));
        return row;
      });
    });
  }
}

/// Adds the dimension `station`, and station positions with their names: those of Machine::places().
void add_stations(const std::vector<RotorStation>& stations, Dataset& data);

/// "12000 rpm"
std::string rotor_speed_text(double speed);

/// One line per speed without an equilibrium, and one for the following speeds that were not computed.
std::vector<std::string> missing_equilibria(const std::vector<SpeedStatus>& speeds);

}  // namespace bumpfoil
