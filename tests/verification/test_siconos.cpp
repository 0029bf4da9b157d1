#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "support/random_problem.hpp"

/// The exact solver against the solvers of Siconos on small random problems: docs/verification/siconos.md. Results of
/// Siconos are data, written by `make verify-siconos`.
namespace bumpfoil {
namespace {

nlohmann::json siconos() {
  return nlohmann::json::parse(std::ifstream(BUMPFOIL_TEST_DATA "/siconos.json"));
}

Vector vector_of_list(const nlohmann::json& list) {
  const auto values = list.get<std::vector<double>>();
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Mode of a contact, from its forces alone.
ContactMode mode_of(double normal, double friction, double coefficient) {
  constexpr double nothing = 1e-6;  // N
  if (normal < nothing) return ContactMode::open;
  if (std::abs(friction) < coefficient * normal - nothing) return ContactMode::stick;
  return friction < 0.0 ? ContactMode::slip_forward : ContactMode::slip_backward;
}

/// Whether the forces found by Siconos solve the problem.
bool solve_it(const ContactProblem& problem, const ContactLoading& loading, const Vector& previous_x,
              const Vector& normal, const Vector& friction) {
  ContactState state = ContactState::unstressed(problem);
  state.normal_force = normal;
  state.friction_force = friction;
  state.x = problem.K.dense().partialPivLu().solve(loading.load + contact_forces(problem, normal, friction));
  state.gap = contact_gaps(problem, loading.initial_gap, state.x);
  // Iterative methods stop at 1e-7 N, which corresponds to a few picometres.
  return contact_residuals(problem, problem.K.multiply(state.x), loading, previous_x, state).within(1e-7, 1e-11);
}

TEST(Siconos, FindsTheSameForcesAndModes) {
  const nlohmann::json document = siconos();
  ASSERT_EQ(document.at("rows").size(), 200U);
  std::map<ContactMode, int> seen;
  for (const nlohmann::json& row : document.at("rows")) {
    const RandomProblem random =
        make_random_problem(row.at("seed"), row.at("blocks"), row.at("block_size"), row.at("friction"));
    const ContactProblem& problem = random.problem;
    NewtonSolver solver(problem);
    ContactState state = ContactState::unstressed(problem);
    for (const std::size_t increment : {0U, 1U}) {
      const ContactState previous = state;
      const ContactLoading& loading = increment == 0 ? random.first : random.second;
      ASSERT_TRUE(solver.solve(loading, previous, state).converged());
      const Vector normal = vector_of_list(row.at("normal_N").at(increment));
      const Vector friction = vector_of_list(row.at("friction_N").at(increment));
      EXPECT_TRUE(solve_it(problem, loading, previous.x, normal, friction)) << row;
      // Forces reach 300 N; Gauss-Seidel, used where Lemke's pivots failed, stops at 1e-7 N.
      ASSERT_LT((state.normal_force - normal).cwiseAbs().maxCoeff(), 1e-6) << row;
      ASSERT_LT((state.friction_force - friction).cwiseAbs().maxCoeff(), 1e-6) << row;
      for (Eigen::Index c = 0; c < normal.size(); ++c) {
        const ContactSite& site = problem.sites[static_cast<std::size_t>(c)];
        if (site.tangential < 0) continue;
        const ContactMode mode = mode_of(normal[c], friction[c], site.friction_coefficient);
        EXPECT_EQ(state.mode[static_cast<std::size_t>(c)], mode) << row << ", contact " << c;
        ++seen[mode];
      }
    }
  }
  // All modes must occur.
  for (const ContactMode mode :
       {ContactMode::open, ContactMode::stick, ContactMode::slip_forward, ContactMode::slip_backward}) {
    EXPECT_GT(seen[mode], 200);
  }
}

}  // namespace
}  // namespace bumpfoil
