#include "contact/pivoting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace bumpfoil {
namespace {

using enum ContactMode;

TEST(ForEachDifference, NamesAllContactsInTheirOrderUntilItIsTold) {
  for (const std::size_t count : {0U, 3U, 8U, 16U, 21U}) {
    const std::vector<ContactMode> a(count, stick);
    std::vector<ContactMode> b = a;
    std::vector<std::size_t> changed;
    for (const std::size_t c : {0U, 2U, 7U, 8U, 9U, 15U, 16U, 20U}) {
      if (c >= count) continue;
      b[c] = c % 2 == 0 ? open : slip_backward;
      changed.push_back(c);
    }
    for (std::size_t most = 1; most <= changed.size() + 1; ++most) {
      std::vector<std::size_t> named;
      const bool all = for_each_difference(a, b, [&](std::size_t c) {
        named.push_back(c);
        return named.size() < most;
      });
      EXPECT_EQ(all, changed.size() < most) << count;
      ASSERT_EQ(named.size(), std::min(most, changed.size()));
      EXPECT_TRUE(std::equal(named.begin(), named.end(), changed.begin())) << count;
    }
    EXPECT_TRUE(for_each_difference(a, a, [](std::size_t) { return false; }));
  }
}

TEST(CheckMode, MeasuresTheInequalityThatFails) {
  const auto excess = [](ContactMode mode, const ContactTrial& trial) {
    return check_mode(0, mode, 0.5, trial, 1e-13, 1e-11).excess;
  };
  EXPECT_EQ(excess(open, {.gap = -2e-6, .normal = 0.0, .friction = 0.0, .slip = 5e-6}), 2e-6);
  EXPECT_EQ(excess(slip_forward, {.gap = 0.0, .normal = -3.0, .friction = 1.5, .slip = 5e-6}), 3.0);
  EXPECT_EQ(excess(slip_forward, {.gap = 0.0, .normal = 3.0, .friction = -1.5, .slip = -5e-6}), 5e-6);
  EXPECT_EQ(excess(stick, {.gap = 0.0, .normal = 4.0, .friction = -3.0, .slip = 0.0}), 1.0);
  EXPECT_EQ(excess(stick, {.gap = 0.0, .normal = -4.0, .friction = 1.0, .slip = 0.0}), 4.0);
}

TEST(PivotingRule, ChangesOneContactOnceTheirNumberDoesNotFall) {
  PivotingRule rule(10);
  const std::vector<ModeChange> changes{{0, stick, 1.0}, {1, stick, 1.0}, {2, stick, 1.0}};
  std::vector<ContactMode> mode;
  for (int round = 0; round < 3; ++round) {  // the first, and two more without progress
    mode.assign(3, open);
    EXPECT_TRUE(rule.apply(changes, mode));
    EXPECT_EQ(mode, (std::vector<ContactMode>{stick, stick, stick})) << round;
  }
  mode.assign(3, open);
  EXPECT_TRUE(rule.apply(changes, mode));
  EXPECT_EQ(mode, (std::vector<ContactMode>{open, open, stick}));
  mode.assign(3, open);
  EXPECT_TRUE(rule.apply({{0, stick, 1.0}, {1, stick, 1.0}}, mode));  // fewer than before
  EXPECT_EQ(mode, (std::vector<ContactMode>{stick, stick, open}));
}

TEST(PivotingRule, EndsAfterItsRounds) {
  const std::vector<ModeChange> changes{{0, stick, 1.0}};
  for (const int rounds : {2, 0, -1}) {
    PivotingRule rule(rounds);
    std::vector<ContactMode> mode{open};
    for (int round = 0; round < rounds; ++round) EXPECT_TRUE(rule.apply(changes, mode));
    mode = {open};
    EXPECT_FALSE(rule.apply(changes, mode));
    EXPECT_FALSE(rule.apply(changes, mode));
    EXPECT_EQ(mode, (std::vector<ContactMode>{open})) << rounds;
  }
}

/// Blocks of two contacts: 0, 2, 4, ... and 1, 3, 5, ... are neighbours.
TEST(WorstOfRuns, ChangesOneContactOfEachRun) {
  WorstOfRuns rule(in_every_block({{.plus = 0}, {.minus = 1}}, 7));
  std::vector<ContactMode> mode(14, open);
  mode[12] = stick;
  rule.apply({{0, stick, 1.0},
              {1, stick, 5.0},  // a separate run of one contact
              {2, stick, 3.0},
              {4, stick, 2.0},           // run 0, 2, 4: the worst is 2
              {6, slip_forward, 9.0},    // a different target mode
              {10, slip_forward, 1.0},   // not a neighbour of 6
              {12, slip_forward, 2.0}},  // a different previous mode
             mode);
  const std::vector<ContactMode> expected{open, stick, stick, open,         open, open,         slip_forward,
                                          open, open,  open,  slip_forward, open, slip_forward, open};
  EXPECT_EQ(mode, expected);
}

TEST(WorstOfRuns, RemembersNothing) {
  WorstOfRuns rule(in_every_block({{.plus = 0}}, 3));
  std::vector<ContactMode> mode(3, open);
  rule.apply({{0, stick, 1.0}}, mode);
  rule.apply({{1, stick, 1.0}}, mode);
  rule.apply({}, mode);
  EXPECT_EQ(mode, (std::vector<ContactMode>{stick, stick, open}));
}

}  // namespace
}  // namespace bumpfoil
