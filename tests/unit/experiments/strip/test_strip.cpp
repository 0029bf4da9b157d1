#include "bumpfoil/experiments/strip/strip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "support/full_increment.hpp"

namespace bumpfoil {
namespace {

Case strip_case(BumpFoilModel model, StripWeld weld, bool top_foil) {
  Case input = reference_case();
  input.bump_foil.model = model;
  StripSettings strip;
  strip.bumps = 5;
  strip.weld = weld;
  strip.top_foil = top_foil;
  strip.amplitude = {.control = Control::displacement, .value = 10e-6};
  strip.steps = 8;
  input.settings.set(strip);
  return input;
}

struct Layout {
  BumpFoilModel model;
  StripWeld weld;
  bool top_foil;
};

class Strip : public testing::TestWithParam<Layout> {
 protected:
  Case input = strip_case(GetParam().model, GetParam().weld, GetParam().top_foil);
};

TEST_P(Strip, WithoutFrictionHasNoLoopAndCyclesRepeat) {
  input.friction = {.top_bump = 0.0, .bump_sleeve = 0.0};
  input.settings.get<StripSettings>().cycles = 2;
  const CycleResult result = run_strip(input);
  ASSERT_TRUE(result.converged());
  ASSERT_EQ(result.cycles.size(), 2U);
  for (const Cycle& cycle : result.cycles) {
    // Roundings of the work done.
    EXPECT_NEAR(*cycle.loop_energy, 0.0, 1e-12 * cycle.turning_point->elastic_energy);
    EXPECT_NEAR(cycle.turning_point->max_force, result.cycles[0].turning_point->max_force,
                1e-9 * cycle.turning_point->max_force);
  }
}

TEST_P(Strip, WithFrictionSettlesInAClosedLoop) {
  input.settings.get<StripSettings>().cycles = 3;
  const CycleResult result = run_strip(input);
  ASSERT_TRUE(result.converged());
  EXPECT_EQ(result.experiment, Experiment::strip);
  ASSERT_EQ(result.cycles.size(), 3U);
  for (std::size_t i = 1; i < 3; ++i) {
    const Cycle& last = result.cycles[i - 1];
    const Cycle& next = result.cycles[i];
    // Each begins in the state that the last ended in, and counts from there.
    EXPECT_EQ(next.fields.crest_u.row(0), last.fields.crest_u.row(16));
    EXPECT_EQ(next.increments.front().force_direct, last.increments.back().force_direct);
    EXPECT_EQ(next.increments.front().work, 0.0);
    EXPECT_EQ(next.increments.front().cost.iterations, 0);
  }
  for (const Cycle& cycle : result.cycles) {
    EXPECT_EQ(cycle.increments.size(), 17U);
    EXPECT_GT(*cycle.loop_energy, 0.0);
    for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
      EXPECT_GE(cycle.increments[k].dissipated_energy, cycle.increments[k - 1].dissipated_energy);
    }
    // The plate holds what the bumps carry.
    const FullIncrement top = turning_increment(cycle);
    const Vector loads = GetParam().top_foil ? top.journal_top.normal_force : top.top_bump.normal_force;
    EXPECT_NEAR(loads.sum(), top.force_direct, 1e-9 * top.force_direct);
  }
  const Cycle& settled = result.cycles.back();
  EXPECT_NEAR(settled.increments.back().force_direct, settled.increments.front().force_direct,
              1e-6 * settled.turning_point->max_force);
}

TEST_P(Strip, SolversAgree) {
  const CycleResult newton = run_strip(input);
  const Cycle& expected = newton.cycles.at(0);
  const double force = expected.turning_point->max_force;
  input.solver.name = SolverName::uzawa;
  const CycleResult uzawa = run_strip(input);
  ASSERT_TRUE(uzawa.converged());
  // What its penalties cost, see docs/verification/uzawa.md.
  EXPECT_NEAR(uzawa.cycles[0].turning_point->max_force, force, 2e-4 * force);
  EXPECT_NEAR(*uzawa.cycles[0].loop_energy, *expected.loop_energy, 2e-3 * *expected.loop_energy);
  input.solver.name = SolverName::events;
  const CycleResult events = run_strip(input);
  ASSERT_TRUE(events.converged());
  // Increments hold the friction of their end throughout: first order in their length.
  EXPECT_NEAR(events.cycles[0].turning_point->max_force, force, 0.02 * force);
  EXPECT_FALSE(events.cycles[0].events.empty());
  for (const CycleEvent& event : events.cycles[0].events) {
    const FoilFields& start = events.cycles[0].fields;
    const InterfaceFields& fields = event.interface == Interface::journal_top ? start.journal_top
                                    : event.interface == Interface::top_bump  ? start.top_bump
                                                                              : start.bump_sleeve;
    EXPECT_GE(event.index, 0);
    EXPECT_LT(event.index, fields.normal_force.cols());
  }
}

TEST_P(Strip, ByLoadOrByDisplacementIsOnePath) {
  const CycleResult by_displacement = run_strip(input);
  const double force = by_displacement.cycles[0].turning_point->max_force;
  StripSettings& strip = input.settings.get<StripSettings>();
  strip.amplitude = {.control = Control::load, .value = force};
  strip.steps = 40;
  const CycleResult by_load = run_strip(input);
  ASSERT_TRUE(by_load.converged());
  const Cycle& cycle = by_load.cycles[0];
  EXPECT_NEAR(cycle.turning_point->max_force, force, 1e-8 * force);
  // Other increments on the same path: first order in their length.
  EXPECT_NEAR(cycle.turns.front().displacement, 10e-6, 0.02 * 10e-6);
  EXPECT_EQ(cycle.amplitude, cycle.turns.front().displacement - cycle.increments.front().displacement);
  EXPECT_NEAR(cycle.increments.back().force_direct, 1e-6 * force, 1e-8);  // stands for none
}

INSTANTIATE_TEST_SUITE_P(Layouts, Strip,
                         testing::Values(Layout{BumpFoilModel::truss, StripWeld::one_end, true},
                                         Layout{BumpFoilModel::truss, StripWeld::one_end, false},
                                         Layout{BumpFoilModel::truss, StripWeld::none, true},
                                         Layout{BumpFoilModel::truss, StripWeld::none, false},
                                         Layout{BumpFoilModel::frame, StripWeld::one_end, true},
                                         Layout{BumpFoilModel::frame, StripWeld::one_end, false},
                                         Layout{BumpFoilModel::frame, StripWeld::none, true},
                                         Layout{BumpFoilModel::frame, StripWeld::none, false}));

class FreeStrip : public testing::TestWithParam<std::tuple<BumpFoilModel, bool, double>> {
 protected:
  FreeStrip() {
    input = strip_case(std::get<0>(GetParam()), StripWeld::none, std::get<1>(GetParam()));
    input.friction = {.top_bump = std::get<2>(GetParam()), .bump_sleeve = std::get<2>(GetParam())};
  }
  Case input;
};

TEST_P(FreeStrip, IsSymmetric) {
  for (const int bumps : {1, 2, 4, 5}) {
    input.settings.get<StripSettings>().bumps = bumps;
    const CycleResult result = run_strip(input);
    ASSERT_TRUE(result.converged()) << bumps;
    for (const FullIncrement& increment : full_increments(result.cycles[0])) {
      const double force = std::max(1.0, increment.force_direct);
      for (const InterfaceRow* fields : {&increment.top_bump, &increment.bump_sleeve}) {
        // Weak springs and round-off: if all contacts slip, only they determine the balance along the foil.
        EXPECT_LT((fields->normal_force - fields->normal_force.reverse()).cwiseAbs().maxCoeff(), 1e-6 * force);
        EXPECT_LT((fields->friction_force + fields->friction_force.reverse()).cwiseAbs().maxCoeff(), 1e-6 * force);
      }
    }
    const FullIncrement top = turning_increment(result.cycles[0]);
    const int feet = input.bump_foil.model == BumpFoilModel::frame ? 2 * bumps : bumps + 1;
    EXPECT_EQ(top.foot_u.size(), feet);
    EXPECT_EQ(top.crest_v.size(), bumps);
  }
}

TEST_P(FreeStrip, DoesNotDependOnTheSpringsThatKeepItInPlace) {
  const SharedBearing foils = make_strip_foils(input);
  BearingModel stiffer = *foils;
  for (Matrix* blocks : {&stiffer.structure.K.diagonal[2], &stiffer.problem.K.diagonal[2]}) {
    for (const int dof : {foils->structure.dofs.foot_u[0], foils->structure.dofs.foot_v[0]}) {
      (*blocks)(dof, dof) += 100.0 * loose_hold;
    }
    if (const int u = foils->structure.dofs.top_u; u >= 0) (*blocks)(u, u) += 100.0 * loose_hold;
  }
  const Eigen::Vector2d down(1.0, 0.0);
  const auto pressed = [&](const SharedBearing& these) {
    FoilStepper stepper = make_stepper(these, input.solver);
    Step step;
    stepper.assemble({}, step);
    for (int k = 1; k <= 8; ++k) {
      const BearingState state = step.state;
      stepper.advance(state, {.position = k * 1.25e-6 * down}, step);
      EXPECT_TRUE(step.converged());
    }
    return step.state.contacts;
  };
  const ContactState expected = pressed(foils);
  const ContactState held = pressed(std::make_shared<const BearingModel>(stiffer));
  const auto loads = [&](const ContactState& state) { return interface_loads(*foils, state, Interface::top_bump); };
  // A micrometre times 1 N/m.
  EXPECT_LT((loads(held) - loads(expected)).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_GT(holding_force(*foils, expected.normal_force).x(), 50.0);
}

INSTANTIATE_TEST_SUITE_P(Free, FreeStrip,
                         testing::Combine(testing::Values(BumpFoilModel::truss, BumpFoilModel::frame), testing::Bool(),
                                          testing::Values(0.0, 0.1)));

TEST(RunStrip, IsFullyReversedAboutItsPreload) {
  Case input = strip_case(BumpFoilModel::frame, StripWeld::one_end, false);
  input.settings.get<StripSettings>().cycles = 2;
  for (const Target preload : {Target{Control::displacement, 15e-6}, Target{Control::load, 150.0}}) {
    input.settings.get<StripSettings>().preload = preload;
    const CycleResult result = run_strip(input);
    ASSERT_TRUE(result.converged());
    for (const Cycle& cycle : result.cycles) {
      ASSERT_EQ(cycle.increments.size(), 33U);
      const double start = cycle.increments[0].displacement;
      EXPECT_NEAR(cycle.increments[8].displacement - start, 10e-6, 1e-18);
      EXPECT_NEAR(cycle.increments[24].displacement - start, -10e-6, 1e-18);
      EXPECT_EQ(cycle.increments[32].displacement, start);
      EXPECT_EQ(cycle.increments[8].branch, Branch::loading);
      EXPECT_EQ(cycle.increments[9].branch, Branch::unloading);
      EXPECT_EQ(cycle.increments[24].branch, Branch::unloading);
      EXPECT_EQ(cycle.increments[25].branch, Branch::loading);
      const double stiffness = (cycle.increments[8].force_direct - cycle.increments[24].force_direct) / 20e-6;
      EXPECT_NEAR(*cycle.loaded_stiffness, stiffness, 1e-9 * stiffness);
      EXPECT_NEAR(*cycle.loss_factor, *cycle.loop_energy / (std::numbers::pi * stiffness * 1e-10),
                  1e-9 * *cycle.loss_factor);
    }
    const Increment& start = result.cycles[0].increments[0];
    const double reached = preload.control == Control::load ? start.force_direct : start.displacement;
    EXPECT_NEAR(reached, preload.value, 1e-8 * preload.value);
  }
}

TEST(RunStrip, AssemblyBelongsToTheFirstCycleAlone) {
  Case input = strip_case(BumpFoilModel::truss, StripWeld::one_end, true);
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[3] = 10e-6;  // pressed, and sliding, as soon as the strip is put together
  input.settings.get<StripSettings>().cycles = 2;
  const CycleResult result = run_strip(input);
  ASSERT_TRUE(result.converged());
  EXPECT_GT(result.cycles[0].assembly_dissipation, 1e-6 * *result.cycles[0].loop_energy);
  EXPECT_EQ(result.cycles[1].assembly_dissipation, 0.0);
}

TEST(RunStrip, SwingHasNoStiffnessBeforeItsLowerTurningPoint) {
  Case input = strip_case(BumpFoilModel::frame, StripWeld::one_end, false);
  input.settings.get<StripSettings>().preload = Target{Control::displacement, 15e-6};
  // The lower turning point is increment 24; one run ends with the one before, the other with it.
  for (const std::size_t increments : {24U, 25U}) {
    std::size_t calls = 0;
    const CycleResult result = run_strip(input, [&](double) { return ++calls < increments; });
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_EQ(result.cycles[0].increments.size(), increments);
    EXPECT_EQ(result.cycles[0].loaded_stiffness.has_value(), increments == 25U);
  }
}

/// Loading from 0 to 20 um and back, and going about 10 um by as much, is the same loop: so is its loss factor.
TEST(RunStrip, LossFactorDoesNotAskWhereTheLoopBegan) {
  Case input = strip_case(BumpFoilModel::frame, StripWeld::one_end, false);
  StripSettings& strip = input.settings.get<StripSettings>();
  strip.amplitude = {.control = Control::displacement, .value = 20e-6};
  strip.steps = 50;
  strip.cycles = 2;
  const double push = *run_strip(input).cycles[1].loss_factor;
  strip.amplitude = {.control = Control::displacement, .value = 10e-6};
  strip.preload = Target{Control::displacement, 10e-6};
  const double swing = *run_strip(input).cycles[1].loss_factor;
  EXPECT_GT(push, 0.05);
  // They differ by the 1 % of the force that the take-up point lies at.
  EXPECT_NEAR(push, swing, 0.02 * push);
}

TEST(RunStrip, HeightErrorsActBumpByBump) {
  Case input = strip_case(BumpFoilModel::truss, StripWeld::none, false);
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[2] = -30e-6;  // never reached by the plate
  const CycleResult result = run_strip(input);
  ASSERT_TRUE(result.converged());
  const Vector& loads = turning_increment(result.cycles[0]).top_bump.normal_force;
  EXPECT_EQ(loads[2], 0.0);
  EXPECT_NEAR(loads[1], loads[3], 1e-6 * loads[1]);
}

TEST(RunStrip, StopsWhenItIsTold) {
  Case input = strip_case(BumpFoilModel::truss, StripWeld::one_end, true);
  input.settings.get<StripSettings>().cycles = 3;
  int calls = 0;
  const CycleResult result = run_strip(input, [&](double done) {
    EXPECT_NEAR(done, ++calls / 51.0, 1e-12);
    return calls < 20;
  });
  ASSERT_EQ(result.cycles.size(), 2U);
  EXPECT_TRUE(result.cycles[0].converged());
  EXPECT_FALSE(result.cycles[1].converged());
  EXPECT_EQ(result.cycles[1].increments.size(), 3U);
}

TEST(RunStrip, ALoadBeyondReachIsAFailureThatEndsTheRun) {
  Case input = strip_case(BumpFoilModel::truss, StripWeld::one_end, true);
  StripSettings& strip = input.settings.get<StripSettings>();
  strip.amplitude = {.control = Control::load, .value = 1e6};
  strip.cycles = 3;
  const CycleResult result = run_strip(input);
  EXPECT_FALSE(result.converged());
  ASSERT_EQ(result.cycles.size(), 1U);
  EXPECT_EQ(result.cycles[0].status, Status::load_out_of_reach);
  // What failed is recorded as failed, after what did not.
  ASSERT_GT(result.cycles[0].increments.size(), 1U);
  EXPECT_EQ(result.cycles[0].increments.back().status, Status::load_out_of_reach);
  EXPECT_TRUE(result.cycles[0].increments.rbegin()[1].converged());
  EXPECT_EQ(result.cycles[0].fields.increments(), std::ssize(result.cycles[0].increments) - 1);
}

TEST(RunStrip, APreloadBeyondReachFailsAtTheStart) {
  Case input = strip_case(BumpFoilModel::truss, StripWeld::one_end, true);
  input.settings.get<StripSettings>().preload = Target{Control::load, 1e6};
  const CycleResult result = run_strip(input);
  ASSERT_EQ(result.cycles.size(), 1U);
  EXPECT_EQ(result.cycles[0].status, Status::load_out_of_reach);
  ASSERT_EQ(result.cycles[0].increments.size(), 1U);
  EXPECT_EQ(result.cycles[0].turning_point, std::nullopt);
}

TEST(RunStrip, RefusesWhatItCannotBuild) {
  EXPECT_THROW((void)run_strip(reference_case()), Error);
  EXPECT_THROW((void)run_strip(strip_case(BumpFoilModel::former, StripWeld::one_end, false)), Error);
}

}  // namespace
}  // namespace bumpfoil
