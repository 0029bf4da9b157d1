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

void StraightPiece::measure_begin(const ContactProblem& problem) {
  begin_force = std::max(problem.least_reference_force(), begin.normal_force.cwiseAbs().maxCoeff());
  force_tolerance = relative_force_tolerance * begin_force;
}

void StraightPiece::measure_target() {
  const double largest = target.normal_force.maxCoeff();
  target_force = std::max(largest, -target.normal_force.minCoeff());
  force_tolerance = relative_force_tolerance * std::max(begin_force, largest);
}

/// A margin that is `now` at the begin and negative `then`: the contact changes its mode where it is spent.
void StraightPiece::limit(Eigen::Index c, double now, double then, ContactMode to) {
  constexpr double above_roundings = 1.0 + 1e-14;
  if (now > above_roundings * end_part * (now - then)) return;  // most lie beyond, and need no division
  const double part = now <= 0.0 ? 0.0 : now / (now - then);
  if (part > end_part) return;
  if (part < end_part) limits.clear();
  end_part = part;
  limits.push_back({c, to});
}

void StraightPiece::look_ahead(const ContactProblem& problem, std::vector<ModeChange>& changes) {
  changes.clear();
  limits.clear();
  end_part = 1.0;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double f = contact.f;
    const ContactMode m = target.mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open) {
      if (target.gap[c] >= -displacement_tolerance) return;
      const ContactMode to =
          next_mode(m, f, trial_of(contact, target, begin.x), displacement_tolerance, force_tolerance);
      limit(c, begin.gap[c], target.gap[c], to);
      if (begin.gap[c] <= displacement_tolerance) changes.push_back({c, to});
      return;
    }
    const double p = begin.normal_force[c];
    const double p_then = target.normal_force[c];
    const bool loaded = p > force_tolerance;
    if (p_then < -force_tolerance) limit(c, p, p_then, ContactMode::open);
    if (m == ContactMode::stick && f > 0.0) {
      const double t = begin.friction_force[c];
      for (const double side : {1.0, -1.0}) {
        const double margin_then = f * p_then - side * target.friction_force[c];
        if (margin_then >= -force_tolerance) continue;
        const double margin = f * p - side * t;
        limit(c, margin, margin_then, slip_mode(-side));
        // Free to choose only at its bound, and only if it would leave the cone on that side: the normal force may fall
        // faster than the friction force.
        const bool on_bound = margin <= force_tolerance && side == std::copysign(1.0, t);
        if (loaded && on_bound) changes.push_back({c, slip_mode(-side)});
      }
    }
    if (loaded && m == ContactMode::stick) return;
    ContactTrial trial = trial_of(contact, target, begin.x);
    if (loaded) trial.normal = std::max(0.0, trial.normal);  // will open later on the way, if at all
    const ContactMode to = next_mode(m, f, trial, displacement_tolerance, force_tolerance);
    if (to != m) changes.push_back({c, to});
  });
}

/// Whether the forces and the gap of a contact with friction coefficient f are at the begin what its mode asks for.
bool StraightPiece::begin_obeys(Eigen::Index c, double f) const {
  const double p = begin.normal_force[c];
  const double t = begin.friction_force[c];
  const ContactMode m = target.mode[static_cast<std::size_t>(c)];
  if (m == ContactMode::open) return std::abs(p) <= force_tolerance && std::abs(t) <= force_tolerance;
  if (std::abs(begin.gap[c]) > displacement_tolerance) return false;
  return !slips(m) || f == 0.0 || std::abs(t - friction_sign(m) * f * p) <= force_tolerance;
}

bool StraightPiece::begin_obeys_modes(const ContactProblem& problem) const {
  bool obeys = true;
  for_each_contact(problem,
                   [&](const CoulombContact& contact) { obeys = obeys && begin_obeys(contact.index, contact.f); });
  return obeys;
}

bool StraightPiece::begin_obeys_new_modes(const ContactProblem& problem) const {
  return for_each_difference(target.mode, begin.mode, [&](std::size_t c) {
    const ContactPair& pair = problem.pairs[c % problem.pairs.size()];
    return begin_obeys(static_cast<Eigen::Index>(c), pair.tangential >= 0 ? pair.friction_coefficient : 0.0);
  });
}

}  // namespace bumpfoil
