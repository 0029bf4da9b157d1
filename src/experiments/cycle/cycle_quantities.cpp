#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bumpfoil {
namespace {

/// Whether a peak is higher than one before by more than round-off, so that every compiler finds the same place: the
/// end of an arc is a crest, and symmetric bumps have equal stresses.
bool is_higher(double later, double before) {
  constexpr double round_off = 1e-10;
  return later > before + round_off * std::abs(before);
}

/// Updates the peak with the stresses at one kind of location, `per_bump` columns for each bump. 0 per bump: one column
/// for the weld of each pad.
void raise(std::optional<StressPeak>& peak, const Increment& increment, const FieldMatrix& stress, Eigen::Index row,
           StressPlace place, int per_bump) {
  for (Eigen::Index i = 0; i < stress.cols(); ++i) {
    if (peak && !is_higher(stress(row, i), peak->stress)) continue;
    peak = StressPeak{.stress = stress(row, i),
                      .place = place,
                      .bump = per_bump > 0 ? static_cast<int>(i) / per_bump : -1,
                      .pad = per_bump > 0 ? 0 : static_cast<int>(i),
                      .increment = increment.index,
                      .displacement = increment.displacement};
  }
}

/// Displacement at which the segment between two points crosses `threshold`.
double crossing(const LoadingCurve::Point& from, const LoadingCurve::Point& to, double threshold) {
  const double part = (threshold - from.force) / (to.force - from.force);
  return from.displacement + part * (to.displacement - from.displacement);
}

/// The higher of two peaks; of equal ones the first.
template <typename Peak>
void take_higher(std::optional<Peak>& peak, const std::optional<Peak>& later, double Peak::*height) {
  if (!peak || (later && is_higher((*later).*height, (*peak).*height))) peak = later;
}

/// The force passes this fraction of its maximum at the take-up point.
constexpr double take_up_force = 0.01;
/// A loop energy below this fraction of the largest work is round-off.
constexpr double least_loop = 1e-10;

std::optional<double> if_positive(double value) {
  return value > 0.0 ? std::optional(value) : std::nullopt;
}

}  // namespace

void LoadingCurve::add(const Point& point) {
  if (first_contact_ && !points_.empty() && points_.back().displacement < *first_contact_ &&
      *first_contact_ < point.displacement) {
    points_.push_back({*first_contact_, points_.back().force});
  }
  points_.push_back(point);
}

std::optional<double> LoadingCurve::first_reaches(double threshold) const {
  const auto reached = std::find_if(points_.begin(), points_.end(),
                                    [threshold](const Point& point) { return point.force >= threshold; });
  if (reached == points_.end()) return std::nullopt;
  if (reached == points_.begin()) return reached->displacement;
  return crossing(*(reached - 1), *reached, threshold);
}

LoadingCurve::Point LoadingCurve::last_rises_through(double threshold) const {
  const auto below = std::find_if(points_.rbegin(), points_.rend(),
                                  [threshold](const Point& point) { return point.force < threshold; });
  if (below == points_.rend()) return points_.front();
  return {crossing(*below, *(below - 1), threshold), threshold};
}

std::optional<double> first_contact_displacement(const Vector& gaps, const Eigen::Matrix2Xd& normals,
                                                 const Eigen::Vector2d& direction) {
  constexpr double facing = 1e-12;  // a smaller cosine is a right angle up to round-off
  std::optional<double> first;
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    const double cosine = normals.col(i).dot(direction);
    if (cosine <= facing) continue;
    const double displacement = std::max(0.0, gaps[i] / cosine);
    first = std::min(first.value_or(displacement), displacement);
  }
  return first;
}

std::optional<StressPeak> top_foil_peak(const StressFields& stress, const std::vector<Increment>& increments) {
  std::optional<StressPeak> peak;
  for (Eigen::Index row = 0; row < stress.top_crest.rows(); ++row) {
    const Increment& increment = increments[static_cast<std::size_t>(row)];
    raise(peak, increment, stress.top_weld, row, StressPlace::weld, 0);
    raise(peak, increment, stress.top_crest, row, StressPlace::crest, 1);
  }
  return peak;
}

std::optional<StressPeak> bump_foil_peak(const StressFields& stress, const std::vector<Increment>& increments) {
  std::optional<StressPeak> peak;
  for (Eigen::Index row = 0; row < stress.bump_crest.rows(); ++row) {
    const Increment& increment = increments[static_cast<std::size_t>(row)];
    raise(peak, increment, stress.bump_weld, row, StressPlace::weld, 0);
    raise(peak, increment, stress.bump_crest, row, StressPlace::crest, 1);
    raise(peak, increment, stress.bump_foot, row, StressPlace::foot, 2);
    raise(peak, increment, stress.bump_largest, row, StressPlace::arc, 1);
  }
  return peak;
}

std::optional<CompressionPeak> compression_peak(const FieldMatrix& compression,
                                                const std::vector<Increment>& increments) {
  std::optional<CompressionPeak> peak;
  for (Eigen::Index row = 0; row < compression.rows(); ++row) {
    const Increment& increment = increments[static_cast<std::size_t>(row)];
    for (Eigen::Index bump = 0; bump < compression.cols(); ++bump) {
      if (peak && !is_higher(compression(row, bump), peak->compression)) continue;
      peak = CompressionPeak{.compression = compression(row, bump),
                             .bump = static_cast<int>(bump),
                             .increment = increment.index,
                             .displacement = increment.displacement};
    }
  }
  return peak;
}

void CycleQuantities::add(const Increment& increment, bool checked, bool ends_leg,
                          std::span<const LoadingCurve::Point> between) {
  cycle_.cost += increment.cost;
  cycle_.substeps += increment.substeps;
  // NaN must not count as a small residual.
  double& largest = cycle_.max_residual;
  if (checked && !std::isnan(largest) && !(increment.residuals.equilibrium <= largest)) {
    largest = increment.residuals.equilibrium;
  }
  if (!increment.converged()) {
    cycle_.status = increment.status;
    return;
  }
  ++good_;
  work_ = increment.work;
  largest_work_ = std::max(largest_work_, std::abs(work_));
  if (increment.index == 0) cycle_.start = increment;
  if (cycle_.course == Course::one_sided && increment.index <= cycle_.steps) {
    for (const LoadingCurve::Point& point : between) loading_.add(point);
    loading_.add({increment.displacement, increment.force_direct});
  }
  if (ends_leg) cycle_.turns.push_back(increment);
}

void CycleQuantities::turn(TurningPoint response) {
  const Increment& turning = cycle_.turns.front();
  response.max_force = turning.force_direct;
  response.cross_force = turning.force_cross;
  response.elastic_energy = turning.elastic_energy;
  cycle_.turning_point = std::move(response);
}

/// Quantities from the turning points only.
void CycleQuantities::find_stiffness() {
  const Increment& top = cycle_.turns.front();
  LoadingCurve::Point base;
  if (cycle_.course == Course::fully_reversed) {
    if (cycle_.turns.size() < 2) return;
    base = {cycle_.turns[1].displacement, cycle_.turns[1].force_direct};
  } else {
    cycle_.secant_stiffness = top.force_direct / top.displacement;
    if (!(top.force_direct > 0.0)) return;
    base = loading_.last_rises_through(take_up_force * top.force_direct);
    cycle_.take_up = base.displacement;
  }
  const double range = top.displacement - base.displacement;
  if (!(range > 0.0)) return;
  half_range_ = 0.5 * range;
  cycle_.loaded_stiffness = if_positive((top.force_direct - base.force) / range);
}

/// Quantities from the complete loop.
void CycleQuantities::find_losses() {
  const double loop = cleared(work_, least_loop * largest_work_);
  cycle_.loop_energy = loop;
  if (cycle_.loaded_stiffness) {
    cycle_.loss_factor = loop / (std::numbers::pi * *cycle_.loaded_stiffness * half_range_ * half_range_);
  }
  if (const auto stored = if_positive(cycle_.turning_point->elastic_energy - cycle_.start->elastic_energy)) {
    cycle_.specific_damping_capacity = loop / *stored;
  }
}

void CycleQuantities::take_recorded() {
  const FoilFields& fields = cycle_.fields;
  take_higher(cycle_.top_foil_stress, top_foil_peak(fields.stress, cycle_.increments), &StressPeak::stress);
  take_higher(cycle_.bump_foil_stress, bump_foil_peak(fields.stress, cycle_.increments), &StressPeak::stress);
  take_higher(cycle_.compression, compression_peak(fields.compression, cycle_.increments),
              &CompressionPeak::compression);
  const Vector forces = largest_pad_forces(fields);
  Vector& largest = cycle_.largest_pad_forces;
  largest = largest.size() == 0 ? forces : forces.size() == 0 ? largest : Vector(largest.cwiseMax(forces));
}

void CycleQuantities::finish() {
  for (Clearance& clearance : cycle_.clearances) clearance.displacement = loading_.first_reaches(clearance.force);
  take_recorded();
  if (!cycle_.turning_point) return;
  find_stiffness();
  if (good_ == cycle_.due) find_losses();
}

}  // namespace bumpfoil
