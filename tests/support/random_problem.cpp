#include "support/random_problem.hpp"

#include <cmath>
#include <random>

namespace bumpfoil {
namespace {

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(generator_);
  }
  Vector vector(Eigen::Index size, double low, double high) {
    Vector out(size);
    for (double& value : out) value = (*this)(low, high);
    return out;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace

RandomProblem make_random_problem(std::uint64_t seed, int blocks, int block_size, double friction) {
  Uniform uniform(seed);
  RandomProblem random;
  ContactProblem& problem = random.problem;
  problem.K = BlockTridiagonal(blocks, block_size);
  // Springs with random directions over one or two blocks, and a soft foundation that makes K positive definite.
  for (int b = 0; b < blocks; ++b) {
    problem.K.diagonal[static_cast<std::size_t>(b)].diagonal().array() += 1e5;
    for (int spring = 0; spring < block_size; ++spring) {
      const double stiffness = std::pow(10.0, uniform(5.0, 7.0));
      const Vector here = uniform.vector(block_size, -1.0, 1.0);
      problem.K.diagonal[static_cast<std::size_t>(b)] += stiffness * here * here.transpose();
      if (b + 1 == blocks) continue;
      const Vector there = uniform.vector(block_size, -1.0, 1.0);
      problem.K.upper[static_cast<std::size_t>(b)] += stiffness * here * there.transpose();
      problem.K.diagonal[static_cast<std::size_t>(b) + 1] += stiffness * there * there.transpose();
    }
  }
  problem.sites = in_every_block({{.plus = 4},
                                  {.plus = 1, .minus = 4, .tangential = 0, .friction_coefficient = friction},
                                  {.minus = 3, .tangential = 2, .friction_coefficient = friction}},
                                 blocks);
  for (ContactLoading* loading : {&random.first, &random.second}) {
    loading->initial_gap = uniform.vector(problem.contacts(), -2e-5, 2e-5);
    loading->load = uniform.vector(problem.K.rows(), -20.0, 20.0);
  }
  return random;
}

RandomProblem make_irregular_problem(std::uint64_t seed, int blocks, int block_size, double friction) {
  RandomProblem random = make_random_problem(seed, blocks, block_size, friction);
  Uniform uniform(seed + 1'000'000);
  std::vector<ContactSite> sites;
  std::vector<Eigen::Index> kept;
  for (std::size_t c = 0; c < random.problem.sites.size(); ++c) {
    // The first one always stays, so that at least one remains.
    if (c > 0 && uniform(0.0, 1.0) < 0.3) continue;
    kept.push_back(static_cast<Eigen::Index>(c));
    sites.push_back(random.problem.sites[c]);
    sites.back().friction_coefficient *= uniform(0.5, 1.5);
  }
  random.problem.sites = sites;
  for (ContactLoading* loading : {&random.first, &random.second}) {
    loading->initial_gap = Vector(loading->initial_gap(kept));
  }
  return random;
}

std::vector<ContactMode> random_modes(std::uint64_t seed, const ContactProblem& problem) {
  Uniform uniform(seed);
  std::vector<ContactMode> mode;
  for (const ContactSite& site : problem.sites) {
    const bool frictionless = site.tangential < 0 || site.friction_coefficient == 0.0;
    mode.push_back(static_cast<ContactMode>(static_cast<int>(uniform(0.0, frictionless ? 2.0 : 4.0))));
  }
  return mode;
}

}  // namespace bumpfoil
