#include "bumpfoil/ensemble/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Correlation matrices closer to singular indicate dependent factors.
constexpr double least_determined = 1e-10;

/// Ranks with mean 0 and unit length; zero if all values are equal.
Eigen::VectorXd scores_of(const std::vector<double>& values) {
  const std::vector<double> ranks = ranks_of(values);
  Eigen::VectorXd scores = Eigen::Map<const Eigen::VectorXd>(ranks.data(), std::ssize(ranks));
  scores.array() -= 0.5 * static_cast<double>(ranks.size() + 1);
  const double length = scores.norm();
  return length > 0.0 ? Eigen::VectorXd(scores / length) : Eigen::VectorXd::Zero(scores.size());
}

}  // namespace

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = 0.5 * static_cast<double>(first + 1 + end);
    first = end;
  }
  return ranks;
}

PartialRankCorrelations::PartialRankCorrelations(const std::vector<std::vector<double>>& factors) {
  BUMPFOIL_ASSERT(!factors.empty());
  const auto samples = std::ssize(factors.front());
  scores_.resize(samples, std::ssize(factors));
  for (Eigen::Index k = 0; k < scores_.cols(); ++k) scores_.col(k) = scores_of(factors[static_cast<std::size_t>(k)]);
  // At least one degree of freedom must remain besides those of the factors and the mean.
  if (samples <= scores_.cols() + 2) return;
  inverse_ = definite_inverse(transposed_product(scores_, scores_), least_determined);
}

std::vector<double> PartialRankCorrelations::of(const std::vector<double>& response) const {
  std::vector<double> found(static_cast<std::size_t>(scores_.cols()), std::numeric_limits<double>::quiet_NaN());
  if (!inverse_) return found;
  const Eigen::VectorXd score = scores_of(response);
  if (score.isZero(0.0)) return found;
  const Eigen::VectorXd correlation = scores_.transpose() * score;
  const Eigen::VectorXd slope = *inverse_ * correlation;
  const double rest = std::max(0.0, 1.0 - correlation.dot(slope));
  for (Eigen::Index k = 0; k < slope.size(); ++k) {
    found[static_cast<std::size_t>(k)] = slope[k] / std::sqrt(slope[k] * slope[k] + rest * (*inverse_)(k, k));
  }
  return found;
}

}  // namespace bumpfoil
