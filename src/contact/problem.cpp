#include "bumpfoil/contact/problem.hpp"

#include <algorithm>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

std::vector<ContactSite> in_every_block(const std::vector<ContactSite>& pattern, int blocks) {
  std::vector<ContactSite> sites;
  sites.reserve(pattern.size() * static_cast<std::size_t>(blocks));
  for (int block = 0; block < blocks; ++block) {
    for (ContactSite site : pattern) {
      site.block = block;
      sites.push_back(site);
    }
  }
  return sites;
}

std::vector<std::size_t> first_sites(const ContactProblem& problem) {
  const auto blocks = static_cast<std::size_t>(problem.K.blocks());
  std::vector<std::size_t> first(blocks + 1, 0);
  for (std::size_t c = 0; c < problem.sites.size(); ++c) {
    const int block = problem.sites[c].block;
    BUMPFOIL_ASSERT(block >= 0 && block < problem.K.blocks() && (c == 0 || block >= problem.sites[c - 1].block));
    ++first[static_cast<std::size_t>(block) + 1];
  }
  for (std::size_t b = 0; b < blocks; ++b) first[b + 1] += first[b];
  return first;
}

bool is_same(const ContactProblem& a, const ContactProblem& b) {
  return !a.law && !b.law && a.K == b.K && a.sites == b.sites && a.force_scale == b.force_scale;
}

ContactLoading ContactLoading::none(const ContactProblem& problem) {
  return {.initial_gap = Vector::Zero(problem.contacts()), .load = Vector::Zero(problem.K.rows())};
}

ContactState ContactState::unstressed(const ContactProblem& problem) {
  const Eigen::Index contacts = problem.contacts();
  return {.x = Vector::Zero(problem.K.rows()),
          .gap = Vector::Zero(contacts),
          .normal_force = Vector::Zero(contacts),
          .friction_force = Vector::Zero(contacts),
          .mode = std::vector<ContactMode>(static_cast<std::size_t>(contacts), ContactMode::open)};
}

bool ContactState::any_slips() const {
  return std::any_of(mode.begin(), mode.end(), slips);
}

Vector contact_gaps(const ContactProblem& problem, const Vector& initial_gap, const Vector& x) {
  BUMPFOIL_ASSERT(initial_gap.size() == problem.contacts() && x.size() == problem.K.rows());
  Vector gap = initial_gap;
  for_each_contact(problem, [&](const CoulombContact& contact) { gap[contact.index] += contact.gap(x); });
  return gap;
}

Vector contact_forces(const ContactProblem& problem, const Vector& normal_force, const Vector& friction_force) {
  Vector force = Vector::Zero(problem.K.rows());
  for_each_contact(problem, [&](const CoulombContact& contact) {
    contact.add_forces(normal_force[contact.index], friction_force[contact.index], 1.0, force);
  });
  return force;
}

Vector tangential_displacements(const ContactProblem& problem, const Vector& x) {
  Vector tangential(problem.contacts());
  for_each_contact(problem, [&](const CoulombContact& contact) { tangential[contact.index] = contact.tangential(x); });
  return tangential;
}

}  // namespace bumpfoil
