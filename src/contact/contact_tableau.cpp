#include "contact/contact_tableau.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/dense_kernels.hpp"

namespace bumpfoil {
namespace {

/// Exchanges that are carried out at once: enough for the matrix to be computed with rather than moved.
constexpr Eigen::Index most_pending = 8;
/// With more coordinates the matrix is too large: its cost goes with their square, that of solves with their number.
constexpr Eigen::Index most_coordinates = 200;
/// Rows and columns come in multiples of this, so that they fill the widest vectors.
constexpr Eigen::Index padding = 8;
/// Where more contacts change at once, as when foils are first touched, the matrix is built anew: exchanges that take
/// it from a foil that hangs loose to one that is held lose digits.
constexpr int most_changes = 32;
/// Exchanges after which rates are compared with those of the linear system, and what they may differ by as part of the
/// largest force and of the largest displacement.
constexpr int exchanges_between_looks = 128;
constexpr double most_drifted = 1e-9;

Eigen::Index padded(Eigen::Index count) {
  return (count + padding - 1) / padding * padding;
}

template <int N>
using Pack = typename VectorOf<N>::Type;

template <int N>
BUMPFOIL_ALWAYS_INLINE inline void load(const double* from, Pack<N>& pack) {
  std::memcpy(&pack, from, sizeof(pack));
}

template <int N>
BUMPFOIL_ALWAYS_INLINE inline void store(const Pack<N>& pack, double* to) {
  std::memcpy(to, &pack, sizeof(pack));
}

/// target += factor * numbers, `count` of them, which fill whole vectors.
template <int N>
BUMPFOIL_ALWAYS_INLINE inline void add_multiple(double factor, const double* numbers, Eigen::Index count,
                                                double* target) {
  for (Eigen::Index i = 0; i < count; i += N) {
    Pack<N> sum, other;
    load<N>(target + i, sum);
    load<N>(numbers + i, other);
    sum += factor * other;
    store<N>(sum, target + i);
  }
}

}  // namespace

bool ContactTableau::pays(const ContactProblem& problem) {
  return widest_vector_instructions() != VectorInstructions::baseline &&
         coordinate_count(problem.pairs) * problem.K.blocks() <= most_coordinates;
}

ContactTableau::ContactTableau(const ContactProblem& problem, std::shared_ptr<ModeSystem> modes)
    : problem_(problem), modes_(std::move(modes)), path_rate_(ContactLoading::none(problem)) {
  const std::vector<Elimination> order = elimination_order(problem.pairs);
  const std::vector<Coordinates> coordinates = coordinates_of(problem.pairs);
  const Eigen::Index per_block = coordinate_count(problem.pairs);
  const Eigen::Index block_size = problem.K.block_size();
  coordinates_ = per_block * problem.K.blocks();
  place_of_.resize(static_cast<std::size_t>(problem.contacts()));
  std::vector<bool> told(static_cast<std::size_t>(problem.K.rows()), false);
  for (Eigen::Index b = 0; b < problem.K.blocks(); ++b) {
    const auto unknown = [&](int i) { return i < 0 ? Eigen::Index{-1} : b * block_size + i; };
    // Backwards through the eliminations: the other unknown of a contact is told before it, where it is an owner, too.
    for (auto e = order.rbegin(); e != order.rend(); ++e) {
      const ContactPair& pair = problem.pairs[e->pair];
      const auto [normal, tangential] = coordinates[e->pair];
      Place place{.contact = b * std::ssize(problem.pairs) + static_cast<Eigen::Index>(e->pair),
                  .owner = unknown(e->owner),
                  .other = unknown(e->other),
                  .tangential = -1,
                  .owner_sign = e->owner_sign,
                  .f = 0.0,
                  .z_normal = b * per_block + normal,
                  .z_tangential = -1};
      told[static_cast<std::size_t>(place.owner)] = true;
      if (tangential >= 0) {
        place.tangential = unknown(pair.tangential);
        place.f = pair.friction_coefficient;
        place.z_tangential = b * per_block + tangential;
        told[static_cast<std::size_t>(place.tangential)] = true;
      }
      place_of_[static_cast<std::size_t>(place.contact)] = places_.size();
      places_.push_back(place);
    }
  }
  for (std::size_t i = 0; i < told.size(); ++i) {
    if (!told[i]) others_.push_back(static_cast<Eigen::Index>(i));
  }
  const Eigen::Index rows = padded(coordinates_ + std::ssize(others_));
  T_.setZero(rows, padded(coordinates_));
  left_.setZero(most_pending, rows);
  right_.setZero(most_pending, T_.cols());
  scale_.setOnes(rows);
  rate_.setZero(rows);
}

void ContactTableau::set_path(const LoadingPath& path) {
  path_rate_.initial_gap = path.end.initial_gap - path.begin.initial_gap;
  path_rate_.load = path.end.load - path.begin.load;
  has_rates_ = false;
}

/// Takes the rates from the linear system. Where the matrix has drifted away from that, it is no more valid.
bool ContactTableau::find_rates() {
  exchanges_ = 0;
  if (!modes_->set_modes(mode_)) return false;
  modes_->solve(path_rate_, Vector::Zero(problem_.K.rows()), answer_);
  if (!answer_.x.allFinite()) return false;
  Eigen::Vector2d drift(0.0, 0.0);  // of forces, of displacements
  Eigen::Vector2d largest(0.0, 0.0);
  const auto take = [&](Eigen::Index i, double rate, bool is_force) {
    const int kind = is_force ? 0 : 1;
    drift[kind] = std::max(drift[kind], std::abs(rate - rate_[i]));
    largest[kind] = std::max(largest[kind], std::abs(rate));
    rate_[i] = rate;
  };
  for (const Place& place : places_) {
    const ContactMode mode = mode_[static_cast<std::size_t>(place.contact)];
    const bool open = mode == ContactMode::open;
    take(place.z_normal, open ? answer_.gap[place.contact] : answer_.normal_force[place.contact], !open);
    if (place.z_tangential < 0) continue;
    const bool sticks = mode == ContactMode::stick;
    take(place.z_tangential, sticks ? answer_.friction_force[place.contact] : answer_.x[place.tangential], sticks);
  }
  Eigen::Index row = coordinates_;
  for (const Eigen::Index other : others_) rate_[row++] = answer_.x[other];
  if (has_rates_) valid_ = (drift.array() <= most_drifted * largest.array()).all();
  has_rates_ = true;
  return true;
}

/// Builds the matrix of given modes anew.
bool ContactTableau::restart(const std::vector<ContactMode>& mode) {
  mode_ = mode;
  has_rates_ = false;
  if (!find_rates()) return false;
  RowMajor x, force;
  modes_->solve_units(x, force);
  scale_.setOnes();
  pending_ = 0;
  for (const Place& place : places_) {
    const ContactMode m = mode_[static_cast<std::size_t>(place.contact)];
    auto normal = T_.row(place.z_normal).head(coordinates_);
    if (m != ContactMode::open) {
      normal = force.row(place.z_normal);
    } else {
      normal = place.owner_sign * x.row(place.owner);
      if (place.other >= 0) normal -= place.owner_sign * x.row(place.other);
    }
    if (place.z_tangential < 0) continue;
    auto tangential = T_.row(place.z_tangential).head(coordinates_);
    if (m == ContactMode::stick) {
      tangential = force.row(place.z_tangential);
    } else {
      tangential = x.row(place.tangential);
    }
  }
  Eigen::Index row = coordinates_;
  for (const Eigen::Index other : others_) T_.row(row++).head(coordinates_) = x.row(other);
  valid_ = T_.allFinite();
  return valid_;
}

void ContactTableau::carry_out() {
  // Those that are missing are zero: then the compiler knows how many there are.
  left_.bottomRows(most_pending - pending_).setZero();
  right_.bottomRows(most_pending - pending_).setZero();
  pending_ = 0;
  with_widest_vectors([this](auto lanes) BUMPFOIL_ALWAYS_INLINE {
    constexpr int n = decltype(lanes)::value;
    constexpr Eigen::Index height = 4;  // rows at once: their sums and a vector of `right` fit the registers
    const Eigen::Index rows = T_.rows();
    const Eigen::Index columns = T_.cols();
    for (Eigen::Index i = 0; i < rows; i += height) {
      double factor[most_pending][height];
      for (Eigen::Index k = 0; k < most_pending; ++k) {
        for (Eigen::Index r = 0; r < height; ++r) factor[k][r] = left_.data()[k * rows + i + r];
      }
      double* row = T_.data() + i * columns;
      for (Eigen::Index j = 0; j < columns; j += n) {
        Pack<n> sum[height];
        for (Eigen::Index r = 0; r < height; ++r) load<n>(row + r * columns + j, sum[r]);
        for (Eigen::Index k = 0; k < most_pending; ++k) {
          Pack<n> v;
          load<n>(right_.data() + k * columns + j, v);
          for (Eigen::Index r = 0; r < height; ++r) sum[r] += factor[k][r] * v;
        }
        for (Eigen::Index r = 0; r < height; ++r) store<n>(sum[r], row + r * columns + j);
      }
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
/// @return false where that leaves a mechanism
bool ContactTableau::exchange(Eigen::Index i) {
  if (pending_ == most_pending) carry_out();
  const Eigen::Index rows = T_.rows();
  const Eigen::Index columns = T_.cols();
  double* const u = left_.data() + pending_ * rows;
  double* const v = right_.data() + pending_ * columns;
  for (Eigen::Index r = 0; r < rows; ++r) u[r] = T_.data()[r * columns + i];
  std::memcpy(v, T_.data() + i * columns, static_cast<std::size_t>(columns) * sizeof(double));
  with_widest_vectors([&](auto lanes) BUMPFOIL_ALWAYS_INLINE {
    constexpr int n = decltype(lanes)::value;
    for (Eigen::Index k = 0; k < pending_; ++k) {
      const double* left = left_.data() + k * rows;
      const double* right = right_.data() + k * columns;
      add_multiple<n>(right[i], left, rows, u);
      add_multiple<n>(left[i], right, columns, v);
    }
  });
  const double pivot = u[i];
  const double size = std::abs(pivot);
  if (!(size > 0.0) || !std::isfinite(pivot)) return false;
  // z_i changes as w_i, which is given now, asks for, and all others follow.
  const double s = scale_[i];
  const double own = -rate_[i] / (s * s * pivot);
  u[i] += size;
  v[i] -= size;
  rate_.array() += s * own * scale_.array() * Eigen::Map<const Eigen::ArrayXd>(u, rows);
  Eigen::Map<Vector>(u, rows) *= -1.0 / pivot;
  rate_[i] = own;
  scale_[i] = 1.0 / (s * size);
  ++pending_;
  ++exchanges_;
  return true;
}

/// Every change of a contact with friction goes through slipping one way or the other; one from open to sticking and
/// back through slipping without friction.
bool ContactTableau::change(const Place& place, ContactMode to) {
  const ContactMode from = std::exchange(mode_[static_cast<std::size_t>(place.contact)], to);
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
  for (std::size_t c = 0; valid_ && c < mode.size(); ++c) {
    if (mode[c] != mode_[c]) changed_.push_back(c);
  }
  valid_ = valid_ && std::ssize(changed_) <= most_changes;
  for (const std::size_t c : changed_) valid_ = valid_ && change(places_[place_of_[c]], mode[c]);
  if (valid_ && (!has_rates_ || exchanges_ >= exchanges_between_looks)) valid_ = find_rates() && valid_;
  return valid_ || restart(mode);
}

void ContactTableau::lead(const ContactState& begin, double part, ContactState& target) const {
  target.mode = mode_;
  Eigen::Index row = coordinates_;
  for (const Eigen::Index other : others_) target.x[other] = begin.x[other] + part * rate_[row++];
  for (const Place& place : places_) {
    const Eigen::Index c = place.contact;
    const ContactMode mode = mode_[static_cast<std::size_t>(c)];
    const bool has_friction = place.z_tangential >= 0;
    const double normal = part * rate_[place.z_normal];
    const double tangential = has_friction ? part * rate_[place.z_tangential] : 0.0;
    double opening = -part * path_rate_.initial_gap[c];  // of x[plus] - x[minus]
    if (mode == ContactMode::open) {
      opening += normal;
      target.gap[c] = begin.gap[c] + normal;
      target.normal_force[c] = target.friction_force[c] = 0.0;
    } else {
      target.gap[c] = begin.gap[c];
      target.normal_force[c] = begin.normal_force[c] + normal;
      target.friction_force[c] = mode == ContactMode::stick ? begin.friction_force[c] + tangential
                                                            : friction_sign(mode) * place.f * target.normal_force[c];
    }
    if (has_friction) {
      const double slip = mode == ContactMode::stick ? 0.0 : tangential;
      target.x[place.tangential] = begin.x[place.tangential] + slip;
    }
    const double with_other = place.other >= 0 ? target.x[place.other] - begin.x[place.other] : 0.0;
    target.x[place.owner] = begin.x[place.owner] + with_other + place.owner_sign * opening;
  }
}

}  // namespace bumpfoil
