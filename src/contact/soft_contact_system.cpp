#include "contact/soft_contact_system.hpp"
#include "bumpfoil/core/assert.hpp"
#include "contact/eliminated_system.hpp"

namespace bumpfoil {
namespace {

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

}  // namespace

std::unique_ptr<SoftContactSystem> make_soft_contact_system(const ContactProblem& problem) {
  return make_for_block_size<SoftContactSystemOf, SoftContactSystem>(problem);
}

}  // namespace bumpfoil
