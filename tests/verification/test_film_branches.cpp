// docs/verification/film.md: states under a load stay on their branch. Several branches exist at one load, often one
// bump apart, so a step that is too long reaches another one. A tiny change of the case must therefore give the same
// number of loaded bumps, or a state that reports a jump of the foil.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

struct Found {
  bool converged{};
  int jumps{}, loaded_bumps{}, lifted_bumps{};
  double h_min{};  ///< m
};

Found found_of(const Case& input) {
  const EquilibriumResult result = run_equilibrium(input);
  const RunningState& state = result.states.at(0);
  if (!state.found()) return {.jumps = state.report.jumps};
  return {.converged = true,
          .jumps = state.report.jumps,
          .loaded_bumps = state.outcome->loaded_bumps,
          .lifted_bumps = result.bearing->bumps() - state.outcome->last_loaded - 1,
          .h_min = state.outcome->thinnest.thickness * result.bearing->film->scales.thickness};
}

/// The same state, unless one reports a jump, after which it may be another.
void expect_same_state(const Found& a, const Found& b, double tolerance) {
  if (a.jumps > 0 || b.jumps > 0) return;
  EXPECT_EQ(a.converged, b.converged);
  EXPECT_EQ(a.loaded_bumps, b.loaded_bumps);
  EXPECT_EQ(a.lifted_bumps, b.lifted_bumps);
  EXPECT_NEAR(a.h_min, b.h_min, tolerance * a.h_min);
}

Case loaded_reference(double load, double friction, const FilmResolution& resolution) {
  Case input = film_reference_case(resolution, friction);
  input.bump_foil.truss = {};  // identified
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{load, 0.0}}});
  return input;
}

/// At 20 N the reference bearing has overlapping branches with 12, 15 and 16 loaded bumps.
TEST(FilmBranches, ALittleMoreLoadOrFrictionIsALittleMore) {
  const FilmResolution mesh{.columns_per_pitch = 6, .rows = 8};
  const Found plain = found_of(loaded_reference(20.0, 0.1, mesh));
  ASSERT_TRUE(plain.converged);
  for (const double more : {1e-8, 1e-6, 1e-4}) {
    SCOPED_TRACE(more);
    const Found loaded = found_of(loaded_reference(20.0 * (1.0 + more), 0.1, mesh));
    const Found rubbing = found_of(loaded_reference(20.0, 0.1 * (1.0 + more), mesh));
    // Also after a jump: the film is marched from the same state.
    for (const Found& other : {loaded, rubbing}) {
      EXPECT_EQ(other.jumps, plain.jumps);
      EXPECT_EQ(other.loaded_bumps, plain.loaded_bumps);
      EXPECT_NEAR(other.h_min, plain.h_min, (1e-6 + more) * plain.h_min);
    }
  }
}

TEST(FilmBranches, MeshesAndIncrementsFindTheSameBranch) {
  std::vector<Found> found;
  for (const FilmResolution& mesh : {FilmResolution{6, 8}, {6, 12}, {8, 12}, {10, 12}}) {
    found.push_back(found_of(loaded_reference(20.0, 0.1, mesh)));
  }
  for (const int steps : {20, 50}) {
    Case input = loaded_reference(20.0, 0.1, {6, 8});
    input.settings.get<EquilibriumSettings>().steps = steps;
    found.push_back(found_of(input));
  }
  for (const Found& one : found) {
    SCOPED_TRACE(&one - found.data());
    ASSERT_TRUE(one.converged);
    expect_same_state(found.front(), one, 5e-3);  // the coarsest mesh is off by 3e-3
  }
}

TEST(FilmBranches, TurnedBearingsStandInTurnedStates) {
  Case input = loaded_reference(20.0, 0.1, {6, 8});
  const Found plain = found_of(input);
  for (const double turn : {0.4, 2.0}) {
    input.bearing.weld_angle = std::numbers::pi + turn;
    input.settings.get<EquilibriumSettings>().loads = {Eigen::Rotation2Dd(turn) * Eigen::Vector2d(20.0, 0.0)};
    const Found turned = found_of(input);
    EXPECT_EQ(turned.jumps, plain.jumps);
    EXPECT_EQ(turned.loaded_bumps, plain.loaded_bumps);
    EXPECT_NEAR(turned.h_min, plain.h_min, 1e-6 * plain.h_min);
  }
}

/// The foil jumps once during run-up. From higher speeds: test_film_run_up.cpp.
TEST(FilmBranches, RunningUpUnderALoadArrivesWhereLoadingDoes) {
  std::vector<Found> found;
  for (const FilmPath path : {FilmPath::load_ramp, FilmPath::speed_ramp, FilmPath::position_ray}) {
    Case input = loaded_reference(20.0, 0.1, {4, 6});
    EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
    equilibrium.speeds = {speed_of_rpm(30000.0)};
    equilibrium.loads = {{20.0, 5.0}};
    equilibrium.path = path;
    found.push_back(found_of(input));
    ASSERT_TRUE(found.back().converged) << found.size();
    EXPECT_EQ(found.back().loaded_bumps, found.front().loaded_bumps) << found.size();
    EXPECT_NEAR(found.back().h_min, found.front().h_min, 1e-3 * found.front().h_min) << found.size();  // friction
  }
}

/// Random bearings without friction: a state then depends on the increments only through its branch. Before steps were
/// held to the tangent, some of these ended up to 25 % apart without reporting it.
class RandomBranches : public testing::TestWithParam<int> {};

Case random_case(int number) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(number));
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(generator);
  };
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4});
  input.bearing.radial_clearance = uniform(20e-6, 45e-6);
  input.bearing.weld_angle = uniform(0.0, 2.0 * std::numbers::pi);
  input.top_foil.thickness = uniform(0.07e-3, 0.2e-3);
  for (int b = 0; b < input.bump_foil.bumps; ++b) input.bump_foil.height_errors.push_back(uniform(-2e-6, 2e-6));
  const double direction = uniform(0.0, 2.0 * std::numbers::pi);
  const double load = uniform(3.0, 60.0);
  const double speed = speed_of_rpm(uniform(15e3, 60e3)) * (uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0);
  input.settings.set(EquilibriumSettings{.speeds = {speed},
                                         .loads = {load * Eigen::Vector2d(std::cos(direction), std::sin(direction))}});
  return input;
}

TEST_P(RandomBranches, DoNotDependOnIncrements) {
  Case input = random_case(GetParam());
  const Found ten = found_of(input);
  input.settings.get<EquilibriumSettings>().steps = 37;
  expect_same_state(ten, found_of(input), 1e-6);
  input.settings.get<EquilibriumSettings>().steps = 150;
  expect_same_state(ten, found_of(input), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Films, RandomBranches, testing::Range(0, 16));

}  // namespace
}  // namespace bumpfoil
