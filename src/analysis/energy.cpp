#include "analysis/energy.hpp"

#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {

double gap_work(const ContactProblem& problem, const ContactState& begin, const ContactState& end) {
  double work = 0.0;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double opened_by_foils = contact.gap(end.x) - contact.gap(begin.x);
    const double initial_gap_change = end.gap[c] - begin.gap[c] - opened_by_foils;
    work -= 0.5 * (begin.normal_force[c] + end.normal_force[c]) * initial_gap_change;
  });
  return work;
}

double friction_dissipation(const ContactProblem& problem, const Vector& normal_force, const Vector& begin_x,
                            const Vector& end_x) {
  double dissipation = 0.0;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const double slip = contact.tangential(end_x) - contact.tangential(begin_x);
    dissipation += contact.f * normal_force[contact.index] * std::abs(slip);
  });
  return dissipation;
}

}  // namespace bumpfoil
