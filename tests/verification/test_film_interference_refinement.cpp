// docs/verification/film.md: a journal as large as the foils, on successively finer meshes. Slow: the finest has 24
// columns per pitch and 32 rows.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Converges more slowly than thicker films: their edge layers are as thin as the intervals of any mesh.
TEST(FilmInterferenceRefinement, ConvergesWithTheMesh) {
  std::vector<double> x;
  for (const int fineness : {1, 2, 4}) {
    Case input = film_reference_case({.columns_per_pitch = 6 * fineness, .rows = 8 * fineness});
    input.bearing.radial_clearance = 0.0;
    input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(-45000.0)}, .loads = {{50.0, 0.0}}});
    const RunningState state = run_equilibrium(input).states.at(0);
    ASSERT_TRUE(state.found()) << fineness;
    EXPECT_EQ(state.last->clearance_offset, 0.0);
    x.push_back(state.last->position.x());
  }
  EXPECT_LT(std::abs(x[2] - x[1]), 3e-3 * x[2]);
  EXPECT_LT(std::abs(x[2] - x[1]), 0.7 * std::abs(x[1] - x[0]));
}

}  // namespace
}  // namespace bumpfoil
