#include "experiments/fit/measured_curve.hpp"

#include <algorithm>
#include <cmath>

namespace bumpfoil {
namespace {

/// The median of absolute deviations of a normal distribution is 1/1.4826 standard deviations.
constexpr double std_over_median = 1.4826;
/// Deviations from the mean of both neighbours have 1 + 1/4 + 1/4 times the variance of a reading.
constexpr double variance_of_differences = 1.5;
/// Lower bound of the scatter over the force range, as for load cells of class 0.05: computed or filtered loops scatter
/// less.
constexpr double least_scatter = 5e-4;

/// Mean of `value` over entries of a list.
template <typename Value>
double mean_of(const std::vector<Reading>& readings, std::size_t from, std::size_t to, const Value& value) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) sum += value(readings[i]);
  return sum / static_cast<double>(to - from);
}

}  // namespace

MeasuredCurve::MeasuredCurve(const FitData& data, bool fully_reversed) {
  const std::vector<double>& s = data.displacements;
  const std::size_t count = s.size();
  const auto top = std::max_element(s.begin(), s.end());
  const auto bottom = std::min_element(top, s.end());
  const auto [lowest, highest] = std::minmax_element(data.forces.begin(), data.forces.end());
  top_ = *top;
  bottom_ = *bottom;
  force_range_ = *highest - *lowest;
  displacement_range_ = *top - *std::min_element(s.begin(), s.end());
  const auto turns = static_cast<std::size_t>(top - s.begin());
  const auto turns_again = fully_reversed ? static_cast<std::size_t>(bottom - s.begin()) : count;
  readings_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double tau = static_cast<double>(i) / static_cast<double>(count - 1) - 0.5;
    readings_.push_back({s[i], data.forces[i], tau, i > turns && i <= turns_again, 0});
  }
  tau_at_top_ = readings_[turns].tau;
  assign_points(data.points);
}

void MeasuredCurve::assign_points(int points) {
  // Use two neighbour means per point.
  const std::size_t coarse = std::min(readings_.size(), 2 * static_cast<std::size_t>(points));
  const auto first_of = [&](std::size_t group) { return group * readings_.size() / coarse; };
  std::vector<double> along(coarse, 0.0);
  double last_s = 0.0;
  double last_force = 0.0;
  for (std::size_t group = 0; group < coarse; ++group) {
    const double s =
        mean_of(readings_, first_of(group), first_of(group + 1), [](const Reading& one) { return one.displacement; });
    const double force =
        mean_of(readings_, first_of(group), first_of(group + 1), [](const Reading& one) { return one.force; });
    if (group > 0) {
      along[group] =
          along[group - 1] + std::hypot((s - last_s) / displacement_range_, (force - last_force) / force_range_);
    }
    last_s = s;
    last_force = force;
  }
  const double whole = along.back();
  std::size_t last_place = 0;
  bool last_pull = false;
  for (std::size_t group = 0; group < coarse; ++group) {
    for (std::size_t i = first_of(group); i < first_of(group + 1); ++i) {
      Reading& reading = readings_[i];
      // Each point belongs to one branch.
      const auto place = static_cast<std::size_t>(std::min(along[group] / whole, 1.0 - 1e-12) * points);
      if (counts_.empty() || place != last_place || reading.pull != last_pull) counts_.push_back(0);
      last_place = place;
      last_pull = reading.pull;
      reading.point = counts_.size() - 1;
      ++counts_.back();
    }
  }
}

double MeasuredCurve::scatter() const {
  std::vector<double> deviations;
  deviations.reserve(readings_.size());
  for (std::size_t i = 1; i + 1 < readings_.size(); ++i) {
    deviations.push_back(std::abs(readings_[i].force - 0.5 * (readings_[i - 1].force + readings_[i + 1].force)));
  }
  const auto middle = deviations.begin() + std::ssize(deviations) / 2;
  std::nth_element(deviations.begin(), middle, deviations.end());
  return std::max(std_over_median * *middle / std::sqrt(variance_of_differences), least_scatter * force_range_);
}

}  // namespace bumpfoil
