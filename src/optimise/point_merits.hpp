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

/// Ranks points, with aims and limits scaled by their sizes.
class PointMerits {
 public:
  /// @param problem  defines aims and limits; must outlive this
  explicit PointMerits(const OptimiseResult& problem) : problem_(problem) {}

  /// Sets the scale of each quantity from the first point that has it; that of a limit with a nonzero bound is the
  /// bound. Call before all else.
  void take_sizes(const std::vector<OptimisePoint>& points);

  [[nodiscard]] bool meets(const OptimisePoint& point, const SearchGoal& goal) const;

  /// An aim, to be minimised. @pre for this and the following functions: the point converged
  [[nodiscard]] double scaled_aim(const OptimisePoint& point, std::size_t aim) const;
  /// Limits of a goal, which must not be positive.
  [[nodiscard]] Eigen::VectorXd scaled_limits(const OptimisePoint& point, const SearchGoal& goal) const;
  /// Smaller is better: first by violation of limits, then by aim.
  [[nodiscard]] std::pair<double, double> merit(const OptimisePoint& point, const SearchGoal& goal) const;

  /// The best of the points that meet a goal; null if there is none.
  [[nodiscard]] const OptimisePoint* best_of(const std::vector<OptimisePoint>& points, const SearchGoal& goal) const;

  /// Goals between the ends of a front, starting from the best of the first aim: the second improves from goal to goal.
  [[nodiscard]] std::vector<SearchGoal> goals_between(const OptimisePoint& first, const OptimisePoint& last,
                                                      int count) const;
  /// Indices of the best points of both aims and of `goals`, without those dominated in both aims; starting from the
  /// best of the first aim.
  [[nodiscard]] std::vector<std::size_t> front_of(const std::vector<OptimisePoint>& points,
                                                  const std::vector<SearchGoal>& goals) const;

 private:
  const OptimiseResult& problem_;
  std::vector<double> aim_scales_;
  std::vector<double> limit_scales_;
};

/// The point of a front that is closest to the best of both aims, each scaled by its range along the front.
std::size_t middle_of_front(const std::vector<OptimisePoint>& points, const std::vector<std::size_t>& front);

}  // namespace bumpfoil
