#include "bumpfoil/analysis/path_runner.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

const Eigen::Vector2d push = unit_vector(0.7);
constexpr double reach = 0.3e-3;

SolverSettings solver(SolverName name) {
  return {.name = name, .uzawa = {}};
}

/// A runner whose bearing was pushed to 60 um in three increments.
class PushedRunner : public testing::TestWithParam<SolverName> {
 protected:
  PushedRunner() {
    EXPECT_TRUE(runner.assemble(Eigen::Vector2d::Zero()));
    for (const double s : {40e-6, 50e-6, 60e-6}) EXPECT_TRUE(runner.move_to(s * push));
  }

  const FoilModel model = make_bearing_model(case_with_given_constants());
  PathRunner runner{model, solver(GetParam())};
};

TEST_P(PushedRunner, RecordsWhereItStandsAndWhatItTook) {
  const Increment now = runner.record(push);
  EXPECT_NEAR(now.displacement, 60e-6, 1e-19);
  EXPECT_NEAR(now.x, 60e-6 * push.x(), 1e-19);
  EXPECT_GT(now.force_direct, 100.0);
  EXPECT_GT(now.work, 0.0);
  EXPECT_GT(now.dissipated_energy, 0.0);
  EXPECT_TRUE(now.solve.converged);
  EXPECT_EQ(runner.events().empty(), GetParam() != SolverName::events);
  runner.reset_books();
  const Increment again = runner.record(push);
  EXPECT_EQ(again.work, 0.0);
  EXPECT_EQ(again.dissipated_energy, 0.0);
  EXPECT_EQ(again.solve.iterations, 0);
  EXPECT_EQ(again.force_direct, now.force_direct);
}

/// Increments of one path, and each increment as a path of its own.
TEST_P(PushedRunner, MovesTheSameWayAlongOnePathOrMany) {
  PathRunner one_path{model, solver(GetParam())};
  ASSERT_TRUE(one_path.assemble(Eigen::Vector2d::Zero()));
  ASSERT_TRUE(one_path.move_to(40e-6 * push));
  one_path.set_out(60e-6 * push);
  for (const double fraction : {0.5, 1.0}) ASSERT_TRUE(one_path.advance_to(fraction));
  const Increment a = one_path.record(push);
  const Increment b = runner.record(push);
  EXPECT_NEAR(a.displacement, b.displacement, 1e-19);
  const double solved = GetParam() == SolverName::uzawa ? 1e-6 : 1e-9;  // that of the multipliers
  EXPECT_NEAR(a.force_direct, b.force_direct, solved * b.force_direct);
  EXPECT_NEAR(a.work, b.work, solved * b.work);
  EXPECT_NEAR(a.dissipated_energy, b.dissipated_energy, solved * b.work);
  // Events are those of the last increment, as fractions of it and not of the path.
  ASSERT_EQ(one_path.events().size(), runner.events().size());
  for (std::size_t i = 0; i < runner.events().size(); ++i) {
    EXPECT_EQ(one_path.events()[i].contact, runner.events()[i].contact);
    EXPECT_NEAR(one_path.events()[i].fraction, runner.events()[i].fraction, 1e-9);
  }
}

TEST_P(PushedRunner, FindsALoadWhereMovingThereMeetsIt) {
  // Up, down, and across the turning point: each is one increment from the same state, whatever led to it.
  for (const double part : {1.3, 0.8, 1.0 - 1e-6}) {
    PathRunner by_load{model, solver(GetParam())};
    PathRunner by_place{model, solver(GetParam())};
    for (PathRunner* each : {&by_load, &by_place}) {
      EXPECT_TRUE(each->assemble(Eigen::Vector2d::Zero()));
      for (const double s : {40e-6, 50e-6, 60e-6}) EXPECT_TRUE(each->move_to(s * push));
    }
    const double load = part * by_load.record(push).force_direct;
    ASSERT_TRUE(by_load.load_to(push, load, reach)) << part;
    const Increment found = by_load.record(push);
    // The tolerance of the search; the regularised solver has a residual of its own.
    EXPECT_NEAR(found.force_direct, load, (GetParam() == SolverName::uzawa ? 1e-5 : 1e-9) * load);
    ASSERT_TRUE(by_place.move_to({found.x, found.y}));
    const Increment met = by_place.record(push);
    // Both are solved to the same bound, by a solver that has seen other increments: 1e-6 is that of the multipliers.
    const double solved = GetParam() == SolverName::uzawa ? 1e-6 : 1e-9;
    EXPECT_NEAR(met.force_direct, found.force_direct, solved * load);
    EXPECT_NEAR(met.work, found.work, solved * std::abs(found.work));
    EXPECT_NEAR(met.dissipated_energy, found.dissipated_energy, solved * found.work);
  }
}

TEST_P(PushedRunner, GivesUpALoadThatIsOutOfReach) {
  const Increment before = runner.record(push);
  EXPECT_FALSE(runner.load_to(push, 3.0 * before.force_direct, 65e-6));
  EXPECT_EQ(runner.record(push).force_direct, before.force_direct);
  EXPECT_EQ(runner.record(push).displacement, before.displacement);
}

INSTANTIATE_TEST_SUITE_P(PathRunner, PushedRunner,
                         testing::Values(SolverName::newton, SolverName::events, SolverName::uzawa));

TEST(PathRunner, FindsTheFirstLoadAcrossAnOpenGap) {
  const FoilModel model = make_bearing_model(case_with_given_constants());
  PathRunner runner(model, solver(SolverName::newton));
  ASSERT_TRUE(runner.assemble(Eigen::Vector2d::Zero()));
  EXPECT_EQ(runner.record(push).force_direct, 0.0);  // nothing is touched, nothing tells the way
  ASSERT_TRUE(runner.load_to(push, 5.0, reach));
  EXPECT_NEAR(runner.record(push).force_direct, 5.0, 1e-8);
  EXPECT_GT(runner.record(push).displacement, 31.8e-6);
}

TEST(PathRunner, AssemblyForgetsWhatWasBefore) {
  Case input = case_with_given_constants();
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[3] = 60e-6;  // squeezed between journal and sleeve at once
  const FoilModel model = make_bearing_model(input);
  PathRunner runner(model, solver(SolverName::newton));
  ASSERT_TRUE(runner.assemble(Eigen::Vector2d::Zero()));
  const Increment first = runner.record(push);
  EXPECT_GT(runner.assembly_dissipation(), 0.0);
  EXPECT_EQ(first.dissipated_energy, 0.0);  // kept apart
  ASSERT_TRUE(runner.move_to(50e-6 * push));
  ASSERT_TRUE(runner.assemble(Eigen::Vector2d::Zero()));
  EXPECT_EQ(runner.record(push).crest_u, first.crest_u);
  EXPECT_EQ(runner.record(push).work, 0.0);
}

}  // namespace
}  // namespace bumpfoil
