#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/drawn_bearings.hpp"

namespace bumpfoil {
namespace {

/// The first bearings of docs/verification/drawn_bearings.md.
TEST(DrawnBearings, AreResolvedAndNoneIsWronglyCalledConverged) {
  for (std::uint64_t number = 0; number < 100; ++number) {
    const Case input = drawn_bearing(number);
    const BearingVerdict verdict = check_bearing(input, number % 10 == 0);
    for (const SolverVerdict& solver : {verdict.newton, verdict.events}) {
      EXPECT_EQ(solver.status, Status::converged) << input.title;
      EXPECT_EQ(solver.wrong, "") << input.title;
    }
    EXPECT_EQ(verdict.newton.substeps, 0) << input.title;
    EXPECT_EQ(verdict.apart.has_value(), number % 10 == 0);
    if (verdict.apart.value_or(0.0) > agreement) {
      EXPECT_LE(verdict.apart_refined.value_or(1.0), agreement) << input.title;
    }
  }
}

/// Ensembles compute quantities in a different way than runs that keep all records; both must agree to about 1e-9. In
/// the first 5,000 bearings forces differ by at most 7e-11, energies and bump loads by at most 5e-10.
TEST(DrawnBearings, HaveTheSameQuantitiesAloneAsWithAllRecords) {
  for (std::uint64_t number = 0; number < 100; ++number) {
    Case input = drawn_bearing(number);
    input.solver.name = SolverName::events;
    CycleRunner runner(make_bearing_foils(input), input.solver);
    const double direction = input.settings.get<CycleSettings>().directions.front();
    const Cycle alone = runner.run(direction, input.settings.get<CycleSettings>(), Recording::quantities);
    const Cycle all = runner.run(direction, input.settings.get<CycleSettings>());
    ASSERT_EQ(alone.status, all.status) << input.title;
    const TurningPoint& expected = *all.turning_point;
    EXPECT_NEAR(alone.turning_point->max_force, expected.max_force, 1e-9 * std::max(1.0, expected.max_force));
    EXPECT_NEAR(*alone.loop_energy, *all.loop_energy, 1e-9 * std::max(expected.elastic_energy, *all.loop_energy))
        << input.title;
    EXPECT_LE((alone.turning_point->bump_loads - expected.bump_loads).cwiseAbs().maxCoeff(),
              1e-9 * std::max(1.0, expected.bump_loads.maxCoeff()))
        << input.title;
  }
}

TEST(DrawnBearings, AreFunctionsOfTheirNumber) {
  EXPECT_EQ(drawn_bearing(7), drawn_bearing(7));
  EXPECT_NE(drawn_bearing(7).bump_foil.height_errors, drawn_bearing(8).bump_foil.height_errors);
  const Case input = drawn_bearing(9);
  EXPECT_EQ(input.friction.top_bump, input.friction.bump_sleeve);  // as for every third bearing
}

}  // namespace
}  // namespace bumpfoil
