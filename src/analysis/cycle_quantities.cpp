#include "bumpfoil/analysis/cycle_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bumpfoil {
namespace {

/// Takes the stresses of one place, `per_bump` columns for each bump, for the peak where they are higher.
void raise(std::optional<StressPeak>& peak, const Increment& increment, const FieldMatrix& stress, Eigen::Index row,
           StressPlace place, int per_bump) {
  for (Eigen::Index i = 0; i < stress.cols(); ++i) {
    if (peak && !(stress(row, i) > peak->stress)) continue;
    peak = StressPeak{.stress = stress(row, i),
                      .place = place,
                      .bump = per_bump > 0 ? static_cast<int>(i) / per_bump : -1,
                      .increment = increment.index,
                      .displacement = increment.displacement};
  }
}

}  // namespace

void Clearance::add(const Increment& increment) {
  if (!displacement_ && increment.force_direct >= threshold_) {
    const double part = began_ ? (threshold_ - last_force_) / (increment.force_direct - last_force_) : 0.0;
    displacement_ = began_ ? last_displacement_ + part * (increment.displacement - last_displacement_) : 0.0;
  }
  last_displacement_ = increment.displacement;
  last_force_ = increment.force_direct;
  began_ = true;
}

std::optional<double> first_contact_displacement(const Vector& gaps, const Eigen::Matrix2Xd& normals,
                                                 const Vector& top_displacement, const Eigen::Vector2d& direction) {
  constexpr double facing = 1e-12;  // a cosine below this is a right angle with roundings
  std::optional<double> first;
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    const double cosine = normals.col(i).dot(direction);
    if (cosine <= facing) continue;
    const double displacement = std::max(0.0, (gaps[i] + top_displacement[i]) / cosine);
    first = std::min(first.value_or(displacement), displacement);
  }
  return first;
}

std::optional<double> loss_factor(double loop_energy, double elastic_energy_stored) {
  if (!(elastic_energy_stored > 0.0)) return std::nullopt;
  return loop_energy / (2.0 * std::numbers::pi * elastic_energy_stored);
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

void CycleQuantities::add(const Increment& increment, bool judged, bool ends_leg) {
  cycle_.cost += increment.cost;
  cycle_.substeps += increment.substeps;
  // An unknown residual is no small one.
  double& largest = cycle_.max_residual;
  if (judged && !std::isnan(largest) && !(increment.residuals.equilibrium <= largest)) {
    largest = increment.residuals.equilibrium;
  }
  if (!increment.converged()) {
    cycle_.status = increment.status;
    return;
  }
  ++good_;
  work_ = increment.work;
  if (increment.index == 0) cycle_.start = increment;
  if (increment.index <= cycle_.steps) {
    clearance_5N_.add(increment);
    clearance_10N_.add(increment);
  }
  if (ends_leg) cycle_.turns.push_back(increment);
}

void CycleQuantities::turn(TurningPoint response) {
  const Increment& turning = cycle_.turns.front();
  response.max_force = turning.force_direct;
  response.cross_force = turning.force_cross;
  response.elastic_energy = turning.elastic_energy;
  response.secant_stiffness = turning.force_direct / cycle_.amplitude;
  cycle_.turning_point = std::move(response);
}

void CycleQuantities::finish() {
  cycle_.clearance_5N = clearance_5N_.displacement();
  cycle_.clearance_10N = clearance_10N_.displacement();
  cycle_.top_foil_stress = top_foil_peak(cycle_.fields.stress, cycle_.increments);
  cycle_.bump_foil_stress = bump_foil_peak(cycle_.fields.stress, cycle_.increments);
  if (good_ != cycle_.due || !cycle_.turning_point) return;
  cycle_.loop_energy = work_;
  cycle_.loss_factor =
      loss_factor(*cycle_.loop_energy, cycle_.turning_point->elastic_energy - cycle_.start->elastic_energy);
}

}  // namespace bumpfoil
