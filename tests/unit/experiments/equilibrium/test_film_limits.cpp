#include "bumpfoil/experiments/equilibrium/film_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/core/error.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case limited_case(double speed, double load) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4});
  input.settings.set(EquilibriumSettings{.speeds = {speed}, .loads = {{load, 0.0}}, .steps = 3});
  input.film.h_lift_off = 8e-6;
  return input;
}

/// The state at the limit, found by another path, has the threshold film thickness.
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
  input.settings.get<EquilibriumSettings>().loads.emplace_back(60.0, 0.0);
  EquilibriumResult result = run_equilibrium(input);
  add_film_limits(input, result);
  ASSERT_EQ(result.limits.size(), 3U);
  ASSERT_TRUE(result.converged());
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(result.states[i].lift_off_speed->value, result.limits[i].value);
    EXPECT_EQ(result.states[i].load_capacity->value, result.limits[2].value);
  }
}

TEST(FilmLimits, AreFoundFromTheOtherSide) {
  const double lift_off = run_film_limits(limited_case(speed_of_rpm(45000.0), 50.0))[0].value;
  const std::vector<FilmLimit> limits = run_film_limits(limited_case(0.8 * lift_off, 50.0));
  ASSERT_TRUE(limits[0].found());
  EXPECT_NEAR(limits[0].value, lift_off, 0.02 * lift_off);
  EXPECT_LT(limits[1].value, 50.0);
}

/// Lightly loaded foils that are formed to the bearing flutter at their free end: no state of either path lasts.
TEST(FilmLimits, AreNoneWhereNoStateIsStable) {
  const std::vector<FilmLimit> limits = run_film_limits(limited_case(speed_of_rpm(45000.0), 20.0));
  for (const FilmLimit& limit : limits) {
    ASSERT_TRUE(limit.found());
    EXPECT_TRUE(std::isnan(limit.value));
    EXPECT_EQ(limit.bounded_by, LimitBound::stability);
    EXPECT_EQ(limit.stable, false);
    // The threshold crossing is known nevertheless.
    EXPECT_GE(limit.h_thick, 8e-6);
    EXPECT_LT(limit.h_thin, 8e-6);
    ASSERT_EQ(limit.unstable.size(), 1U);
  }
  // Down from the first speed; up from a tenth of the first load, where a stable state was looked for.
  EXPECT_EQ(limits[0].unstable[0].from, limits[0].thick.speed);
  EXPECT_NEAR(limits[0].unstable[0].to, speed_of_rpm(45000.0), 1e-9);
  EXPECT_NEAR(limits[1].unstable[0].from, 20.0 * std::pow(0.8, 10), 1e-9);
  EXPECT_EQ(limits[1].unstable[0].to, limits[1].thick.journal.x());
}

/// The same foils formed flatter, free end on the last bump: the film alone decides.
TEST(FilmLimits, OfSeatedFoilsAreThoseOfTheFilm) {
  Case input = limited_case(speed_of_rpm(45000.0), 20.0);
  input.top_foil.formed_radius = {FormedTo::seated};
  for (const FilmLimit& limit : run_film_limits(input)) {
    ASSERT_TRUE(limit.found());
    EXPECT_EQ(limit.bounded_by, LimitBound::film_thickness);
    EXPECT_EQ(limit.stable, true);
    EXPECT_TRUE(limit.unstable.empty());
    EXPECT_EQ(limit.unknown, 0);
    EXPECT_GT(limit.h_thick, limit.h_thin);
  }
}

/// At 60,000 rpm the free end holds under small loads. The verdicts on both sides of the load capacity are those of
/// states that a list of loads leads to.
TEST(FilmLimits, EndWhereStatesBecomeUnstable) {
  const Case input = limited_case(speed_of_rpm(60000.0), 20.0);
  const FilmLimit limit = run_film_limits(input)[1];
  ASSERT_TRUE(limit.found());
  EXPECT_EQ(limit.bounded_by, LimitBound::stability);
  EXPECT_EQ(limit.stable, true);
  EXPECT_EQ(limit.value, limit.thick.journal.x());
  EXPECT_GT(limit.h_thin, 8e-6);
  ASSERT_EQ(limit.unstable.size(), 1U);
  EXPECT_EQ(limit.unstable[0].from, limit.thin.journal.x());
  EXPECT_NEAR(limit.unstable[0].from, limit.value, 2e-3 * limit.value);  // the last step of the search: a thousandth
  EXPECT_GT(limit.unstable[0].to, 20.0);
  for (const auto& [part, stable] : {std::pair(0.98, true), std::pair(1.02, false)}) {
    Case list = input;
    list.settings.get<EquilibriumSettings>().loads = {{20.0, 0.0}, {part * limit.value, 0.0}};
    const EquilibriumResult result = run_equilibrium(list);
    ASSERT_TRUE(result.converged());
    EXPECT_EQ(result.states[1].held.is_stable(), stable) << part;
  }
}

TEST(FilmLimits, NeedAThresholdAndALoad) {
  Case input = limited_case(1000.0, 50.0);
  input.film.h_lift_off.reset();
  EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  equilibrium.loads.clear();
  equilibrium.positions = {{1e-5, 0.0}};
  try {
    run_film_limits(input);
    ADD_FAILURE();
  } catch (const Error& error) {
    // The ramp that a limit begins with has no load either.
    EXPECT_EQ(error.errors().size(), 3U);
  }
}

}  // namespace
}  // namespace bumpfoil
