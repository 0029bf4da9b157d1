#include "contact/piece_energy.hpp"

#include <gtest/gtest.h>

#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// The block of toy::dragged_block() pressed by 40 N: where it is, and its friction.
ContactState block_at(double x, double friction, ContactMode mode) {
  ContactState state = ContactState::unstressed(toy::dragged_block());
  state.x[0] = x;
  state.normal_force[0] = 40.0;
  state.friction_force[0] = friction;
  state.mode = {mode};
  return state;
}

// Pulled from 20 N, where friction is spent, to 30 N: 25 N on 5 um, 25 uJ in the spring, 100 uJ of friction.
TEST(PieceEnergy, AStraightPieceHasNoDefect) {
  const PieceEnergy energy = piece_energy(toy::dragged_block(), block_at(0.0, -20.0, ContactMode::slip_forward),
                                          block_at(5e-6, -20.0, ContactMode::slip_forward));
  EXPECT_NEAR(energy.given_off, 100e-6, 1e-18);
  EXPECT_NEAR(energy.friction, 100e-6, 1e-18);
  EXPECT_NEAR(energy.defect(), 0.0, 1e-18);
}

// Pulled from 0 N: 15 N over 5 um along the chord, 25 uJ in the spring; friction grows on the way.
TEST(PieceEnergy, AChordOverABendHasOne) {
  const PieceEnergy energy = piece_energy(toy::dragged_block(), block_at(0.0, 0.0, ContactMode::stick),
                                          block_at(5e-6, -20.0, ContactMode::slip_forward));
  EXPECT_NEAR(energy.given_off, 50e-6, 1e-18);
  EXPECT_NEAR(energy.defect(), -50e-6, 1e-18);
}

// The wall moves by 2 um, the first through a gap, and pushes the spring by 1 um with 1 N: a chord of 1 uJ where 0.5 uJ
// are stored.
TEST(PieceEnergy, AGapThatClosesOnTheWayBendsThePiece) {
  const ContactProblem problem = toy::spring_against_a_wall();
  ContactState apart = ContactState::unstressed(problem);
  apart.gap[0] = 1e-6;
  ContactState pressed = ContactState::unstressed(problem);
  pressed.x[0] = -1e-6;
  pressed.normal_force[0] = 1.0;
  EXPECT_NEAR(piece_energy(problem, apart, pressed).given_off, 0.5e-6, 1e-20);
  EXPECT_NEAR(piece_energy(problem, pressed, apart).given_off, -0.5e-6, 1e-20);
  EXPECT_EQ(piece_energy(problem, apart, pressed).friction, 0.0);
}

TEST(PieceEnergy, RoundingsFollowFromEnergyAndForces) {
  const ContactProblem block = toy::dragged_block();
  const ContactState near = block_at(0.0, 0.0, ContactMode::stick);
  EXPECT_DOUBLE_EQ(negligible_energy(block, near, near), 40e-14);
  // 2e6 N/m on 1 mm: 1 J.
  EXPECT_DOUBLE_EQ(negligible_energy(block, near, block_at(1e-3, -20.0, ContactMode::slip_forward)), 1e-11);
}

}  // namespace
}  // namespace bumpfoil
