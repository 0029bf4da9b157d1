#include "optimise/point_merits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bumpfoil {
namespace {

/// Magnitude of a quantity at the first point that has it.
double size_at_first(const std::vector<OptimisePoint>& points, std::vector<double> OptimisePoint::*numbers,
                     std::size_t i) {
  for (const OptimisePoint& point : points) {
    if (point.status != PointStatus::converged) continue;
    if (const double size = std::abs((point.*numbers)[i]); size > 0.0) return size;
  }
  return 1.0;
}

}  // namespace

void PointMerits::take_sizes(const std::vector<OptimisePoint>& points) {
  aim_scales_.reserve(problem_.aims.size());
  for (std::size_t i = 0; i < problem_.aims.size(); ++i) {
    aim_scales_.push_back(size_at_first(points, &OptimisePoint::aims, i));
  }
  limit_scales_.reserve(problem_.limits.size());
  for (std::size_t i = 0; i < problem_.limits.size(); ++i) {
    const double bound = std::abs(problem_.limits[i].bound);
    limit_scales_.push_back(bound > 0.0 ? bound : size_at_first(points, &OptimisePoint::limits, i));
  }
}

bool PointMerits::meets(const OptimisePoint& point, const SearchGoal& goal) const {
  return problem_.is_feasible(point) && (!goal.other || goal.other->margin(point.aims[1 - goal.aim]) >= 0.0);
}

double PointMerits::scaled_aim(const OptimisePoint& point, std::size_t aim) const {
  return (problem_.aims[aim].maximise ? -1.0 : 1.0) * point.aims[aim] / aim_scales_[aim];
}

Eigen::VectorXd PointMerits::scaled_limits(const OptimisePoint& point, const SearchGoal& goal) const {
  const std::size_t count = problem_.limits.size();
  Eigen::VectorXd all(std::ssize(problem_.limits) + (goal.other ? 1 : 0));
  for (std::size_t i = 0; i < count; ++i) {
    all[static_cast<Eigen::Index>(i)] = -problem_.limits[i].margin(point.limits[i]) / limit_scales_[i];
  }
  if (goal.other) {
    const std::size_t other = 1 - goal.aim;
    all[all.size() - 1] = -goal.other->margin(point.aims[other]) / aim_scales_[other];
  }
  return all;
}

std::pair<double, double> PointMerits::merit(const OptimisePoint& point, const SearchGoal& goal) const {
  const Eigen::VectorXd missed = scaled_limits(point, goal);
  const double most = missed.size() > 0 && !meets(point, goal) ? missed.maxCoeff() : 0.0;
  return {std::max(most, 0.0), scaled_aim(point, goal.aim)};
}

const OptimisePoint* PointMerits::best_of(const std::vector<OptimisePoint>& points, const SearchGoal& goal) const {
  const OptimisePoint* best = nullptr;
  for (const OptimisePoint& point : points) {
    if (!meets(point, goal)) continue;
    if (best == nullptr || scaled_aim(point, goal.aim) < scaled_aim(*best, goal.aim)) best = &point;
  }
  return best;
}

std::vector<SearchGoal> PointMerits::goals_between(const OptimisePoint& first, const OptimisePoint& last,
                                                   int count) const {
  std::vector<SearchGoal> goals;
  goals.reserve(static_cast<std::size_t>(count));
  const bool above = problem_.aims[1].maximise;
  for (int k = 1; k <= count; ++k) {
    const double bound = first.aims[1] + (last.aims[1] - first.aims[1]) * k / (count + 1.0);
    goals.push_back({0, OptimiseLimit{.text = {}, .quantity = {}, .above = above, .bound = bound}});
  }
  return goals;
}

std::vector<std::size_t> PointMerits::front_of(const std::vector<OptimisePoint>& points,
                                               const std::vector<SearchGoal>& goals) const {
  std::vector<const OptimisePoint*> best;
  const auto add = [&](const SearchGoal& goal) {
    const OptimisePoint* const point = best_of(points, goal);
    if (point != nullptr && std::find(best.begin(), best.end(), point) == best.end()) best.push_back(point);
  };
  add({0});
  for (const SearchGoal& goal : goals) add(goal);
  add({1});
  const auto is_beaten = [&](const OptimisePoint* point) {
    return std::any_of(best.begin(), best.end(), [&](const OptimisePoint* other) {
      return other != point && scaled_aim(*other, 0) <= scaled_aim(*point, 0) &&
             scaled_aim(*other, 1) <= scaled_aim(*point, 1);
    });
  };
  std::vector<const OptimisePoint*> kept;
  std::copy_if(best.begin(), best.end(), std::back_inserter(kept),
               [&](const auto* point) { return !is_beaten(point); });
  std::stable_sort(kept.begin(), kept.end(),
                   [&](const auto* a, const auto* b) { return scaled_aim(*a, 0) < scaled_aim(*b, 0); });
  std::vector<std::size_t> front;
  front.reserve(kept.size());
  for (const OptimisePoint* point : kept) front.push_back(static_cast<std::size_t>(point - points.data()));
  return front;
}

std::size_t middle_of_front(const std::vector<OptimisePoint>& points, const std::vector<std::size_t>& front) {
  const OptimisePoint& first = points[front.front()];
  const OptimisePoint& last = points[front.back()];
  const auto part = [](const OptimisePoint& point, std::size_t aim, const OptimisePoint& best,
                       const OptimisePoint& worst) {
    const double range = worst.aims[aim] - best.aims[aim];
    return range == 0.0 ? 0.0 : (point.aims[aim] - best.aims[aim]) / range;
  };
  const auto distance = [&](std::size_t number) {
    return std::hypot(part(points[number], 0, first, last), part(points[number], 1, last, first));
  };
  return *std::min_element(front.begin(), front.end(),
                           [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
}

}  // namespace bumpfoil
