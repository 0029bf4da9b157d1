#include "contact/straight_piece.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/path_follower.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// The block of toy::dragged_block() between two loadings, with one mode throughout.
StraightPiece block_between(const ContactLoading& begin, const ContactLoading& end, ContactMode mode) {
  const ContactProblem block = toy::dragged_block();
  const auto modes = make_mode_system(block);
  StraightPiece piece(block);
  EXPECT_TRUE(modes->set_modes({mode}));
  modes->solve(begin, Vector::Zero(2), piece.begin);
  modes->solve(end, Vector::Zero(2), piece.target);
  piece.measure_begin(block);
  piece.take_target();
  return piece;
}

/// The changes that it needs.
std::vector<ModeChange> look_ahead(StraightPiece& piece) {
  std::vector<ModeChange> changes;
  piece.look_ahead(changes);
  return changes;
}

/// Pressed by 40 N, which is 20 N of friction, from no pull on.
StraightPiece block_pulled_to(double pull, ContactMode mode) {
  return block_between(toy::pull(0.0, 40.0), toy::pull(pull, 40.0), mode);
}

TEST(StraightPiece, EndsWhereFrictionIsSpent) {
  StraightPiece piece = block_pulled_to(50.0, ContactMode::stick);
  piece.begin_fraction = 0.2;
  EXPECT_TRUE(look_ahead(piece).empty());
  ASSERT_EQ(piece.limits.size(), 1U);
  EXPECT_EQ(piece.limits.front().to, ContactMode::slip_forward);
  EXPECT_DOUBLE_EQ(piece.end_part, 0.4);  // 20 N of 50 N
  EXPECT_DOUBLE_EQ(piece.end_fraction(), 0.2 + 0.4 * 0.8);
  EXPECT_DOUBLE_EQ(piece.part_at(piece.end_fraction()), piece.end_part);

  ContactState end = ContactState::unstressed(toy::dragged_block());
  piece.at(piece.end_part, end);
  EXPECT_DOUBLE_EQ(end.friction_force[0], -20.0);
  EXPECT_DOUBLE_EQ(end.normal_force[0], 40.0);
  EXPECT_EQ(end.mode, piece.target.mode);
}

TEST(StraightPiece, ReachesTheEndOfThePathWhereNothingHappens) {
  StraightPiece piece = block_pulled_to(10.0, ContactMode::stick);
  piece.begin_fraction = 0.3;
  EXPECT_TRUE(look_ahead(piece).empty());
  EXPECT_TRUE(piece.limits.empty());
  EXPECT_EQ(piece.end_part, 1.0);
  EXPECT_EQ(piece.end_fraction(), 1.0);
  EXPECT_EQ(piece.part_at(1.0), 1.0);
}

TEST(StraightPiece, EndsWhereTheLastForceIsGone) {
  StraightPiece piece = block_between(toy::pull(0.0, 40.0), toy::pull(0.0, -40.0), ContactMode::stick);
  for (int again = 0; again < 2; ++again) EXPECT_TRUE(look_ahead(piece).empty());
  // Its cone ends there, too, and is left on both sides.
  ASSERT_EQ(piece.limits.size(), 3U);
  EXPECT_DOUBLE_EQ(piece.end_part, 0.5);
  EXPECT_EQ(piece.limits.front().to, ContactMode::open);
}

TEST(StraightPiece, EndsWhereAGapCloses) {
  StraightPiece piece = block_between(toy::pull(0.0, -10.0), toy::pull(0.0, 30.0), ContactMode::open);
  EXPECT_DOUBLE_EQ(piece.begin.gap[0], 1e-5);
  EXPECT_TRUE(look_ahead(piece).empty());
  ASSERT_EQ(piece.limits.size(), 1U);
  EXPECT_EQ(piece.limits.front().to, ContactMode::stick);
  EXPECT_DOUBLE_EQ(piece.end_part, 0.25);
}

TEST(StraightPiece, ContradictsModesThatLeadAgainstTheirOwnSense) {
  // A block inside its cone has no choice yet.
  StraightPiece inside = block_between(toy::pull(10.0, 40.0), toy::pull(50.0, 40.0), ContactMode::stick);
  EXPECT_TRUE(look_ahead(inside).empty());
  // At its bound it has, and the pull takes it beyond.
  StraightPiece at_bound = block_pulled_to(50.0, ContactMode::stick);
  at_bound.at(0.4, at_bound.begin);
  std::vector<ModeChange> changes = look_ahead(at_bound);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes.front().to, ContactMode::slip_forward);
  // Slipping forward where it is pulled back: it sticks.
  StraightPiece reversed = block_pulled_to(50.0, ContactMode::slip_forward);
  std::swap(reversed.begin, reversed.target);
  reversed.take_target();
  changes = look_ahead(reversed);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes.front().to, ContactMode::stick);
}

TEST(StraightPiece, SeesWhetherItsBeginObeysItsModes) {
  StraightPiece piece = block_pulled_to(50.0, ContactMode::slip_forward);
  EXPECT_TRUE(piece.begin_obeys_modes());
  piece.begin.friction_force[0] += 1e-6;  // N of 40: far above the tolerance of 4e-10
  EXPECT_FALSE(piece.begin_obeys_modes());
  piece = block_pulled_to(50.0, ContactMode::stick);
  EXPECT_TRUE(piece.begin_obeys_modes());
  piece.begin.gap[0] = 1e-9;  // m, above the tolerance of 1e-13
  EXPECT_FALSE(piece.begin_obeys_modes());
}

/// Fraction of the distance from `begin` to `target` at which the first contact violates its mode; 1 if none does.
double first_limit(const ContactProblem& problem, const ContactState& begin, const ContactState& target) {
  double first = 1.0;
  const auto consider = [&](double now, double then) {
    if (then < -1e-9) first = std::min(first, now / (now - then));
  };
  for_each_contact(problem, [&](const CoulombContact& contact) {
    const Eigen::Index c = contact.index;
    const ContactMode mode = target.mode[static_cast<std::size_t>(c)];
    if (mode == ContactMode::open) return consider(begin.gap[c], target.gap[c]);
    consider(begin.normal_force[c], target.normal_force[c]);
    if (mode != ContactMode::stick || contact.f == 0.0) return;
    for (const double side : {1.0, -1.0}) {
      consider(contact.f * begin.normal_force[c] - side * begin.friction_force[c],
               contact.f * target.normal_force[c] - side * target.friction_force[c]);
    }
  });
  return first;
}

/// Independent of the previous piece: contacts screened out as far from their limits must not include those that end
/// the piece.
TEST(StraightPiece, FindsTheFirstLimitOfManyContacts) {
  int with_limit = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const RandomProblem random = make_random_problem(seed, 11, 6, seed % 4 == 0 ? 0.0 : 0.3);
    const ContactProblem& problem = random.problem;
    StraightPiece piece(problem);
    const ContactState unstressed = ContactState::unstressed(problem);
    ASSERT_TRUE(NewtonSolver(problem).solve(random.first, unstressed, piece.begin).converged());
    piece.measure_begin(problem);
    const std::unique_ptr<ModeSystem> modes = make_mode_system(problem);
    ASSERT_TRUE(modes->set_modes(piece.begin.mode));
    for (const double far : {1.0, 1e-3, 1.0, 3.0, 1e-2, 0.3}) {
      const LoadingPath path{random.first, random.second};
      modes->solve(path.at(far), piece.begin.x, piece.target);
      piece.take_target();
      std::vector<ModeChange> changes;
      piece.look_ahead(changes);
      // Contacts that slip may turn round, which is a change at the begin: then limits mean nothing.
      if (!changes.empty()) continue;
      EXPECT_NEAR(piece.end_part, first_limit(problem, piece.begin, piece.target), 1e-9) << seed << ' ' << far;
      with_limit += piece.end_part < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(with_limit, 40);
}

/// A start in random modes with random margins, many of them zero, as after events and without load.
ContactState random_begin(std::mt19937_64& random, const ContactProblem& problem) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto happens = [&] { return uniform(random) < -0.7; };
  ContactState begin = ContactState::unstressed(problem);
  begin.mode = random_modes(random(), problem);
  for (Eigen::Index c = 0; c < problem.contacts(); ++c) {
    const ContactMode mode = begin.mode[static_cast<std::size_t>(c)];
    const double f = problem.sites[static_cast<std::size_t>(c)].friction_coefficient;
    if (happens()) continue;  // touches without force
    if (mode == ContactMode::open) {
      begin.gap[c] = 1e-5 * std::abs(uniform(random));
      continue;
    }
    begin.normal_force[c] = 10.0 * std::abs(uniform(random));
    const double of_bound = slips(mode) ? friction_sign(mode) : uniform(random);
    begin.friction_force[c] = (happens() ? std::copysign(1.0, of_bound) : of_bound) * f * begin.normal_force[c];
  }
  return begin;
}

/// After a short piece the search starts nearby; a new one covers the whole distance at once.
TEST(StraightPiece, FindsTheSameHoweverFarItLooksAtFirst) {
  int with_changes = 0;
  int with_one_limit = 0;
  int with_more_limits = 0;
  for (const double f : {0.0, 0.6}) {
    const ContactProblem problem = make_random_problem(1, 11, 6, f).problem;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto rates = [&] { return Vector::NullaryExpr(problem.contacts(), [&] { return uniform(random); }).eval(); };
    StraightPiece used(problem);
    for (int i = 0; i < 200; ++i) {
      ContactState begin = random_begin(random, problem);
      ContactRates rate{.normal = rates(), .tangential = rates()};
      if (i % 2 == 0) rate.normal = rate.normal.cwiseAbs();  // nothing opens or closes
      // A contact with only round-off forces is inside its cone nearby, but not at the end.
      for (Eigen::Index c = 0; c < problem.contacts(); ++c) {
        if (begin.mode[static_cast<std::size_t>(c)] != ContactMode::stick || begin.normal_force[c] > 0.0) continue;
        begin.friction_force[c] = f * 1e-9;
        rate.normal[c] = 1.5e-7;
        rate.tangential[c] = -1e-7;
      }
      StraightPiece fresh(problem);
      std::vector<ModeChange> changes, changes_of_fresh;
      for (const auto& [piece, found] : {std::pair(&used, &changes), std::pair(&fresh, &changes_of_fresh)}) {
        piece->begin = begin;
        piece->measure_begin(problem);
        piece->set_modes(begin.mode);
        piece->lead(rate, i % 3 == 0 ? 1e-3 : 1.0);
        piece->look_ahead(*found);
      }
      EXPECT_EQ(changes, changes_of_fresh) << f << ' ' << i;
      EXPECT_EQ(used.limits, fresh.limits) << f << ' ' << i;
      EXPECT_EQ(used.end_part, fresh.end_part) << f << ' ' << i;
      with_changes += changes.empty() ? 0 : 1;
      with_one_limit += used.limits.size() == 1 ? 1 : 0;
      with_more_limits += used.limits.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(with_changes, 100);
  EXPECT_GT(with_one_limit, 20);
  EXPECT_GT(with_more_limits, 100);
}

}  // namespace
}  // namespace bumpfoil
