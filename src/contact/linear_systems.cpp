#include "bumpfoil/contact/linear_systems.hpp"

#include <algorithm>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal_lu.hpp"
#include "contact/eliminated_system.hpp"
#include "contact/pivoting.hpp"

namespace bumpfoil {
namespace {

template <int B>
class ModeSystemOf final : public ModeSystem, private EliminatedSystem<B> {
  using Base = EliminatedSystem<B>;
  using Base::carry_normal_force;
  using Base::for_each_elimination;
  using Base::imbalance_;
  using Base::K_;
  using Base::lu_;
  using Base::order_;
  using Base::pairs_;
  using Base::rhs_;
  using Base::rows_;

 public:
  explicit ModeSystemOf(const ContactProblem& problem)
      : Base(problem), mode_(static_cast<std::size_t>(problem.contacts()), ContactMode::open) {
    for (const Matrix& block : problem.K.diagonal) {
      constraint_scale_ = std::max(constraint_scale_, block.diagonal().cwiseAbs().maxCoeff());
    }
  }

  void set_elasticity(const BlockTridiagonal& K) override {
    Base::assign_elasticity(K);
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
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact) {
      const ContactMode mode = mode_[static_cast<std::size_t>(contact)];
      if (mode == ContactMode::open) return;
      // Minus the part of the normal force that the loads carry, moved through the rows as in assemble_block.
      const double p = carry_normal_force(e, row, rhs_);
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
    Base::store_rows(b);
  }

  void recover_forces(const ContactLoading& loading, ContactState& state) {
    K_.multiply(state.x, imbalance_);
    imbalance_ -= loading.load;
    state.mode = mode_;
    const auto contacts = static_cast<Eigen::Index>(mode_.size());
    state.gap.resize(contacts);
    state.normal_force.resize(contacts);
    state.friction_force.resize(contacts);
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact) {
      const ContactMode mode = mode_[static_cast<std::size_t>(contact)];
      double& p = state.normal_force[contact];
      double& t = state.friction_force[contact];
      state.gap[contact] = loading.initial_gap[contact] + (pair.plus >= 0 ? state.x[row + pair.plus] : 0.0) -
                           (pair.minus >= 0 ? state.x[row + pair.minus] : 0.0);
      p = 0.0;
      t = 0.0;
      if (mode == ContactMode::open) return;
      p = carry_normal_force(e, row, imbalance_);
      if (is_frictionless(pair)) return;
      t = mode == ContactMode::stick ? imbalance_[row + pair.tangential]
                                     : friction_sign(mode) * pair.friction_coefficient * p;
    });
  }

  std::vector<ContactMode> mode_;
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
      lu_.lower(static_cast<int>(b) + 1) = K_.lower_block(b);
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
class SoftContactSystemOf final : public SoftContactSystem, private EliminatedSystem<B> {
  using Base = EliminatedSystem<B>;
  using Base::carry_normal_force;
  using Base::for_each_elimination;
  using Base::imbalance_;
  using Base::K_;
  using Base::lu_;
  using Base::order_;
  using Base::pairs_;
  using Base::rhs_;
  using Base::rows_;

 public:
  explicit SoftContactSystemOf(const ContactProblem& problem)
      : Base(problem), contacts_(static_cast<std::size_t>(problem.contacts())) {}

  void set_elasticity(const BlockTridiagonal& K) override { Base::assign_elasticity(K); }

  bool set_contacts(const std::vector<SoftContact>& contacts) override {
    BUMPFOIL_ASSERT(contacts.size() == contacts_.size());
    contacts_ = contacts;
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) assemble_block(b);
    return lu_.factor();
  }

  void solve_in_place(Vector& x, Vector& p, Vector& t) override {
    rhs_ = x;
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact) {
      const SoftContact& soft = contacts_[static_cast<std::size_t>(contact)];
      const double force = carry_normal_force(e, row, rhs_);
      if (!is_frictionless(pair)) {
        double& tangential = rhs_[row + pair.tangential];
        tangential = t[contact] + soft.friction_force * tangential + soft.coupling * force;
      }
      rhs_[row + e.owner] = p[contact] + soft.normal_force * force;
    });
    lu_.solve_in_place(rhs_);
    K_.multiply(rhs_, imbalance_);
    imbalance_ -= x;
    x = rhs_;
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact) {
      p[contact] = carry_normal_force(e, row, imbalance_);
      t[contact] = is_frictionless(pair) ? 0.0 : imbalance_[row + pair.tangential];
    });
  }

  const Vector& multiply(const Vector& x) override {
    K_.multiply(x, imbalance_);
    return imbalance_;
  }

 private:
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
    Base::store_rows(b);
  }

  std::vector<SoftContact> contacts_;
};

/// The block sizes of the foil models get code of their own; any other size works, more slowly.
template <template <int> class System, typename Interface>
std::unique_ptr<Interface> make_for_block_size(const ContactProblem& problem) {
  switch (problem.K.block_size()) {
    case 6:
      return std::make_unique<System<6>>(problem);
    case 11:
      return std::make_unique<System<11>>(problem);
    case 14:  // the truss under a film of eight rows
      return std::make_unique<System<14>>(problem);
    case 22:  // of sixteen
      return std::make_unique<System<22>>(problem);
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
