#include "bumpfoil/analysis/increment.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// A made-up state of the reference bearing: bump 3 pressed, everything else open.
struct Example {
  FoilModel model = make_bearing_model(case_with_given_constants());
  ContactState state = ContactState::unstressed(model.problem);
  Eigen::Vector2d position{1e-6, 0.0};
  ContactLoading loading = loading_at(model, position);
  Vector previous_x = state.x;

  Example() {
    state.gap.setConstant(5e-6);
    for (const int contact : {6, 7, 8}) state.gap[contact] = 0.0;
    state.normal_force.segment(6, 3) << 20.0, 15.0, 1e-12;
    state.friction_force[7] = -1.5;
    state.mode[6] = ContactMode::stick;
    state.mode[7] = ContactMode::slip_forward;
    state.mode[8] = ContactMode::stick;
    const int block = model.problem.K.block_size();
    state.x[2 * block + model.structure.dofs.crest_u] = 1e-7;
    state.x[2 * block + model.structure.dofs.foot_v[0]] = -3e-7;
    state.x[2 * block + model.structure.dofs.top_u] = 4e-7;
  }

  Increment record() const {
    return record_increment(model, position, Eigen::Vector2d(0.0, 1.0), loading, previous_x, state);
  }
};

TEST(RecordIncrement, SortsFieldsByInterfaceAndBump) {
  const Increment increment = Example().record();
  EXPECT_EQ(increment.crest_u[2], 1e-7);
  EXPECT_EQ(increment.foot_v[2], -3e-7);
  EXPECT_EQ(increment.top_displacement[2], 4e-7);
  EXPECT_EQ(increment.crest_u.cwiseAbs().sum(), 1e-7);
  EXPECT_EQ(increment.journal_top.normal_force[2], 20.0);
  EXPECT_EQ(increment.top_bump.normal_force[2], 15.0);
  EXPECT_EQ(increment.top_bump.friction_force[2], -1.5);
  EXPECT_EQ(increment.top_bump.mode[2], ContactMode::slip_forward);
  EXPECT_EQ(increment.top_bump.gap[2], 0.0);
  EXPECT_EQ(increment.top_bump.gap[3], 5e-6);
  EXPECT_EQ(increment.top_bump.mode[3], ContactMode::open);
}

TEST(RecordIncrement, ReportsAContactWithoutLoadAsOpen) {
  const Increment increment = Example().record();
  EXPECT_EQ(increment.bump_sleeve.mode[2], ContactMode::open);  // 1e-12 N is below 1e-9 of 20 N
  EXPECT_EQ(increment.bump_sleeve.normal_force[2], 0.0);
}

TEST(RecordIncrement, FrictionlessContactsSlipTheWayTheyMove) {
  Example example;
  for (ContactPair& pair : example.model.problem.pairs) pair.friction_coefficient = 0.0;
  example.state.mode[7] = ContactMode::stick;  // what a solver keeps for a frictionless contact
  EXPECT_EQ(example.record().top_bump.mode[2], ContactMode::slip_forward);
  example.previous_x = example.state.x;
  EXPECT_EQ(example.record().top_bump.mode[2], ContactMode::stick);
}

TEST(RecordIncrement, ResolvesTheForceOnTheJournal) {
  const Example example;
  const Increment increment = example.record();
  const Case input = case_with_given_constants();
  const double phi = polar_angles(input.bearing, crest_angles(input))[2];
  EXPECT_NEAR(increment.force_x, 20.0 * std::cos(phi), 1e-13);
  EXPECT_NEAR(increment.force_y, 20.0 * std::sin(phi), 1e-13);
  EXPECT_EQ(increment.force_direct, increment.force_y);  // n is +Y
  EXPECT_EQ(increment.force_cross, -increment.force_x);  // n turned by +90 deg is -X
}

TEST(RecordIncrement, JudgesTheState) {
  // Made-up forces balance nothing.
  EXPECT_GT(Example().record().residuals.equilibrium, 0.1);
}

}  // namespace
}  // namespace bumpfoil
