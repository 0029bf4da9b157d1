#pragma once

#include <cstddef>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// A reading of a measured loop, and its position.
struct Reading {
  double displacement{};
  double force{};
  double tau{};         ///< time, from -1/2 at the start of the loop to 1/2 at its end
  bool pull{};          ///< on the unloading branch
  std::size_t point{};  ///< index of the point of equal arc length to whose residual it contributes
};

/// A measured loop as points of equal arc length, with displacement and force scaled by their ranges. Thus a section of
/// the loop counts by its length, however many readings it has: turning points, with steep changes of force, have few.
/// Noise would lengthen the loop, so arc length is measured along means of neighbouring readings.
class MeasuredCurve {
 public:
  /// @param fully_reversed  whether the loop is fully reversed: it then rises again from its minimum displacement
  MeasuredCurve(const FitData& data, bool fully_reversed);

  [[nodiscard]] const std::vector<Reading>& readings() const { return readings_; }
  [[nodiscard]] std::size_t points() const { return counts_.size(); }

  /// Number of readings of each point, at least one.
  [[nodiscard]] const std::vector<int>& counts() const { return counts_; }

  /// Mean over the readings of each point. @param value  (Reading) -> double
  template <typename Value>
  [[nodiscard]] std::vector<double> means(const Value& value) const {
    std::vector<double> sums(points(), 0.0);
    for (const Reading& reading : readings_) sums[reading.point] += value(reading);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts_[i];
    return sums;
  }

  /// Standard deviation of one force reading about the line through its neighbours in time, from the median, which the
  /// few readings at turns do not affect [Gasser1986]; N.
  [[nodiscard]] double scatter() const;

  [[nodiscard]] double top() const { return top_; }        ///< largest displacement, m
  [[nodiscard]] double bottom() const { return bottom_; }  ///< smallest displacement after it, m
  [[nodiscard]] double tau_at_top() const { return tau_at_top_; }
  [[nodiscard]] double force_range() const { return force_range_; }
  [[nodiscard]] double displacement_range() const { return displacement_range_; }

 private:
  void assign_points(int points);

  std::vector<Reading> readings_;
  std::vector<int> counts_;
  double top_{}, bottom_{}, tau_at_top_{}, force_range_{}, displacement_range_{};
};

}  // namespace bumpfoil
