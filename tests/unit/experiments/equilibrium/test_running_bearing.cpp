#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case coarse_case(const EquilibriumSettings& equilibrium) {
  Case input = film_reference_case({.columns_per_pitch = 6, .rows = 8}, 0.1);
  input.equilibrium = equilibrium;
  return input;
}

TEST(RunningBearing, IsComparedWithAPathOfAnotherKind) {
  EquilibriumSettings loads{.loads = {{20.0, 0.0}}};
  EXPECT_EQ(second_path(loads), FilmPath::speed_ramp);
  for (const FilmPath path : {FilmPath::speed_ramp, FilmPath::position_ray, FilmPath::cold_start}) {
    loads.path = path;
    EXPECT_EQ(second_path(loads), FilmPath::load_ramp);
  }
  EquilibriumSettings positions{.positions = {{1e-5, 0.0}}, .path = FilmPath::position_ray};
  EXPECT_EQ(second_path(positions), FilmPath::speed_ramp);
  positions.path = FilmPath::cold_start;
  EXPECT_EQ(second_path(positions), FilmPath::speed_ramp);
  positions.path = FilmPath::speed_ramp;
  EXPECT_EQ(second_path(positions), FilmPath::position_ray);
}

/// A ramp over 10 and 20 N ends at 50 N on another branch than coasting down under 50 N: the foil has lifted farther.
TEST(RunningBearing, SaysWhereASecondPathEndsElsewhere) {
  EquilibriumSettings settings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{10.0, 0.0}, {20.0, 0.0}, {50.0, 0.0}}};
  const EquilibriumResult two = analyse_running_bearing(coarse_case(settings));
  ASSERT_EQ(two.states.size(), 3U);  // of the second path none is kept
  EXPECT_FALSE(two.states[0].before.has_value());
  EXPECT_EQ(two.states[2].before, two.states[1].asked);
  EXPECT_TRUE(two.states[2].mesh_error.has_value());

  settings.paths = ComparedPaths::all;
  const EquilibriumResult all = analyse_running_bearing(coarse_case(settings));
  ASSERT_EQ(all.states.size(), 12U);
  EXPECT_TRUE(all.other_branches.empty());
  const auto h_min = [&](const RunningState& state) {
    return state.outcome->thinnest.thickness * all.bearing->scales.thickness;
  };
  std::size_t different = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const RunningState& coasting = all.states[3 + i];
    ASSERT_EQ(coasting.path, FilmPath::speed_ramp);
    ASSERT_EQ(coasting.asked, two.states[i].asked);
    const bool differs = std::abs(h_min(coasting) / h_min(two.states[i]) - 1.0) > 0.02;
    if (!differs) continue;
    ASSERT_LT(different, two.other_branches.size());
    const OtherBranch& told = two.other_branches[different++];
    EXPECT_EQ(told.state, i);
    EXPECT_EQ(told.path, FilmPath::speed_ramp);
    EXPECT_EQ(told.minimum_film_thickness, h_min(coasting));
  }
  EXPECT_EQ(two.other_branches.size(), different);
  EXPECT_GT(different, 0U);

  settings.paths = ComparedPaths::one;
  EXPECT_TRUE(analyse_running_bearing(coarse_case(settings)).other_branches.empty());
}

TEST(RunningBearing, TellsProgressOfAllParts) {
  std::vector<double> fractions;
  Case input = coarse_case({.speeds = {speed_of_rpm(45000.0)}, .loads = {{30.0, 0.0}}, .steps = 2});
  input.film.columns_per_pitch = 4;
  input.film.rows = 4;
  input.film.h_lift_off = 5e-6;
  input.equilibrium->limits = true;
  const EquilibriumResult result = analyse_running_bearing(input, [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_EQ(result.limits.size(), 2U);
  for (const double part : {0.0, 1.0, 2.0}) {
    EXPECT_TRUE(std::any_of(fractions.begin(), fractions.end(), [part](double fraction) {
      return fraction >= part / 3.0 && fraction <= (part + 1.0) / 3.0;
    })) << part;
  }
  EXPECT_LE(*std::max_element(fractions.begin(), fractions.end()), 1.0);
}

}  // namespace
}  // namespace bumpfoil
