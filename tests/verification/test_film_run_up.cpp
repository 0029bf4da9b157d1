// docs/verification/film.md: run-up under a load from a speed at which the branch has several turning points, the first
// where the march slowly drifts past its end. Takes a minute.

#include <gtest/gtest.h>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

int loaded_bumps_after(FilmPath path) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 6}, 0.1);
  input.bump_foil.truss = {};  // identified
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{20.0, 5.0}}, .path = path});
  const RunningState state = run_equilibrium(input).states.at(0);
  return state.found() ? state.outcome->loaded_bumps : 0;
}

TEST(FilmRunUp, ArrivesWhereLoadingDoes) {
  const int loaded = loaded_bumps_after(FilmPath::load_ramp);
  EXPECT_GT(loaded, 0);
  EXPECT_EQ(loaded_bumps_after(FilmPath::speed_ramp), loaded);
  EXPECT_EQ(loaded_bumps_after(FilmPath::position_ray), loaded);
}

}  // namespace
}  // namespace bumpfoil
