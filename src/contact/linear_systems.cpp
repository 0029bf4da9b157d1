#include "bumpfoil/contact/linear_systems.hpp"

#include <algorithm>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal_lu.hpp"

namespace bumpfoil {
namespace {

/// How the normal force of a contact is found from the balance of its block.
struct Elimination {
  std::size_t pair{};   ///< contact of the block
  int owner{};          ///< unknown whose balance gives the normal force
  double owner_sign{};  ///< of the normal force on the owner
  int other{-1};        ///< the other unknown the normal force acts on, if any
};

/// Order in which the contacts of a block can be eliminated: each owner is touched by no contact that comes later.
std::vector<Elimination> elimination_order(const std::vector<ContactPair>& pairs) {
  std::vector<Elimination> order;
  std::vector<bool> done(pairs.size(), false);
  const auto touched_by_others = [&](int unknown, std::size_t self) {
    for (std::size_t c = 0; c < pairs.size(); ++c) {
      const ContactPair& pair = pairs[c];
      if (c == self || (done[c] && pair.tangential != unknown)) continue;
      if (pair.plus == unknown || pair.minus == unknown || pair.tangential == unknown) return true;
    }
    return false;
  };
  while (order.size() < pairs.size()) {
    const std::size_t before = order.size();
    for (std::size_t c = 0; c < pairs.size(); ++c) {
      if (done[c]) continue;
      const ContactPair& pair = pairs[c];
      if (pair.plus >= 0 && !touched_by_others(pair.plus, c)) {
        order.push_back({c, pair.plus, 1.0, pair.minus});
      } else if (pair.minus >= 0 && !touched_by_others(pair.minus, c)) {
        order.push_back({c, pair.minus, -1.0, pair.plus});
      } else {
        continue;
      }
      done[c] = true;
    }
    BUMPFOIL_ASSERT(order.size() > before);  // contacts that form a ring cannot be eliminated one by one
    if (order.size() == before) break;
  }
  return order;
}

/// K in blocks of fixed size.
template <int B>
struct Stiffness {
  using Block = Eigen::Matrix<double, B, B>;

  explicit Stiffness(const BlockTridiagonal& K) : block_size(K.block_size()) { assign(K); }

  void assign(const BlockTridiagonal& K) {
    BUMPFOIL_ASSERT(K.block_size() == block_size);
    diagonal.assign(K.diagonal.begin(), K.diagonal.end());
    upper.assign(K.upper.begin(), K.upper.end());
  }

  [[nodiscard]] auto segment(const Vector& x, std::size_t b) const {
    return x.segment<B>(static_cast<Eigen::Index>(b) * block_size, block_size);
  }

  /// Blocks (b, b-1), (b, b), (b, b+1) side by side; zero where the matrix ends.
  template <typename Rows>
  void copy_rows(std::size_t b, Rows& rows) const {
    rows.setZero();
    if (b > 0) rows.leftCols(block_size) = upper[b - 1].transpose();
    rows.middleCols(block_size, block_size) = diagonal[b];
    if (b + 1 < diagonal.size()) rows.rightCols(block_size) = upper[b];
  }

  void multiply(const Vector& x, Vector& y) const {
    for (std::size_t b = 0; b < diagonal.size(); ++b) {
      auto row = y.segment<B>(static_cast<Eigen::Index>(b) * block_size, block_size);
      row.noalias() = diagonal[b] * segment(x, b);
      if (b + 1 < diagonal.size()) row.noalias() += upper[b] * segment(x, b + 1);
      if (b > 0) row.noalias() += upper[b - 1].transpose() * segment(x, b - 1);
    }
  }

  int block_size;
  std::vector<Block> diagonal, upper;
};

/// Sign of the friction force of a slipping contact, in units of f p: it opposes the slip.
double friction_sign(ContactMode mode) {
  if (mode == ContactMode::slip_forward) return -1.0;
  if (mode == ContactMode::slip_backward) return 1.0;
  return 0.0;
}

bool is_frictionless(const ContactPair& pair) {
  return pair.tangential < 0 || pair.friction_coefficient == 0.0;
}

template <int B>
class ModeSystemOf final : public ModeSystem {
 public:
  explicit ModeSystemOf(const ContactProblem& problem)
      : pairs_(problem.pairs),
        order_(elimination_order(problem.pairs)),
        K_(problem.K),
        lu_(problem.K.blocks(), problem.K.block_size()),
        mode_(static_cast<std::size_t>(problem.contacts()), ContactMode::open),
        rhs_(problem.K.rows()),
        imbalance_(problem.K.rows()),
        rows_(problem.K.block_size(), 3 * problem.K.block_size()) {
    for (const Matrix& block : problem.K.diagonal) {
      constraint_scale_ = std::max(constraint_scale_, block.diagonal().cwiseAbs().maxCoeff());
    }
  }

  void set_elasticity(const BlockTridiagonal& K) override {
    BUMPFOIL_ASSERT(K.blocks() == lu_.blocks());
    K_.assign(K);
    factored_ = false;
  }

  bool set_modes(const std::vector<ContactMode>& mode) override {
    BUMPFOIL_ASSERT(mode.size() == K_.diagonal.size() * pairs_.size());
    const std::size_t n = pairs_.size();
    std::size_t first = factored_ ? K_.diagonal.size() : 0;
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) {
      const auto begin = mode.begin() + static_cast<std::ptrdiff_t>(b * n);
      if (factored_ && std::equal(begin, begin + static_cast<std::ptrdiff_t>(n),
                                  mode_.begin() + static_cast<std::ptrdiff_t>(b * n))) {
        continue;
      }
      first = std::min(first, b);
      assemble_block(b, &*begin);
    }
    mode_ = mode;
    if (first < K_.diagonal.size()) {
      factored_ = lu_.factor(static_cast<int>(first));
      ++factorisations_;
    }
    return factored_;
  }

  [[nodiscard]] int factorisations() const override { return factorisations_; }

  void solve(const ContactLoading& loading, const Vector& previous_x, ContactState& state) override {
    BUMPFOIL_ASSERT(factored_);
    rhs_ = loading.load;
    for_each_elimination(
        [&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact, ContactMode mode) {
          if (mode == ContactMode::open) return;
          // Minus the part of the normal force that the loads carry, moved through the rows as in assemble_block.
          const double p = e.owner_sign * rhs_[row + e.owner];
          if (e.other >= 0) rhs_[row + e.other] += e.owner_sign * p;
          if (!is_frictionless(pair)) {
            if (mode == ContactMode::stick) {
              rhs_[row + pair.tangential] = constraint_scale_ * previous_x[row + pair.tangential];
            } else {
              rhs_[row + pair.tangential] -= friction_sign(mode) * pair.friction_coefficient * p;
            }
          }
          rhs_[row + e.owner] = -constraint_scale_ * loading.initial_gap[contact];
        });
    state.x = rhs_;
    lu_.solve_in_place(state.x);
    recover_forces(loading, state);
  }

  void loading_of(const ContactState& state, ContactLoading& loading) override {
    loading.initial_gap = state.gap;
    loading.load.resize(state.x.size());
    K_.multiply(state.x, loading.load);
    for_each_contact(pairs_, K_.block_size, state.x.size(), [&](const CoulombContact& contact) {
      const Eigen::Index c = contact.index;
      loading.initial_gap[c] -= contact.gap(state.x);
      contact.add_forces(state.normal_force[c], state.friction_force[c], -1.0, loading.load);
    });
  }

 private:
  /// Calls visit(elimination, pair, first row of the block, contact, mode) in the order of elimination.
  template <typename Visitor>
  void for_each_elimination(Visitor&& visit) const {
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) {
      for (const Elimination& e : order_) {
        const std::size_t contact = b * pairs_.size() + e.pair;
        visit(e, pairs_[e.pair], static_cast<Eigen::Index>(b) * K_.block_size, static_cast<Eigen::Index>(contact),
              mode_[contact]);
      }
    }
  }

  /// Rows of block b: the balance K x = load + contact forces with the normal forces of closed contacts eliminated.
  void assemble_block(std::size_t b, const ContactMode* mode) {
    const Eigen::Index n = K_.block_size;
    K_.copy_rows(b, rows_);
    for (const Elimination& e : order_) {
      const ContactMode m = mode[e.pair];
      if (m == ContactMode::open) continue;
      const ContactPair& pair = pairs_[e.pair];
      // The balance of the owner reads (row) x - load = owner_sign * p; the force on the other unknown is -owner_sign
      // p.
      if (e.other >= 0) rows_.row(e.other) += rows_.row(e.owner);
      if (!is_frictionless(pair)) {
        if (m == ContactMode::stick) {
          rows_.row(pair.tangential).setZero();
          rows_(pair.tangential, n + pair.tangential) = constraint_scale_;
        } else {
          const double factor = friction_sign(m) * pair.friction_coefficient * e.owner_sign;
          rows_.row(pair.tangential) -= factor * rows_.row(e.owner);
        }
      }
      rows_.row(e.owner).setZero();
      if (pair.plus >= 0) rows_(e.owner, n + pair.plus) = constraint_scale_;
      if (pair.minus >= 0) rows_(e.owner, n + pair.minus) = -constraint_scale_;
    }
    const int i = static_cast<int>(b);
    lu_.lower(i) = rows_.leftCols(n);
    lu_.diagonal(i) = rows_.middleCols(n, n);
    lu_.upper(i) = rows_.rightCols(n);
  }

  void recover_forces(const ContactLoading& loading, ContactState& state) {
    K_.multiply(state.x, imbalance_);
    imbalance_ -= loading.load;
    state.mode = mode_;
    const auto contacts = static_cast<Eigen::Index>(mode_.size());
    state.gap.resize(contacts);
    state.normal_force.resize(contacts);
    state.friction_force.resize(contacts);
    for_each_elimination(
        [&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact, ContactMode mode) {
          double& p = state.normal_force[contact];
          double& t = state.friction_force[contact];
          state.gap[contact] = loading.initial_gap[contact] + (pair.plus >= 0 ? state.x[row + pair.plus] : 0.0) -
                               (pair.minus >= 0 ? state.x[row + pair.minus] : 0.0);
          p = 0.0;
          t = 0.0;
          if (mode == ContactMode::open) return;
          p = e.owner_sign * imbalance_[row + e.owner];
          if (e.other >= 0) imbalance_[row + e.other] += e.owner_sign * p;
          if (is_frictionless(pair)) return;
          t = mode == ContactMode::stick ? imbalance_[row + pair.tangential]
                                         : friction_sign(mode) * pair.friction_coefficient * p;
        });
  }

  std::vector<ContactPair> pairs_;
  std::vector<Elimination> order_;
  Stiffness<B> K_;
  BlockTridiagonalLU<B> lu_;
  std::vector<ContactMode> mode_;
  Vector rhs_, imbalance_;
  Eigen::Matrix<double, B, B == Eigen::Dynamic ? Eigen::Dynamic : 3 * B> rows_;
  double constraint_scale_{0.0};  ///< brings constraint rows to the size of the stiffness, so that pivots compare
  bool factored_{false};
  int factorisations_{0};
};

template <int B>
class PenaltySystemOf final : public PenaltySystem {
 public:
  explicit PenaltySystemOf(const ContactProblem& problem)
      : pairs_(problem.pairs),
        K_(problem.K),
        lu_(problem.K.blocks(), problem.K.block_size()),
        product_(problem.K.rows()) {
    set_elasticity(problem.K);
  }

  void set_elasticity(const BlockTridiagonal& K) final {
    BUMPFOIL_ASSERT(K.blocks() == lu_.blocks());
    K_.assign(K);
    for (std::size_t b = 0; b < K_.upper.size(); ++b) {
      lu_.upper(static_cast<int>(b)) = K_.upper[b];
      lu_.lower(static_cast<int>(b) + 1) = K_.upper[b].transpose();
    }
  }

  bool set_stiffness(const Vector& normal_stiffness, const Vector& tangential_stiffness) override {
    Eigen::Index contact = 0;
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) {
      auto& block = lu_.diagonal(static_cast<int>(b));
      block = K_.diagonal[b];
      for (const ContactPair& pair : pairs_) {
        const double k = normal_stiffness[contact];
        if (pair.plus >= 0) block(pair.plus, pair.plus) += k;
        if (pair.minus >= 0) block(pair.minus, pair.minus) += k;
        if (pair.plus >= 0 && pair.minus >= 0) {
          block(pair.plus, pair.minus) -= k;
          block(pair.minus, pair.plus) -= k;
        }
        if (pair.tangential >= 0) block(pair.tangential, pair.tangential) += tangential_stiffness[contact];
        ++contact;
      }
    }
    return lu_.factor();
  }

  void solve_in_place(Vector& x) override { lu_.solve_in_place(x); }

  const Vector& multiply(const Vector& x) override {
    K_.multiply(x, product_);
    return product_;
  }

 private:
  std::vector<ContactPair> pairs_;
  Stiffness<B> K_;
  BlockTridiagonalLU<B> lu_;
  Vector product_;
};

template <int B>
class SoftContactSystemOf final : public SoftContactSystem {
 public:
  explicit SoftContactSystemOf(const ContactProblem& problem)
      : pairs_(problem.pairs),
        order_(elimination_order(problem.pairs)),
        K_(problem.K),
        lu_(problem.K.blocks(), problem.K.block_size()),
        contacts_(static_cast<std::size_t>(problem.contacts())),
        rhs_(problem.K.rows()),
        imbalance_(problem.K.rows()),
        rows_(problem.K.block_size(), 3 * problem.K.block_size()) {}

  void set_elasticity(const BlockTridiagonal& K) override {
    BUMPFOIL_ASSERT(K.blocks() == lu_.blocks());
    K_.assign(K);
  }

  bool set_contacts(const std::vector<SoftContact>& contacts) override {
    BUMPFOIL_ASSERT(contacts.size() == contacts_.size());
    contacts_ = contacts;
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) assemble_block(b);
    return lu_.factor();
  }

  void solve_in_place(Vector& x, Vector& p, Vector& t) override {
    rhs_ = x;
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact,
                             const SoftContact& soft) {
      const double owner = rhs_[row + e.owner];
      if (e.other >= 0) rhs_[row + e.other] += owner;
      if (!is_frictionless(pair)) {
        double& tangential = rhs_[row + pair.tangential];
        tangential = t[contact] + soft.friction_force * tangential + soft.coupling * e.owner_sign * owner;
      }
      rhs_[row + e.owner] = p[contact] + soft.normal_force * e.owner_sign * owner;
    });
    lu_.solve_in_place(rhs_);
    K_.multiply(rhs_, imbalance_);
    imbalance_ -= x;
    x = rhs_;
    for_each_elimination(
        [&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact, const SoftContact&) {
          p[contact] = e.owner_sign * imbalance_[row + e.owner];
          if (e.other >= 0) imbalance_[row + e.other] += e.owner_sign * p[contact];
          t[contact] = is_frictionless(pair) ? 0.0 : imbalance_[row + pair.tangential];
        });
  }

  const Vector& multiply(const Vector& x) override {
    K_.multiply(x, imbalance_);
    return imbalance_;
  }

 private:
  /// Calls visit(elimination, pair, first row of the block, contact, soft contact) in the order of elimination.
  template <typename Visitor>
  void for_each_elimination(Visitor&& visit) const {
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) {
      for (const Elimination& e : order_) {
        const std::size_t contact = b * pairs_.size() + e.pair;
        visit(e, pairs_[e.pair], static_cast<Eigen::Index>(b) * K_.block_size, static_cast<Eigen::Index>(contact),
              contacts_[contact]);
      }
    }
  }

  /// Rows of block b: the balance of each owner gives dp, that of the tangential unknown dt, and both go into the
  /// conditions, which take the place of these rows.
  void assemble_block(std::size_t b) {
    const Eigen::Index n = K_.block_size;
    K_.copy_rows(b, rows_);
    for (const Elimination& e : order_) {
      const SoftContact& soft = contacts_[b * pairs_.size() + e.pair];
      const ContactPair& pair = pairs_[e.pair];
      if (e.other >= 0) rows_.row(e.other) += rows_.row(e.owner);
      if (!is_frictionless(pair)) {
        rows_.row(pair.tangential) *= soft.friction_force;
        rows_.row(pair.tangential) += soft.coupling * e.owner_sign * rows_.row(e.owner);
        rows_(pair.tangential, n + pair.tangential) += soft.slip;
      }
      rows_.row(e.owner) *= soft.normal_force * e.owner_sign;
      if (pair.plus >= 0) rows_(e.owner, n + pair.plus) += soft.gap;
      if (pair.minus >= 0) rows_(e.owner, n + pair.minus) -= soft.gap;
    }
    const int i = static_cast<int>(b);
    lu_.lower(i) = rows_.leftCols(n);
    lu_.diagonal(i) = rows_.middleCols(n, n);
    lu_.upper(i) = rows_.rightCols(n);
  }

  std::vector<ContactPair> pairs_;
  std::vector<Elimination> order_;
  Stiffness<B> K_;
  BlockTridiagonalLU<B> lu_;
  std::vector<SoftContact> contacts_;
  Vector rhs_, imbalance_;
  Eigen::Matrix<double, B, B == Eigen::Dynamic ? Eigen::Dynamic : 3 * B> rows_;
};

/// The block sizes of the foil models get code of their own; any other size works, more slowly.
template <template <int> class System, typename Interface>
std::unique_ptr<Interface> make_for_block_size(const ContactProblem& problem) {
  switch (problem.K.block_size()) {
    case 6:
      return std::make_unique<System<6>>(problem);
    case 11:
      return std::make_unique<System<11>>(problem);
    default:
      return std::make_unique<System<Eigen::Dynamic>>(problem);
  }
}

}  // namespace

std::unique_ptr<ModeSystem> make_mode_system(const ContactProblem& problem) {
  return make_for_block_size<ModeSystemOf, ModeSystem>(problem);
}

std::unique_ptr<PenaltySystem> make_penalty_system(const ContactProblem& problem) {
  return make_for_block_size<PenaltySystemOf, PenaltySystem>(problem);
}

std::unique_ptr<SoftContactSystem> make_soft_contact_system(const ContactProblem& problem) {
  return make_for_block_size<SoftContactSystemOf, SoftContactSystem>(problem);
}

}  // namespace bumpfoil
