#include "bumpfoil/analysis/cycle_quantities.hpp"

#include <algorithm>
#include <numbers>

#include "bumpfoil/contact/linear_systems.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {

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

std::optional<double> first_contact_displacement(const BearingModel& model, const Vector& top_displacement,
                                                 const Eigen::Vector2d& direction) {
  constexpr double facing = 1e-12;  // a cosine below this is a right angle with roundings
  std::optional<double> first;
  for (Eigen::Index i = 0; i < model.phi.size(); ++i) {
    const double cosine = unit_vector(model.phi[i]).dot(direction);
    if (cosine <= facing) continue;
    const double displacement = std::max(0.0, (model.bearing.radial_clearance + top_displacement[i]) / cosine);
    first = std::min(first.value_or(displacement), displacement);
  }
  return first;
}

std::optional<double> loss_factor(double loop_energy, double elastic_energy_stored) {
  if (!(elastic_energy_stored > 0.0)) return std::nullopt;
  return loop_energy / (2.0 * std::numbers::pi * elastic_energy_stored);
}

TangentStiffnesses tangent_stiffnesses(const BearingModel& model, const std::vector<ContactMode>& mode,
                                       const Eigen::Vector2d& direction) {
  const std::unique_ptr<ModeSystem> system = make_mode_system(model.problem);
  const ContactLoading rate = loading_rate(model, direction);
  ContactState state = ContactState::unstressed(model.problem);
  const Vector at_rest = state.x;
  const auto stiffness = [&](const std::vector<ContactMode>& modes) {
    if (!system->set_modes(modes)) return 0.0;
    system->solve(rate, at_rest, state);
    return journal_force(model.phi, journal_loads(model, state.normal_force)).dot(direction);
  };

  std::vector<ContactMode> sticking = mode;
  for (ContactMode& m : sticking) {
    if (m != ContactMode::open) m = ContactMode::stick;
  }
  return {.loading = stiffness(mode), .unloading = stiffness(sticking)};
}

}  // namespace bumpfoil
