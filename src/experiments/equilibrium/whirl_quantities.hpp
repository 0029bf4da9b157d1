#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/results/dataset.hpp"

/// Stiffness and damping of running bearings for small motions, over frequency: described once for all files.
namespace bumpfoil {

struct WhirlQuantity {
  std::string axes;    ///< "xy" for dF_x/dy; "a" and "b": slopes of the axis towards X and Y, and the moments
  bool damping;        ///< otherwise stiffness
  std::string suffix;  ///< "" for sliding contacts, "_stuck" for full stick
  std::string unit;    ///< SI
  std::string long_name;
  /// NaN if the system is singular.
  std::function<double(const FilmWhirl&)> value;

  /// "cxy_stuck"; in result.nc "cxy_at_frequency_stuck".
  [[nodiscard]] std::string name(const std::string& of = "") const {
    return (damping ? "c" : "k") + axes + of + suffix;
  }
};

/// In the order of coefficients.csv: stiffness, then damping, with sliding contacts; then the same with full stick.
/// @param motions  of the journal: 2, or 4 if it may tilt
const std::vector<WhirlQuantity>& whirl_quantities(Eigen::Index motions);

/// Frequencies common to all states, rad/s: those of the case or, by default, the tabulated ones; none if there are
/// neither.
std::vector<double> common_frequencies(const EquilibriumSettings& settings, const EquilibriumResult& result);

/// Motions of a state at the common frequencies; none if unknown.
const std::vector<FilmWhirl>& common_whirls(const EquilibriumSettings& settings, const RunningState& state);

/// Adds the dimension `frequency`, and stiffness and damping over it, to a dataset of states if there are common
/// frequencies.
/// @param dims    of a quantity of states
/// @param places  index of each state among its values
void add_whirls(const EquilibriumSettings& settings, const EquilibriumResult& result, std::vector<std::string> dims,
                const std::vector<std::size_t>& places, Dataset& data);

}  // namespace bumpfoil
