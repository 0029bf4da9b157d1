#include "bumpfoil/bearing/energy.hpp"

#include <cmath>
#include <cstddef>
#include <iterator>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {

double gap_work(const Vector& mean_force, const Vector& gap_change) {
  return -mean_force.dot(gap_change);
}

double friction_work(const ContactProblem& problem, const ContactState& begin, const ContactState& end) {
  const Vector slip = tangential_displacements(problem, end.x) - tangential_displacements(problem, begin.x);
  return -0.5 * (begin.friction_force + end.friction_force).dot(slip);
}

FrictionDissipation::FrictionDissipation(const ContactProblem& problem) {
  // Ordered by rank within their blocks, so that the sums of corresponding contacts along the foil are contiguous.
  std::vector<std::vector<CoulombContact>> ranks;
  int block = -1;
  std::size_t rank = 0;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    rank = contact.site.block == block ? rank + 1 : 0;
    block = contact.site.block;
    if (is_frictionless(contact.site)) return;
    ranks.resize(std::max(ranks.size(), rank + 1));
    ranks[rank].push_back(contact);
  });
  for (const std::vector<CoulombContact>& contacts : ranks) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (i == 0 || contacts[i].f != contacts[i - 1].f) {
        coefficients_.push_back(contacts[i].f);
        ends_.push_back(contacts_.size());
      }
      contacts_.push_back(contacts[i].index);
      unknowns_.push_back(contacts[i].row + contacts[i].site.tangential);
      ends_.back() = contacts_.size();
    }
  }
}

double FrictionDissipation::of(const Vector& normal_force, const Vector& begin_x, const Vector& end_x) const {
  double dissipation = 0.0;
  std::size_t i = 0;
  for (std::size_t kind = 0; kind < ends_.size(); ++kind) {
    double work = 0.0;  // in units of the friction coefficient
    for (; i < ends_[kind]; ++i) {
      const Eigen::Index x = unknowns_[i];
      work += normal_force[contacts_[i]] * std::abs(end_x[x] - begin_x[x]);
    }
    dissipation += coefficients_[kind] * work;
  }
  return dissipation;
}

}  // namespace bumpfoil
