#pragma once

#include <utility>
#include <vector>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// One contact of a problem, with Coulomb's law, located by its place in the block.
struct CoulombContact {
  const ContactSite& site;
  double f;            ///< friction coefficient, 0 where frictionless
  Eigen::Index row;    ///< first unknown of its block
  Eigen::Index index;  ///< in contact arrays

  /// Part of the gap that depends on the unknowns, m.
  [[nodiscard]] double gap(const Vector& x) const {
    return (site.plus >= 0 ? x[row + site.plus] : 0.0) - (site.minus >= 0 ? x[row + site.minus] : 0.0);
  }
  [[nodiscard]] double tangential(const Vector& x) const {
    return site.tangential >= 0 ? x[row + site.tangential] : 0.0;
  }
  /// Adds the forces of compression p and friction t (N) times `factor` to the forces on the unknowns.
  void add_forces(double p, double t, double factor, Vector& force) const {
    if (site.plus >= 0) force[row + site.plus] += factor * p;
    if (site.minus >= 0) force[row + site.minus] -= factor * p;
    if (site.tangential >= 0) force[row + site.tangential] += factor * t;
  }
};

/// Whether a contact never carries friction.
inline bool is_frictionless(const ContactSite& site) {
  return site.tangential < 0 || site.friction_coefficient == 0.0;
}

/// Sign of the friction force of a slipping contact, in units of f p: it opposes the slip.
inline double friction_sign(ContactMode mode) {
  if (mode == ContactMode::slip_forward) return -1.0;
  if (mode == ContactMode::slip_backward) return 1.0;
  return 0.0;
}

inline bool slips(ContactMode mode) {
  return mode == ContactMode::slip_forward || mode == ContactMode::slip_backward;
}

/// Slip in the direction of `slip`, or against a friction force of opposite sign.
inline ContactMode slip_mode(double slip) {
  return slip > 0.0 ? ContactMode::slip_forward : ContactMode::slip_backward;
}

/// Calls visit(CoulombContact) for every contact in blocks of `block_size` unknowns, in the order of contact arrays.
template <typename Visitor>
void for_each_contact(const std::vector<ContactSite>& sites, Eigen::Index block_size, Visitor&& visit) {
  Eigen::Index index = 0;
  for (const ContactSite& site : sites) {
    visit(
        CoulombContact{site, site.tangential >= 0 ? site.friction_coefficient : 0.0, site.block * block_size, index++});
  }
}

/// The same for all contacts of a problem.
template <typename Visitor>
void for_each_contact(const ContactProblem& problem, Visitor&& visit) {
  for_each_contact(problem.sites, problem.K.block_size(), std::forward<Visitor>(visit));
}

}  // namespace bumpfoil
