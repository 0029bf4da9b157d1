#include "bumpfoil/ensemble/ensemble_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/ensemble/sensitivity.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Statistics of columns at one place, over the samples that reached it.
class ConvergedSamples {
 public:
  ConvergedSamples(const EnsembleLayout& layout, const RowLog& log, std::size_t place)
      : layout_(layout), log_(log), place_(place), status_(log.column(layout.entry(place, 0))) {}

  /// Values of the first `count` samples.
  [[nodiscard]] std::vector<double> values(std::size_t column, std::size_t count) const {
    const std::vector<double> all = log_.column(layout_.entry(place_, column), 0, count);
    std::vector<double> good;
    good.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (converged(i)) good.push_back(all[i]);
    }
    return good;
  }

  [[nodiscard]] Statistics statistics(std::size_t column, Undefined undefined) const {
    return statistics_of(values(column, log_.rows()), undefined);
  }

  [[nodiscard]] bool converged(std::size_t sample) const { return status_[sample] == 0.0; }

  void tell_failures(std::vector<SampleFailure>& failures) const {
    for (std::size_t i = 0; i < status_.size(); ++i) {
      if (!converged(i)) failures.push_back({i, place_, static_cast<int>(status_[i])});
    }
  }

 private:
  const EnsembleLayout& layout_;
  const RowLog& log_;
  std::size_t place_;
  std::vector<double> status_;
};

/// Values of all factors for the samples that converged.
std::vector<std::vector<double>> factors_of(const Case& input, const ConvergedSamples& samples, std::size_t count) {
  std::vector<std::vector<double>> factors(factor_count(input));
  for (std::size_t i = 0; i < count; ++i) {
    if (!samples.converged(i)) continue;
    const std::vector<double> drawn = factors_of(input, draw_sample(input, i));
    for (std::size_t k = 0; k < factors.size(); ++k) factors[k].push_back(drawn[k]);
  }
  return factors;
}

std::vector<std::vector<double>> sensitivities_of(const Case& input, const EnsembleLayout& layout,
                                                  const ConvergedSamples& samples, std::size_t count) {
  std::vector<std::vector<double>> found(layout.columns.size());
  if (factor_count(input) == 0) return found;
  const PartialRankCorrelations correlations(factors_of(input, samples, count));
  for (std::size_t k = 1; k < layout.columns.size(); ++k) {
    std::vector<double> values = samples.values(k, count);
    if (layout.columns[k].undefined == Undefined::largest) {
      std::replace_if(
          values.begin(), values.end(), [](double value) { return std::isnan(value); },
          std::numeric_limits<double>::infinity());
    }
    const bool defined = std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
    found[k] = defined ? correlations.of(values) : std::vector(factor_count(input), absent);
  }
  return found;
}

}  // namespace

EnsembleStatistics make_ensemble_statistics(const Case& input, const EnsembleLayout& layout, const RowLog& log) {
  EnsembleStatistics found{.samples = log.rows(), .places = {}, .failures = {}};
  for (std::size_t place = 0; place < layout.places.size(); ++place) {
    const ConvergedSamples samples(layout, log, place);
    samples.tell_failures(found.failures);
    PlaceStatistics& of_place = found.places.emplace_back();
    for (std::size_t k = 0; k < layout.columns.size(); ++k) {
      of_place.columns.push_back(samples.statistics(k, layout.columns[k].undefined));
    }
    for (std::size_t bump = 0; bump < layout.loads(); ++bump) {
      of_place.bump_loads.push_back(samples.statistics(layout.columns.size() + bump, Undefined::unknown));
    }
    of_place.sensitivities = sensitivities_of(input, layout, samples, std::min(log.rows(), most_ranked_samples));
  }
  std::stable_sort(found.failures.begin(), found.failures.end(),
                   [](const SampleFailure& a, const SampleFailure& b) { return a.sample < b.sample; });
  return found;
}

double relative_error_of_mean(const EnsembleLayout& layout, const RowLog& log) {
  const std::size_t column = layout.column(layout.target);
  double largest = 0.0;
  for (std::size_t place = 0; place < layout.places.size(); ++place) {
    const Statistics found = ConvergedSamples(layout, log, place).statistics(column, Undefined::unknown);
    const double error = found.standard_error / std::abs(found.mean);
    // NaN must not count as a small error.
    if (!std::isnan(largest) && !(error <= largest)) largest = error;
  }
  return largest;
}

}  // namespace bumpfoil
