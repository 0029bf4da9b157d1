#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/optimise/optimise_settings.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// How an optimisation ended.
enum class OptimiseStatus {
  /// The search of the best point ended by its tolerance, with two aims those of the best of each; evaluated again, the
  /// best point is the same.
  converged,
  evaluations_spent,  ///< the search of the best point ended as it had no evaluations left
  rounding_limited,   ///< it ended by round-off
  infeasible,         ///< no point meets all limits
  no_result,          ///< no point has a result
  not_confirmed,      ///< evaluated again, the best point differs
  interrupted,        ///< stopped from outside
};

template <>
inline constexpr auto enum_names<OptimiseStatus> = std::to_array<std::string_view>(
    {"converged", "evaluations_spent", "rounding_limited", "infeasible", "no_result", "not_confirmed", "interrupted"});

/// How the run of a point ended.
enum class PointStatus {
  converged,
  failed,        ///< a numerical failure, or samples of an ensemble that failed
  not_physical,  ///< there is no such bearing
  no_value,      ///< a quantity of an aim or a limit does not exist there
};

template <>
inline constexpr auto enum_names<PointStatus> = std::to_array<std::string_view>({"converged", "failed", "not_physical",
                                                                                 "no_value"});

/// A quantity of the result of a point: over all its directions or states the smallest, or the largest.
struct OptimisedQuantity {
  std::string name;  ///< "h_min"; of an ensemble "yield", or with a statistic, "h_min.p5"
  std::string unit;  ///< SI
  ShownUnit shown;
  bool largest{};
};

struct OptimiseAim {
  OptimisedQuantity quantity;
  bool maximise{};
};

struct OptimiseLimit {
  std::string text;  ///< as it was written
  OptimisedQuantity quantity;
  bool above{};
  double bound{};

  /// Of a value to the bound: positive where the limit is met.
  [[nodiscard]] double margin(double value) const { return above ? value - bound : bound - value; }
};

/// A point that was evaluated. Numbers are SI.
struct OptimisePoint {
  std::vector<double> values;  ///< of the keys
  PointStatus status{};
  std::string message{};         ///< why it has no result
  std::vector<double> aims{};    ///< where it converged
  std::vector<double> limits{};  ///< quantities of the limits, likewise
  std::size_t search{};          ///< that evaluated it, from 1; 0: one of the places that searches start from
};

/// A search from one start.
struct OptimiseSearch {
  std::size_t aim{};           ///< that it was for
  bool by_tolerance{};         ///< it ended by its tolerance
  bool by_round_off{};         ///< or by round-off
  std::size_t evaluations{};   ///< points that it evaluated
  std::vector<double> best{};  ///< values of the best that it met; empty where none meets all limits
};

struct OptimiseResult {
  OptimiseSettings settings;
  std::vector<std::string> key_units;  ///< SI; "1" where there is none
  std::vector<OptimiseAim> aims;
  std::vector<OptimiseLimit> limits;
  OptimiseStatus status{OptimiseStatus::no_result};
  std::vector<OptimisePoint> points;  ///< all that were evaluated; the first has the values that are given
  std::vector<OptimiseSearch> searches;
  /// Number of the best point; with two aims the point of the front nearest to the best values of both. Absent where
  /// none meets all limits.
  std::optional<std::size_t> best{};
  std::optional<std::size_t> nearest{};  ///< the point that misses its limits by the least, where none meets them
  std::vector<std::size_t> front{};      ///< of two aims: numbers of its points, from the best of the first aim on
  std::vector<std::string> warnings{};   ///< of the run of the best point
  Case optimised;                        ///< the case with the best values, without [optimise]

  [[nodiscard]] bool is_feasible(const OptimisePoint& point) const;
  /// Whether the best point lies at a bound of a key: 0, or -1 at the lower, 1 at the upper.
  [[nodiscard]] int bound_of(std::size_t key) const;
  /// Whether a limit is active at the best point.
  [[nodiscard]] bool is_active(std::size_t limit) const;
};

/// By how much a value misses a limit, relative to its bound; negative if it meets the limit.
double relative_miss(const OptimiseLimit& limit, double value);

/// Errors of [optimise] that only the results of its command can reveal: names of quantities, limits, starts.
std::vector<InputError> optimise_errors(const Case& input);

/// Maximises or minimises a quantity over keys of a case, within their bounds and under limits on other quantities,
/// without derivatives.
///
/// The result depends on the case alone, to the last bit, not on threads. A point that fails is kept, and never best.
/// @throws Error (input) with optimise_errors()
OptimiseResult run_optimise(const Case& input, const ProgressCallback& progress = {}, unsigned threads = 0);

}  // namespace bumpfoil
