#include "bumpfoil/experiments/equilibrium/film_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/core/error.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case limited_case(double speed, double load) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4});
  input.equilibrium = EquilibriumSettings{.speeds = {speed}, .loads = {{load, 0.0}}, .steps = 3};
  input.film.h_lift_off = 8e-6;
  return input;
}

/// The state at the limit, found by another path, is as thin as it should be.
TEST(FilmLimits, LieWhereTheFilmIsAsThinAsItMayBe) {
  const Case input = limited_case(speed_of_rpm(45000.0), 50.0);
  const std::vector<FilmLimit> limits = run_film_limits(input);
  ASSERT_EQ(limits.size(), 2U);
  for (const FilmLimit& limit : limits) {
    ASSERT_TRUE(limit.found());
    EXPECT_GE(limit.h_thick, 8e-6);
    EXPECT_LT(limit.h_thin, 8e-6);
    const bool by_speed = limit.kind == FilmLimitKind::lift_off_speed;
    const Case at_limit = by_speed ? limited_case(limit.value, 50.0) : limited_case(speed_of_rpm(45000.0), limit.value);
    const EquilibriumResult result = run_equilibrium(at_limit);
    ASSERT_TRUE(result.converged());
    EXPECT_NEAR(result.states[0].outcome->thinnest.thickness * 31.8, 8.0, 0.05);  // um; paths may differ by a bump
  }
  // From 50 N at 45,000 rpm, where the film is thicker: less speed, or more load.
  EXPECT_EQ(limits[0].kind, FilmLimitKind::lift_off_speed);
  EXPECT_LT(limits[0].value, speed_of_rpm(45000.0));
  EXPECT_GT(limits[1].value, 50.0);
  // More load lifts off at a higher speed.
  EXPECT_GT(run_film_limits(limited_case(speed_of_rpm(45000.0), 60.0))[0].value, limits[0].value);
}

TEST(FilmLimits, AreTheOnesOfTheLoadAndTheSpeedOfAState) {
  Case input = limited_case(speed_of_rpm(45000.0), 50.0);
  input.equilibrium->loads.emplace_back(60.0, 0.0);
  EquilibriumResult result = run_equilibrium(input);
  add_film_limits(input, result);
  ASSERT_EQ(result.limits.size(), 3U);
  ASSERT_TRUE(result.converged());
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(result.states[i].lift_off_speed, result.limits[i].value);
    EXPECT_EQ(result.states[i].load_capacity, result.limits[2].value);
  }
}

TEST(FilmLimits, AreFoundFromTheOtherSide) {
  const double lift_off = run_film_limits(limited_case(speed_of_rpm(45000.0), 50.0))[0].value;
  const std::vector<FilmLimit> limits = run_film_limits(limited_case(0.8 * lift_off, 50.0));
  ASSERT_TRUE(limits[0].found());
  EXPECT_NEAR(limits[0].value, lift_off, 0.02 * lift_off);
  EXPECT_LT(limits[1].value, 50.0);
}

TEST(FilmLimits, NeedAThresholdAndALoad) {
  Case input = limited_case(1000.0, 50.0);
  input.film.h_lift_off.reset();
  input.equilibrium->loads.clear();
  input.equilibrium->positions = {{1e-5, 0.0}};
  try {
    run_film_limits(input);
    ADD_FAILURE();
  } catch (const Error& error) {
    // The ramp that a limit begins with has no load either.
    EXPECT_EQ(error.faults().size(), 3U);
  }
}

}  // namespace
}  // namespace bumpfoil
