#include "contact/straight_piece.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/extremes.hpp"
#include "bumpfoil/core/vector_instructions.hpp"

namespace bumpfoil {
namespace {

/// First screening distance in lengths of the last piece, and the factor by which it grows if no contact reaches a
/// limit within it. Affects speed, not results.
constexpr double first_sight = 2.0;
constexpr double farther_sight = 8.0;
constexpr double least_sight = 0.01;

}  // namespace

StraightPiece::StraightPiece(const ContactProblem& problem)
    : begin(ContactState::unstressed(problem)),
      target(begin),
      friction_coefficient_(Vector::Zero(problem.contacts())),
      tangential_(begin.mode.size()),
      mode_(begin.mode.size(), ContactMode::open),
      closed_(friction_coefficient_),
      held_(friction_coefficient_),
      sense_(friction_coefficient_),
      slip_(friction_coefficient_),
      clear_(friction_coefficient_),
      near_(begin.mode.size()) {
  limits.reserve(begin.mode.size());
  for_each_contact(problem, [&](const CoulombContact& contact) {
    if (contact.f == 0.0) return;
    friction_coefficient_[contact.index] = contact.f;
    tangential_[static_cast<std::size_t>(contact.index)] = static_cast<int>(contact.row + contact.site.tangential);
    can_slip_.push_back(contact.index);
  });
}

double StraightPiece::end_fraction() const {
  return end_part < 1.0 ? begin_fraction + end_part * (1.0 - begin_fraction) : 1.0;
}

double StraightPiece::part_at(double fraction) const {
  return (fraction - begin_fraction) / (1.0 - begin_fraction);
}

void StraightPiece::at(double part, ContactState& state) const {
  state.mode = target.mode;
  with_widest_vectors([&](auto /*lanes*/) BUMPFOIL_ALWAYS_INLINE {
    for (Vector ContactState::*field :
         {&ContactState::x, &ContactState::gap, &ContactState::normal_force, &ContactState::friction_force}) {
      const Eigen::Index count = (begin.*field).size();
      (state.*field).resize(count);
      const double* const from = (begin.*field).data();
      const double* const to = (target.*field).data();
      double* const between = (state.*field).data();
      const double fraction = part;
      BUMPFOIL_INDEPENDENT
      for (Eigen::Index i = 0; i < count; ++i) between[i] = (1.0 - fraction) * from[i] + fraction * to[i];
    }
  });
}

void StraightPiece::measure_begin(const ContactProblem& problem) {
  begin_force = std::max(problem.least_reference_force(), extremes_of(begin.normal_force).size());
  force_tolerance = relative_force_tolerance * begin_force;
}

void StraightPiece::measure_target() {
  const Extremes normal_force = extremes_of(target.normal_force);
  target_force = normal_force.size();
  force_tolerance = relative_force_tolerance * std::max(begin_force, normal_force.most);
}

void StraightPiece::set_modes(const std::vector<ContactMode>& mode) {
  for_each_difference(mode, mode_, [&](std::size_t contact) {
    const auto c = static_cast<Eigen::Index>(contact);
    const ContactMode m = mode[contact];
    closed_[c] = m == ContactMode::open ? 0.0 : 1.0;
    held_[c] = m == ContactMode::stick && friction_coefficient_[c] > 0.0 ? 1.0 : 0.0;
    sense_[c] = -friction_sign(m);
    return true;
  });
  mode_ = mode;
  target.mode = mode;
}

void StraightPiece::lead(const ContactRates& rate, double part) {
  with_widest_vectors([this, &rate, part](auto /*lanes*/) BUMPFOIL_ALWAYS_INLINE {
    const double* const normal_rate = rate.normal.data();
    const double* const tangential_rate = rate.tangential.data();
    const double* const f = friction_coefficient_.data();
    const double* const closed = closed_.data();
    const double* const held = held_.data();
    const double* const sense = sense_.data();
    const double* const gap = begin.gap.data();
    const double* const normal = begin.normal_force.data();
    const double* const friction = begin.friction_force.data();
    double* const gap_then = target.gap.data();
    double* const normal_then = target.normal_force.data();
    double* const friction_then = target.friction_force.data();
    double* const slip = slip_.data();
    const double fraction = part;
    const Eigen::Index count = slip_.size();
    BUMPFOIL_INDEPENDENT
    for (Eigen::Index c = 0; c < count; ++c) {
      const double normal_change = fraction * normal_rate[c];
      const double tangential_change = fraction * tangential_rate[c];
      const double p = closed[c] * (normal[c] + normal_change);
      gap_then[c] = gap[c] + (1.0 - closed[c]) * normal_change;
      normal_then[c] = p;
      friction_then[c] = held[c] * (friction[c] + tangential_change) - sense[c] * f[c] * p;
      slip[c] = (1.0 - held[c]) * tangential_change;
    }
  });
  for (const Eigen::Index c : can_slip_) {
    const int unknown = tangential_[static_cast<std::size_t>(c)];
    target.x[unknown] = begin.x[unknown] + slip_[c];
  }
  measure_target();
}

void StraightPiece::take_target() {
  set_modes(target.mode);
  for (const Eigen::Index c : can_slip_) {
    const int unknown = tangential_[static_cast<std::size_t>(c)];
    slip_[c] = target.x[unknown] - begin.x[unknown];
  }
  measure_target();
}

/// A margin that is `now` at the start and negative `then`: the contact changes its mode at its zero.
void StraightPiece::limit(Eigen::Index c, double now, double then, ContactMode to) {
  constexpr double above_round_off = 1.0 + 1e-14;
  if (now > above_round_off * end_part * (now - then)) return;  // most limits lie beyond, which needs no division
  const double part = now <= 0.0 ? 0.0 : now / (now - then);
  if (part > end_part) return;
  if (part < end_part) limits.clear();
  end_part = part;
  limits.push_back({c, to});
}

/// Fills clear_: positive if a contact neither reaches a limit of its mode within a fraction of the distance to the
/// target nor may change its mode at the start, as contacts without force may. A margin that is zero at the start and
/// negative at the target is negative in between.
void StraightPiece::screen(double part) {
  with_widest_vectors([this, part](auto /*lanes*/) BUMPFOIL_ALWAYS_INLINE {
    const double* const f = friction_coefficient_.data();
    const double* const closed = closed_.data();
    const double* const held = held_.data();
    const double* const sense = sense_.data();
    const double* const slip = slip_.data();
    const double* const gap = begin.gap.data();
    const double* const gap_then = target.gap.data();
    const double* const normal = begin.normal_force.data();
    const double* const normal_then = target.normal_force.data();
    const double* const friction = begin.friction_force.data();
    const double* const friction_then = target.friction_force.data();
    double* const clear = clear_.data();
    const double fraction = part;
    const double no_force = force_tolerance;
    const Eigen::Index count = clear_.size();
    BUMPFOIL_INDEPENDENT
    for (Eigen::Index c = 0; c < count; ++c) {
      const double open = 1.0 - closed[c];
      const double g = gap[c] + fraction * (gap_then[c] - gap[c]);
      const double p = normal[c] + fraction * (normal_then[c] - normal[c]);
      const double t = friction[c] + fraction * (friction_then[c] - friction[c]);
      const double least_p = normal[c] < p ? normal[c] : p;
      const double apart = open * (g - displacement_tolerance) + closed[c] * (least_p - no_force);
      const double in_cone = 1.0 + held[c] * (f[c] * p - std::abs(t) - no_force - 1.0);
      const double along = sense[c] * slip[c] + displacement_tolerance;
      const double others = in_cone < along ? in_cone : along;
      clear[c] = apart < others ? apart : others;
    }
  });
}

void StraightPiece::look_ahead(std::vector<ModeChange>& changes) {
  BUMPFOIL_ASSERT(mode_ == target.mode);
  const double part_left = 1.0 - begin_fraction;
  for (double sight = std::max(least_sight, first_sight * last_length_ / part_left);; sight *= farther_sight) {
    sight = std::min(1.0, sight);
    changes.clear();
    limits.clear();
    end_part = 1.0;
    screen(sight);
    const double* const clear = clear_.data();
    Eigen::Index* const near = near_.data();
    const Eigen::Index contacts = clear_.size();
    Eigen::Index count = 0;
    for (Eigen::Index c = 0; c < contacts; ++c) {
      near[count] = c;
      count += clear[c] > 0.0 ? 0 : 1;
    }
    for (Eigen::Index i = 0; i < count; ++i) look_at(near[i], changes);
    if (!(end_part > sight)) break;
  }
  last_length_ = end_part * part_left;
}

/// Check of contact c for look_ahead().
void StraightPiece::look_at(Eigen::Index c, std::vector<ModeChange>& changes) {
  const double f = friction_coefficient_[c];
  const ContactMode m = target.mode[static_cast<std::size_t>(c)];
  ContactTrial trial{
      .gap = target.gap[c], .normal = target.normal_force[c], .friction = target.friction_force[c], .slip = slip_[c]};
  const auto change = [&] { return check_mode(c, m, f, trial, displacement_tolerance, force_tolerance); };
  if (m == ContactMode::open) {
    if (trial.gap >= -displacement_tolerance) return;
    limit(c, begin.gap[c], trial.gap, change().to);
    if (begin.gap[c] <= displacement_tolerance) changes.push_back(change());
    return;
  }
  const double p = begin.normal_force[c];
  const bool loaded = p > force_tolerance;
  if (trial.normal < -force_tolerance) limit(c, p, trial.normal, ContactMode::open);
  if (m == ContactMode::stick && f > 0.0) {
    const double t = begin.friction_force[c];
    for (const double side : {1.0, -1.0}) {
      const double margin_then = f * trial.normal - side * trial.friction;
      if (margin_then >= -force_tolerance) continue;
      const double margin = f * p - side * t;
      limit(c, margin, margin_then, slip_mode(-side));
      // The mode is free only at the friction bound, and only if the force would leave the cone on that side: the
      // normal force may fall faster than the friction force.
      const bool on_bound = margin <= force_tolerance && side == std::copysign(1.0, t);
      if (loaded && on_bound) changes.push_back({c, slip_mode(-side), -margin_then});
    }
  }
  if (loaded && m == ContactMode::stick) return;
  if (loaded) trial.normal = std::max(0.0, trial.normal);  // opens later in the piece, if at all
  if (change().to != m) changes.push_back(change());
}

/// Whether the initial forces and gap of a contact agree with its mode.
bool StraightPiece::begin_obeys(Eigen::Index c) const {
  const double p = begin.normal_force[c];
  const double t = begin.friction_force[c];
  const double f = friction_coefficient_[c];
  const ContactMode m = target.mode[static_cast<std::size_t>(c)];
  if (m == ContactMode::open) return std::abs(p) <= force_tolerance && std::abs(t) <= force_tolerance;
  if (std::abs(begin.gap[c]) > displacement_tolerance) return false;
  return !slips(m) || f == 0.0 || std::abs(t - friction_sign(m) * f * p) <= force_tolerance;
}

bool StraightPiece::begin_obeys_modes() const {
  bool obeys = true;
  for (Eigen::Index c = 0; c < slip_.size(); ++c) obeys = obeys && begin_obeys(c);
  return obeys;
}

bool StraightPiece::begin_obeys_new_modes() const {
  return for_each_difference(target.mode, begin.mode,
                             [&](std::size_t c) { return begin_obeys(static_cast<Eigen::Index>(c)); });
}

}  // namespace bumpfoil
