#include "bumpfoil/analysis/cycle_quantities.hpp"

#include <algorithm>
#include <numbers>

#include "bumpfoil/contact/linear_systems.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// Takes the stress for the peak if it is higher.
void raise(std::optional<StressPeak>& peak, const Increment& increment, double stress, StressPlace place, int bump) {
  if (peak && !(stress > peak->stress)) return;
  peak = StressPeak{.stress = stress,
                    .place = place,
                    .bump = bump,
                    .increment = increment.index,
                    .displacement = increment.displacement};
}

/// The same for a list of stresses, `per_bump` for each bump.
void raise(std::optional<StressPeak>& peak, const Increment& increment, const Vector& stress, StressPlace place,
           int per_bump) {
  for (Eigen::Index i = 0; i < stress.size(); ++i) {
    raise(peak, increment, stress[i], place, static_cast<int>(i) / per_bump);
  }
}

}  // namespace

std::optional<double> clearance_at(const std::vector<Increment>& increments, double threshold) {
  if (increments.empty()) return std::nullopt;
  if (increments.front().force_direct >= threshold) return 0.0;
  for (std::size_t k = 1; k < increments.size() && increments[k].branch == Branch::loading; ++k) {
    const Increment& before = increments[k - 1];
    const Increment& after = increments[k];
    if (after.force_direct < threshold) continue;
    const double part = (threshold - before.force_direct) / (after.force_direct - before.force_direct);
    return before.displacement + part * (after.displacement - before.displacement);
  }
  return std::nullopt;
}

std::optional<double> first_contact_displacement(double clearance, const Eigen::Matrix2Xd& normals,
                                                 const Vector& top_displacement, const Eigen::Vector2d& direction) {
  constexpr double facing = 1e-12;  // a cosine below this is a right angle with roundings
  std::optional<double> first;
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    const double cosine = normals.col(i).dot(direction);
    if (cosine <= facing) continue;
    const double displacement = std::max(0.0, (clearance + top_displacement[i]) / cosine);
    first = std::min(first.value_or(displacement), displacement);
  }
  return first;
}

std::optional<double> loss_factor(double loop_energy, double elastic_energy_stored) {
  if (!(elastic_energy_stored > 0.0)) return std::nullopt;
  return loop_energy / (2.0 * std::numbers::pi * elastic_energy_stored);
}

TangentStiffnesses tangent_stiffnesses(const FoilModel& model, const ContactState& state,
                                       const Eigen::Vector2d& direction) {
  const std::unique_ptr<ModeSystem> system = make_mode_system(model.problem);
  system->set_elasticity(tangent_stiffness(model.structure, state.x));
  const ContactLoading motion = loading_rate(model, direction);
  ContactState rate = ContactState::unstressed(model.problem);
  const Vector at_rest = rate.x;
  const auto stiffness = [&](const std::vector<ContactMode>& modes) -> std::optional<double> {
    if (!system->set_modes(modes)) return std::nullopt;
    system->solve(motion, at_rest, rate);
    return holding_force(model, rate.normal_force).dot(direction);
  };

  std::vector<ContactMode> sticking = state.mode;
  for (ContactMode& m : sticking) {
    if (m != ContactMode::open) m = ContactMode::stick;
  }
  return {.loading = stiffness(state.mode), .unloading = stiffness(sticking)};
}

std::optional<StressPeak> top_foil_peak(const std::vector<Increment>& increments) {
  std::optional<StressPeak> peak;
  for (const Increment& increment : increments) {
    if (increment.stress.top_weld) raise(peak, increment, *increment.stress.top_weld, StressPlace::weld, -1);
    raise(peak, increment, increment.stress.top_crest, StressPlace::crest, 1);
  }
  return peak;
}

std::optional<StressPeak> bump_foil_peak(const std::vector<Increment>& increments) {
  std::optional<StressPeak> peak;
  for (const Increment& increment : increments) {
    const FoilStress& stress = increment.stress;
    if (stress.bump_weld) raise(peak, increment, *stress.bump_weld, StressPlace::weld, -1);
    raise(peak, increment, stress.bump_crest, StressPlace::crest, 1);
    raise(peak, increment, stress.bump_foot, StressPlace::foot, 2);
    raise(peak, increment, stress.bump_largest, StressPlace::arc, 1);
  }
  return peak;
}

void derive_quantities(Cycle& cycle, const std::optional<TangentStiffnesses>& tangents) {
  const std::vector<Increment>& increments = cycle.increments;
  const auto all = static_cast<std::size_t>(cycle.due);
  const auto good = static_cast<std::size_t>(std::count_if(
      increments.begin(), increments.end(), [](const Increment& increment) { return increment.solve.converged; }));
  cycle.converged = good == all;
  cycle.top_foil_stress = top_foil_peak(increments);
  cycle.bump_foil_stress = bump_foil_peak(increments);
  if (good > 0) {
    cycle.clearance_5N = clearance_at(increments, 5.0);
    cycle.clearance_10N = clearance_at(increments, 10.0);
  }
  if (good > static_cast<std::size_t>(cycle.steps) && tangents) {
    const Increment& turning = cycle.at_turning_point();
    cycle.turning_point = TurningPoint{.max_force = turning.force_direct,
                                       .cross_force = turning.force_cross,
                                       .elastic_energy = turning.elastic_energy,
                                       .tangent = *tangents,
                                       .secant_stiffness = turning.force_direct / cycle.amplitude};
  }
  if (good == all && cycle.turning_point) {
    cycle.loop_energy = increments.back().work;
    cycle.loss_factor =
        loss_factor(*cycle.loop_energy, cycle.turning_point->elastic_energy - increments.front().elastic_energy);
  }
}

}  // namespace bumpfoil
