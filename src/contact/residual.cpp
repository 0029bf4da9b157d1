#include "bumpfoil/contact/residual.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {
namespace {

/// max that propagates NaN, so that a broken state never passes.
void raise(double& largest, double value) {
  if (!(value <= largest)) largest = value;
}

}  // namespace

ContactResiduals contact_residuals(const ContactProblem& problem, const Vector& elastic_force,
                                   const ContactLoading& loading, const Vector& previous_x, const ContactState& state) {
  const Vector& p = state.normal_force;
  const Vector& t = state.friction_force;
  const double scale = std::max({p.cwiseAbs().maxCoeff(), t.cwiseAbs().maxCoeff(), 1.0});
  // A force is inside the cone if its distance from the bound exceeds the force tolerance.
  const double clear_of_the_bound = 1e-9 * scale;

  ContactResiduals residuals;
  Vector imbalance = elastic_force - loading.load;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    contact.add_forces(p[c], t[c], -1.0, imbalance);
    const double gap = loading.initial_gap[c] + contact.gap(state.x);
    const double slip = contact.tangential(state.x) - contact.tangential(previous_x);
    const double bound = contact.f * p[c];
    raise(residuals.penetration, -gap);
    raise(residuals.complementarity, gap > displacement_resolution ? std::abs(p[c]) : -p[c]);
    raise(residuals.cone, std::abs(t[c]) - bound);
    if (std::abs(t[c]) < bound - clear_of_the_bound || std::isnan(slip)) {
      raise(residuals.slip_in_stick, std::abs(slip));
    } else if (std::abs(slip) > displacement_resolution) {
      raise(residuals.cone, std::abs(t[c] + std::copysign(bound, slip)));
    }
  });
  for (const double entry : imbalance) raise(residuals.equilibrium, std::abs(entry));
  for (double* force : {&residuals.equilibrium, &residuals.complementarity, &residuals.cone}) *force /= scale;
  return residuals;
}

}  // namespace bumpfoil
