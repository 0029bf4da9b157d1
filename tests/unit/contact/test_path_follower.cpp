#include "bumpfoil/contact/path_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// Moves its one unknown to the load, if it likes that; else it fails and leaves rubbish.
class ScriptedSolver final : public ContactSolver {
 public:
  using Likes = std::function<bool(double from, const ContactLoading& to)>;
  explicit ScriptedSolver(Likes likes) : likes_(std::move(likes)) {}
  [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                  ContactState& state) override {
    const bool good = likes_(previous.x[0], loading);
    state = previous;
    state.x[0] = good ? loading.load[0] : std::numeric_limits<double>::quiet_NaN();
    state.mode.assign(1, ContactMode::slip_backward);
    return {.status = good ? Status::converged : Status::no_modes,
            .cost = {.iterations = 3, .factorisations = 2, .outer_iterations = 1}};
  }

 private:
  Likes likes_;
};

ContactLoading at(double load) {
  return {.initial_gap = Vector::Constant(1, 10.0 * load), .load = Vector::Constant(1, load)};
}

ContactState start() {
  return {.x = Vector::Zero(1),
          .gap = Vector::Zero(1),
          .normal_force = Vector::Zero(1),
          .friction_force = Vector::Zero(1),
          .mode = {}};
}

/// Follows a path from start to end in one increment.
FollowReport follow(const ScriptedSolver::Likes& likes, const LoadingPath& path, ContactState& state,
                    const PartVisitor& visit = {}, int max_halvings = 8) {
  const auto follower = make_increment_follower(std::make_unique<ScriptedSolver>(likes), max_halvings);
  std::vector<ContactEvent> events;
  follower->set_out(path, state);
  const FollowReport report = follower->follow_to(1.0, state, visit, events);
  EXPECT_TRUE(events.empty());
  return report;
}

/// Goes no further than `reach` at a time, and notes where it starts from.
ScriptedSolver::Likes short_reach(double reach, std::vector<double>* started_from = nullptr) {
  return [=](double from, const ContactLoading& to) {
    if (started_from != nullptr) started_from->push_back(from);
    return std::abs(to.load[0] - from) <= reach;
  };
}

TEST(IncrementFollower, TakesTheIncrementAtOnceWhereItCan) {
  ContactState state = start();
  const FollowReport report = follow(short_reach(1.0), {at(0.0), at(1.0)}, state);
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.substeps, 0);
  EXPECT_EQ(report.cost.iterations, 3);
  EXPECT_EQ(state.x[0], 1.0);
  EXPECT_EQ(state.mode.front(), ContactMode::slip_backward);
}

TEST(IncrementFollower, HalvesFromTheRestoredStateAndCountsEveryExtraSolve) {
  std::vector<double> started_from;
  ContactState state = start();
  const FollowReport report = follow(short_reach(0.25, &started_from), {at(0.0), at(1.0)}, state);
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(state.x[0], 1.0);
  // 1 fails; 1/2 fails, 1/4 and 1/2 succeed; 1 from 1/2 fails, 3/4 and 1 succeed.
  EXPECT_EQ(started_from, (std::vector<double>{0.0, 0.0, 0.0, 0.25, 0.5, 0.5, 0.75}));
  EXPECT_EQ(report.substeps, 6);
  EXPECT_EQ(report.cost, (SolveCost{.iterations = 21, .factorisations = 14, .outer_iterations = 7}));
}

TEST(IncrementFollower, InterpolatesGapsAndLoadsAlike) {
  std::vector<ContactLoading> seen;
  const auto second_time = [&](double, const ContactLoading& to) {
    seen.push_back(to);
    return seen.size() > 1;
  };
  ContactState state = start();
  EXPECT_TRUE(follow(second_time, {at(2.0), at(4.0)}, state).converged());
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[1].load[0], 3.0);
  EXPECT_EQ(seen[1].initial_gap[0], 30.0);
  EXPECT_EQ(seen[2].load[0], 4.0);
}

TEST(IncrementFollower, GivesUpAtTheLastGoodStateAndSaysWhy) {
  std::vector<double> started_from;
  ContactState state = start();
  const FollowReport report = follow(short_reach(0.0, &started_from), {at(0.0), at(1.0)}, state, {}, 3);
  EXPECT_EQ(report.status, Status::no_modes);
  EXPECT_EQ(state.x[0], 0.0);          // restored, not the rubbish of the failed solve
  EXPECT_EQ(started_from.size(), 4U);  // once whole and once per halving: nothing after a failed first half
  EXPECT_EQ(report.substeps, 3);
}

TEST(IncrementFollower, KeepsWhatWasReachedWhenTheSecondHalfFails) {
  const auto tiring = [](double, const ContactLoading& to) { return to.load[0] <= 0.5; };
  ContactState state = start();
  EXPECT_FALSE(follow(tiring, {at(0.0), at(1.0)}, state, {}, 1).converged());
  EXPECT_EQ(state.x[0], 0.5);
}

TEST(IncrementFollower, ShowsEveryPartThatConverged) {
  ContactState state = start();
  std::vector<double> ends;
  const auto visit = [&](const ResponsePart& part) {
    EXPECT_EQ(part.begin.x[0], ends.empty() ? 0.0 : ends.back());
    EXPECT_FALSE(part.linear);  // an increment ignores the path in between
    ends.push_back(part.end.x[0]);
  };
  EXPECT_TRUE(follow(short_reach(0.5), {at(0.0), at(0.5)}, state, visit).converged());
  EXPECT_EQ(ends, std::vector<double>{0.5});
  ends.clear();
  state = start();
  EXPECT_TRUE(follow(short_reach(0.5), {at(0.0), at(1.0)}, state, visit).converged());
  EXPECT_EQ(ends, (std::vector<double>{0.5, 1.0}));
}

TEST(IncrementFollower, HaltsOnThePathWhereItIsTold) {
  const auto follower = make_increment_follower(std::make_unique<ScriptedSolver>(short_reach(1.0)));
  ContactState state = start();
  std::vector<ContactEvent> events;
  follower->set_out({at(0.0), at(2.0)}, state);
  for (const double fraction : {0.25, 0.5, 1.0}) {
    EXPECT_TRUE(follower->follow_to(fraction, state, {}, events).converged());
    EXPECT_EQ(state.x[0], 2.0 * fraction);
  }
  EXPECT_EQ(follower->path().end.load[0], 2.0);
}

TEST(LoadingPath, IsStraightAndMeetsItsEnds) {
  const LoadingPath path{at(2.0), at(4.1)};
  EXPECT_DOUBLE_EQ(path.at(0.25).load[0], 2.525);
  EXPECT_DOUBLE_EQ(path.at(0.25).initial_gap[0], 25.25);
  EXPECT_EQ(path.at(0.0).load[0], 2.0);
  EXPECT_EQ(path.at(1.0).load[0], 4.1);
}

/// Block pressed by 40 N (20 N of friction) and pulled by 30 N against a spring of 2 N/um: both followers have the same
/// interface.
TEST(PathFollower, SeesPartsAndEventsWhereItFollowsThem) {
  const ContactProblem problem = toy::dragged_block();
  const auto increments = make_increment_follower(std::make_unique<NewtonSolver>(problem));
  const auto stepper = make_event_stepper(problem, make_mode_system(problem));
  for (PathFollower* follower : std::vector<PathFollower*>{increments.get(), stepper.get()}) {
    const bool sees_events = follower == stepper.get();
    const ContactState unstressed = ContactState::unstressed(problem);
    ContactState state = unstressed;
    ASSERT_TRUE(follower->assemble(toy::pull(0.0, 40.0), unstressed, state).converged());
    follower->set_out({toy::pull(0.0, 40.0), toy::pull(30.0, 40.0)}, state);
    int parts = 0;
    std::vector<ContactEvent> events;
    const auto visit = [&](const ResponsePart& part) {
      ++parts;
      EXPECT_EQ(part.linear, sees_events);
    };
    EXPECT_TRUE(follower->follow_to(1.0, state, visit, events).converged());
    EXPECT_EQ(parts, sees_events ? 2 : 1);
    ASSERT_EQ(events.size(), sees_events ? 1U : 0U);
    for (const ContactEvent& event : events) EXPECT_NEAR(event.fraction, 20.0 / 30.0, 1e-12);
    EXPECT_NEAR(state.x[0], 5e-6, 1e-17);
  }
}

}  // namespace
}  // namespace bumpfoil
