#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

/// Nine cycles of the reference bearing against an independent dense prototype.
namespace bumpfoil {
namespace {

class TrussCycles : public testing::TestWithParam<std::size_t> {};

TEST_P(TrussCycles, AgreeWithTheDensePrototype) {
  const ReferenceCycle& reference = reference_cycles().at(GetParam());
  const CycleResult result = run_cycles(reference.input);
  ASSERT_EQ(result.cycles.size(), 1U);
  const Cycle& cycle = result.cycles.front();
  ASSERT_TRUE(cycle.converged());
  ASSERT_EQ(static_cast<Eigen::Index>(cycle.increments.size()), reference.force_direct.size());
  EXPECT_EQ(cycle.substeps, 0);
  EXPECT_LT(cycle.max_residual, 1e-9);

  // The prototype stops at about 1e-6 of the largest force and prints six decimals.
  double direct_defect = 0.0;
  double cross_defect = 0.0;
  for (const Increment& increment : cycle.increments) {
    const double direct = reference.force_direct[increment.index];
    const double scale = std::max(1.0, std::abs(direct));
    direct_defect = std::max(direct_defect, std::abs(increment.force_direct - direct) / scale);
    cross_defect =
        std::max(cross_defect, std::abs(increment.force_cross - reference.force_cross[increment.index]) / scale);
  }
  EXPECT_LT(direct_defect, 1e-5);
  EXPECT_LT(cross_defect, 1e-5);  // of the direct force: the cross force may pass through zero

  ASSERT_TRUE(cycle.turning_point);
  EXPECT_NEAR(cycle.turning_point->max_force, reference.max_force, 1e-5 * reference.max_force);
  const auto expect_loads = [](const Vector& loads, const Vector& expected) {
    ASSERT_EQ(loads.size(), expected.size());
    EXPECT_LT((loads - expected).cwiseAbs().maxCoeff(), 1e-4 * expected.maxCoeff());
  };
  const FullIncrement turning = turning_increment(cycle);
  expect_loads(turning.top_bump.normal_force, reference.bump_loads);
  expect_loads(turning.bump_sleeve.normal_force, reference.foot_loads);
  expect_loads(turning.journal_top.normal_force, reference.journal_loads);

  // Without friction the loop is zero to round-off: then the reference is the work of the push, about 14 mJ.
  ASSERT_TRUE(cycle.loop_energy);
  const double work = cycle.turns.front().work;
  EXPECT_NEAR(*cycle.loop_energy, reference.loop_energy,
              1e-4 * (reference.loop_energy > 1e-9 ? reference.loop_energy : 1e-6 * work));
  RecordProperty("direct_force_defect", fmt::format("{:.2g}", direct_defect));
  RecordProperty("cross_force_defect", fmt::format("{:.2g}", cross_defect));
}

INSTANTIATE_TEST_SUITE_P(Reference, TrussCycles, testing::Range(std::size_t{0}, std::size_t{9}),
                         [](const testing::TestParamInfo<std::size_t>& which) {
                           std::string name = reference_cycles().at(which.param).name;
                           for (char& c : name) {
                             if (c == '+') c = 'p';
                             if (c == '-') c = 'm';
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

TEST(TrussCycles, FileHoldsNineCyclesOneWithHeightErrors) {
  EXPECT_EQ(reference_cycles().size(), 9U);
  EXPECT_EQ(std::count_if(reference_cycles().begin(), reference_cycles().end(),
                          [](const ReferenceCycle& cycle) { return !cycle.input.bump_foil.height_errors.empty(); }),
            1);
}

}  // namespace
}  // namespace bumpfoil
