#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bumpfoil/bearing/bearing_state.hpp"
#include "bumpfoil/core/status.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/rotor/rotor.hpp"

/// What results over the speeds of a rotor say alike.
namespace bumpfoil {

/// How a search for equilibria ended.
inline constexpr Form search_status{Form::flag, enum_names<Status>};

/// How the search at one speed ended.
struct SpeedStatus {
  double speed{};  ///< Omega, rad/s
  Status status{};
};

/// Adds the dimension `bearing`.
void add_bearing_numbers(std::size_t count, Dataset& data);

/// Adds it, and the journal centres over speed and bearing.
/// @param points  with the states of the bearings in equilibrium; they live as long as the data
template <typename Point>
void add_journals(const std::vector<Point>& points, std::size_t count, Dataset& data) {
  add_bearing_numbers(count, data);
  for (const int axis : {0, 1}) {
    data.add({axis == 0 ? "x" : "y", "m",
              axis == 0 ? "journal centre in equilibrium, X" : "journal centre in equilibrium, Y"},
             {"speed", "bearing"}, [&points, axis, count] {
               return padded_rows(points.size(), count, [&](std::size_t i) {
                 return each(points[i].states, [axis](const BearingState& state) { return state.position[axis]; });
               });
             });
  }
}

/// Adds the dimension `station`, and where stations are with their names: those of Machine::places().
void add_stations(const std::vector<RotorStation>& stations, Dataset& data);

/// "12000 rpm"
std::string rotor_speed_text(double speed);

/// A line for each speed without an equilibrium, and one for those behind that were not looked for.
std::vector<std::string> missing_equilibria(const std::vector<SpeedStatus>& speeds);

}  // namespace bumpfoil
