#include "bearing/energy.hpp"

#include <cmath>
#include <cstddef>
#include <iterator>

#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {

double gap_work(const Vector& mean_force, const Vector& gap_change) {
  return -mean_force.dot(gap_change);
}

double friction_dissipation(const ContactProblem& problem, const Vector& normal_force, const Vector& begin_x,
                            const Vector& end_x) {
  double dissipation = 0.0;
  // Kind by kind, without a branch per contact: ensembles ask for it some 400 times a sample.
  const std::ptrdiff_t stride = std::ssize(problem.pairs);
  const Eigen::Index size = problem.K.block_size();
  for (std::ptrdiff_t i = 0; i < stride; ++i) {
    const ContactPair& pair = problem.pairs[static_cast<std::size_t>(i)];
    if (is_frictionless(pair)) continue;
    double work = 0.0;  // in units of the friction coefficient
    for (Eigen::Index b = 0; b < problem.K.blocks(); ++b) {
      const Eigen::Index x = b * size + pair.tangential;
      work += normal_force[b * stride + i] * std::abs(end_x[x] - begin_x[x]);
    }
    dissipation += pair.friction_coefficient * work;
  }
  return dissipation;
}

}  // namespace bumpfoil
