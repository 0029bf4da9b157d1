#include "contact/contact_tableau.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/dense_kernels.hpp"
#include "contact/eliminated_system.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {
namespace {

/// Rank-one updates collected before they are applied together, so that the matrix update is limited by arithmetic, not
/// by memory traffic.
constexpr Eigen::Index most_pending = 8;
/// Maximum number of coordinates: the cost of the matrix grows with their square, that of linear solves only linearly.
constexpr Eigen::Index most_coordinates = 200;
/// Rows and columns are padded to multiples of this, to fill the widest vector registers.
constexpr Eigen::Index padding = 8;
/// If more contacts change at once, as at first touch, the matrix is rebuilt: exchanges lose digits on the way from a
/// loose foil to a held one.
constexpr int most_changes = 32;
/// Number of exchanges between comparisons with the rates of the linear system, and the accepted difference relative to
/// the largest force and to the largest displacement.
constexpr int exchanges_between_looks = 128;
constexpr double most_drifted = 1e-9;

Eigen::Index padded(Eigen::Index count) {
  return (count + padding - 1) / padding * padding;
}

/// target -= factor * numbers for `count` entries, a whole number of vectors.
template <int N>
BUMPFOIL_ALWAYS_INLINE inline void subtract_multiple(double factor, const double* numbers, Eigen::Index count,
                                                     double* target) {
  for (Eigen::Index i = 0; i < count; i += N) {
    RegisterRow<N, N> difference, other;
    difference.load(target + i);
    other.load(numbers + i);
    difference.template use<Products::subtract>(factor, other);
    difference.store(target + i);
  }
}

}  // namespace

bool ContactTableau::pays(const ContactProblem& problem) {
  return widest_vector_instructions() != VectorInstructions::baseline &&
         coordinate_count(problem.sites) <= most_coordinates;
}

ContactTableau::ContactTableau(const ContactProblem& problem, std::shared_ptr<ModeSystem> modes)
    : problem_(problem),
      modes_(std::move(modes)),
      coordinates_(coordinate_count(problem.sites)),
      size_(padded(coordinates_)),
      numbers_(static_cast<std::size_t>(size_ * (size_ + 2 * most_pending)), 0.0),
      T_(numbers_.data(), size_, size_),
      scale_(Vector::Ones(size_)),
      rate_(Vector::Zero(size_)),
      left_(T_.data() + T_.size(), most_pending, size_),
      right_(left_.data() + left_.size(), most_pending, size_),
      path_rate_(ContactLoading::none(problem)),
      rates_{.normal = Vector::Zero(problem.contacts()), .tangential = Vector::Zero(problem.contacts())} {
  const std::vector<SiteCoordinates> coordinates = coordinates_of(problem.sites);
  places_.reserve(problem.sites.size());
  for (std::size_t c = 0; c < problem.sites.size(); ++c) {
    const ContactSite& site = problem.sites[c];
    const Eigen::Index row = Eigen::Index{site.block} * problem.K.block_size();
    const auto unknown = [row](int i) { return i < 0 ? Eigen::Index{-1} : row + i; };
    places_.push_back({.plus = unknown(site.plus),
                       .minus = unknown(site.minus),
                       .tangential = unknown(site.tangential),
                       .f = is_frictionless(site) ? 0.0 : site.friction_coefficient,
                       .z_normal = coordinates[c].normal,
                       .z_tangential = coordinates[c].tangential});
  }
}

void ContactTableau::set_path(const LoadingPath& path) {
  path_rate_.initial_gap = path.end.initial_gap - path.begin.initial_gap;
  path_rate_.load = path.end.load - path.begin.load;
  has_rates_ = false;
}

/// Takes the rates from the linear system. If the matrix has drifted away from it, it becomes invalid.
bool ContactTableau::find_rates() {
  exchanges_ = 0;
  if (!modes_->set_modes(mode_)) return false;
  modes_->solve(path_rate_, Vector::Zero(problem_.K.rows()), answer_);
  if (!answer_.x.allFinite()) return false;
  Eigen::Vector2d drift(0.0, 0.0);  // in forces and in displacements
  Eigen::Vector2d largest(0.0, 0.0);
  const auto take = [&](Eigen::Index i, double rate, bool is_force) {
    const int kind = is_force ? 0 : 1;
    drift[kind] = std::max(drift[kind], std::abs(rate - rate_[i]));
    largest[kind] = std::max(largest[kind], std::abs(rate));
    rate_[i] = rate;
  };
  for (std::size_t c = 0; c < places_.size(); ++c) {
    const Place& place = places_[c];
    const auto contact = static_cast<Eigen::Index>(c);
    const bool open = mode_[c] == ContactMode::open;
    take(place.z_normal, open ? answer_.gap[contact] : answer_.normal_force[contact], !open);
    if (place.z_tangential < 0) continue;
    const bool sticks = mode_[c] == ContactMode::stick;
    take(place.z_tangential, sticks ? answer_.friction_force[contact] : answer_.x[place.tangential], sticks);
  }
  if (has_rates_) valid_ = (drift.array() <= most_drifted * largest.array()).all();
  has_rates_ = true;
  return true;
}

/// Rebuilds the matrix for given modes.
bool ContactTableau::restart(const std::vector<ContactMode>& mode) {
  mode_ = mode;
  if (!find_rates()) return false;
  modes_->solve_units(unit_x_, unit_force_);
  scale_.setOnes();
  pending_ = 0;
  for (std::size_t c = 0; c < places_.size(); ++c) {
    const Place& place = places_[c];
    auto normal = T_.row(place.z_normal).head(coordinates_);
    if (mode[c] != ContactMode::open) {
      normal = unit_force_.row(place.z_normal);
    } else {
      normal.setZero();
      if (place.plus >= 0) normal += unit_x_.row(place.plus);
      if (place.minus >= 0) normal -= unit_x_.row(place.minus);
    }
    if (place.z_tangential < 0) continue;
    auto tangential = T_.row(place.z_tangential).head(coordinates_);
    if (mode[c] == ContactMode::stick) {
      tangential = unit_force_.row(place.z_tangential);
    } else {
      tangential = unit_x_.row(place.tangential);
    }
  }
  valid_ = T_.allFinite();
  return valid_;
}

void ContactTableau::carry_out() {
  // Unused rows are zeroed, so that the loop length is a compile-time constant.
  left_.bottomRows(most_pending - pending_).setZero();
  right_.bottomRows(most_pending - pending_).setZero();
  pending_ = 0;
  with_widest_vectors([this](auto lanes) BUMPFOIL_ALWAYS_INLINE {
    constexpr int n = decltype(lanes)::value;
    constexpr int two_vectors = 2 * n;
    constexpr int together = 4;  // rows, of two vectors each: their sums and two vectors of `right` fit the registers
    const auto carry_out_in = [this](auto length, Eigen::Index i, Eigen::Index j) BUMPFOIL_ALWAYS_INLINE {
      constexpr int numbers = decltype(length)::value;
      RegisterSums<numbers, together, n> sums;
      double* const part = T_.data() + i * size_ + j;
      sums.template begin<Products::subtract>(part, size_);
      for (Eigen::Index k = 0; k < most_pending; ++k) {
        RegisterRow<numbers, n> row;
        row.load(right_.data() + k * size_ + j);
        sums.template use<Products::subtract>(left_.data() + k * size_ + i, 1, row);
      }
      sums.store(part, size_);
    };
    for (Eigen::Index i = 0; i < size_; i += together) {
      Eigen::Index j = 0;
      for (; j + two_vectors <= size_; j += two_vectors) carry_out_in(Lanes<two_vectors>(), i, j);
      for (; j < size_; j += n) carry_out_in(Lanes<n>(), i, j);
    }
  });
}

/// Adds a row and its rate to another.
void ContactTableau::add_row(Eigen::Index to, Eigen::Index from, double factor) {
  if (factor == 0.0) return;
  rate_[to] += factor * rate_[from];
  const double scaled = factor * scale_[from] / scale_[to];
  T_.row(to) += scaled * T_.row(from);
  left_.col(to).head(pending_) += scaled * left_.col(from).head(pending_);
}

void ContactTableau::add_column(Eigen::Index to, Eigen::Index from, double factor) {
  if (factor == 0.0) return;
  const double scaled = factor * scale_[from] / scale_[to];
  T_.col(to) += scaled * T_.col(from);
  right_.col(to).head(pending_) += scaled * right_.col(from).head(pending_);
}

/// Exchanges w_i and z_i.
/// @return false if that leaves a mechanism
bool ContactTableau::exchange(Eigen::Index i) {
  if (pending_ == most_pending) carry_out();
  double* const u = left_.row(pending_).data();
  double* const v = right_.row(pending_).data();
  for (Eigen::Index r = 0; r < size_; ++r) u[r] = T_.data()[r * size_ + i];
  std::memcpy(v, T_.data() + i * size_, static_cast<std::size_t>(size_) * sizeof(double));
  const double s = scale_[i];
  double size = 0.0;
  double own = 0.0;
  const bool regular = with_widest_vectors([&](auto lanes) BUMPFOIL_ALWAYS_INLINE {
    constexpr int n = decltype(lanes)::value;
    for (Eigen::Index k = 0; k < pending_; ++k) {
      const double* left = left_.data() + k * size_;
      const double* right = right_.data() + k * size_;
      subtract_multiple<n>(right[i], left, size_, u);
      subtract_multiple<n>(left[i], right, size_, v);
    }
    const double pivot = u[i];
    size = std::abs(pivot);
    if (!(size > 0.0) || !std::isfinite(pivot)) return false;
    // z_i changes as required by w_i, which is now prescribed, and all others follow.
    own = -rate_[i] / (s * s * pivot);
    u[i] += size;
    v[i] -= size;
    const double change = s * own;
    const double inverse = 1.0 / pivot;
    for (Eigen::Index r = 0; r < size_; ++r) {
      rate_.data()[r] += change * scale_.data()[r] * u[r];
      u[r] *= inverse;
    }
    return true;
  });
  if (!regular) return false;
  rate_[i] = own;
  scale_[i] = 1.0 / (s * size);
  ++pending_;
  ++exchanges_;
  return true;
}

/// A contact with friction changes mode only via slip in one direction; between open and stick it passes through
/// frictionless slip.
bool ContactTableau::change(std::size_t contact, ContactMode to) {
  const Place& place = places_[contact];
  const ContactMode from = std::exchange(mode_[contact], to);
  const Eigen::Index n = place.z_normal;
  const Eigen::Index t = place.z_tangential;
  if (t < 0) return exchange(n);
  const auto close = [&](ContactMode slip) {
    add_column(n, t, friction_sign(slip) * place.f);
    return exchange(n);
  };
  const auto open = [&](ContactMode slip) {
    const bool exchanged = exchange(n);
    add_column(n, t, -friction_sign(slip) * place.f);
    return exchanged;
  };
  const auto hold = [&](ContactMode slip) {
    const bool exchanged = exchange(t);
    add_row(t, n, friction_sign(slip) * place.f);
    return exchanged;
  };
  const auto release = [&](ContactMode slip) {
    add_row(t, n, -friction_sign(slip) * place.f);
    return exchange(t);
  };
  if (from == ContactMode::open) return close(to) && (slips(to) || hold(to));
  if (to == ContactMode::open) return (slips(from) || release(to)) && open(from);
  return (!slips(from) || hold(from)) && (!slips(to) || release(to));
}

bool ContactTableau::set_modes(const std::vector<ContactMode>& mode) {
  changed_.clear();
  if (valid_) {
    for_each_difference(mode, mode_, [&](std::size_t c) {
      changed_.push_back(c);
      return true;
    });
  }
  valid_ = valid_ && std::ssize(changed_) <= most_changes;
  for (const std::size_t c : changed_) valid_ = valid_ && change(c, mode[c]);
  if (valid_ && (!has_rates_ || exchanges_ >= exchanges_between_looks)) valid_ = find_rates() && valid_;
  return valid_ || restart(mode);
}

const ContactRates& ContactTableau::rates() {
  for (std::size_t c = 0; c < places_.size(); ++c) {
    const Place& place = places_[c];
    const auto contact = static_cast<Eigen::Index>(c);
    rates_.normal[contact] = rate_[place.z_normal];
    rates_.tangential[contact] = place.z_tangential < 0 ? 0.0 : rate_[place.z_tangential];
  }
  return rates_;
}

}  // namespace bumpfoil
