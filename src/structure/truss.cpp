#include "bumpfoil/structure/truss.hpp"

#include <cmath>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

std::vector<Spring> make_truss_springs(const std::vector<TrussConstants>& bumps, const BumpDofs& dofs, bool welded) {
  BUMPFOIL_ASSERT(dofs.feet() == 1);
  const int foot_u = dofs.foot_u.front();
  const int foot_v = dofs.foot_v.front();
  std::vector<Spring> springs;
  const int first = welded ? 0 : 1;
  int n = first;
  for (const TrussConstants& constants : bumps) {
    const double c = std::cos(constants.theta_d);
    const double s = std::sin(constants.theta_d);
    Spring front{constants.k1, {{n, dofs.crest_u, c}, {n, dofs.crest_v, -s}}};
    const Spring back{constants.k1, {{n, foot_u, c}, {n, dofs.crest_u, -c}, {n, dofs.crest_v, -s}, {n, foot_v, s}}};
    Spring feet{constants.k2, {{n, foot_u, 1.0}}};
    Spring crests{n > first ? constants.k3 : constants.k4, {{n, dofs.crest_u, 1.0}}};
    if (n > 0) {
      front.terms.push_back({n - 1, foot_u, -c});
      front.terms.push_back({n - 1, foot_v, s});
      feet.terms.push_back({n - 1, foot_u, -1.0});
      crests.terms.push_back({n - 1, dofs.crest_u, -1.0});
    }
    springs.insert(springs.end(), {front, back, feet});
    if (n > first || welded) springs.push_back(crests);
    ++n;
  }
  return springs;
}

double spring_energy(const std::vector<Spring>& springs, int block_size, const Vector& x) {
  double energy = 0.0;
  for (const Spring& spring : springs) {
    double elongation = 0.0;
    for (const Spring::Term& term : spring.terms) {
      elongation += term.coefficient * x[Eigen::Index{term.bump} * block_size + term.dof];
    }
    energy += 0.5 * spring.stiffness * elongation * elongation;
  }
  return energy;
}

void assemble_springs(const std::vector<Spring>& springs, BlockTridiagonal& K) {
  for (const Spring& spring : springs) {
    for (std::size_t i = 0; i < spring.terms.size(); ++i) {
      for (std::size_t j = i; j < spring.terms.size(); ++j) {
        const Spring::Term& a = spring.terms[i];
        const Spring::Term& b = spring.terms[j];
        K.add(a.bump, a.dof, b.bump, b.dof, spring.stiffness * a.coefficient * b.coefficient);
      }
    }
  }
}

}  // namespace bumpfoil
