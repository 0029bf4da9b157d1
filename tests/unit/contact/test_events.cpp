#include "bumpfoil/contact/events.hpp"

#include <gtest/gtest.h>

#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// A whole path at once.
IncrementReport advance(EventStepper& stepper, const ContactLoading& from, const ContactLoading& to,
                        ContactState& state, const PartVisitor& visit, std::vector<ContactEvent>& events) {
  stepper.set_out(from, to, state);
  return stepper.advance_to(1.0, state, visit, events);
}

TEST(EventStepper, FractionsRunFromBeginToEndOfTheStep) {
  EventStepper stepper(toy::dragged_block());
  ContactState state = ContactState::unstressed(toy::dragged_block());
  std::vector<ContactEvent> events;
  ASSERT_TRUE(advance(stepper, toy::pull(0.0, 40.0), toy::pull(0.0, 40.0), state, {}, events).solve.converged);
  events.clear();
  // There and back: slips at 20 N, sticks at once on the way back, slips back when 40 N are taken.
  ASSERT_TRUE(advance(stepper, toy::pull(0.0, 40.0), toy::pull(30.0, 40.0), state, {}, events).solve.converged);
  const IncrementReport back = advance(stepper, toy::pull(30.0, 40.0), toy::pull(-30.0, 40.0), state, {}, events);
  EXPECT_TRUE(back.solve.converged);
  EXPECT_EQ(back.substeps, 0);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_NEAR(events[0].fraction, 20.0 / 30.0, 1e-12);
  EXPECT_EQ(events[1].fraction, 0.0);
  EXPECT_EQ(events[1].to, ContactMode::stick);
  EXPECT_NEAR(events[2].fraction, 40.0 / 60.0, 1e-12);
  EXPECT_EQ(events[2].to, ContactMode::slip_backward);
}

TEST(EventStepper, PartsJoinWithoutAGap) {
  EventStepper stepper(toy::stacked_slabs());
  ContactState state = ContactState::unstressed(toy::stacked_slabs());
  std::vector<ContactEvent> events;
  const ContactLoading apart{.initial_gap = Eigen::Vector2d(10e-6, 4e-6), .load = Vector::Zero(2)};
  const ContactLoading pressed{.initial_gap = Eigen::Vector2d(-2e-6, -3e-6), .load = Vector::Zero(2)};
  ASSERT_TRUE(advance(stepper, apart, apart, state, {}, events).solve.converged);
  Vector joint = state.x;
  int parts = 0;
  const auto visit = [&](const ContactState& begin, const ContactState& end) {
    EXPECT_EQ(begin.x, joint);
    joint = end.x;
    ++parts;
  };
  events.clear();
  ASSERT_TRUE(advance(stepper, apart, pressed, state, visit, events).solve.converged);
  EXPECT_EQ(joint, state.x);
  EXPECT_EQ(parts, 3);  // two contacts close on the way
  EXPECT_EQ(events.size(), 2U);
}

}  // namespace
}  // namespace bumpfoil
