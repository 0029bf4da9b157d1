#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {

/// Values outside indicate wrong units, and could overflow.
struct Range {
  double least, most;
  std::string_view unit;
};
inline constexpr Range length_range{1e-9, 1e3, "m"};
inline constexpr Range modulus_range{1e6, 1e13, "Pa"};
inline constexpr Range stiffness_range{1.0, 1e15, "N/m"};
inline constexpr Range load_range{1e-6, 1e9, "N"};
inline constexpr Range frequency_range{1e-3, 1e7, "rad/s"};
inline constexpr Range strength_range{1e5, 1e11, "Pa"};
inline constexpr Range coefficient_range{0.0, 1.0, ""};
inline constexpr Range poisson_range{0.0, 0.5, ""};

/// Foils thicker than this fraction of the bearing radius, and larger clearances, are implausible.
inline constexpr double thin = 0.1;

/// Memory limit of a run: about 200 bytes per bump and increment.
inline constexpr std::int64_t most_bump_increments = 20'000'000;
inline constexpr int most_steps = 1'000'000;

/// Relative round-off allowed between the sum of pitches and the circumference.
inline constexpr double round_off = 1e-9;

/// The quantity as messages show it.
inline std::string quantity(double value, std::string_view unit) {
  return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

/// A key and its accepted range.
struct CheckedKey {
  std::string key;
  Range range;
};

/// The ranges of all numbers of a case that have their own.
std::vector<CheckedKey> checked_keys(const Case& input);

/// Collects the errors of a case.
class Checks {
 public:
  /// @param checked  receives the ranges of all keys checked, for callers that list them
  explicit Checks(std::vector<CheckedKey>* checked = nullptr) : checked_(checked) {}

  /// Keeps the error if `right` is false; returns `right`.
  bool require(bool right, std::string key, std::string value, std::string what, std::string advice) {
    return require_for("", right, std::move(key), std::move(value), std::move(what), std::move(advice));
  }

  /// The same for an error that prevents only one command.
  bool require_for(std::string_view command, bool right, std::string key, std::string value, std::string what,
                   std::string advice) {
    if (right) return true;
    errors_.push_back({command, {"", 0, std::move(key), std::move(value), std::move(what), std::move(advice)}});
    return false;
  }

  /// The same for one that prevents several.
  bool require_for(const std::vector<std::string_view>& commands, bool right, const std::string& key,
                   const std::string& value, const std::string& what, const std::string& advice) {
    for (const std::string_view command : commands) require_for(command, right, key, value, what, advice);
    return right;
  }

  // Valid values create no text: ensembles check every bearing.

  bool finite(const std::string& key, double value, std::string_view unit) {
    return std::isfinite(value) || require(false, key, quantity(value, unit), "is not finite", "give a finite number");
  }

  bool within(const std::string& key, double value, const Range& range) {
    note(key, range);
    if (value >= std::max(range.least, 0.0) && value <= range.most) return true;
    if (!finite(key, value, range.unit)) return false;
    const std::string shown = quantity(value, range.unit);
    const bool sign_right = range.least > 0.0 ? value > 0.0 : value >= 0.0;
    if (!require(sign_right, key, shown, range.least > 0.0 ? "must be positive" : "must not be negative",
                 fmt::format("give a value from {} to {}", quantity(range.least, range.unit),
                             quantity(range.most, range.unit)))) {
      return false;
    }
    return require(value >= range.least && value <= range.most, key, shown, "is unphysical",
                   fmt::format("give a value from {} to {}{}", quantity(range.least, range.unit),
                               quantity(range.most, range.unit), range.unit.empty() ? "" : "; is the unit right?"));
  }

  bool angle(const std::string& key, double value) {
    note(key, {-turn, turn, "rad"});
    if (std::abs(value) <= turn * (1.0 + round_off)) return true;
    return finite(key, value, "rad") && require(false, key, quantity(value, "rad"), "is more than a full turn",
                                                "give at most 360 degrees either way");
  }

  /// A count, such as "increments".
  bool count(const std::string& key, int value, std::string_view what, std::pair<int, int> ends = {1, most_steps}) {
    note(key, {static_cast<double>(ends.first), static_cast<double>(ends.second), ""});
    if (value >= ends.first && value <= ends.second) return true;
    return require(false, key, std::to_string(value), fmt::format("is not a valid number of {}", what),
                   fmt::format("give a whole number from {} to {}", ends.first, ends.second));
  }

  /// An error of the Le Lez (2007) model, which has no history, that prevents a command.
  bool require_history(std::string_view command, bool right, std::string what,
                       std::string advice = "set model = \"truss\" or \"frame\"") {
    return right || require_for(command, false, "bump_foil.model", std::string(name_of(BumpFoilModel::former)),
                                std::move(what), std::move(advice));
  }

  std::vector<CommandError> take() { return std::move(errors_); }

 private:
  void note(const std::string& key, const Range& range) {
    if (checked_ != nullptr) checked_->push_back({key, range});
  }

  std::vector<CommandError> errors_;
  std::vector<CheckedKey>* checked_;
};

/// Whether a run with this number of increments and bumps fits in memory.
inline void check_memory(Checks& checks, std::string_view command, const std::string& key, int steps,
                         std::int64_t increments, int bumps) {
  checks.require_for(command, increments <= most_bump_increments / bumps, key, std::to_string(steps),
                     fmt::format("{} increments of {} bumps would not fit in memory", increments, bumps),
                     "give fewer steps, or fewer directions or cycles");
}

/// Journal displacement that flattens the bumps, m; 0 if unknown.
inline double flattening(const Bearing& bearing, double rise) {
  const bool clear = std::abs(bearing.radial_clearance) <= thin * bearing.radius;
  return rise > 0.0 && clear ? bearing.radial_clearance + rise : 0.0;
}

/// Whether a foil of this thickness, given by `key`, is plausible for the bearing.
inline bool check_thinness(Checks& checks, const std::string& key, double thickness, double radius) {
  return checks.require(thickness <= thin * radius, key, quantity(thickness, "m"),
                        "is too thick for a foil in this bearing",
                        fmt::format("give at most a tenth of the radius, {:.6g} m", thin * radius));
}

}  // namespace bumpfoil
