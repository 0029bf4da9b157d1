#include "bumpfoil/contact/penalty_system.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal_lu.hpp"
#include "contact/eliminated_system.hpp"

namespace bumpfoil {
namespace {

template <int B>
class PenaltySystemOf final : public PenaltySystem {
 public:
  explicit PenaltySystemOf(const ContactProblem& problem)
      : sites_(problem.sites),
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
    for (std::size_t b = 0; b < K_.diagonal.size(); ++b) lu_.diagonal(static_cast<int>(b)) = K_.diagonal[b];
    Eigen::Index contact = 0;
    for (const ContactSite& site : sites_) {
      auto& block = lu_.diagonal(site.block);
      const double k = normal_stiffness[contact];
      if (site.plus >= 0) block(site.plus, site.plus) += k;
      if (site.minus >= 0) block(site.minus, site.minus) += k;
      if (site.plus >= 0 && site.minus >= 0) {
        block(site.plus, site.minus) -= k;
        block(site.minus, site.plus) -= k;
      }
      if (site.tangential >= 0) block(site.tangential, site.tangential) += tangential_stiffness[contact];
      ++contact;
    }
    return lu_.factor();
  }

  void solve_in_place(Vector& x) override { lu_.solve_in_place(x); }

  const Vector& multiply(const Vector& x) override {
    K_.multiply(x, product_);
    return product_;
  }

 private:
  std::vector<ContactSite> sites_;
  Stiffness<shared_size<B>> K_;
  BlockTridiagonalLU<B> lu_;
  Vector product_;
};

}  // namespace

std::unique_ptr<PenaltySystem> make_penalty_system(const ContactProblem& problem) {
  // The methods that take penalties are for foils without a film, on trusses and frames.
  switch (problem.K.block_size()) {
    case 6:
      return std::make_unique<PenaltySystemOf<6>>(problem);
    case 11:
      return std::make_unique<PenaltySystemOf<11>>(problem);
    default:
      return std::make_unique<PenaltySystemOf<Eigen::Dynamic>>(problem);
  }
}

}  // namespace bumpfoil
