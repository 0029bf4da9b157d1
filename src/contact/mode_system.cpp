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
  using Base::eliminations;
  using Base::first_;
  using Base::for_each_elimination;
  using Base::imbalance_;
  using Base::K_;
  using Base::lu_;
  using Base::rhs_;
  using Base::rows_;
  using Base::sites_;

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
    BUMPFOIL_ASSERT(mode.size() == sites_.size());
    std::size_t first = factored_ ? K_.diagonal.size() : 0;
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) {
      const auto begin = static_cast<std::ptrdiff_t>(first_[b]);
      const auto end = static_cast<std::ptrdiff_t>(first_[b + 1]);
      if (factored_ && std::equal(mode.begin() + begin, mode.begin() + end, mode_.begin() + begin)) continue;
      first = std::min(first, b);
      assemble_block(b, mode);
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
    for_each_elimination([&](const Elimination& e, const ContactSite& site, Eigen::Index row) {
      const ContactMode mode = mode_[e.site];
      if (mode == ContactMode::open) return;
      // Minus the load part of the normal force, moved through the rows as in assemble_block.
      const double p = carry_normal_force(e, row, rhs_);
      if (!is_frictionless(site)) {
        if (mode == ContactMode::stick) {
          rhs_[row + site.tangential] = constraint_scale_ * previous_x[row + site.tangential];
        } else {
          rhs_[row + site.tangential] -= friction_sign(mode) * site.friction_coefficient * p;
        }
      }
      rhs_[row + e.owner] = -constraint_scale_ * loading.initial_gap[static_cast<Eigen::Index>(e.site)];
    });
    state.x = rhs_;
    lu_.solve_in_place(state.x);
    recover_forces(loading, state);
  }

  void solve_units(RowMajorMatrix& x, RowMajorMatrix& force) override {
    BUMPFOIL_ASSERT(factored_);
    const std::vector<SiteCoordinates> coordinates = coordinates_of(sites_);
    const Eigen::Index count = coordinate_count(sites_);
    const Eigen::Index n = K_.block_size;
    // Index range of a block: loads and forces act within their block only.
    const auto begin_of = [&](std::size_t site) { return site < sites_.size() ? coordinates[site].normal : count; };
    // Loads first, moved through the rows as in solve().
    RowMajorMatrix& load = unit_loads_;
    load.setZero(std::ssize(K_.diagonal) * n, count);
    for (std::size_t c = 0; c < sites_.size(); ++c) {
      const ContactSite& site = sites_[c];
      const ContactMode mode = mode_[c];
      const Eigen::Index row = site.block * n;
      if (mode == ContactMode::open && site.plus >= 0) load(row + site.plus, coordinates[c].normal) += 1.0;
      if (mode == ContactMode::open && site.minus >= 0) load(row + site.minus, coordinates[c].normal) -= 1.0;
      if (!is_frictionless(site) && mode != ContactMode::stick) {
        load(row + site.tangential, coordinates[c].tangential) += 1.0;
      }
    }
    x = load;
    for_each_elimination([&](const Elimination& e, const ContactSite& site, Eigen::Index row) {
      const ContactMode mode = mode_[e.site];
      if (mode == ContactMode::open) return;
      const auto b = static_cast<std::size_t>(site.block);
      const Eigen::Index begin = begin_of(first_[b]);
      const Eigen::Index size = begin_of(first_[b + 1]) - begin;
      const auto part = [&](int unknown) { return x.row(row + unknown).segment(begin, size); };
      const Eigen::RowVectorXd p = e.owner_sign * part(e.owner);
      if (e.other >= 0) part(e.other) += e.owner_sign * p;
      if (!is_frictionless(site)) {
        if (mode == ContactMode::stick) {
          part(site.tangential).setZero();
          x(row + site.tangential, coordinates[e.site].tangential) = constraint_scale_;
        } else {
          part(site.tangential) -= friction_sign(mode) * site.friction_coefficient * p;
        }
      }
      part(e.owner).setZero();
      x(row + e.owner, coordinates[e.site].normal) = constraint_scale_;
    });
    lu_.solve_panel_in_place(x);
    RowMajorMatrix& imbalance = load;
    K_.multiply_panel(x, imbalance);
    force.setZero(count, count);
    for_each_elimination([&](const Elimination& e, const ContactSite& site, Eigen::Index row) {
      const ContactMode mode = mode_[e.site];
      if (mode == ContactMode::open) return;
      auto p = force.row(coordinates[e.site].normal);
      p = e.owner_sign * imbalance.row(row + e.owner);
      if (e.other >= 0) imbalance.row(row + e.other) += e.owner_sign * p;
      if (is_frictionless(site)) return;
      auto t = force.row(coordinates[e.site].tangential);
      if (mode == ContactMode::stick) {
        t = imbalance.row(row + site.tangential);
      } else {
        t = friction_sign(mode) * site.friction_coefficient * p;
      }
    });
  }

  void loading_of(const ContactState& state, ContactLoading& loading) override {
    loading.initial_gap = state.gap;
    loading.load.resize(state.x.size());
    K_.multiply(state.x, loading.load);
    for_each_contact(sites_, K_.block_size, [&](const CoulombContact& contact) {
      const Eigen::Index c = contact.index;
      loading.initial_gap[c] -= contact.gap(state.x);
      contact.add_forces(state.normal_force[c], state.friction_force[c], -1.0, loading.load);
    });
  }

 private:
  /// Rows of block b: the balance K x = load + contact forces with the normal forces of closed contacts eliminated.
  void assemble_block(std::size_t b, const std::vector<ContactMode>& mode) {
    const Eigen::Index n = K_.block_size;
    K_.copy_rows(b, rows_);
    for (const Elimination& e : eliminations(b)) {
      const ContactMode m = mode[e.site];
      if (m == ContactMode::open) continue;
      const ContactSite& site = sites_[e.site];
      // The balance of the owner reads (row) x - load = owner_sign * p; the other unknown bears -owner_sign p.
      if (e.other >= 0) rows_.row(e.other) += rows_.row(e.owner);
      if (!is_frictionless(site)) {
        if (m == ContactMode::stick) {
          rows_.row(site.tangential).setZero();
          rows_(site.tangential, n + site.tangential) = constraint_scale_;
        } else {
          const double factor = friction_sign(m) * site.friction_coefficient * e.owner_sign;
          rows_.row(site.tangential) -= factor * rows_.row(e.owner);
        }
      }
      rows_.row(e.owner).setZero();
      if (site.plus >= 0) rows_(e.owner, n + site.plus) = constraint_scale_;
      if (site.minus >= 0) rows_(e.owner, n + site.minus) = -constraint_scale_;
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
    for_each_elimination([&](const Elimination& e, const ContactSite& site, Eigen::Index row) {
      const ContactMode mode = mode_[e.site];
      const auto contact = static_cast<Eigen::Index>(e.site);
      double& p = state.normal_force[contact];
      double& t = state.friction_force[contact];
      state.gap[contact] = loading.initial_gap[contact] + (site.plus >= 0 ? state.x[row + site.plus] : 0.0) -
                           (site.minus >= 0 ? state.x[row + site.minus] : 0.0);
      p = 0.0;
      t = 0.0;
      if (mode == ContactMode::open) return;
      p = carry_normal_force(e, row, imbalance_);
      if (is_frictionless(site)) return;
      t = mode == ContactMode::stick ? imbalance_[row + site.tangential]
                                     : friction_sign(mode) * site.friction_coefficient * p;
    });
  }

  std::vector<ContactMode> mode_;
  double constraint_scale_{0.0};  ///< brings constraint rows to the size of the stiffness, so that pivots compare
  RowMajorMatrix unit_loads_;     ///< of solve_units(), and then what they leave of the balance
  bool factored_{false};
  int factorisations_{0};
};

}  // namespace

std::unique_ptr<ModeSystem> make_mode_system(const ContactProblem& problem) {
  return make_for_block_size<ModeSystemOf, ModeSystem>(problem);
}

}  // namespace bumpfoil
