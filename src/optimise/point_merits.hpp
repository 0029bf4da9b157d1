#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "bumpfoil/optimise/optimise.hpp"

namespace bumpfoil {

/// Target of a search: an aim, and the limit on the other aim.
struct SearchGoal {
  std::size_t aim{};
  std::optional<OptimiseLimit> other{};
};

/// How good points are, with aims and limits in parts of their sizes.
class PointMerits {
 public:
  /// @param problem  has aims and limits, and lives as long as this
  explicit PointMerits(const OptimiseResult& problem) : problem_(problem) {}

  /// Takes the sizes of quantities from the first of the points that has them; of limits whose bound is not zero that
  /// of the bound. Due before all else.
  void take_sizes(const std::vector<OptimisePoint>& points);

  [[nodiscard]] bool meets(const OptimisePoint& point, const SearchGoal& goal) const;

  /// An aim, to be minimised. @pre of all that follow: the point converged
  [[nodiscard]] double scaled_aim(const OptimisePoint& point, std::size_t aim) const;
  /// Limits of a goal, not to be positive.
  [[nodiscard]] Eigen::VectorXd scaled_limits(const OptimisePoint& point, const SearchGoal& goal) const;
  /// Smaller is better: first the violation of limits, then the aim.
  [[nodiscard]] std::pair<double, double> merit(const OptimisePoint& point, const SearchGoal& goal) const;

  /// The best of those that meet a goal; null where none does.
  [[nodiscard]] const OptimisePoint* best_of(const std::vector<OptimisePoint>& points, const SearchGoal& goal) const;

  /// Goals between the ends of a front, from the best of the first aim on: the second is to be better and better.
  [[nodiscard]] std::vector<SearchGoal> goals_between(const OptimisePoint& first, const OptimisePoint& last,
                                                      int count) const;
  /// Numbers of the best points of both aims and of `goals`, without those that another is no worse than in both aims;
  /// from the best of the first aim on.
  [[nodiscard]] std::vector<std::size_t> front_of(const std::vector<OptimisePoint>& points,
                                                  const std::vector<SearchGoal>& goals) const;

 private:
  const OptimiseResult& problem_;
  std::vector<double> aim_scales_;
  std::vector<double> limit_scales_;
};

/// The point of a front that is nearest to the best of both aims, each in parts of its range along the front.
std::size_t middle_of_front(const std::vector<OptimisePoint>& points, const std::vector<std::size_t>& front);

}  // namespace bumpfoil
