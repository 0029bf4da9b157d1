#include "bumpfoil/contact/solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace bumpfoil {
namespace {

/// Moves its one unknown to the load, but by no more than `reach` at a time; beyond it fails and leaves rubbish.
class ShortReach final : public ContactSolver {
 public:
  explicit ShortReach(double reach) : reach_(reach) {}
  [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                  ContactState& state) override {
    const bool good = std::abs(loading.load[0] - previous.x[0]) <= reach_;
    started_from.push_back(previous.x[0]);
    state = previous;
    state.x[0] = good ? loading.load[0] : std::numeric_limits<double>::quiet_NaN();
    state.mode.assign(1, ContactMode::slip_backward);
    return {.converged = good, .iterations = 3, .factorisations = 2, .outer_iterations = 1};
  }

  std::vector<double> started_from;

 private:
  double reach_;
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

TEST(Advance, TakesTheIncrementAtOnceWhereItCan) {
  ShortReach solver(1.0);
  ContactState state = start();
  const IncrementReport report = advance(solver, at(0.0), at(1.0), state);
  EXPECT_TRUE(report.solve.converged);
  EXPECT_EQ(report.substeps, 0);
  EXPECT_EQ(report.solve.iterations, 3);
  EXPECT_EQ(state.x[0], 1.0);
  EXPECT_EQ(state.mode.front(), ContactMode::slip_backward);
}

TEST(Advance, HalvesFromTheRestoredStateAndCountsEveryExtraSolve) {
  ShortReach solver(0.25);
  ContactState state = start();
  const IncrementReport report = advance(solver, at(0.0), at(1.0), state);
  EXPECT_TRUE(report.solve.converged);
  EXPECT_EQ(state.x[0], 1.0);
  // 1 fails; 1/2 fails, 1/4 and 1/2 succeed; 1 from 1/2 fails, 3/4 and 1 succeed.
  EXPECT_EQ(solver.started_from, (std::vector<double>{0.0, 0.0, 0.0, 0.25, 0.5, 0.5, 0.75}));
  EXPECT_EQ(report.substeps, 6);
  EXPECT_EQ(report.solve.iterations, 21);
  EXPECT_EQ(report.solve.factorisations, 14);
  EXPECT_EQ(report.solve.outer_iterations, 7);
}

TEST(Advance, InterpolatesGapsAndLoadsAlike) {
  class Recorder final : public ContactSolver {
   public:
    [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                    ContactState& state) override {
      seen.push_back(loading);
      state = previous;
      return {.converged = seen.size() > 1};
    }
    std::vector<ContactLoading> seen;
  } solver;
  ContactState state = start();
  EXPECT_TRUE(advance(solver, at(2.0), at(4.0), state).solve.converged);
  ASSERT_EQ(solver.seen.size(), 3U);
  EXPECT_EQ(solver.seen[1].load[0], 3.0);
  EXPECT_EQ(solver.seen[1].initial_gap[0], 30.0);
  EXPECT_EQ(solver.seen[2].load[0], 4.0);
}

TEST(Advance, GivesUpAtTheLastGoodState) {
  ShortReach solver(0.0);
  ContactState state = start();
  const IncrementReport report = advance(solver, at(0.0), at(1.0), state, {}, 3);
  EXPECT_FALSE(report.solve.converged);
  EXPECT_EQ(state.x[0], 0.0);                 // restored, not the rubbish of the failed solve
  EXPECT_EQ(solver.started_from.size(), 4U);  // once whole and once per halving: nothing after a failed first half
  EXPECT_EQ(report.substeps, 3);
}

TEST(Advance, KeepsWhatWasReachedWhenTheSecondHalfFails) {
  // Steps of one half succeed once: from 0 to 1/2; after that the reach is too short.
  class Tiring final : public ContactSolver {
   public:
    [[nodiscard]] SolveReport solve(const ContactLoading& loading, const ContactState& previous,
                                    ContactState& state) override {
      state = previous;
      state.x = loading.load;
      return {.converged = loading.load[0] <= 0.5};
    }
  } solver;
  ContactState state = start();
  EXPECT_FALSE(advance(solver, at(0.0), at(1.0), state, {}, 1).solve.converged);
  EXPECT_EQ(state.x[0], 0.5);
}

TEST(Advance, ShowsEveryPartThatConverged) {
  ShortReach solver(0.5);
  ContactState state = start();
  std::vector<double> ends;
  const auto visit = [&](const ContactState& begin, const ContactState& end) {
    EXPECT_EQ(begin.x[0], ends.empty() ? 0.0 : ends.back());
    ends.push_back(end.x[0]);
  };
  EXPECT_TRUE(advance(solver, at(0.0), at(0.5), state, visit).solve.converged);
  EXPECT_EQ(ends, std::vector<double>{0.5});
  ends.clear();
  state = start();
  EXPECT_TRUE(advance(solver, at(0.0), at(1.0), state, visit).solve.converged);
  EXPECT_EQ(ends, (std::vector<double>{0.5, 1.0}));
}

TEST(Interpolate, IsLinear) {
  EXPECT_EQ(interpolate(at(2.0), at(4.0), 0.25).load[0], 2.5);
  EXPECT_EQ(interpolate(at(2.0), at(4.0), 0.25).initial_gap[0], 25.0);
}

TEST(SolveReport, SumsCostsAndKeepsTheLastVerdict) {
  SolveReport sum{.converged = true, .iterations = 1, .factorisations = 2, .outer_iterations = 3};
  sum += {.converged = false, .iterations = 10, .factorisations = 20, .outer_iterations = 30};
  EXPECT_FALSE(sum.converged);
  EXPECT_EQ(sum.iterations, 11);
  EXPECT_EQ(sum.factorisations, 22);
  EXPECT_EQ(sum.outer_iterations, 33);
}

}  // namespace
}  // namespace bumpfoil
