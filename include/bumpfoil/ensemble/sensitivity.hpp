#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace bumpfoil {

/// Ranks of numbers among each other, from 1; equal ones share the mean of theirs. Infinite numbers have ranks, too.
std::vector<double> ranks_of(const std::vector<double>& values);

/// How much a response depends on each of several factors, the others held: partial rank correlations, which detect any
/// monotonic dependence, linear or not. With the correlations R of the ranks of the factors and r of these with the
/// ranks of the response, Q = R^-1 and b = Q r,
///
///     rho_k = b_k / sqrt(b_k^2 + (1 - r'b) Q_kk)
class PartialRankCorrelations {
 public:
  /// @param factors  values of each, one per sample
  explicit PartialRankCorrelations(const std::vector<std::vector<double>>& factors);

  /// @param response  one value per sample   @return one number per factor, from -1 to 1; not numbers where there are
  /// too few samples, a factor or the response is always the same, or factors follow from each other
  [[nodiscard]] std::vector<double> of(const std::vector<double>& response) const;

 private:
  Eigen::MatrixXd scores_;                  ///< ranks of each factor in a column, mean 0, length 1
  std::optional<Eigen::MatrixXd> inverse_;  ///< Q; nothing if no correlation is defined
};

}  // namespace bumpfoil
