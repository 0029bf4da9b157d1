#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

struct Estimate {
  double h_min{}, force{};  // m, N
  MeshError error;
};

Estimate estimate_on(const FilmResolution& resolution, const EquilibriumSettings& equilibrium) {
  Case input = film_reference_case(resolution);
  input.settings.set(equilibrium);
  EquilibriumResult result = run_equilibrium(input);
  estimate_mesh_errors(input, result);
  const RunningState& state = result.states.at(0);
  return {.h_min = state.outcome->thinnest.thickness * result.bearing->film->scales.thickness,
          .force = state.outcome->force.norm(),
          .error = state.mesh_error.value_or(MeshError{NAN, NAN})};
}

/// Against a mesh that is as good as exact. The estimate is of the leading term alone: within a factor of two.
void expect_good(const Estimate& estimate, const Estimate& exact) {
  const double error = std::abs(estimate.h_min - exact.h_min);
  EXPECT_GT(estimate.error.minimum_film_thickness, 0.5 * error);
  EXPECT_LT(estimate.error.minimum_film_thickness, 2.0 * error);
}

TEST(MeshError, IsThatOfTheFilmThicknessUnderALoad) {
  const EquilibriumSettings loaded{.speeds = {speed_of_rpm(45000.0)}, .loads = {{50.0, 0.0}}, .steps = 3};
  const Estimate exact = estimate_on({16, 24}, loaded);
  // The first of these cannot be coarser: it is compared with a finer one.
  for (const FilmResolution& resolution : {FilmResolution{4, 4}, {6, 8}, {8, 12}}) {
    SCOPED_TRACE(resolution.rows);
    expect_good(estimate_on(resolution, loaded), exact);
  }
}

TEST(MeshError, IsThatOfTheForceAtAPosition) {
  const EquilibriumSettings held{
      .speeds = {speed_of_rpm(45000.0)}, .positions = {{20e-6, 5e-6}}, .path = FilmPath::position_ray, .steps = 2};
  const Estimate exact = estimate_on({16, 24}, held);
  for (const FilmResolution& resolution : {FilmResolution{4, 4}, {6, 8}}) {
    SCOPED_TRACE(resolution.rows);
    const Estimate estimate = estimate_on(resolution, held);
    const double error = std::abs(estimate.force - exact.force);
    EXPECT_GT(estimate.error.force, 0.5 * error);
    EXPECT_LT(estimate.error.force, 3.0 * error);  // of the vector, which turns, too
  }
}

/// Friction history and pads are transferred to the other mesh.
TEST(MeshError, IsKnownWithFrictionAndPads) {
  Case input = film_reference_case({6, 6}, 0.1);
  input.bump_foil.bumps = 8;
  input.pads.resize(3);
  for (std::size_t k = 0; k < 3; ++k) input.pads[k].weld_angle = 0.1 + 2.0943951 * static_cast<double>(k);
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{30.0, 0.0}}, .steps = 3});
  EquilibriumResult result = run_equilibrium(input);
  estimate_mesh_errors(input, result);
  ASSERT_TRUE(result.states.at(0).mesh_error.has_value());
  const double h = result.states[0].outcome->thinnest.thickness * result.bearing->film->scales.thickness;
  EXPECT_GT(result.states[0].mesh_error->minimum_film_thickness, 1e-6 * h);
  EXPECT_LT(result.states[0].mesh_error->minimum_film_thickness, 0.2 * h);
}

}  // namespace
}  // namespace bumpfoil
