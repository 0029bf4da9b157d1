#include "bumpfoil/contact/residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bumpfoil {
namespace {

/// max that keeps a NaN, so that a broken state is never judged good.
void raise(double& largest, double value) {
  if (!(value <= largest)) largest = value;
}

}  // namespace

ContactResiduals contact_residuals(const ContactProblem& problem, const Vector& elastic_force,
                                   const ContactLoading& loading, const Vector& previous_x, const ContactState& state) {
  const Vector& p = state.normal_force;
  const Vector& t = state.friction_force;
  const Vector gap = contact_gaps(problem, loading.initial_gap, state.x);
  const Vector slip = tangential_displacements(problem, state.x) - tangential_displacements(problem, previous_x);
  const Vector imbalance = elastic_force - loading.load - contact_forces(problem, p, t);
  const double scale = std::max({p.cwiseAbs().maxCoeff(), t.cwiseAbs().maxCoeff(), 1.0});
  // A force is inside the cone where it stays clear of the bound by more than the force tolerance.
  const double clear_of_the_bound = 1e-9 * scale;

  ContactResiduals residuals;
  for (const double entry : imbalance) raise(residuals.equilibrium, std::abs(entry) / scale);
  for (Eigen::Index c = 0; c < problem.contacts(); ++c) {
    const ContactPair& pair = problem.pairs[static_cast<std::size_t>(c) % problem.pairs.size()];
    const double f = pair.tangential >= 0 ? pair.friction_coefficient : 0.0;
    const double bound = f * p[c];
    raise(residuals.penetration, -gap[c]);
    raise(residuals.complementarity, -p[c] / scale);
    if (gap[c] > displacement_resolution) raise(residuals.complementarity, p[c] / scale);
    raise(residuals.cone, (std::abs(t[c]) - bound) / scale);
    if (std::abs(t[c]) < bound - clear_of_the_bound || std::isnan(slip[c])) {
      raise(residuals.slip_in_stick, std::abs(slip[c]));
    } else if (std::abs(slip[c]) > displacement_resolution) {
      raise(residuals.cone, std::abs(t[c] + std::copysign(bound, slip[c])) / scale);
    }
  }
  return residuals;
}

}  // namespace bumpfoil
