#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/results/dataset.hpp"

/// Stiffness and damping of running bearings under small motions, over their frequency: described once for all files.
namespace bumpfoil {

struct WhirlQuantity {
  std::string axes;    ///< "xy" of dF_x/dy; "a" and "b" of the slopes of the axis towards X and Y, and the moments
  bool damping;        ///< or stiffness
  std::string suffix;  ///< "" where slipping contacts slip on, "_stuck"
  std::string unit;    ///< SI
  std::string long_name;
  /// Not a number where the system is singular.
  std::function<double(const FilmWhirl&)> value;

  /// "cxy_stuck"; of result.nc "cxy_at_frequency_stuck".
  [[nodiscard]] std::string name(const std::string& of = "") const {
    return (damping ? "c" : "k") + axes + of + suffix;
  }
};

/// In the order of coefficients.csv: stiffness, then damping, of further motion; the same of stuck contacts.
/// @param motions  of the journal: 2, or 4 where it may tilt
const std::vector<WhirlQuantity>& whirl_quantities(Eigen::Index motions);

/// Frequencies that all states have in common, rad/s: those of the case or, where it names none, those tabulated; none
/// where there are neither.
std::vector<double> common_frequencies(const EquilibriumSettings& settings, const EquilibriumResult& result);

/// Motions of a state at the common frequencies; none of a state without.
const std::vector<FilmWhirl>& common_whirls(const EquilibriumSettings& settings, const RunningState& state);

/// Adds the dimension `frequency` and stiffness and damping over it to a dataset of states, if there are common
/// frequencies.
/// @param dims    of a quantity of states
/// @param places  of the states among its values
void add_whirls(const EquilibriumSettings& settings, const EquilibriumResult& result, std::vector<std::string> dims,
                const std::vector<std::size_t>& places, Dataset& data);

}  // namespace bumpfoil
