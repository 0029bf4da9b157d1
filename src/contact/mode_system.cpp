#include <algorithm>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/core/assert.hpp"
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

  void solve_units(RowMajor& x, RowMajor& force) override {
    BUMPFOIL_ASSERT(factored_);
    const std::vector<Coordinates> coordinates = coordinates_of(pairs_);
    const Eigen::Index per_block = coordinate_count(pairs_);
    const auto count = per_block * std::ssize(K_.diagonal);
    const Eigen::Index n = K_.block_size;
    // Loads first, carried through the rows as in solve().
    RowMajor& load = unit_loads_;
    load.setZero(count / per_block * n, count);
    for (Eigen::Index b = 0; b < count / per_block; ++b) {
      for (std::size_t c = 0; c < pairs_.size(); ++c) {
        const ContactPair& pair = pairs_[c];
        const ContactMode mode = mode_[static_cast<std::size_t>(b) * pairs_.size() + c];
        const Eigen::Index normal = b * per_block + coordinates[c].normal;
        if (mode == ContactMode::open && pair.plus >= 0) load(b * n + pair.plus, normal) += 1.0;
        if (mode == ContactMode::open && pair.minus >= 0) load(b * n + pair.minus, normal) -= 1.0;
        if (!is_frictionless(pair) && mode != ContactMode::stick) {
          load(b * n + pair.tangential, b * per_block + coordinates[c].tangential) += 1.0;
        }
      }
    }
    x = load;
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact) {
      const ContactMode mode = mode_[static_cast<std::size_t>(contact)];
      if (mode == ContactMode::open) return;
      const Eigen::Index first = row / n * per_block;
      const auto part = [&](int unknown) { return x.row(row + unknown).segment(first, per_block); };
      const Eigen::RowVectorXd p = e.owner_sign * part(e.owner);
      if (e.other >= 0) part(e.other) += e.owner_sign * p;
      if (!is_frictionless(pair)) {
        if (mode == ContactMode::stick) {
          part(pair.tangential).setZero();
          part(pair.tangential)[coordinates[e.pair].tangential] = constraint_scale_;
        } else {
          part(pair.tangential) -= friction_sign(mode) * pair.friction_coefficient * p;
        }
      }
      part(e.owner).setZero();
      part(e.owner)[coordinates[e.pair].normal] = constraint_scale_;
    });
    lu_.solve_panel_in_place(x);
    RowMajor& imbalance = load;
    K_.multiply_panel(x, imbalance);
    force.setZero(count, count);
    for_each_elimination([&](const Elimination& e, const ContactPair& pair, Eigen::Index row, Eigen::Index contact) {
      const ContactMode mode = mode_[static_cast<std::size_t>(contact)];
      if (mode == ContactMode::open) return;
      const Eigen::Index first = row / n * per_block;
      auto p = force.row(first + coordinates[e.pair].normal);
      p = e.owner_sign * imbalance.row(row + e.owner);
      if (e.other >= 0) imbalance.row(row + e.other) += e.owner_sign * p;
      if (is_frictionless(pair)) return;
      auto t = force.row(first + coordinates[e.pair].tangential);
      if (mode == ContactMode::stick) {
        t = imbalance.row(row + pair.tangential);
      } else {
        t = friction_sign(mode) * pair.friction_coefficient * p;
      }
    });
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
  RowMajor unit_loads_;           ///< of solve_units(), and then what they leave of the balance
  bool factored_{false};
  int factorisations_{0};
};

}  // namespace

std::unique_ptr<ModeSystem> make_mode_system(const ContactProblem& problem) {
  return make_for_block_size<ModeSystemOf, ModeSystem>(problem);
}

}  // namespace bumpfoil
