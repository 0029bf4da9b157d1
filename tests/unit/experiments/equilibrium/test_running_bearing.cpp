#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case coarse_case(const EquilibriumSettings& equilibrium) {
  Case input = film_reference_case({.columns_per_pitch = 6, .rows = 8}, 0.1);
  input.settings.set(equilibrium);
  return input;
}

/// From rest on rough surfaces.
Case rough_case(const std::vector<double>& speeds) {
  Case input = coarse_case({.speeds = speeds, .loads = {{50.0, 0.0}}, .path = FilmPath::speed_ramp});
  input.film.columns_per_pitch = 4;
  input.film.rows = 4;
  input.top_foil.formed_radius = {FormedTo::seated};
  input.asperity = AsperitySettings{.sigma = 0.3e-6, .pressure_factor = 2.4e8, .friction = 0.2};
  input.settings.get<EquilibriumSettings>().paths = ComparedPaths::one;
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
  EXPECT_EQ(two.states[2].before, two.states[1].requested);
  EXPECT_TRUE(two.states[2].mesh_error.has_value());

  settings.paths = ComparedPaths::all;
  const EquilibriumResult all = analyse_running_bearing(coarse_case(settings));
  ASSERT_EQ(all.states.size(), 12U);
  EXPECT_TRUE(all.other_branches.empty());
  const auto h_min = [&](const RunningState& state) {
    return state.outcome->thinnest.thickness * all.bearing->film->scales.thickness;
  };
  std::size_t different = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const RunningState& coasting = all.states[3 + i];
    ASSERT_EQ(coasting.path, FilmPath::speed_ramp);
    ASSERT_EQ(coasting.requested, two.states[i].requested);
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
  input.settings.get<EquilibriumSettings>().limits = true;
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

/// Bit-identical: results of checks on other threads do not depend on threads or order.
TEST(RunningBearing, IsCheckedOnAllCoresAsOnOne) {
  const Case input = rough_case({0.0, speed_of_rpm(20000.0), speed_of_rpm(30000.0), speed_of_rpm(45000.0)});
  const EquilibriumResult parallel = analyse_running_bearing(input);
  StateCheckers at_once;
  EquilibriumResult one = run_equilibrium(input, {}, {}, &at_once);
  estimate_mesh_errors(input, one);
  ASSERT_TRUE(one.converged());
  ASSERT_EQ(parallel.states.size(), one.states.size());
  for (std::size_t i = 0; i < one.states.size(); ++i) {
    const RunningState& a = one.states[i];
    const RunningState& b = parallel.states[i];
    ASSERT_TRUE(a.stiffness && b.stiffness && a.held.stuck && b.held.stuck && a.mesh_error && b.mesh_error) << i;
    EXPECT_EQ(*a.stiffness, *b.stiffness) << i;
    EXPECT_EQ(a.held.sliding->rate, b.held.sliding->rate) << i;
    EXPECT_EQ(a.held.stuck->rate, b.held.stuck->rate) << i;
    EXPECT_EQ(a.outcome->torque, b.outcome->torque) << i;
    EXPECT_EQ(a.mesh_error->minimum_film_thickness, b.mesh_error->minimum_film_thickness) << i;
    EXPECT_EQ(a.top_foil_stress, b.top_foil_stress) << i;
    ASSERT_EQ(a.critical_mass.has_value(), b.critical_mass.has_value()) << i;
    if (a.critical_mass) {
      EXPECT_EQ(a.critical_mass->mass, b.critical_mass->mass) << i;
    }
    ASSERT_EQ(a.tabulated.size(), b.tabulated.size()) << i;
    ASSERT_FALSE(a.tabulated.empty());
    for (std::size_t k = 0; k < a.tabulated.size(); ++k) {
      EXPECT_EQ(*a.tabulated[k].impedance, *b.tabulated[k].impedance) << i << ", " << k;
      EXPECT_EQ(*a.tabulated[k].stuck_impedance, *b.tabulated[k].stuck_impedance) << i << ", " << k;
    }
  }
}

/// States found before an interruption, or before the callback throws, are still checked.
TEST(RunningBearing, ChecksWhatItFoundBeforeAnInterruption) {
  const Case input = rough_case({speed_of_rpm(45000.0), speed_of_rpm(40000.0), speed_of_rpm(35000.0)});
  const EquilibriumResult result = analyse_running_bearing(input, [](double fraction) { return fraction < 0.6; });
  ASSERT_EQ(result.states.size(), 3U);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(result.states[i].found()) << i;
    EXPECT_TRUE(result.states[i].held.is_stable().has_value()) << i;
    EXPECT_TRUE(result.states[i].mesh_error.has_value()) << i;
    EXPECT_FALSE(result.states[i].tabulated.empty()) << i;
  }
  EXPECT_EQ(result.states[2].report.status, Status::interrupted);
  EXPECT_TRUE(result.states[2].tabulated.empty());
  const auto throws = [](double fraction) -> bool {
    if (fraction > 0.6) throw std::runtime_error("enough");
    return true;
  };
  EXPECT_THROW(static_cast<void>(analyse_running_bearing(input, throws)), std::runtime_error);
}

/// A journal comes to rest on rough surfaces within 100 to 200 Newton steps: with steps that must reduce the residuals,
/// it took 1251 and 524.
TEST(RunningBearing, ComesToRestOnRoughSurfacesInFewSteps) {
  const EquilibriumResult result = run_equilibrium(rough_case({0.0, speed_of_rpm(100.0)}));
  ASSERT_TRUE(result.converged());
  EXPECT_LT(result.states[0].report.iterations, 300);
  EXPECT_LT(result.states[1].report.iterations, 300);
}

}  // namespace
}  // namespace bumpfoil
