#include "experiments/fit/fit_statistics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/results/dataset.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Singular values below this fraction of the largest are round-off of differences.
constexpr double singular = 1e-6;
/// A parameter that changes residuals by less from bound to bound, in standard deviations, has no effect.
constexpr double difference_floor = 1e-3;
/// Components of a direction below this are omitted from texts.
constexpr double least_part = 0.2;
/// Two changes with a ratio this close to 1 are called a sum or a difference.
constexpr double near_one = 0.2;

std::string joined(const std::vector<std::string>& names) {
  if (names.size() == 1) return names.front();
  const auto last = names.end() - 1;
  return fmt::format("{} and {}", fmt::join(names.begin(), last, ", "), *last);
}

std::string with_unit(double number, const std::string& unit) {
  return fmt::format("{:+.3g}{}{}", number, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

/// @param change  of the parameters, SI, that the data poorly determine
std::string words_of(const std::vector<std::size_t>& which, const Eigen::VectorXd& change,
                     const std::vector<FitParameter>& parameters, const std::vector<std::string>& units) {
  const std::vector<std::string> names = each(which, [&](std::size_t i) { return parameters[i].key; });
  if (which.size() != 2) {
    const std::vector<std::string> changes = each(which, [&](std::size_t i) {
      return fmt::format("{} of {}", with_unit(change[static_cast<Eigen::Index>(i)], units[i]), parameters[i].key);
    });
    return fmt::format("{} hardly change the data together: {}", joined(names), fmt::join(changes, ", "));
  }
  const double first = change[static_cast<Eigen::Index>(which[0])];
  const double second = change[static_cast<Eigen::Index>(which[1])];
  const double ratio = -first / second;
  const bool same_unit = units[which[0]] == units[which[1]];
  if (same_unit && std::abs(std::abs(ratio) - 1.0) < near_one) {
    return fmt::format("{}: only their {} can be identified", joined(names), ratio > 0.0 ? "sum" : "difference");
  }
  return fmt::format("{} are hardly separable: {} of one makes up for {} of the other", joined(names),
                     with_unit(std::abs(first), units[which[0]]),
                     with_unit(first > 0.0 ? second : -second, units[which[1]]));
}

}  // namespace

Eigen::MatrixXd covariance_of(const FitEstimate& estimate) {
  const Eigen::Index count = estimate.sensitivities.cols();
  std::vector<Eigen::Index> open;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!estimate.held[static_cast<std::size_t>(i)]) open.push_back(i);
  }
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(count, count, absent);
  if (open.empty()) return covariance;
  const auto size = static_cast<Eigen::Index>(open.size());
  const Eigen::VectorXd roots = estimate.weights.cwiseSqrt();
  Eigen::MatrixXd scaled(estimate.sensitivities.rows(), size);
  Eigen::VectorXd lengths(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    scaled.col(k) = roots.cwiseProduct(estimate.sensitivities.col(open[static_cast<std::size_t>(k)]));
    lengths[k] = scaled.col(k).norm();
    if (lengths[k] > 0.0) scaled.col(k) /= lengths[k];
  }
  const auto [values, right] = singular_vectors(scaled);
  Eigen::VectorXd inverse_squares = Eigen::VectorXd::Zero(size);
  std::vector<bool> determined(open.size(), true);
  for (Eigen::Index s = 0; s < size; ++s) {
    if (values[s] > singular * values[0]) {
      inverse_squares[s] = 1.0 / (values[s] * values[s]);
      continue;
    }
    for (Eigen::Index k = 0; k < size; ++k) {
      if (std::abs(right(k, s)) > singular) determined[static_cast<std::size_t>(k)] = false;
    }
  }
  // Parameters by residuals: the pseudo-inverse V S^-2 (A V)^T of A = sqrt(W) J, times sqrt(W).
  const Eigen::MatrixXd left = product(scaled, right);
  const Eigen::MatrixXd gains = product(right * inverse_squares.asDiagonal(), left.transpose()) * roots.asDiagonal();
  const Eigen::MatrixXd inner = product(gains * estimate.variances.asDiagonal(), gains.transpose());
  for (Eigen::Index a = 0; a < size; ++a) {
    for (Eigen::Index b = 0; b < size; ++b) {
      if (!determined[static_cast<std::size_t>(a)] || !determined[static_cast<std::size_t>(b)]) continue;
      covariance(open[static_cast<std::size_t>(a)], open[static_cast<std::size_t>(b)]) =
          inner(a, b) / (lengths[a] * lengths[b]);
    }
  }
  return covariance;
}

double student_975(int degrees_of_freedom) {
  // Cornish-Fisher expansion about the normal distribution.
  constexpr double z = 1.959963984540054;
  const double n = degrees_of_freedom;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n);
}

bool is_excessive(double chi_square, int degrees_of_freedom) {
  constexpr double deviations = 4.0;
  const double spread = 2.0 / (9.0 * degrees_of_freedom);
  return std::cbrt(chi_square / degrees_of_freedom) > 1.0 - spread + deviations * std::sqrt(spread);
}

std::vector<std::string> hardly_told(const Eigen::MatrixXd& sensitivities, const std::vector<FitParameter>& parameters,
                                     const std::vector<std::string>& units, double& collinearity) {
  std::vector<std::string> lines;
  const Eigen::VectorXd lengths = sensitivities.colwise().norm();
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < lengths.size(); ++i) {
    const FitParameter& parameter = parameters[static_cast<std::size_t>(i)];
    if (lengths[i] * (parameter.upper - parameter.lower) < difference_floor) {
      lines.push_back(fmt::format("{} does not change the data", parameter.key));
    } else {
      seen.push_back(i);
    }
  }
  collinearity = 1.0;
  if (seen.size() < 2) return lines;
  Eigen::MatrixXd scaled(sensitivities.rows(), static_cast<Eigen::Index>(seen.size()));
  for (std::size_t k = 0; k < seen.size(); ++k) {
    scaled.col(static_cast<Eigen::Index>(k)) = sensitivities.col(seen[k]) / lengths[seen[k]];
  }
  const auto [values, right] = singular_vectors(scaled);
  collinearity = 1.0 / std::max(values[values.size() - 1], singular);
  for (Eigen::Index s = values.size(); s-- > 0;) {
    if (values[s] * collinear > 1.0) break;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(lengths.size());
    std::vector<std::size_t> which;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double part = right(static_cast<Eigen::Index>(k), s);
      if (std::abs(part) < least_part) continue;
      change[seen[k]] = part / lengths[seen[k]];
      which.push_back(static_cast<std::size_t>(seen[k]));
    }
    // Scaled to change the first parameter by 1 % of its bounds.
    const FitParameter& first = parameters[which.front()];
    change *= 0.01 * (first.upper - first.lower) / std::abs(change[static_cast<Eigen::Index>(which.front())]);
    lines.push_back(words_of(which, change, parameters, units));
  }
  return lines;
}

}  // namespace bumpfoil
