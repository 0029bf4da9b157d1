#include "bumpfoil/former/former_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

Case former_case(double friction) {
  Case input = case_with_given_constants();
  input.bump_foil.model = BumpFoilModel::former;
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  return input;
}

FormerSolution solve(const Case& input, const Eigen::Vector2d& position) {
  return FormerSolver(make_former_model(input)).solve(position);
}

TEST(FormerModel, FollowsTheJournalAndTheSleeve) {
  Case input = former_case(0.1);
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[20] = 60e-6;  // stands out far enough to be reached on the other side
  const FormerModel model = make_former_model(input);
  const Eigen::Vector2d position(60e-6, 20e-6);
  const FormerSolution solution = FormerSolver(model).solve(position);
  ASSERT_TRUE(solution.report.converged);
  const Vector gap = former_crest_gaps(model, position);
  EXPECT_NEAR(gap[20], journal_gaps(model.bearing.radial_clearance, model.normals, position)[20] - 60e-6, 1e-18);
  int reached = 0;
  for (Eigen::Index i = 0; i < gap.size(); ++i) {
    EXPECT_NEAR(solution.state.x[4 * i + 3], 0.0, 1e-18);  // prescribed
    if (gap[i] < 0.0) {
      ++reached;
      EXPECT_NEAR(solution.state.x[4 * i + 1], -gap[i], 1e-18);
      EXPECT_NE(solution.state.mode[static_cast<std::size_t>(2 * i)], ContactMode::open);
    } else {
      EXPECT_EQ(solution.state.normal_force[2 * i], 0.0);
      EXPECT_EQ(solution.state.friction_force[2 * i], 0.0);
    }
    EXPECT_NE(solution.state.mode[static_cast<std::size_t>(2 * i + 1)], ContactMode::open);
  }
  EXPECT_GT(reached, 5);
  EXPECT_LT(reached, 20);
}

/// Without friction: prescribed displacements eliminated from the dense matrix.
TEST(FormerModel, IsLinearElasticWithoutFriction) {
  const FormerModel model = make_former_model(former_case(0.0));
  const Eigen::Vector2d position(-50e-6, 30e-6);
  const FormerSolution solution = FormerSolver(model).solve(position);
  ASSERT_TRUE(solution.report.converged);

  const Vector gap = former_crest_gaps(model, position);
  const Matrix K = model.structure.K.dense();
  Vector x = Vector::Zero(K.rows());
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < gap.size(); ++i) {
    x[4 * i + 1] = std::max(0.0, -gap[i]);
    free.push_back(4 * i);
    if (gap[i] >= 0.0) free.push_back(4 * i + 1);
    free.push_back(4 * i + 2);
  }
  const Vector right = -(K * x)(free);
  const Vector solved = Matrix(K(free, free)).partialPivLu().solve(right);
  x(free) = solved;
  EXPECT_LT((x - solution.state.x).norm(), 1e-12 * x.norm());
  const Vector p = (K * x)(Eigen::seqN(1, gap.size(), 4));
  const Eigen::Vector2d force = former_journal_force(model, solution.state);
  EXPECT_LT((journal_force(model.normals, p) - force).norm(), 1e-9 * force.norm());
}

/// Coulomb's law against the total displacement, tensions included, spelt out.
TEST(FormerModel, FrictionOpposesTheTotalDisplacement) {
  for (const double friction : {0.05, 0.1, 0.3}) {
    const FormerModel model = make_former_model(former_case(friction));
    const FormerSolution solution = FormerSolver(model).solve({0.0, 70e-6});
    ASSERT_TRUE(solution.report.converged);
    const ContactState& s = solution.state;
    const Vector balance = model.structure.K.multiply(s.x);
    int slipping = 0;
    int tensions = 0;
    for (Eigen::Index c = 0; c < s.normal_force.size(); ++c) {
      const Eigen::Index block = 4 * (c / 2);
      const bool foot = c % 2 == FormerModel::foot;
      const double u = s.x[block + (foot ? 2 : 0)];
      const double bound = friction * std::abs(s.normal_force[c]);
      const double t = s.friction_force[c];
      EXPECT_NEAR(balance[block + (foot ? 2 : 0)], t, 1e-8);
      EXPECT_NEAR(balance[block + (foot ? 3 : 1)], foot ? -s.normal_force[c] : s.normal_force[c], 1e-8);
      EXPECT_LE(std::abs(t), bound + 1e-8);
      const ContactMode mode = s.mode[static_cast<std::size_t>(c)];
      EXPECT_FALSE(mode == ContactMode::slip_forward && u < -1e-12);
      EXPECT_FALSE(mode == ContactMode::slip_backward && u > 1e-12);
      if (std::abs(u) > 1e-12) {
        EXPECT_NEAR(t, -std::copysign(bound, u), 1e-8);
        ++slipping;
      }
      if (s.normal_force[c] < -1e-6) ++tensions;
    }
    EXPECT_GT(slipping, 10);
    EXPECT_GT(tensions, 0);  // the feet at the edge of the loaded bumps are held down
    EXPECT_TRUE(solution.residuals.within());
  }
}

TEST(FormerModel, ResidualsTellAWrongState) {
  const FormerModel model = make_former_model(former_case(0.1));
  const FormerSolution good = FormerSolver(model).solve({60e-6, 0.0});
  ASSERT_TRUE(good.residuals.within());
  // The same judge under twice the friction finds the slipping contacts inside their cone.
  FormerModel rougher = model;
  for (ContactPair& pair : rougher.problem.pairs) pair.friction_coefficient = 0.2;
  EXPECT_FALSE(former_residuals(rougher, {60e-6, 0.0}, good.state).within());
  EXPECT_FALSE(former_residuals(model, {60e-6, 1e-6}, good.state).within());
}

TEST(FormerModel, TangentIsTheSlopeOfTheForce) {
  const FormerModel model = make_former_model(former_case(0.1));
  FormerSolver solver(model);
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const Eigen::Vector2d n = unit_vector(angle);
    const double step = 1e-10;
    const auto force = [&](double s) { return former_journal_force(model, solver.solve(s * n).state).dot(n); };
    const double slope = (force(60e-6 + step) - force(60e-6 - step)) / (2.0 * step);
    // Force to 1e-9 N over 2e-10 m of 15 N/um; no contact changes its mode within the step.
    EXPECT_NEAR(solver.tangent_stiffness(solver.solve(60e-6 * n).state, n).value(), slope, 1e-5 * slope) << angle;
  }
}

TEST(FormerModel, DoesNotDependOnWhatWasSolvedBefore) {
  FormerSolver solver(make_former_model(former_case(0.1)));
  const FormerSolution first = solver.solve({0.0, 70e-6});
  (void)solver.solve({0.0, -70e-6});
  const FormerSolution again = solver.solve({0.0, 70e-6});
  EXPECT_EQ(first.state.x, again.state.x);
}

TEST(FormerModel, SolvesRandomPositionsWithScatterAndFriction) {
  std::mt19937_64 generator(20);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> scatter(0.0, 20e-6);
  for (int trial = 0; trial < 100; ++trial) {
    Case input = former_case(0.0);
    input.friction = {.top_bump = 0.3 * uniform(generator), .bump_sleeve = 0.3 * uniform(generator)};
    for (int bump = 0; bump < 26; ++bump) input.bump_foil.height_errors.push_back(scatter(generator));
    const Eigen::Vector2d n = unit_vector(6.283 * uniform(generator));
    const FormerSolution solution = solve(input, 80e-6 * uniform(generator) * n);
    EXPECT_TRUE(solution.report.converged) << trial;
    EXPECT_TRUE(solution.residuals.within()) << trial;
  }
}

TEST(FormerModel, FeetStayOnTheSleeveAcrossGaps) {
  Case input = former_case(0.0);
  input.bump_foil.sleeve_gaps.assign(26, 5e-6);
  const FormerSolution solution = solve(input, Eigen::Vector2d::Zero());
  ASSERT_TRUE(solution.report.converged);
  EXPECT_NEAR(solution.state.x[3], 5e-6, 1e-18);
}

}  // namespace
}  // namespace bumpfoil
