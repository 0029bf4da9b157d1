#include "bumpfoil/contact/residual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// The dragged block slipping forward: pressed by 40 N, pulled by 30 N, friction 20 N against it, spring 10 N.
struct SlippingBlock {
  ContactProblem problem = toy::dragged_block();
  ContactLoading loading = toy::pull(30.0, 40.0);
  Vector previous_x = Vector::Zero(2);
  ContactState state{.x = Eigen::Vector2d(5e-6, 0.0),
                     .gap = Vector::Zero(1),
                     .normal_force = Vector::Constant(1, 40.0),
                     .friction_force = Vector::Constant(1, -20.0),
                     .mode = {ContactMode::slip_forward}};

  [[nodiscard]] ContactResiduals residuals() const {
    return contact_residuals(problem, problem.K.multiply(state.x), loading, previous_x, state);
  }
};

/// The same block in stick: pulled by 15 N, friction 15 N, no displacement.
SlippingBlock sticking_block() {
  SlippingBlock block;
  block.loading = toy::pull(15.0, 40.0);
  block.state.x.setZero();
  block.state.friction_force[0] = -15.0;
  return block;
}

TEST(ContactResiduals, AreZeroAtSolutions) {
  for (const SlippingBlock& block : {SlippingBlock{}, sticking_block()}) {
    const ContactResiduals residuals = block.residuals();
    EXPECT_LT(residuals.equilibrium, 1e-15);  // 2e6 * 5e-6 is 10 up to round-off
    EXPECT_EQ(residuals.penetration, 0.0);
    EXPECT_EQ(residuals.slip_in_stick, 0.0);
    EXPECT_EQ(residuals.complementarity, 0.0);
    EXPECT_EQ(residuals.cone, 0.0);
    EXPECT_TRUE(residuals.within());
  }
}

TEST(ContactResiduals, EquilibriumIsMeasuredByTheLargestForce) {
  SlippingBlock block;
  block.loading.load[0] += 4.0;
  EXPECT_NEAR(block.residuals().equilibrium, 0.1, 1e-12);
  EXPECT_FALSE(block.residuals().within());
}

TEST(ContactResiduals, ForcesBelowOneNewtonAreMeasuredByOne) {
  SlippingBlock block;
  block.loading = toy::pull(0.3, 0.4);
  block.state = {.x = Eigen::Vector2d(5e-8, 0.0),
                 .gap = Vector::Zero(1),
                 .normal_force = Vector::Constant(1, 0.4),
                 .friction_force = Vector::Constant(1, -0.2),
                 .mode = {ContactMode::slip_forward}};
  block.loading.load[0] += 0.01;
  EXPECT_NEAR(block.residuals().equilibrium, 0.01, 1e-12);
}

TEST(ContactResiduals, PenetrationIsALength) {
  SlippingBlock block;
  block.state.x[1] = -3e-7;
  block.loading.load[1] -= 0.3;  // keeps the balance
  EXPECT_DOUBLE_EQ(block.residuals().penetration, 3e-7);
  EXPECT_LT(block.residuals().equilibrium, 1e-14);
  EXPECT_FALSE(block.residuals().within());
}

TEST(ContactResiduals, StuckContactsMustNotMove) {
  SlippingBlock block = sticking_block();
  block.previous_x[0] = 2e-9;
  EXPECT_DOUBLE_EQ(block.residuals().slip_in_stick, 2e-9);
  EXPECT_EQ(block.residuals().cone, 0.0);
  EXPECT_FALSE(block.residuals().within());
}

TEST(ContactResiduals, TensionAndForceAcrossAGapViolateComplementarity) {
  SlippingBlock tension;
  tension.state.normal_force[0] = -40.0;
  EXPECT_DOUBLE_EQ(tension.residuals().complementarity, 1.0);

  SlippingBlock apart;
  apart.loading.initial_gap[0] = 1e-6;
  EXPECT_DOUBLE_EQ(apart.residuals().complementarity, 1.0);
  EXPECT_EQ(apart.residuals().penetration, 0.0);
  EXPECT_FALSE(apart.residuals().within());
}

TEST(ContactResiduals, FrictionAboveTheConeIsSeen) {
  SlippingBlock block = sticking_block();
  block.state.friction_force[0] = -24.0;
  EXPECT_DOUBLE_EQ(block.residuals().cone, 0.1);
  block.state.friction_force[0] = 24.0;
  EXPECT_DOUBLE_EQ(block.residuals().cone, 0.1);
}

TEST(ContactResiduals, FrictionMustOpposeSlip) {
  SlippingBlock block;
  block.state.friction_force[0] = 20.0;
  EXPECT_DOUBLE_EQ(block.residuals().cone, 1.0);
  EXPECT_EQ(block.residuals().slip_in_stick, 0.0);
  block.state.x[0] = -5e-6;
  block.state.friction_force[0] = -20.0;
  EXPECT_DOUBLE_EQ(block.residuals().cone, 1.0);
}

TEST(ContactResiduals, NoModeIsTrusted) {
  SlippingBlock block;
  const ContactResiduals before = block.residuals();
  block.state.mode = {ContactMode::open};
  EXPECT_EQ(block.residuals().cone, before.cone);
  EXPECT_EQ(block.residuals().complementarity, before.complementarity);
}

TEST(ContactResiduals, NotANumberFailsWhereverItStands) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(SlippingBlock&)>> breakages = {
      [](SlippingBlock& b) { b.state.x[0] = nan; },
      [](SlippingBlock& b) { b.state.x[1] = nan; },
      [](SlippingBlock& b) { b.state.normal_force[0] = nan; },
      [](SlippingBlock& b) { b.state.friction_force[0] = nan; },
      [](SlippingBlock& b) { b.loading.initial_gap[0] = nan; },
      [](SlippingBlock& b) { b.loading.load[1] = nan; },
      [](SlippingBlock& b) { b.previous_x[0] = nan; },
  };
  for (std::size_t i = 0; i < breakages.size(); ++i) {
    SlippingBlock block;
    breakages[i](block);
    EXPECT_FALSE(block.residuals().within()) << "breakage " << i;
    SlippingBlock held = sticking_block();
    breakages[i](held);
    EXPECT_FALSE(held.residuals().within()) << "breakage " << i;
  }
}

TEST(ContactResiduals, EachBoundIsAskedFor) {
  const ContactResiduals good{
      .equilibrium = 1e-9, .penetration = 1e-12, .slip_in_stick = 1e-12, .complementarity = 1e-9, .cone = 1e-9};
  EXPECT_TRUE(good.within());
  for (double ContactResiduals::*entry :
       {&ContactResiduals::equilibrium, &ContactResiduals::penetration, &ContactResiduals::slip_in_stick,
        &ContactResiduals::complementarity, &ContactResiduals::cone}) {
    ContactResiduals bad = good;
    bad.*entry *= 1.01;
    EXPECT_FALSE(bad.within());
    bad.*entry = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(bad.within());
  }
}

}  // namespace
}  // namespace bumpfoil
