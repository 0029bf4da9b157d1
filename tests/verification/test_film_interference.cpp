// docs/verification/film.md: journals as large as the foils, or larger. The reference bearing without friction at
// 45,000 rpm, gas entering at the weld, where the clearance closes under the load.

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

RunningState state_of(double clearance, double load, const FilmResolution& resolution, double rpm = -45000.0) {
  Case input = film_reference_case(resolution);
  input.bearing.radial_clearance = clearance;
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(rpm)}, .loads = {{load, 0.0}}});
  return run_equilibrium(input).states.at(0);
}

/// From interference to clearance: a state exists at every clearance, and the film grows steadily with it.
TEST(FilmInterference, StatesGoOnFromInterferenceToClearance) {
  double before = 0.0;
  for (const double clearance : {-0.05e-6, -0.01e-6, 0.0, 1e-9, 0.01e-6, 0.02e-6, 0.05e-6, 0.07e-6, 0.1e-6}) {
    const RunningState state = state_of(clearance, 50.0, {.columns_per_pitch = 4, .rows = 6});
    ASSERT_TRUE(state.found()) << clearance;
    EXPECT_EQ(state.last->clearance_offset, 0.0) << clearance;
    const double h = film_thickness_scale(clearance) * state.last->film.thickness.minCoeff();
    if (before > 0.0) {
      EXPECT_GT(h, before) << clearance;
      EXPECT_LT(h, 1.1 * before) << clearance;
    }
    before = h;
  }
}

/// A film this thin and fast loses hardly any gas at the sides: P H keeps its inlet value.
TEST(FilmInterference, FilmsAreAsThinAsWhatEntersAndThePressureMakeThem) {
  const RunningState state = state_of(-2e-6, 100.0, {.columns_per_pitch = 6, .rows = 8});
  ASSERT_TRUE(state.found());
  const FilmState& film = state.last->film;
  const double entering = film.thickness(0, 0);  // P = 1 there
  EXPECT_LT(std::abs(film.pressure.row(0).maxCoeff() * film.thickness.minCoeff() / entering - 1.0), 0.05);
  // The journal moves off the weld by more than the interference.
  EXPECT_GT(state.last->position.x(), 2e-6);
}

/// Gas that enters under the free end is limited by the foil's own shape: its radius minus that of the journal. The
/// film vanishes with the clearance; the other direction of rotation, or a load that holds less, helps.
TEST(FilmInterference, FreeEndsLetInNoMoreThanTheClearance) {
  const FilmResolution coarse{.columns_per_pitch = 6, .rows = 8};
  for (const double clearance : {2e-6, 1e-6}) {
    const RunningState state = state_of(clearance, 50.0, coarse, 45000.0);
    ASSERT_TRUE(state.found()) << clearance;
    const FilmState& film = state.last->film;
    const double c = film_thickness_scale(clearance);
    EXPECT_NEAR(c * film.thickness(0, film.thickness.cols() - 1), clearance, 1e-3 * clearance);
    EXPECT_LT(std::abs(film.pressure.maxCoeff() * c * film.thickness.minCoeff() / clearance - 1.0), 0.05);
  }
  const RunningState none = state_of(0.0, 50.0, coarse, 45000.0);
  EXPECT_EQ(none.report.status, Status::touchdown);
  EXPECT_NEAR(none.last->clearance_offset, 0.28e-6, 0.03e-6);
}

}  // namespace
}  // namespace bumpfoil
