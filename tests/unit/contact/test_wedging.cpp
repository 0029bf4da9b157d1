#include "bumpfoil/contact/wedging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"

namespace bumpfoil {
namespace {

/// A particle on an obstacle, held by springs [Klarbring1990]: tangential and normal displacement x0, x1, with 1 N/m
/// and 4 N/m, coupled by -1.5 N/m. In forward slip, (1 - 1.5 f) x0 = L - f with a normal load of 1 N: beyond f = 2/3 it
/// moves against its load L.
ContactProblem particle(double f) {
  ContactProblem problem;
  problem.K.diagonal = {(Matrix(2, 2) << 1.0, -1.5, -1.5, 4.0).finished()};
  problem.sites = {{.block = 0, .plus = 1, .tangential = 0, .friction_coefficient = f}};
  problem.force_scale = 1.0;
  return problem;
}

/// State of the particle under (L, -1) in a mode, from hand calculation with f = 1.
ContactState answer(ContactMode mode, double x0, double x1, double p, double t) {
  ContactState state;
  state.x = Eigen::Vector2d(x0, x1);
  state.gap = Vector::Constant(1, x1);
  state.normal_force = Vector::Constant(1, p);
  state.friction_force = Vector::Constant(1, t);
  state.mode = {mode};
  return state;
}

TEST(Wedging, GivesAParticleThreeAnswers) {
  const ContactProblem problem = particle(1.0);
  const ContactLoading loading{.initial_gap = Vector::Zero(1), .load = Eigen::Vector2d(0.8, -1.0)};
  const ContactState stuck = answer(ContactMode::stick, 0.0, 0.0, 1.0, -0.8);
  const ContactState sliding = answer(ContactMode::slip_forward, 0.4, 0.0, 0.4, -0.4);
  const ContactState open = answer(ContactMode::open, 1.7 / 1.75, 0.2 / 1.75, 0.0, 0.0);
  for (const ContactState* state : {&stuck, &sliding, &open}) {
    const ContactResiduals residuals =
        contact_residuals(problem, problem.K.multiply(state->x), loading, Vector::Zero(2), *state);
    EXPECT_TRUE(residuals.within(1e-14, 1e-14)) << static_cast<int>(state->mode[0]);
  }
  const std::optional<Wedge> wedge = strongest_wedge(problem);
  ASSERT_TRUE(wedge);
  EXPECT_EQ(wedge->contact, 0);
  EXPECT_DOUBLE_EQ(wedge->friction, 2.0 / 3.0);
  // The exact solver finds one of the solutions.
  ContactState found = ContactState::unstressed(problem);
  NewtonSolver solver{SharedProblem(problem)};
  ASSERT_TRUE(solver.solve(loading, answer(ContactMode::stick, 0.0, 0.0, 1.0, 0.0), found).converged());
  EXPECT_TRUE(found.x.isApprox(stuck.x) || found.x.isApprox(sliding.x) || found.x.isApprox(open.x)) << found.x;
}

TEST(Wedging, BeginsWhereTheSlopeTurns) {
  EXPECT_FALSE(strongest_wedge(particle(0.0)));
  EXPECT_FALSE(strongest_wedge(particle(0.666)));
  EXPECT_TRUE(strongest_wedge(particle(0.667)));
}

/// The foot of a flat at 45 degrees whose crest is fixed: T = |a|, f = 1. Neighbours that support the foot stiffen it.
TEST(Wedging, IsThatOfTheSteepestFlat) {
  ContactProblem problem;
  const auto block = [](double angle, double beside) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return Matrix{{c * c + beside, c * s}, {c * s, s * s}};
  };
  problem.K = BlockTridiagonal(3, 2);
  problem.K.diagonal = {block(0.6, 0.0), block(std::numbers::pi / 4.0, 0.0), block(0.9, 1.0)};
  problem.sites = in_every_block({{.plus = 1, .tangential = 0, .friction_coefficient = 1.2}}, 3);
  const std::optional<Wedge> wedge = strongest_wedge(problem);
  ASSERT_TRUE(wedge);
  EXPECT_EQ(wedge->contact, 1);
  EXPECT_NEAR(wedge->friction, 1.0, 1e-15);
  for (ContactSite& site : problem.sites) site.friction_coefficient = 0.99;
  EXPECT_FALSE(strongest_wedge(problem));
}

}  // namespace
}  // namespace bumpfoil
