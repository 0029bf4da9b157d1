#include "contact/straight_piece.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/contact/mode_system.hpp"
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
  piece.measure_target();
  return piece;
}

/// The changes that it needs.
std::vector<ModeChange> look_ahead(StraightPiece& piece) {
  std::vector<ModeChange> changes;
  piece.look_ahead(toy::dragged_block(), changes);
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
  changes = look_ahead(reversed);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes.front().to, ContactMode::stick);
}

TEST(StraightPiece, SeesWhetherItsBeginObeysItsModes) {
  const ContactProblem block = toy::dragged_block();
  StraightPiece piece = block_pulled_to(50.0, ContactMode::slip_forward);
  EXPECT_TRUE(piece.begin_obeys_modes(block));
  piece.begin.friction_force[0] += 1e-6;  // N of 40: far above the tolerance of 4e-10
  EXPECT_FALSE(piece.begin_obeys_modes(block));
  piece = block_pulled_to(50.0, ContactMode::stick);
  EXPECT_TRUE(piece.begin_obeys_modes(block));
  piece.begin.gap[0] = 1e-9;  // m, above the tolerance of 1e-13
  EXPECT_FALSE(piece.begin_obeys_modes(block));
}

}  // namespace
}  // namespace bumpfoil
