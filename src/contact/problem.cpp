#include "bumpfoil/contact/problem.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Calls visit(contact, pair, first row of its block) for every contact.
template <typename Visitor>
void for_each_contact(const ContactProblem& problem, Visitor&& visit) {
  Eigen::Index contact = 0;
  for (Eigen::Index row = 0; row < problem.K.rows(); row += problem.K.block_size()) {
    for (const ContactPair& pair : problem.pairs) visit(contact++, pair, row);
  }
}

}  // namespace

ContactState ContactState::unstressed(const ContactProblem& problem) {
  const Eigen::Index contacts = problem.contacts();
  return {.x = Vector::Zero(problem.K.rows()),
          .gap = Vector::Zero(contacts),
          .normal_force = Vector::Zero(contacts),
          .friction_force = Vector::Zero(contacts),
          .mode = std::vector<ContactMode>(static_cast<std::size_t>(contacts), ContactMode::open)};
}

Vector contact_gaps(const ContactProblem& problem, const Vector& initial_gap, const Vector& x) {
  BUMPFOIL_ASSERT(initial_gap.size() == problem.contacts() && x.size() == problem.K.rows());
  Vector gap = initial_gap;
  for_each_contact(problem, [&](Eigen::Index contact, const ContactPair& pair, Eigen::Index row) {
    if (pair.plus >= 0) gap[contact] += x[row + pair.plus];
    if (pair.minus >= 0) gap[contact] -= x[row + pair.minus];
  });
  return gap;
}

Vector contact_forces(const ContactProblem& problem, const Vector& normal_force, const Vector& friction_force) {
  Vector force = Vector::Zero(problem.K.rows());
  for_each_contact(problem, [&](Eigen::Index contact, const ContactPair& pair, Eigen::Index row) {
    if (pair.plus >= 0) force[row + pair.plus] += normal_force[contact];
    if (pair.minus >= 0) force[row + pair.minus] -= normal_force[contact];
    if (pair.tangential >= 0) force[row + pair.tangential] += friction_force[contact];
  });
  return force;
}

Vector tangential_displacements(const ContactProblem& problem, const Vector& x) {
  Vector tangential = Vector::Zero(problem.contacts());
  for_each_contact(problem, [&](Eigen::Index contact, const ContactPair& pair, Eigen::Index row) {
    if (pair.tangential >= 0) tangential[contact] = x[row + pair.tangential];
  });
  return tangential;
}

}  // namespace bumpfoil
