#include "bumpfoil/origin/former_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "core/linear_algebra.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

Case rubbing_former_case(double friction) {
  Case input = case_with_given_constants();
  input.bump_foil.model = BumpFoilModel::former;
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  return input;
}

FormerSolution solve(const Case& input, const Eigen::Vector2d& position) {
  return FormerSolver(make_former_model(input)).solve(position);
}

TEST(FormerModel, FollowsTheJournalAndTheSleeve) {
  Case input = rubbing_former_case(0.1);
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[20] = 60e-6;  // high enough to be in contact on the opposite side
  const FormerModel model = make_former_model(input);
  const Eigen::Vector2d position(60e-6, 20e-6);
  const FormerSolution solution = FormerSolver(model).solve(position);
  ASSERT_TRUE(solution.report.converged());
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

/// Without friction: the dense matrix with prescribed displacements eliminated.
TEST(FormerModel, IsLinearElasticWithoutFriction) {
  const FormerModel model = make_former_model(rubbing_former_case(0.0));
  const Eigen::Vector2d position(-50e-6, 30e-6);
  const FormerSolution solution = FormerSolver(model).solve(position);
  ASSERT_TRUE(solution.report.converged());

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
  const Vector solved = bumpfoil::solve(K(free, free), right);
  x(free) = solved;
  EXPECT_LT((x - solution.state.x).norm(), 1e-12 * x.norm());
  const Vector p = (K * x)(Eigen::seqN(1, gap.size(), 4));
  const Eigen::Vector2d force = former_journal_force(model, solution.state);
  EXPECT_LT((journal_force(model.normals, p) - force).norm(), 1e-9 * force.norm());
}

/// Coulomb's law for the total displacement, including tension, written out.
TEST(FormerModel, FrictionOpposesTheTotalDisplacement) {
  for (const double friction : {0.05, 0.1, 0.3}) {
    const FormerModel model = make_former_model(rubbing_former_case(friction));
    const FormerSolution solution = FormerSolver(model).solve({0.0, 70e-6});
    ASSERT_TRUE(solution.report.converged());
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
    EXPECT_GT(tensions, 0);  // feet at the edge of the loaded bumps are in tension
    EXPECT_TRUE(solution.residuals.within());
  }
}

TEST(FormerModel, ResidualsTellAWrongState) {
  const FormerModel model = make_former_model(rubbing_former_case(0.1));
  const FormerSolution good = FormerSolver(model).solve({60e-6, 0.0});
  ASSERT_TRUE(good.residuals.within());
  // With twice the friction coefficient, the same check finds the slipping contacts inside their cone.
  FormerModel rougher = model;
  for (ContactSite& site : rougher.problem.sites) site.friction_coefficient = 0.2;
  EXPECT_FALSE(former_residuals(rougher, {60e-6, 0.0}, good.state).within());
  EXPECT_FALSE(former_residuals(model, {60e-6, 1e-6}, good.state).within());
}

TEST(FormerModel, TangentIsTheSlopeOfTheForce) {
  const FormerModel model = make_former_model(rubbing_former_case(0.1));
  FormerSolver solver(model);
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const Eigen::Vector2d n = unit_vector(angle);
    const double step = 1e-10;
    const auto force = [&](double s) { return former_journal_force(model, solver.solve(s * n).state).dot(n); };
    const double slope = (force(60e-6 + step) - force(60e-6 - step)) / (2.0 * step);
    // Force errors of 1e-9 N over 2e-10 m with 15 N/um; no contact changes its mode within the step.
    EXPECT_NEAR(solver.tangent_stiffness(solver.solve(60e-6 * n).state, n).value(), slope, 1e-5 * slope) << angle;
  }
}

TEST(FormerModel, DoesNotDependOnWhatWasSolvedBefore) {
  FormerSolver solver(make_former_model(rubbing_former_case(0.1)));
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
    Case input = rubbing_former_case(0.0);
    input.friction = {.top_bump = 0.3 * uniform(generator), .bump_sleeve = 0.3 * uniform(generator)};
    for (int bump = 0; bump < 26; ++bump) input.bump_foil.height_errors.push_back(scatter(generator));
    const Eigen::Vector2d n = unit_vector(6.283 * uniform(generator));
    const FormerSolution solution = solve(input, 80e-6 * uniform(generator) * n);
    EXPECT_TRUE(solution.report.converged()) << trial;
    EXPECT_TRUE(solution.residuals.within()) << trial;
  }
}

/// A random bearing, reproducible by its number; not always a valid one.
Case random_former_case(std::uint64_t number) {
  std::mt19937_64 generator(number);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(generator);
  };
  Case input = reference_case();
  input.bearing.radius = uniform(5e-3, 40e-3);
  input.bearing.axial_length = uniform(10e-3, 80e-3);
  BumpFoil& foil = input.bump_foil;
  foil.model = BumpFoilModel::former;
  foil.bumps = static_cast<int>(uniform(3.0, 45.0));
  const double pitch = uniform(4.3, 6.2) * input.bearing.radius / foil.bumps;
  const double length = pitch * uniform(0.5, 0.9);
  const double height = length * uniform(0.08, 0.3);
  foil.pitch = pitch;
  foil.length = length;
  foil.height = height;
  foil.height_reference = HeightReference::midsurface;
  foil.thickness = std::min(0.1 * pitch, uniform(0.05e-3, 0.15e-3));
  input.bearing.radial_clearance = height * uniform(0.05, 0.6);
  std::normal_distribution<double> scatter(0.0, uniform(0.0, 0.1) * height);
  for (int bump = 0; bump < foil.bumps; ++bump) {
    foil.height_errors.push_back(std::clamp(scatter(generator), -0.5 * height, 0.5 * height));
  }
  input.friction.top_bump = uniform(0.0, 1.0);
  input.friction.bump_sleeve = number % 2 == 0 ? input.friction.top_bump : uniform(0.0, 1.0);
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {uniform(0.0, 6.28)};
  cycle.amplitude.value = input.bearing.radial_clearance + uniform(0.0, 0.5) * height;
  return input;
}

/// With a penalty far above the foil stiffness, one in a hundred of these bearings had unsolved positions.
TEST(FormerModel, SolvesRandomBearingsOfAnyStiffnessAndStrongFriction) {
  int bearings = 0;
  for (std::uint64_t number = 0; number < 1500; ++number) {
    const Case input = random_former_case(number);
    if (!find_errors(input).empty() || !find_truss_errors(make_bearing_design(input)).empty()) continue;
    ++bearings;
    FormerSolver solver(make_former_model(input));
    for (int k = 0; k <= 10; ++k) {
      const FormerSolution solution = solver.solve(input.settings.get<CycleSettings>().amplitude.value * k / 10.0 *
                                                   unit_vector(input.settings.get<CycleSettings>().directions[0]));
      EXPECT_TRUE(solution.report.converged()) << number << ", position " << k;
      EXPECT_TRUE(solution.residuals.within()) << number << ", position " << k;
    }
  }
  EXPECT_GT(bearings, 300);
}

/// A stiff row of small bumps with friction 0.99, where friction bounds used to oscillate with the normal forces.
TEST(FormerModel, SolvesAStiffRowUnderFrictionOfNearlyOne) {
  Case input = reference_case();
  input.bearing = {.radius = 7.902294237435568e-3,
                   .axial_length = 65.97506480029106e-3,
                   .radial_clearance = 78.79562906794749e-6,
                   .wrap = Wrap::counterclockwise};
  BumpFoil& foil = input.bump_foil;
  foil.model = BumpFoilModel::former;
  foil.bumps = 38;
  foil.pitch = 1.2105741044433817e-3;
  foil.length = 0.6999603230912446e-3;
  foil.height = 0.14528432828061688e-3;
  foil.height_reference = HeightReference::midsurface;
  foil.thickness = 92.01845595072681e-6;
  foil.youngs_modulus = 47597047151.80383;
  foil.poisson_ratio = 0.05284318067314371;
  foil.height_errors = {
      7.51940936525583e-06,    1.5269113376735317e-07,  -6.927488552812602e-07, 2.0306960911725696e-06,
      -6.81645160122169e-06,   7.892864499466286e-07,   5.606736263119272e-06,  -2.652339421827841e-06,
      -1.7438968101054582e-06, 6.5148704464007175e-06,  5.730944346637155e-06,  4.176777822730914e-06,
      2.143517569830651e-06,   -5.416503350988927e-06,  1.1628307152474387e-06, 8.53619372450451e-06,
      -1.2540133391443865e-05, 2.8430289270752827e-06,  -2.821939748940875e-06, -1.0504922201951384e-05,
      -9.819009551445034e-06,  -5.545683133252785e-06,  7.169813707405836e-06,  -2.652143552193005e-06,
      -3.9431857787583516e-07, 1.3874967491845757e-06,  -3.682685199984899e-06, -8.644878784365724e-06,
      4.762913735169899e-07,   -1.1051548729504123e-06, -3.390431033886809e-06, 2.0538637257435994e-08,
      5.661981782320741e-06,   -5.095888032714124e-06,  -3.569605577342493e-06, -6.355021421340358e-06,
      8.662990227587227e-06,   -7.831392583665405e-06};
  input.friction = {.top_bump = 0.9918788395347787, .bump_sleeve = 0.9918788395347787};
  FormerSolver solver(make_former_model(input));
  for (int k = 0; k <= 10; ++k) {
    const FormerSolution solution = solver.solve({0.0, 132.20046803062816e-6 * k / 10.0});
    EXPECT_TRUE(solution.report.converged()) << k;
    EXPECT_TRUE(solution.residuals.within()) << k;
  }
}

TEST(FormerModel, FeetStayOnTheSleeveAcrossGaps) {
  Case input = rubbing_former_case(0.0);
  input.bump_foil.sleeve_gaps.assign(26, 5e-6);
  const FormerSolution solution = solve(input, Eigen::Vector2d::Zero());
  ASSERT_TRUE(solution.report.converged());
  EXPECT_NEAR(solution.state.x[3], 5e-6, 1e-18);
}

}  // namespace
}  // namespace bumpfoil
