#include "contact/soft_contact_system.hpp"
#include "bumpfoil/core/assert.hpp"
#include "contact/eliminated_system.hpp"

namespace bumpfoil {
namespace {

template <int B>
class SoftContactSystemOf final : public SoftContactSystem, private EliminatedSystem<B> {
  using Base = EliminatedSystem<B>;
  using Base::carry_normal_force;
  using Base::eliminations;
  using Base::for_each_elimination;
  using Base::imbalance_;
  using Base::K_;
  using Base::lu_;
  using Base::rhs_;
  using Base::rows_;
  using Base::sites_;

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
    for_each_elimination([&](const Elimination& e, const ContactSite& site, Eigen::Index row) {
      const SoftContact& soft = contacts_[e.site];
      const auto contact = static_cast<Eigen::Index>(e.site);
      const double force = carry_normal_force(e, row, rhs_);
      if (!is_frictionless(site)) {
        double& tangential = rhs_[row + site.tangential];
        tangential = t[contact] + soft.friction_force * tangential + soft.coupling * force;
      }
      rhs_[row + e.owner] = p[contact] + soft.normal_force * force;
    });
    lu_.solve_in_place(rhs_);
    K_.multiply(rhs_, imbalance_);
    imbalance_ -= x;
    x = rhs_;
    for_each_elimination([&](const Elimination& e, const ContactSite& site, Eigen::Index row) {
      const auto contact = static_cast<Eigen::Index>(e.site);
      p[contact] = carry_normal_force(e, row, imbalance_);
      t[contact] = is_frictionless(site) ? 0.0 : imbalance_[row + site.tangential];
    });
  }

  const Vector& multiply(const Vector& x) override {
    K_.multiply(x, imbalance_);
    return imbalance_;
  }

 private:
  /// Rows of block b: the balance of each owner yields dp, that of the tangential unknown dt. Both are inserted in the
  /// contact conditions, which replace these rows.
  void assemble_block(std::size_t b) {
    const Eigen::Index n = K_.block_size;
    K_.copy_rows(b, rows_);
    for (const Elimination& e : eliminations(b)) {
      const SoftContact& soft = contacts_[e.site];
      const ContactSite& site = sites_[e.site];
      if (e.other >= 0) rows_.row(e.other) += rows_.row(e.owner);
      if (!is_frictionless(site)) {
        rows_.row(site.tangential) *= soft.friction_force;
        rows_.row(site.tangential) += soft.coupling * e.owner_sign * rows_.row(e.owner);
        rows_(site.tangential, n + site.tangential) += soft.slip;
      }
      rows_.row(e.owner) *= soft.normal_force * e.owner_sign;
      if (site.plus >= 0) rows_(e.owner, n + site.plus) += soft.gap;
      if (site.minus >= 0) rows_(e.owner, n + site.minus) -= soft.gap;
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
