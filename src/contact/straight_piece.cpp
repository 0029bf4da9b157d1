#include "contact/straight_piece.hpp"

#include <algorithm>
#include <cmath>

namespace bumpfoil {

StraightPiece::StraightPiece(const ContactProblem& problem) : begin(ContactState::unstressed(problem)), target(begin) {
  limits.reserve(begin.mode.size());
}

double StraightPiece::end_fraction() const {
  return end_part < 1.0 ? begin_fraction + end_part * (1.0 - begin_fraction) : 1.0;
}

double StraightPiece::part_at(double fraction) const {
  return (fraction - begin_fraction) / (1.0 - begin_fraction);
}

void StraightPiece::at(double part, ContactState& state) const {
  state.mode = target.mode;
  for (Vector ContactState::*field :
       {&ContactState::x, &ContactState::gap, &ContactState::normal_force, &ContactState::friction_force}) {
    state.*field = (1.0 - part) * (begin.*field) + part * (target.*field);
  }
}

void StraightPiece::measure_forces(const ContactProblem& problem) {
  force_tolerance = relative_force_tolerance * std::max({problem.least_reference_force(), begin.normal_force.maxCoeff(),
                                                         target.normal_force.maxCoeff()});
}

void StraightPiece::find_changes(const ContactProblem& problem, std::vector<ModeChange>& changes) const {
  changes.clear();
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double f = contact.f;
    const ContactMode m = target.mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open && begin.gap[c] > displacement_tolerance) return;
    const bool loaded = begin.normal_force[c] > force_tolerance;
    if (loaded && m == ContactMode::stick) {
      // Free to choose only at its bound, and only if it would leave the cone on that side: the normal force may fall
      // faster than the friction force.
      const double side = std::copysign(1.0, begin.friction_force[c]);
      const bool on_bound = f * begin.normal_force[c] - side * begin.friction_force[c] <= force_tolerance;
      const bool leaves = f * target.normal_force[c] - side * target.friction_force[c] < -force_tolerance;
      if (f > 0.0 && on_bound && leaves) changes.push_back({c, slip_mode(-side)});
      return;
    }
    ContactTrial trial = trial_of(contact, target, begin.x);
    if (loaded) trial.normal = std::max(0.0, trial.normal);  // will open later on the way, if at all
    const ContactMode to = next_mode(m, f, trial, displacement_tolerance, force_tolerance);
    if (to != m) changes.push_back({c, to});
  });
}

/// Whether the forces and the gap of a contact are at the begin what its mode asks for.
bool StraightPiece::begin_obeys(const CoulombContact& contact) const {
  const Eigen::Index c = contact.index;
  const double p = begin.normal_force[c];
  const double t = begin.friction_force[c];
  const ContactMode m = target.mode[static_cast<std::size_t>(c)];
  if (m == ContactMode::open) return std::abs(p) <= force_tolerance && std::abs(t) <= force_tolerance;
  if (std::abs(begin.gap[c]) > displacement_tolerance) return false;
  return !slips(m) || contact.f == 0.0 || std::abs(t - friction_sign(m) * contact.f * p) <= force_tolerance;
}

bool StraightPiece::begin_obeys_modes(const ContactProblem& problem) const {
  bool obeys = true;
  for_each_contact(problem, [&](const CoulombContact& contact) { obeys = obeys && begin_obeys(contact); });
  return obeys;
}

bool StraightPiece::begin_obeys_new_modes(const ContactProblem& problem) const {
  bool obeys = true;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const auto c = static_cast<std::size_t>(contact.index);
    if (target.mode[c] != begin.mode[c]) obeys = obeys && begin_obeys(contact);
  });
  return obeys;
}

void StraightPiece::find_limits(const ContactProblem& problem) {
  limits.clear();
  end_part = 1.0;
  const auto pass = [&](Eigen::Index c, double now, double then, ContactMode to) {
    const double part = now <= 0.0 ? 0.0 : now / (now - then);
    if (part > end_part) return;
    if (part < end_part) limits.clear();
    end_part = part;
    limits.push_back({c, to});
  };
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const ContactMode m = target.mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open) {
      if (target.gap[c] >= -displacement_tolerance) return;
      const ContactTrial trial = trial_of(contact, target, begin.x);
      pass(c, begin.gap[c], target.gap[c], next_mode(m, contact.f, trial, displacement_tolerance, force_tolerance));
      return;
    }
    const double p = begin.normal_force[c];
    const double p_then = target.normal_force[c];
    if (p_then < -force_tolerance) pass(c, p, p_then, ContactMode::open);
    if (m != ContactMode::stick || contact.f == 0.0) return;
    for (const double side : {1.0, -1.0}) {
      const double margin = contact.f * p_then - side * target.friction_force[c];
      if (margin >= -force_tolerance) continue;
      pass(c, contact.f * p - side * begin.friction_force[c], margin, slip_mode(-side));
    }
  });
}

}  // namespace bumpfoil
