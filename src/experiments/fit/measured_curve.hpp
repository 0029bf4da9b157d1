#pragma once

#include <cstddef>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// A reading of a measured loop, and where it belongs.
struct Reading {
  double displacement{};
  double force{};
  double tau{};         ///< time, from -1/2 at the start of the loop to 1/2 at its end
  bool pull{};          ///< on the way back
  std::size_t point{};  ///< of equal arc length, whose residual it is part of
};

/// A measured loop in points of equal arc length, with displacement and force scaled by their ranges. So a part of the
/// loop counts by its length, however many readings a rig takes of it: turning points, where the force falls steeply,
/// have few. Noise would lengthen the loop; so its length is that through means of neighbouring readings.
class MeasuredCurve {
 public:
  /// @param swings  the loop goes to both sides: what follows its lowest displacement is a push again
  MeasuredCurve(const FitData& data, bool swings);

  [[nodiscard]] const std::vector<Reading>& readings() const { return readings_; }
  [[nodiscard]] std::size_t points() const { return counts_.size(); }

  /// Number of readings of each point; none is without.
  [[nodiscard]] const std::vector<int>& counts() const { return counts_; }

  /// Mean over the readings of each point. @param value  (Reading) -> double
  template <typename Value>
  [[nodiscard]] std::vector<double> means(const Value& value) const {
    std::vector<double> sums(points(), 0.0);
    for (const Reading& reading : readings_) sums[reading.point] += value(reading);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts_[i];
    return sums;
  }

  /// Standard deviation of one reading of the force about the line through its neighbours in time, by the median, to
  /// which the few at turns do not matter [Gasser1986]; N.
  [[nodiscard]] double scatter() const;

  [[nodiscard]] double top() const { return top_; }        ///< largest displacement, m
  [[nodiscard]] double bottom() const { return bottom_; }  ///< smallest behind it, m
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
