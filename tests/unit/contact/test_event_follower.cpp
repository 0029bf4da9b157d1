#include "contact/event_follower.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// A problem followed along straight paths.
struct Path {
  explicit Path(const ContactProblem& problem)
      : follower(problem, make_mode_system(problem)),
        state(ContactState::unstressed(problem)),
        begin(ContactLoading::none(problem)) {}

  void to(const ContactLoading& end) {
    events.clear();
    follower.set_out({begin, end}, state.mode);
    report = follower.follow_to(1.0, state, {}, &events);
    ASSERT_TRUE(report.arrived);
    begin = end;
    EXPECT_EQ(report.fraction, 1.0);
  }

  EventFollower follower;
  ContactState state;
  ContactLoading begin;  ///< where the state is
  EventProgress report;
  std::vector<ContactEvent> events;
};

/// Pressed by 40 N the floor holds 20 N of friction; the spring along it has 2 N/um.
TEST(EventFollower, BlockSlipsExactlyWhenThePullReachesItsFriction) {
  Path path(toy::dragged_block());
  path.to(toy::pull(0.0, 40.0));
  path.to(toy::pull(30.0, 40.0));
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_NEAR(path.events[0].fraction, 20.0 / 30.0, 1e-12);
  EXPECT_EQ(path.events[0].from, ContactMode::stick);
  EXPECT_EQ(path.events[0].to, ContactMode::slip_forward);
  EXPECT_EQ(path.report.events, 1);
  EXPECT_NEAR(path.state.x[0], 5e-6, 1e-17);

  path.to(toy::pull(-30.0, 40.0));  // sticks at once, slips back when 40 of the 60 N are taken
  ASSERT_EQ(path.events.size(), 2U);
  EXPECT_EQ(path.events[0].fraction, 0.0);
  EXPECT_EQ(path.events[0].to, ContactMode::stick);
  EXPECT_NEAR(path.events[1].fraction, 40.0 / 60.0, 1e-12);
  EXPECT_EQ(path.events[1].to, ContactMode::slip_backward);
  EXPECT_NEAR(path.state.x[0], -5e-6, 1e-17);
  EXPECT_NEAR(path.state.friction_force[0], 20.0, 1e-11);
}

/// Held with all of its friction it slips at once when it is pulled further, on either side: no place has to be passed.
TEST(EventFollower, ABlockAtItsBoundSlipsAtOnceToEitherSide) {
  for (const double side : {1.0, -1.0}) {
    Path path(toy::dragged_block());
    path.to(toy::pull(0.0, 40.0));
    path.to(toy::pull(side * 20.0, 40.0));
    ASSERT_EQ(path.state.mode[0], ContactMode::stick);
    path.to(toy::pull(side * 30.0, 40.0));
    ASSERT_EQ(path.events.size(), 1U);
    EXPECT_EQ(path.events[0].fraction, 0.0);
    EXPECT_EQ(path.report.events, 0);
    EXPECT_NEAR(path.state.x[0], side * 5e-6, 1e-17);
  }
}

/// A block lifted while friction held it: it jumps to the free length of its spring, whose energy is dissipated.
TEST(EventFollower, AnOpenContactHasNoFriction) {
  const ContactProblem block = toy::dragged_block();
  EventFollower follower(block, make_mode_system(block));
  ContactState state = ContactState::unstressed(block);
  state.x[1] = state.gap[0] = 1e-6;
  state.friction_force[0] = -5.0;
  follower.set_out({toy::pull(5.0, -1.0), toy::pull(5.0, -2.0)}, state.mode);
  const EventProgress report = follower.follow_to(0.5, state);
  ASSERT_TRUE(report.arrived);
  EXPECT_EQ(state.friction_force[0], 0.0);
  EXPECT_NEAR(state.x[0], 2.5e-6, 1e-17);
  EXPECT_NEAR(report.jump_dissipation, 0.5 * 5.0 * 2.5e-6, 1e-17);
}

/// Slabs on beds of 1 N/um, 10 um above the floor and 4 um apart.
TEST(EventFollower, SlabsMeetOneAfterTheOther) {
  Path path(toy::stacked_slabs());
  const Vector gaps = Eigen::Vector2d(10e-6, 4e-6);
  path.to({.initial_gap = gaps, .load = Vector::Zero(2)});
  path.to({.initial_gap = gaps, .load = Eigen::Vector2d(0.0, -40.0)});
  ASSERT_EQ(path.events.size(), 2U);
  EXPECT_EQ(path.events[0].contact, 1);  // the upper reaches the lower under 4 N
  EXPECT_NEAR(path.events[0].fraction, 0.1, 1e-12);
  EXPECT_EQ(path.events[1].contact, 0);  // both reach the floor under 4 + 2 * 10 N
  EXPECT_NEAR(path.events[1].fraction, 0.6, 1e-12);
  EXPECT_NEAR(path.state.normal_force[0], 16.0, 1e-11);
}

TEST(EventFollower, PiecesJoinWithoutAGap) {
  const RandomProblem random = make_random_problem(21, 6, 6, 0.3);
  Path path(random.problem);
  path.to(random.first);
  ContactState state = path.state;
  Vector x = state.x;
  double reached = 0.0;
  int pieces = 0;
  const auto visit = [&](const ResponsePart& part) {
    const auto& [begin, end, at, linear] = part;
    EXPECT_TRUE(linear);
    EXPECT_GE(at, reached);
    reached = at;
    EXPECT_EQ(begin.x, x);
    EXPECT_EQ(begin.mode, end.mode);
    x = end.x;
    ++pieces;
  };
  path.follower.set_out({random.first, random.second}, state.mode);
  ASSERT_TRUE(path.follower.follow_to(1.0, state, visit).arrived);
  EXPECT_EQ(x, state.x);
  EXPECT_EQ(reached, 1.0);
  EXPECT_GT(pieces, 3);
}

/// What increments converge to: at every event all conditions hold, slip measured from the event before.
class EventFollowerRates : public testing::TestWithParam<Rates> {};

TEST_P(EventFollowerRates, EveryEventIsASolution) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const RandomProblem random = make_random_problem(seed, 5, 6, 0.3);
    EventFollower follower(random.problem, make_mode_system(random.problem), {.rates = GetParam()});
    ContactState state = ContactState::unstressed(random.problem);
    NewtonSolver solver(random.problem);
    const ContactState start = state;
    ASSERT_TRUE(solver.solve(random.first, start, state).converged());
    const std::shared_ptr<ModeSystem> system = make_mode_system(random.problem);
    ContactState exact;
    const auto visit = [&](const ResponsePart& part) {
      EXPECT_TRUE(part.linear);
      const ContactLoading loading = LoadingPath{random.first, random.second}.at(part.fraction);
      ASSERT_TRUE(system->set_modes(part.end.mode));
      system->solve(loading, part.end.x, exact);
      EXPECT_LT((part.end.gap - exact.gap).norm(), 1e-9 * exact.gap.norm()) << seed;
      EXPECT_LT((part.end.normal_force - exact.normal_force).norm(), 1e-9 * exact.normal_force.norm()) << seed;
      EXPECT_LT(tangential_displacements(random.problem, part.end.x - exact.x).norm(), 1e-9 * exact.x.norm()) << seed;
      const ContactResiduals residuals =
          contact_residuals(random.problem, random.problem.K.multiply(exact.x), loading, part.begin.x, exact);
      EXPECT_TRUE(residuals.within()) << "seed " << seed << " at " << part.fraction;
    };
    follower.set_out({random.first, random.second}, state.mode);
    EXPECT_TRUE(follower.follow_to(1.0, state, visit).arrived) << seed;
    // The returned state is complete, independent of the parts.
    EXPECT_LT((state.x - exact.x).norm(), 1e-12 * exact.x.norm()) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, EventFollowerRates, testing::Values(Rates::by_solves, Rates::by_tableau));

TEST(EventFollower, WithoutFrictionThePathDoesNotMatter) {
  const RandomProblem random = make_random_problem(3, 6, 6, 0.0);
  Path path(random.problem);
  path.to(random.second);
  const Vector direct = path.state.x;
  path.to(random.first);
  path.to(random.second);
  EXPECT_LT((path.state.x - direct).norm(), 1e-11 * direct.norm());
}

/// Halts do not change the path: states in between are interpolated, without a solve unless there is an event.
TEST(EventFollower, HaltsAnywhereOnTheWay) {
  const RandomProblem random = make_random_problem(21, 6, 6, 0.3);
  Path direct(random.problem);
  direct.to(random.first);
  Path halting(random.problem);
  halting.to(random.first);
  direct.to(random.second);

  halting.events.clear();
  halting.follower.set_out({random.first, random.second}, halting.state.mode);
  constexpr int halts = 500;
  int solves = 0;
  int events = 0;
  for (int k = 1; k <= halts; ++k) {
    const double fraction = static_cast<double>(k) / halts;
    const Vector before = halting.state.x;
    const EventProgress report = halting.follower.follow_to(fraction, halting.state, {}, &halting.events);
    ASSERT_TRUE(report.arrived);
    EXPECT_EQ(report.fraction, fraction);
    solves += report.cost.iterations;
    events += report.events;
    if (k > 1 && report.events == 0) {
      EXPECT_EQ(report.cost.iterations, 0);
    }
    const ContactResiduals residuals =
        contact_residuals(random.problem, random.problem.K.multiply(halting.state.x),
                          LoadingPath{random.first, random.second}.at(fraction), before, halting.state);
    EXPECT_LT(residuals.equilibrium, 1e-12);
    EXPECT_LT(residuals.penetration, 1e-15);
    EXPECT_LT(residuals.complementarity, 1e-12);
  }
  EXPECT_EQ(halting.state.x, direct.state.x);
  EXPECT_EQ(solves, direct.report.cost.iterations);
  EXPECT_EQ(events, direct.report.events);
  EXPECT_EQ(halting.events.size(), direct.events.size());
}

TEST(EventFollower, StopsWhereItCannotGoOn) {
  const ContactProblem block = toy::dragged_block();
  ContactLoading broken = toy::pull(10.0, 40.0);
  broken.load[0] = std::numeric_limits<double>::quiet_NaN();
  const auto arrives = [](EventFollower& follower, const ContactLoading& end, ContactState& state) {
    follower.set_out({toy::pull(0.0, 40.0), end}, state.mode);
    return follower.follow_to(1.0, state).arrived;
  };
  EventFollower follower(block, make_mode_system(block));
  ContactState state = ContactState::unstressed(block);
  EXPECT_FALSE(arrives(follower, broken, state));

  EventFollower short_sighted(block, make_mode_system(block), {.max_events = 0});
  EXPECT_TRUE(arrives(short_sighted, toy::pull(0.0, 40.0), state));
  EXPECT_FALSE(arrives(short_sighted, toy::pull(30.0, 40.0), state));
  EXPECT_NEAR(state.x[0], 0.0, 1e-17);  // the place where it would begin to slip
  EXPECT_NEAR(state.friction_force[0], -20.0, 1e-11);
}

}  // namespace
}  // namespace bumpfoil
