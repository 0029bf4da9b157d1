#include "contact/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {
namespace {

/// A contact as compliant as the foils themselves, in units of the largest stiffness: sets the ratio of forces and
/// lengths at the start. A factor of ten more or less makes little difference.
constexpr double start_stiffness = 0.01;

/// Previous friction forces are kept this far inside their cone.
constexpr double start_cone = 0.9;

/// Lower bound, m: keeps a previous state that fits its loading exactly off the bounds, to avoid 0/0. Negligible, yet
/// its products do not underflow.
constexpr double smallest_length = 1e-50;

/// Lower bound of the friction coefficient in the initial slips.
constexpr double smallest_friction = 1e-15;

/// Mean product, relative to the initial one, below which only round-off changes.
constexpr double smallest_product = 1e-30;

/// Both quantities of a pair tend to zero if their relative changes are within this of -1/2.
constexpr double trend_band = 0.1;

}  // namespace

double ComplementaryPair::longest(double fraction) const {
  if (force + fraction * force_step < 0.0) fraction = -force / force_step;
  if (length + fraction * length_step < 0.0) fraction = -length / length_step;
  return fraction;
}

void ComplementaryPair::take(double fraction) {
  force += fraction * force_step;
  length += fraction * length_step;
}

int ComplementaryPair::trend() const {
  const double change = force_step / force;
  if (change < -0.5 - trend_band) return 1;
  return change > -0.5 + trend_band ? -1 : 0;
}

InteriorPoint::InteriorPoint(const SharedProblem& problem)
    : problem_(problem),
      system_(make_soft_contact_system(*problem)),
      contacts_(static_cast<std::size_t>(problem->contacts())),
      soft_(contacts_.size()),
      previous_modes_(contacts_.size(), ContactMode::open),
      modes_(previous_modes_),
      imbalance_(problem->K.rows()),
      dx_(problem->K.rows()),
      dp_(problem->contacts()),
      dt_(problem->contacts()) {
  for (const Matrix& block : problem->K.diagonal) {
    stiffness_ = std::max(stiffness_, block.diagonal().cwiseAbs().maxCoeff());
  }
}

template <typename Visitor>
void InteriorPoint::for_each_pair(Contact& contact, Visitor&& visit) {
  visit(contact.closing);
  if (contact.f == 0.0) return;
  visit(contact.forward);
  visit(contact.backward);
}

/// Misfit of the previous state with the loading, m. Fills imbalance_ with the residual of equilibrium in that state.
double InteriorPoint::misfit(const ContactLoading& loading, const ContactState& previous) {
  const double k = start_stiffness * stiffness_;
  imbalance_ = loading.load - system_->multiply(previous.x);
  double largest = 0.0;
  for_each_contact(*problem_, [&](const CoulombContact& contact) {
    const double p = previous.normal_force[contact.index];
    contact.add_forces(p, previous.friction_force[contact.index], 1.0, imbalance_);
    const double gap = loading.initial_gap[contact.index] + contact.gap(previous.x);
    largest = std::max(largest, std::abs(std::min(gap, p / k)));
  });
  return std::max(largest, imbalance_.cwiseAbs().maxCoeff() / k);
}

void InteriorPoint::start(const ContactLoading& loading, const ContactState& previous, double spread, double reach) {
  const double length = std::max(spread * misfit(loading, previous), smallest_length);
  const double force = start_stiffness * stiffness_ * length;
  for_each_contact(*problem_, [&](const CoulombContact& contact) {
    Contact& c = contacts_[static_cast<std::size_t>(contact.index)];
    c.f = contact.f;
    const double gap = loading.initial_gap[contact.index] + contact.gap(previous.x);
    const double p = previous.normal_force[contact.index];
    c.closing = {.force = std::max(force, p), .length = std::max(length, gap)};
    c.gap_residual = gap - c.closing.length;
    const double bound = c.f * c.closing.force;
    const double friction = previous.friction_force[contact.index];
    const double t = std::clamp(friction, -start_cone * bound, start_cone * bound);
    // Slips scale with normal force over margin, so that all initial products are equal.
    const double slip = length / std::clamp(c.f, smallest_friction, 1.0);
    c.forward = {.force = bound + t, .length = slip};
    c.backward = {.force = bound - t, .length = slip};
    contact.add_forces(c.closing.force - p, t - friction, 1.0, imbalance_);
  });
  modes_ = previous_modes_ = previous.mode;
  changed_modes_ = 0;
  remaining_ = 1.0;
  reach_ = reach;
  first_product_ = mean_product(0.0);
}

bool InteriorPoint::step() {
  solves_ = 0;
  if (!factor()) return false;
  find_step(0.0, false);
  read_modes();
  // The predictor shows how far the products can be reduced in this step [Mehrotra1992].
  const double product = mean_product(0.0);
  const double ratio = std::clamp(mean_product(longest_step(1.0)) / product, 0.0, 1.0);
  find_step(ratio * ratio * ratio * product, true);
  take(std::min(1.0, reach_ * longest_step(1.0 / reach_)));
  return mean_product(0.0) > smallest_product * first_product_;  // false for NaN
}

/// Linearised conditions of the contacts. With w the slip, a = f p + t and b = f p - t, the friction pairs give
///
///     (w+ b + w- a) dt + (w+ b - w- a) f dp + a b dw = ...
bool InteriorPoint::factor() {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& c = contacts_[i];
    SoftContact& soft = soft_[i];
    const double scale = c.closing.length + c.closing.force / stiffness_;
    soft.normal_force = c.closing.length / scale;
    soft.gap = c.closing.force / scale;
    if (c.f == 0.0) continue;
    const double forward = c.forward.length * c.backward.force;
    const double backward = c.backward.length * c.forward.force;
    const double margins = c.forward.force * c.backward.force;
    const double friction_scale = forward + backward + margins / stiffness_;
    soft.friction_force = (forward + backward) / friction_scale;
    soft.coupling = (forward - backward) * c.f / friction_scale;
    soft.slip = margins / friction_scale;
  }
  return system_->set_contacts(soft_);
}

/// Newton step to products of size `target`.
/// @param correct  subtract the second-order part of the last step
void InteriorPoint::find_step(double target, bool correct) {
  dx_ = remaining_ * imbalance_;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    Contact& c = contacts_[i];
    const auto contact = static_cast<Eigen::Index>(i);
    for_each_pair(c, [&](ComplementaryPair& pair) { pair.aim(target, correct); });
    // The scales are part of the factored conditions.
    dp_[contact] =
        soft_[i].normal_force * c.closing.deficit / c.closing.length - soft_[i].gap * remaining_ * c.gap_residual;
    if (c.f == 0.0) continue;
    dt_[contact] = soft_[i].slip * (c.forward.deficit / c.forward.force - c.backward.deficit / c.backward.force);
  }
  system_->solve_in_place(dx_, dp_, dt_);
  ++solves_;
  for_each_contact(*problem_, [&](const CoulombContact& contact) {
    Contact& c = contacts_[static_cast<std::size_t>(contact.index)];
    // The system's force is a difference of large ones; from the product it is accurate however small.
    c.closing.length_step = contact.gap(dx_) + remaining_ * c.gap_residual;
    c.closing.take_force_from_length();
    if (c.f > 0.0) read_friction_step(c, contact.tangential(dx_), dt_[contact.index]);
  });
}

/// The same for the friction pairs.
void InteriorPoint::read_friction_step(Contact& c, double slip_step, double friction_step) const {
  const double bound_step = c.f * c.closing.force_step;
  const double forward = c.forward.length * c.backward.force;
  const double backward = c.backward.length * c.forward.force;
  const double margins = c.forward.force * c.backward.force;
  if (stiffness_ * (forward + backward) < margins) {  // stick
    c.forward.force_step = bound_step + friction_step;
    c.backward.force_step = bound_step - friction_step;
    c.forward.take_length_from_force();
    c.backward.take_length_from_force();
    return;
  }
  friction_step = (c.backward.force * c.forward.deficit - c.forward.force * c.backward.deficit - margins * slip_step -
                   (forward - backward) * bound_step) /
                  (forward + backward);
  const bool slips_forward = c.forward.force < c.backward.force;
  const double sign = slips_forward ? 1.0 : -1.0;
  ComplementaryPair& slipping = slips_forward ? c.forward : c.backward;
  ComplementaryPair& other = slips_forward ? c.backward : c.forward;
  other.force_step = bound_step - sign * friction_step;
  other.take_length_from_force();
  slipping.length_step = other.length_step + sign * slip_step;
  slipping.take_force_from_length();
  other.force_step = 2.0 * bound_step - slipping.force_step;
}

/// Modes indicated by a step to zero products. Contacts that admit two modes keep that of the last increment.
void InteriorPoint::read_modes() {
  changed_modes_ = 0;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& c = contacts_[i];
    const ContactMode before = previous_modes_[i];
    const int opens = c.closing.trend();
    const bool open = opens > 0 || (opens == 0 && before == ContactMode::open);
    const ContactMode mode = open ? ContactMode::open : closed_mode(c, before);
    if (mode != modes_[i]) ++changed_modes_;
    modes_[i] = mode;
  }
}

ContactMode InteriorPoint::closed_mode(const Contact& c, ContactMode before) {
  if (c.f == 0.0) return ContactMode::stick;
  const bool towards_forward = c.forward.force < c.backward.force;
  const ContactMode slip = towards_forward ? ContactMode::slip_forward : ContactMode::slip_backward;
  const int slips = (towards_forward ? c.forward : c.backward).trend();
  return slips > 0 || (slips == 0 && before == slip) ? slip : ContactMode::stick;
}

double InteriorPoint::mean_product(double fraction) {
  double sum = 0.0;
  int pairs = 0;
  for (Contact& c : contacts_) {
    for_each_pair(c, [&](const ComplementaryPair& pair) {
      sum += pair.product(fraction);
      ++pairs;
    });
  }
  return sum / pairs;
}

double InteriorPoint::longest_step(double fraction) {
  for (Contact& c : contacts_) {
    for_each_pair(c, [&](const ComplementaryPair& pair) { fraction = pair.longest(fraction); });
  }
  return fraction;
}

void InteriorPoint::take(double fraction) {
  remaining_ *= 1.0 - fraction;
  for (Contact& c : contacts_) {
    for_each_pair(c, [&](ComplementaryPair& pair) { pair.take(fraction); });
    if (c.f == 0.0) continue;
    // Keeps the sum of the margins at 2 f p if p has fallen by orders of magnitude.
    ComplementaryPair& smaller = c.forward.force < c.backward.force ? c.forward : c.backward;
    ComplementaryPair& larger = c.forward.force < c.backward.force ? c.backward : c.forward;
    larger.force = 2.0 * c.f * c.closing.force - smaller.force;
  }
}

}  // namespace bumpfoil
