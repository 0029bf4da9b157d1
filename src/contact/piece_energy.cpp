#include "contact/piece_energy.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {
namespace {

constexpr double negligible_part = 1e-11;
constexpr double negligible_length = 1e-14;  // m; a tenth of the tolerance of solvers for gaps and slips

}  // namespace

PieceEnergy piece_energy(const ContactProblem& problem, const ContactState& begin, const ContactState& end) {
  PieceEnergy energy;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double p = 0.5 * (begin.normal_force[c] + end.normal_force[c]);
    const double t = 0.5 * (begin.friction_force[c] + end.friction_force[c]);
    const double slip = contact.tangential(end.x) - contact.tangential(begin.x);
    energy.given_off -= p * (end.gap[c] - begin.gap[c]) + t * slip;
    energy.friction += contact.f * p * std::abs(slip);
  });
  return energy;
}

double negligible_energy(const ContactProblem& problem, const ContactState& begin, const ContactState& end) {
  double energy = 0.0;
  double force = problem.least_reference_force();
  for (const ContactState* state : {&begin, &end}) {
    energy = std::max(energy, 0.5 * state->x.dot(problem.K.multiply(state->x)));
    force = std::max(force, state->normal_force.cwiseAbs().maxCoeff());
  }
  return std::max(negligible_part * energy, negligible_length * force);
}

}  // namespace bumpfoil
