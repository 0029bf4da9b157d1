#include "bumpfoil/analysis/energy.hpp"

#include <cmath>

namespace bumpfoil {

double gap_work(const ContactProblem& problem, const ContactState& begin, const ContactState& end) {
  const Vector opened_by_foils = contact_gaps(problem, Vector::Zero(problem.contacts()), end.x - begin.x);
  const Vector initial_gap_change = end.gap - begin.gap - opened_by_foils;
  return -0.5 * (begin.normal_force + end.normal_force).dot(initial_gap_change);
}

double friction_dissipation(const ContactProblem& problem, const Vector& normal_force, const Vector& begin_x,
                            const Vector& end_x) {
  const Vector slip = tangential_displacements(problem, end_x - begin_x);
  double dissipation = 0.0;
  for (Eigen::Index c = 0; c < slip.size(); ++c) {
    const ContactPair& pair = problem.pairs[static_cast<std::size_t>(c) % problem.pairs.size()];
    dissipation += pair.friction_coefficient * normal_force[c] * std::abs(slip[c]);
  }
  return dissipation;
}

}  // namespace bumpfoil
