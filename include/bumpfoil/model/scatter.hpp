#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"

namespace bumpfoil {

struct BearingDesign;

/// Distribution of a quantity about its nominal value.
enum class DistributionKind {
  normal,
  truncated_normal,  ///< normal, truncated between two bounds
  uniform,
  table,  ///< one of a set of measured values, all equally likely
};

/// Words of the case file.
template <>
inline constexpr auto enum_names<DistributionKind> = std::to_array<std::string_view>({"normal", "truncated_normal",
                                                                                      "uniform", "table"});

/// Distribution of a deviation from a nominal value. A plain value; unused members are absent.
struct Distribution {
  DistributionKind kind{DistributionKind::normal};
  std::optional<double> sigma{};  ///< standard deviation; of a truncated one that of the normal one it is cut from
  std::optional<double> lower{};  ///< bound of a truncated or uniform one
  std::optional<double> upper{};  ///< the same
  std::vector<double> values{};   ///< of a table

  bool operator==(const Distribution&) const = default;
};

/// Heights of bumps: each is distributed alike.
struct HeightScatter {
  Distribution distribution;
  /// Distance along the foil over which the correlation of the (normal scores of the) heights falls by 1/e, m; zero:
  /// they are independent.
  double correlation_length{};

  bool operator==(const HeightScatter&) const = default;
};

/// Waves of a sleeve, with uniformly random phase.
struct WavinessScatter {
  int harmonic{};
  double amplitude{};  ///< m

  bool operator==(const WavinessScatter&) const = default;
};

/// An ensemble of bearings that differ within their tolerances. Deviations are from what the case says, and those other
/// than of heights are common to a bearing.
struct MonteCarloSettings {
  std::string command{"cycle"};  ///< experiment that is run for each bearing
  int samples{1000};
  int seed{1};
  bool limits{};                                       ///< for running bearings: also lift-off speeds and load
                                                       ///< capacities
  std::optional<HeightScatter> bump_height{};          ///< m
  std::optional<Distribution> bump_foil_thickness{};   ///< m
  std::optional<Distribution> top_foil_thickness{};    ///< m
  std::optional<Distribution> bump_length{};           ///< m
  std::optional<Distribution> friction_top_bump{};     ///< 1
  std::optional<Distribution> friction_bump_sleeve{};  ///< 1
  std::optional<Distribution> radial_clearance{};      ///< m
  std::optional<Distribution> formed_radius{};         ///< of the top foil, m
  std::optional<WavinessScatter> sleeve_waviness{};

  bool operator==(const MonteCarloSettings&) const = default;
};

/// A number of the case that scatters from bearing to bearing.
struct ScatteredNumber {
  std::string_view name;       ///< of its table in [montecarlo]
  std::string_view unit;       ///< SI; "1" where there is none
  std::string_view long_name;  ///< of the deviation
  std::optional<Distribution> MonteCarloSettings::*distribution;
  void (*add)(BearingDesign&, double deviation);
};

/// All of them, in the order of the case file.
std::span<const ScatteredNumber> scattered_numbers();

/// Standard normal distribution function, the probability of less than `z`.
double normal_probability(double z);

/// Its inverse, to a few units in the last place of the probability (of that of more than z, where z > 0).
/// @param p  between 0 and 1, bounds excluded
double normal_quantile(double p);

/// The `p` quantile: the deviation below which the fraction `p` lies. Turns uniform numbers into deviations.
/// @param p  between 0 and 1, bounds excluded
double quantile(const Distribution& distribution, double p);

}  // namespace bumpfoil
