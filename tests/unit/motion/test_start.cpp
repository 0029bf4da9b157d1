#include "bumpfoil/motion/start.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// A bearing without clearance: the foils touch the journal everywhere at rest.
BearingModel tight_bearing() {
  Case input = film_reference_case({4, 4});
  input.bearing.radial_clearance = 0.0;
  return make_film_bearing(input);
}

/// With clearance nothing is opened; without, until c remains.
TEST(ClearanceOffsetToStart, LeavesTheRoomOfAFilm) {
  EXPECT_EQ(clearance_offset_to_start(film_reference_bearing({4, 4}), 1e-7), 0.0);
  const BearingModel tight = tight_bearing();
  EXPECT_NEAR(clearance_offset_to_start(tight, 1e-7) + tight.film->assembled_clearance, tight.film->scales.thickness,
              1e-15);
}

TEST(StartFromRest, ClosesTheClearanceThatItOpened) {
  FilmStepper stepper(tight_bearing());
  const OperatingPoint to = OperatingPoint::loaded_by({20.0, 0.0}, speed_of_rpm(-45000.0));
  BearingState state;
  int begun = 0;
  const FilmReport report = start_from_rest(
      stepper, to, 5,
      [&](FilmStepper& begins, double clearance_offset, BearingState& first) {
        ++begun;
        EXPECT_GT(clearance_offset, 0.0);
        FilmReport found = start_from_ambient(begins, {1e-6, 0.0}, to.speed, first, clearance_offset);
        OperatingPoint opened = to;
        opened.clearance_offset = clearance_offset;
        found += settle(begins, opened, first);
        EXPECT_EQ(first.clearance_offset, clearance_offset);
        found += close_clearance(begins, to, 5, first);
        return found;
      },
      state);
  EXPECT_EQ(report.status, Status::converged);
  EXPECT_EQ(begun, 1);
  EXPECT_EQ(state.clearance_offset, 0.0);
  EXPECT_NEAR((journal_force(stepper.film(), state.film, state.speed) - to.journal).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace bumpfoil
