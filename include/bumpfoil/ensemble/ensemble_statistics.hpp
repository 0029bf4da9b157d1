#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bumpfoil/ensemble/statistics.hpp"
#include "bumpfoil/experiments/sampling.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// A place of a sample that was not reached.
struct SampleFailure {
  std::size_t sample{};
  std::size_t place{};  ///< of EnsembleLayout::places
  int status{};         ///< see EnsembleLayout::status_name
};

/// Statistics of an ensemble at one place, over the samples that reached it.
struct PlaceStatistics {
  std::vector<Statistics> columns;     ///< one for each of the layout; of the status it means nothing
  std::vector<Statistics> bump_loads;  ///< one per bump
  /// For each column one for each of the factors, see PartialRankCorrelations; not numbers where the column is not
  /// defined for some.
  std::vector<std::vector<double>> sensitivities;
};

/// Samples that sensitivities are taken from at most: the first.
inline constexpr std::size_t most_ranked_samples = 100'000;

struct EnsembleStatistics {
  std::size_t samples{};  ///< that are there
  std::vector<PlaceStatistics> places;
  std::vector<SampleFailure> failures;  ///< by number
};

/// Reads a log column by column, one in memory at a time, and draws the samples of sensitivities again.
EnsembleStatistics make_ensemble_statistics(const Case& input, const EnsembleLayout& layout, const RowLog& log);

/// Standard error of the mean of EnsembleLayout::target over that mean, the largest of all places; not a number
/// where there are too few samples.
double relative_error_of_mean(const EnsembleLayout& layout, const RowLog& log);

}  // namespace bumpfoil
