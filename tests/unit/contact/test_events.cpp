#include <gtest/gtest.h>

#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/path_follower.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

std::unique_ptr<PathFollower> stepper_of(const ContactProblem& problem) {
  return make_event_stepper(problem, make_mode_system(problem));
}

/// A whole path at once.
FollowReport follow_events(PathFollower& stepper, const ContactLoading& from, const ContactLoading& to,
                           ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events) {
  stepper.set_out({from, to}, state);
  return stepper.follow_to(1.0, state, visit, events);
}

TEST(EventStepper, FractionsRunFromBeginToEndOfTheStep) {
  const auto stepper = stepper_of(toy::dragged_block());
  ContactState state = ContactState::unstressed(toy::dragged_block());
  std::vector<ContactEvent> events;
  ASSERT_TRUE(follow_events(*stepper, toy::pull(0.0, 40.0), toy::pull(0.0, 40.0), state, {}, events).converged());
  events.clear();
  // Forward and back: slips at 20 N, sticks immediately on reversal, slips back after a change of 40 N.
  ASSERT_TRUE(follow_events(*stepper, toy::pull(0.0, 40.0), toy::pull(30.0, 40.0), state, {}, events).converged());
  const FollowReport back = follow_events(*stepper, toy::pull(30.0, 40.0), toy::pull(-30.0, 40.0), state, {}, events);
  EXPECT_TRUE(back.converged());
  EXPECT_EQ(back.substeps, 0);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_NEAR(events[0].fraction, 20.0 / 30.0, 1e-12);
  EXPECT_EQ(events[1].fraction, 0.0);
  EXPECT_EQ(events[1].to, ContactMode::stick);
  EXPECT_NEAR(events[2].fraction, 40.0 / 60.0, 1e-12);
  EXPECT_EQ(events[2].to, ContactMode::slip_backward);
}

TEST(EventStepper, PartsJoinWithoutAGap) {
  const auto stepper = stepper_of(toy::stacked_slabs());
  ContactState state = ContactState::unstressed(toy::stacked_slabs());
  std::vector<ContactEvent> events;
  const ContactLoading apart{.initial_gap = Eigen::Vector2d(10e-6, 4e-6), .load = Vector::Zero(2)};
  const ContactLoading pressed{.initial_gap = Eigen::Vector2d(-2e-6, -3e-6), .load = Vector::Zero(2)};
  ASSERT_TRUE(follow_events(*stepper, apart, apart, state, {}, events).converged());
  Vector joint = state.x;
  int parts = 0;
  const auto visit = [&](const ResponsePart& part) {
    const ContactState& begin = part.begin;
    const ContactState& end = part.end;
    EXPECT_EQ(begin.x, joint);
    joint = end.x;
    ++parts;
  };
  events.clear();
  ASSERT_TRUE(follow_events(*stepper, apart, pressed, state, visit, events).converged());
  EXPECT_EQ(joint, state.x);
  EXPECT_EQ(parts, 3);  // two contacts close on the way
  EXPECT_EQ(events.size(), 2U);
}

/// Two springs against walls, one of them released: a negligible force compared with 1000 N at the start of the path is
/// a tension compared with 0.1 mN at its end.
TEST(EventStepper, ChecksForcesByThoseThatAreLeft) {
  ContactProblem problem;
  problem.K = BlockTridiagonal(2, 1);
  for (const int block : {0, 1}) problem.K.add(block, 0, block, 0, 1e6);
  problem.sites = in_every_block({{.minus = 0}}, problem.K.blocks());
  const auto stepper = stepper_of(problem);
  const auto walls = [](double first, double second) {
    return ContactLoading{.initial_gap = Eigen::Vector2d(first, second), .load = Vector::Zero(2)};
  };
  const ContactState unstressed = ContactState::unstressed(problem);
  ContactState state = unstressed;
  ASSERT_TRUE(stepper->assemble(walls(-1e-3, -1e-6), unstressed, state).converged());
  ContactState before;
  const auto visit = [&](const ResponsePart& part) { before = part.begin; };
  std::vector<ContactEvent> events;
  const ContactLoading end = walls(-1e-10, 5e-15);
  ASSERT_TRUE(follow_events(*stepper, walls(-1e-3, -1e-6), end, state, visit, events).converged());
  EXPECT_TRUE(contact_residuals(problem, problem.K.multiply(state.x), end, before.x, state).within());
  EXPECT_EQ(state.normal_force[1], 0.0);
  EXPECT_NEAR(state.normal_force[0], 1e-4, 1e-12);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].contact, 1);
  EXPECT_EQ(events[0].to, ContactMode::open);
  // The path goes on from there.
  ASSERT_TRUE(follow_events(*stepper, end, walls(-1e-6, -1e-6), state, visit, events).converged());
  EXPECT_NEAR(state.normal_force[1], 1.0, 1e-9);
}

/// Strong friction on random springs: the response jumps, and after some events no modes continue. A small increment is
/// then inserted in the response and counted, and the path continues from its end; every part is still a solution.
TEST(EventStepper, TakesASmallIncrementWhereNoModesLeadOn) {
  int substeps = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const RandomProblem random = make_random_problem(seed, 8, 6, 2.0);
    const ContactProblem& problem = random.problem;
    NewtonSolver newton(problem);
    const ContactState unstressed = ContactState::unstressed(problem);
    ContactState state = unstressed;
    if (!newton.solve(random.first, unstressed, state).converged()) continue;  // so much friction has no sure method
    const auto stepper = stepper_of(problem);
    stepper->set_out({random.first, random.second}, state);
    Vector joint = state.x;
    std::vector<ContactMode> modes = state.mode;
    const auto visit = [&](const ResponsePart& part) {
      const ContactState& begin = part.begin;
      const ContactState& end = part.end;
      EXPECT_EQ(begin.x, joint) << seed;
      joint = end.x;
      // Gaps of the first and second loading differ everywhere: they show the progress on the path.
      const Vector initial_gap = end.gap - contact_gaps(problem, Vector::Zero(end.gap.size()), end.x);
      const double fraction = (initial_gap - random.first.initial_gap).norm() /
                              (random.second.initial_gap - random.first.initial_gap).norm();
      const ContactResiduals residuals = contact_residuals(
          problem, problem.K.multiply(end.x), LoadingPath{random.first, random.second}.at(fraction), begin.x, end);
      EXPECT_TRUE(residuals.within()) << seed << " at " << fraction;
    };
    std::vector<ContactEvent> events;
    FollowReport report;
    constexpr int halts = 5;
    for (int k = 1; k <= halts && report.converged(); ++k) {
      const double fraction = static_cast<double>(k) / halts;
      report = stepper->follow_to(fraction, state, visit, events);
      if (!report.converged()) break;
      substeps += report.substeps;
      // At the reported end: gaps agree with the loading there, up to round-off of lengths of 1e-4 m.
      const Vector gap =
          contact_gaps(problem, LoadingPath{random.first, random.second}.at(fraction).initial_gap, state.x);
      EXPECT_LT((state.gap - gap).cwiseAbs().maxCoeff(), 1e-17) << seed << " at " << fraction;
    }
    if (!report.converged()) continue;
    EXPECT_EQ(state.x, joint) << seed;
    for (std::size_t i = 1; i < events.size(); ++i) EXPECT_LE(events[i - 1].fraction, events[i].fraction) << seed;
    for (const ContactEvent& event : events) {
      ContactMode& mode = modes[static_cast<std::size_t>(event.contact)];
      EXPECT_EQ(mode, event.from) << seed;
      mode = event.to;
    }
    EXPECT_EQ(modes, state.mode) << seed;
  }
  EXPECT_GT(substeps, 0);
}

}  // namespace
}  // namespace bumpfoil
