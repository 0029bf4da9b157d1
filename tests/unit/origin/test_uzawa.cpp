#include "bumpfoil/origin/uzawa.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

constexpr UzawaOptions options{.eps_alm = 1e8, .eps_f = 1e10, .eps_r = 1e12, .tau_f = 1e-10};
constexpr double stiffness = 1e6;  // N/m

/// A point above a wall on two springs: u along the wall, v towards it, f = 0.3. Uncoupled, for simple results.
ContactProblem point_over_wall() {
  ContactProblem problem;
  problem.K = BlockTridiagonal(1, 2);
  problem.K.add(0, 0, 0, 0, stiffness);
  problem.K.add(0, 1, 0, 1, stiffness);
  problem.sites = in_every_block({{.minus = 1, .tangential = 0, .friction_coefficient = 0.3}}, problem.K.blocks());
  return problem;
}

ContactLoading pushed(double along, double towards, double gap = 0.0) {
  return {.initial_gap = Vector::Constant(1, gap), .load = Eigen::Vector2d(along, towards)};
}

struct Solved {
  ContactState state;
  SolveReport report;
};

Solved solve(const ContactProblem& problem, const ContactLoading& loading, const ContactState& previous,
             const UzawaOptions& with = options) {
  Solved solved;
  solved.report = UzawaSolver(problem, with).solve(loading, previous, solved.state);
  return solved;
}

/// The stiffness across the contact is 1e6 N/m; the default force scale is 10 N.
TEST(UzawaOptions, FollowFromStiffnessAndForces) {
  ContactProblem problem = point_over_wall();
  problem.K.add(0, 0, 0, 0, 7e6);  // along the wall: no effect
  const UzawaOptions found = uzawa_options_for(problem);
  EXPECT_DOUBLE_EQ(found.eps_alm, 4.5e6);
  EXPECT_DOUBLE_EQ(found.eps_f, 4.5e8);
  EXPECT_DOUBLE_EQ(found.eps_r, 4.5e10);
  EXPECT_DOUBLE_EQ(found.tau_f, 6.5e-11);
  EXPECT_DOUBLE_EQ(found.gap_tolerance, 6.5e-11);
  EXPECT_EQ(found.max_contact_updates, 61);
  problem.force_scale = 40.0;
  EXPECT_DOUBLE_EQ(uzawa_options_for(problem).tau_f, 2.6e-10);

  // A top foil in moment form has no diagonal stiffness, and contacts of a journal are ignored.
  ContactProblem stacked;
  stacked.K = BlockTridiagonal(1, 3);
  stacked.K.add(0, 1, 0, 1, stiffness);
  stacked.sites = in_every_block({{.plus = 2}, {.plus = 1, .minus = 2, .tangential = 0, .friction_coefficient = 0.3}},
                                 stacked.K.blocks());
  EXPECT_DOUBLE_EQ(uzawa_options_for(stacked).eps_alm, 4.5e6);
}

TEST(Uzawa, ItsStatesAreNotCheckedByResiduals) {
  const UzawaSolver uzawa(toy::dragged_block(), options);
  EXPECT_GT(uzawa.bounds().force, 1e300);
  EXPECT_GT(uzawa.bounds().load, NewtonSolver(toy::dragged_block()).bounds().load);
}

TEST(Uzawa, HoldsAPointInsideTheCone) {
  const ContactProblem problem = point_over_wall();
  const auto [state, report] = solve(problem, pushed(2.0, 10.0), ContactState::unstressed(problem));
  ASSERT_TRUE(report.converged());
  EXPECT_EQ(state.mode[0], ContactMode::stick);
  // The spring of a sticking contact deflects by 2 N / eps_f, and its force is reduced accordingly.
  EXPECT_NEAR(state.x[0], 2.0 / (options.eps_f + stiffness), 1e-15);
  EXPECT_NEAR(state.friction_force[0], -2.0, 1e-3);
  EXPECT_NEAR(state.normal_force[0], 10.0, 1e-5);  // multiplier_tolerance * 10 N
}

TEST(Uzawa, FrictionOpposesTheSlipBothWays) {
  const ContactProblem problem = point_over_wall();
  for (const double sign : {1.0, -1.0}) {
    const auto [state, report] = solve(problem, pushed(sign * 5.0, 10.0), ContactState::unstressed(problem));
    ASSERT_TRUE(report.converged());
    EXPECT_EQ(state.mode[0], sign > 0.0 ? ContactMode::slip_forward : ContactMode::slip_backward);
    // 5 N against 0.3 * 10 N leave 2 N for the spring; the arctangent is short by (2/pi) 1e-10/2e-6 of 3 N.
    EXPECT_NEAR(state.friction_force[0], -sign * 3.0, 1e-4);
    EXPECT_NEAR(state.x[0], sign * 2.0 / stiffness, 1e-10);
  }
}

TEST(Uzawa, RegularisedSlipFollowsTheArctangent) {
  const ContactProblem problem = point_over_wall();
  UzawaOptions smooth = options;
  smooth.tau_f = 1e-6;
  const auto [state, report] = solve(problem, pushed(5.0, 10.0), ContactState::unstressed(problem), smooth);
  ASSERT_TRUE(report.converged());
  const double expected = -0.3 * 10.0 * 2.0 / std::numbers::pi * std::atan(state.x[0] / 1e-6);
  EXPECT_NEAR(state.friction_force[0], expected, 1e-5);  // multiplier_tolerance * 10 N
  EXPECT_GT(state.x[0], 2.1e-6);                         // clearly more than the 2 um of Coulomb's law
}

TEST(Uzawa, AStuckContactDoesNotCreep) {
  const ContactProblem problem = point_over_wall();
  ContactState state = solve(problem, pushed(2.0, 10.0), ContactState::unstressed(problem)).state;
  const double first = state.x[0];
  for (int increment = 0; increment < 100; ++increment) {
    const Solved next = solve(problem, pushed(2.0, 10.0), state);
    ASSERT_TRUE(next.report.converged());
    EXPECT_EQ(next.state.mode[0], ContactMode::stick);
    state = next.state;
  }
  // A spring restarted each time would move by 100 * 2 N / eps_f = 2e-8 m; the load is balanced to 1e-8 of 10 N.
  EXPECT_NEAR(state.x[0], first, 1e-16);
}

TEST(Uzawa, ASlidingContactComesToRestAndKeepsItsForce) {
  const ContactProblem problem = point_over_wall();
  ContactState state = solve(problem, pushed(5.0, 10.0), ContactState::unstressed(problem)).state;
  const double first = state.x[0];
  for (int increment = 0; increment < 100; ++increment) state = solve(problem, pushed(5.0, 10.0), state).state;
  EXPECT_EQ(state.mode[0], ContactMode::stick);
  // At rest it sticks with its full friction force.
  EXPECT_NEAR(state.x[0], first, 1e-14);
  EXPECT_NEAR(state.friction_force[0], -3.0, 1e-4);
}

TEST(Uzawa, OpensAndClosesByTheGap) {
  const ContactProblem problem = point_over_wall();
  const ContactState start = ContactState::unstressed(problem);
  const Solved open = solve(problem, pushed(0.0, -1.0), start);  // starts with zero gap, thus closed
  ASSERT_TRUE(open.report.converged());
  EXPECT_EQ(open.state.mode[0], ContactMode::open);
  EXPECT_EQ(open.state.normal_force[0], 0.0);
  EXPECT_NEAR(open.state.gap[0], 1e-6, 1e-13);

  const Solved closes = solve(problem, pushed(0.0, 10.0, 4e-6), start);  // would move 10 um through a gap of 4 um
  ASSERT_TRUE(closes.report.converged());
  EXPECT_NE(closes.state.mode[0], ContactMode::open);
  EXPECT_NEAR(closes.state.normal_force[0], 6.0, 1e-5);
  EXPECT_NEAR(closes.state.x[1], 4e-6, 1e-13);

  const Solved touching = solve(problem, pushed(0.0, 10.0, 0.0), start);
  EXPECT_NEAR(touching.state.normal_force[0], 10.0, 1e-5);
}

/// 4 N move the point 4 um down, a hundredth of a nanometre into the wall.
TEST(Uzawa, LeavesOpenWhatOverlapsByLessThanItsTolerance) {
  const ContactProblem problem = point_over_wall();
  const ContactLoading loading = pushed(0.0, 4.0, 4e-6 - 1e-11);
  const ContactState start = ContactState::unstressed(problem);
  UzawaOptions tolerant = options;
  tolerant.gap_tolerance = 1e-10;
  EXPECT_EQ(solve(problem, loading, start, tolerant).state.mode[0], ContactMode::open);
  tolerant.gap_tolerance = 1e-12;
  EXPECT_NE(solve(problem, loading, start, tolerant).state.mode[0], ContactMode::open);
  // Without a gap tolerance, only the overlap that remains in closed contacts is accepted: 1e-6 * 1 N / eps_alm
  EXPECT_NE(solve(problem, loading, start).state.mode[0], ContactMode::open);
}

TEST(Uzawa, ThePenaltyContactPenetratesByItsForce) {
  ContactProblem problem = point_over_wall();
  problem.sites = in_every_block({{.minus = 1}}, problem.K.blocks());
  UzawaOptions soft = options;
  soft.eps_r = 1e9;
  const auto [state, report] = solve(problem, pushed(0.0, 10.0), ContactState::unstressed(problem), soft);
  ASSERT_TRUE(report.converged());
  EXPECT_NEAR(state.x[1], 10.0 / (1e9 + stiffness), 1e-15);
  EXPECT_NEAR(state.normal_force[0], 1e9 * state.x[1], 1e-9);
  EXPECT_EQ(state.mode[0], ContactMode::stick);
  EXPECT_EQ(state.friction_force[0], 0.0);
}

TEST(Uzawa, ForcesReportedAreInBalance) {
  const ContactProblem problem = point_over_wall();
  const ContactState start = ContactState::unstressed(problem);
  for (const double along : {0.0, 2.0, 2.99, 3.0, 3.01, 5.0}) {
    const ContactLoading loading = pushed(along, 10.0);
    const auto [state, report] = solve(problem, loading, start);
    ASSERT_TRUE(report.converged()) << along;
    const ContactResiduals r = contact_residuals(problem, problem.K.multiply(state.x), loading, start.x, state);
    EXPECT_LT(r.equilibrium, options.newton_tolerance + options.multiplier_tolerance) << along;
    EXPECT_LT(r.penetration, options.multiplier_tolerance * 10.0 / options.eps_alm) << along;
    // cone_tolerance * 0.3, and 0.3 * multiplier_tolerance
    EXPECT_LT(r.cone, 0.3 * (options.cone_tolerance + options.multiplier_tolerance)) << along;
  }
}

TEST(Uzawa, SaysSoWhereItGivesUp) {
  const ContactProblem problem = point_over_wall();
  UzawaOptions impatient = options;
  impatient.eps_alm = 1e5;  // a tenth of the stiffness: multipliers need about a hundred updates
  impatient.max_multiplier_updates = 10;
  const Solved gave_up = solve(problem, pushed(5.0, 10.0), ContactState::unstressed(problem), impatient);
  EXPECT_FALSE(gave_up.report.converged());
  EXPECT_EQ(gave_up.report.cost.outer_iterations, 10);
  impatient.max_multiplier_updates = 400;
  const Solved patient = solve(problem, pushed(5.0, 10.0), ContactState::unstressed(problem), impatient);
  EXPECT_TRUE(patient.report.converged());
  EXPECT_GT(patient.report.cost.outer_iterations, 100);

  impatient = options;
  impatient.max_friction_updates = 1;  // finds that the point slips, without a second check
  EXPECT_FALSE(solve(problem, pushed(5.0, 10.0), ContactState::unstressed(problem), impatient).report.converged());

  impatient = options;
  impatient.max_newton_steps = 1;  // the arctangent needs several
  EXPECT_FALSE(solve(problem, pushed(5.0, 10.0), ContactState::unstressed(problem), impatient).report.converged());

  impatient = options;
  impatient.max_contact_updates = 1;  // finds that the point is lifted, without a second check
  EXPECT_FALSE(solve(problem, pushed(0.0, -1.0), ContactState::unstressed(problem), impatient).report.converged());
}

/// Violated contacts change together as long as this converges.
TEST(Uzawa, OpensManyContactsAtOnce) {
  ContactProblem problem = point_over_wall();
  problem.K = BlockTridiagonal(10, 2);
  problem.sites = in_every_block(problem.sites, 10);
  for (int block = 0; block < 10; ++block) {
    problem.K.add(block, 0, block, 0, stiffness);
    problem.K.add(block, 1, block, 1, stiffness);
  }
  ContactLoading lifted = ContactLoading::none(problem);
  for (Eigen::Index i = 1; i < lifted.load.size(); i += 2) lifted.load[i] = -1.0;
  const Solved solved = solve(problem, lifted, ContactState::unstressed(problem));
  ASSERT_TRUE(solved.report.converged());
  EXPECT_LE(solved.report.cost.outer_iterations, 5);  // one at a time would need a round each
}

/// `blocks` of three springs coupled so that changing all contacts at once cycles forever: all closed, only the first,
/// only the second, all closed. The fourth unknown slides freely.
ContactProblem going_round(int blocks) {
  ContactProblem problem;
  problem.K = BlockTridiagonal(blocks, 4);
  for (Matrix& K : problem.K.diagonal) {
    K.topLeftCorner(3, 3) << 6.0, -5.0, -7.0, -5.0, 14.0, 13.0, -7.0, 13.0, 14.0;
    K(3, 3) = 1.0;
    K *= stiffness;
  }
  problem.sites = in_every_block(
      {{.plus = 0, .tangential = 3}, {.plus = 1, .tangential = 3}, {.plus = 2, .tangential = 3}}, problem.K.blocks());
  return problem;
}

ContactLoading loading_that_goes_round(const ContactProblem& problem) {
  ContactLoading loading = ContactLoading::none(problem);
  for (int block = 0; block < problem.K.blocks(); ++block) loading.load.segment(4 * block, 3) << -5.0, 1.0, 5.0;
  return loading;
}

/// After twelve changes of all contacts at once they are all closed again, and then change one at a time: the third one
/// opens, which has the largest tension, and the other two stay closed. The fourteenth round finds no change.
TEST(Uzawa, ChangesOneContactAtATimeWhereTheyGoRoundTogether) {
  const ContactProblem problem = going_round(1);
  const ContactLoading loading = loading_that_goes_round(problem);
  const ContactState start = ContactState::unstressed(problem);
  UzawaOptions limited = options;
  limited.max_contact_updates = 14;
  const Solved solved = solve(problem, loading, start, limited);
  ASSERT_TRUE(solved.report.converged());
  limited.max_contact_updates = 13;
  EXPECT_FALSE(solve(problem, loading, start, limited).report.converged());
}

/// Sixty such blocks need 12 + 60 + 1 rounds; a limit independent of the number of contacts would fail.
TEST(Uzawa, HasRoundsEnoughForOneContactAtATime) {
  const ContactProblem problem = going_round(60);
  const Solved solved =
      solve(problem, loading_that_goes_round(problem), ContactState::unstressed(problem), uzawa_options_for(problem));
  EXPECT_TRUE(solved.report.converged());
}

}  // namespace
}  // namespace bumpfoil
