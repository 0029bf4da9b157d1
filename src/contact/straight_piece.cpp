#include "contact/straight_piece.hpp"

#include <algorithm>
#include <cmath>

namespace bumpfoil {

StraightPiece::StraightPiece(const ContactProblem& problem) : begin(ContactState::unstressed(problem)), target(begin) {
  limits.reserve(3 * begin.mode.size());  // a contact may open or leave its cone on either side
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
    const bool loaded = begin.normal_force[c] > force_tolerance;
    if (m == ContactMode::open && begin.gap[c] > displacement_tolerance) return;
    ContactTrial trial = trial_of(contact, target, begin.x);
    if (loaded) {
      trial.normal = std::max(0.0, trial.normal);  // will open later on the way, if at all
      if (m == ContactMode::stick) {
        // Free to choose only at its bound, and only if it would leave the cone on that side: the normal force may
        // fall faster than the friction force.
        const double side = std::copysign(1.0, begin.friction_force[c]);
        const bool on_bound = f * begin.normal_force[c] - side * begin.friction_force[c] <= force_tolerance;
        const bool leaves = f * target.normal_force[c] - side * target.friction_force[c] < -force_tolerance;
        if (f > 0.0 && on_bound && leaves) changes.push_back({c, slip_mode(-side)});
        return;
      }
    }
    const ContactMode to = next_mode(m, f, trial, displacement_tolerance, force_tolerance);
    if (to != m) changes.push_back({c, to});
  });
}

bool StraightPiece::begin_obeys_modes(const ContactProblem& problem) const {
  bool obeys = true;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double p = begin.normal_force[c];
    const double t = begin.friction_force[c];
    const ContactMode m = target.mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open) {
      obeys = obeys && std::abs(p) <= force_tolerance && std::abs(t) <= force_tolerance;
      return;
    }
    obeys = obeys && std::abs(begin.gap[c]) <= displacement_tolerance;
    if (slips(m) && contact.f > 0.0) {
      obeys = obeys && std::abs(t - friction_sign(m) * contact.f * p) <= force_tolerance;
    }
  });
  return obeys;
}

void StraightPiece::find_limits(const ContactProblem& problem) {
  limits.clear();
  end_part = 1.0;
  const auto add = [&](Eigen::Index c, double now, double then, ContactMode to) {
    const double part = now <= 0.0 ? 0.0 : now / (now - then);
    limits.push_back({part, c, to});
    end_part = std::min(end_part, part);
  };
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const double f = contact.f;
    const ContactMode m = target.mode[static_cast<std::size_t>(c)];
    if (m == ContactMode::open) {
      const ContactMode to =
          next_mode(m, f, trial_of(contact, target, begin.x), displacement_tolerance, force_tolerance);
      if (to != m) add(c, begin.gap[c], target.gap[c], to);
      return;
    }
    if (target.normal_force[c] < -force_tolerance) {
      add(c, begin.normal_force[c], target.normal_force[c], ContactMode::open);
    }
    if (m == ContactMode::stick && f > 0.0) {
      for (const double side : {1.0, -1.0}) {
        const double margin = f * target.normal_force[c] - side * target.friction_force[c];
        if (margin < -force_tolerance) {
          add(c, f * begin.normal_force[c] - side * begin.friction_force[c], margin, slip_mode(-side));
        }
      }
    }
  });
}

}  // namespace bumpfoil
