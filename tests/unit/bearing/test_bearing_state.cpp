#include "bumpfoil/bearing/bearing_state.hpp"

#include "bumpfoil/experiments/build.hpp"

#include <gtest/gtest.h>

#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

TEST(BearingState, OfUnstressedFoilsIsAllZeroAndOpen) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  const BearingState state = BearingState::unstressed(*foils);
  EXPECT_EQ(state.contacts.x, Vector::Zero(foils->problem.K.rows()));
  EXPECT_EQ(state.slip_origin, state.contacts.x);
  EXPECT_EQ(state.contacts.normal_force, Vector::Zero(78));
  EXPECT_EQ(state.loading.initial_gap, Vector::Zero(78));
  EXPECT_EQ(state.work, 0.0);
  EXPECT_EQ(state.dissipated_energy, 0.0);
}

TEST(Step, ConvergesOrSaysWhyNot) {
  EXPECT_TRUE(Step{}.converged());
  Step step;
  step.status = Status::load_out_of_reach;
  EXPECT_FALSE(step.converged());
}

}  // namespace
}  // namespace bumpfoil
