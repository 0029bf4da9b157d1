#include "analysis/energy.hpp"

#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {

double gap_work(const Vector& mean_force, const Vector& gap_change) {
  return -mean_force.dot(gap_change);
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
