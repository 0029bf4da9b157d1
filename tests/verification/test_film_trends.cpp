// docs/verification/film.md: known trends of foil bearings from experiments and theory. The reference bearing without
// friction, 50 N along +X unless stated otherwise.

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case trend_case(std::vector<double> rpm, std::vector<Eigen::Vector2d> loads, FilmPath path) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 6});
  for (double& speed : rpm) speed = speed_of_rpm(speed);
  input.settings.set(EquilibriumSettings{.speeds = std::move(rpm), .loads = std::move(loads), .path = path});
  return input;
}

/// With falling speed the torque falls until the film is thin, then rises: the lift-off of the Stribeck curve.
TEST(FilmTrends, TorqueHasALeastValueWhereTheFilmIsThin) {
  const EquilibriumResult result =
      run_equilibrium(trend_case({45000.0, 30000.0, 20000.0, 10000.0, 5000.0, 3500.0, 2500.0, 1800.0, 1400.0, 1200.0},
                                 {{50.0, 0.0}}, FilmPath::speed_ramp));
  ASSERT_TRUE(result.converged());
  std::size_t least = 0;
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    const auto& [torque, h] = std::pair(result.states[i].outcome->torque, result.states[i].outcome->thinnest.thickness);
    if (torque < result.states[least].outcome->torque) least = i;
    if (i > 0) {
      EXPECT_LT(h, result.states[i - 1].outcome->thinnest.thickness) << i;
    }
  }
  EXPECT_GT(least, 4U);
  EXPECT_LT(least, result.states.size() - 1);

  // Between 10,000 and 45,000 rpm the power grows with the speed to the power of 1.4 to 1.6.
  const double exponent =
      std::log(result.states[0].outcome->power / result.states[3].outcome->power) / std::log(45000.0 / 10000.0);
  EXPECT_GT(exponent, 1.4);
  EXPECT_LT(exponent, 1.6);
}

/// Under a heavy load the film is the stiffer of two springs in series: a third less speed makes it much thinner, while
/// the stiffness, that of the foils, hardly changes.
TEST(FilmTrends, HeavyLoadsForgetTheSpeed) {
  const EquilibriumResult result =
      run_equilibrium(trend_case({45000.0, 30000.0}, {{20.0, 0.0}, {100.0, 0.0}}, FilmPath::load_ramp));
  ASSERT_TRUE(result.converged());
  const auto Kxx = [&](std::size_t state) { return (*result.states[state].stiffness)(0, 0); };
  const auto h_min = [&](std::size_t state) { return result.states[state].outcome->thinnest.thickness; };
  EXPECT_GT(Kxx(1), 2.0 * Kxx(0));
  EXPECT_LT(std::abs(Kxx(3) / Kxx(1) - 1.0), 0.1);
  EXPECT_LT(h_min(3), 0.8 * h_min(1));
}

TEST(FilmTrends, LiftOffSpeedRisesWithTheLoad) {
  Case input = trend_case({10000.0}, {{20.0, 0.0}, {40.0, 0.0}, {80.0, 0.0}}, FilmPath::load_ramp);
  input.film.h_lift_off = 3e-6;
  const std::vector<FilmLimit> limits = run_film_limits(input);
  ASSERT_EQ(limits.size(), 4U);
  for (const std::size_t i : {0U, 1U, 2U}) {
    ASSERT_TRUE(limits[i].found());
    if (i > 0) {
      EXPECT_GT(limits[i].value, 1.1 * limits[i - 1].value);
    }
  }
}

}  // namespace
}  // namespace bumpfoil
