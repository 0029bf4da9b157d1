// The strips of docs/verification/strip.md: ours against continuum finite elements.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/analysis/strip.hpp"
#include "support/full_increment.hpp"

namespace bumpfoil {
namespace {

/// A flat strip of bumps between two rigid flat plates, compressed by 20 um in 20 increments and released. A continuum:
/// CalculiX 2.20, plane strain, small or large displacements, 36 elements along half a bump; bumps of the reference
/// bearing with a mid-surface rise of 0.508 mm, clamped at the start of the first arc.
struct Continuum {
  int bumps;
  double friction_coefficient;
  Geometry geometry;
  double total;               ///< load of the plate, N
  double loop_energy;         ///< mJ
  std::vector<double> loads;  ///< of the plate on each bump from the weld on, N

  [[nodiscard]] std::string name() const {
    return std::to_string(bumps) + " bumps, f = " + std::to_string(friction_coefficient) +
           (geometry == Geometry::nonlinear ? ", large displacements" : "");
  }
};

const std::vector<Continuum> continuum_strips{
    {1, 0.0, Geometry::linear, 36.610, -0.00276, {36.61}},
    {1, 0.0, Geometry::nonlinear, 36.356, -0.00273, {36.356}},
    {3, 0.0, Geometry::linear, 117.183, -0.01300, {50.527, 39.522, 27.133}},
    {3, 0.0, Geometry::nonlinear, 116.417, -0.01287, {50.223, 39.266, 26.928}},
    {10,
     0.0,
     Geometry::linear,
     393.701,
     -0.04780,
     {50.53, 39.333, 39.505, 39.503, 39.503, 39.503, 39.503, 39.5, 39.692, 27.131}},
    {10,
     0.0,
     Geometry::nonlinear,
     391.140,
     -0.04731,
     {50.226, 39.077, 39.249, 39.246, 39.246, 39.246, 39.246, 39.243, 39.435, 26.926}},
    {1, 0.1, Geometry::linear, 38.525, 0.03167, {38.525}},
    {1, 0.1, Geometry::nonlinear, 38.162, 0.03047, {38.162}},
    {3, 0.1, Geometry::linear, 138.036, 0.33446, {63.017, 46.187, 28.832}},
    {3, 0.1, Geometry::nonlinear, 136.058, 0.32223, {61.959, 45.562, 28.537}},
    {10,
     0.1,
     Geometry::linear,
     768.003,
     4.39266,
     {134.663, 113.35, 99.78, 87.765, 77.194, 67.887, 59.699, 52.491, 46.345, 28.83}},
    {10,
     0.1,
     Geometry::nonlinear,
     739.049,
     4.22185,
     {127.604, 107.648, 95.258, 84.228, 74.48, 65.856, 58.231, 51.488, 45.721, 28.535}},
};

Cycle compress(BumpFoilModel model, const Continuum& strip) {
  Case input = reference_case();
  input.bump_foil.model = model;
  input.bump_foil.height_reference = HeightReference::midsurface;
  if (model == BumpFoilModel::frame) {
    input.bump_foil.weld_at = WeldPosition::arc_start;
    input.bump_foil.geometry = strip.geometry;
  }
  input.friction = {.top_bump = strip.friction_coefficient, .bump_sleeve = strip.friction_coefficient};
  StripSettings settings;
  settings.bumps = strip.bumps;
  settings.top_foil = false;
  settings.amplitude = {.control = Control::displacement, .value = 20e-6};
  settings.steps = 20;
  input.strip = settings;
  const CycleResult result = run_strip(input);
  EXPECT_TRUE(result.converged()) << strip.name();
  return result.cycles.at(0);
}

TEST(StripOfFrames, MeetsTheContinuum) {
  for (const Continuum& strip : continuum_strips) {
    const Cycle cycle = compress(BumpFoilModel::frame, strip);
    ASSERT_TRUE(cycle.turning_point) << strip.name();
    const bool large = strip.geometry == Geometry::nonlinear;
    // The beam neglects shear and the thickness against the radius (0.102 mm to 3.4 mm): errors below 1 %. At large
    // displacements contacts stay at the nodes of the mid-surface while the continuum rolls on its skin.
    EXPECT_NEAR(cycle.turning_point->max_force, strip.total, (large ? 0.008 : 0.005) * strip.total) << strip.name();
    const Vector loads = turning_increment(cycle).top_bump.normal_force;
    for (Eigen::Index n = 0; n < loads.size(); ++n) {
      const double expected = strip.loads[static_cast<std::size_t>(n)];
      EXPECT_NEAR(loads[n], expected, (large ? 0.015 : 0.01) * expected) << strip.name() << ", bump " << n + 1;
    }
    if (strip.friction_coefficient > 0.0) {
      // Its penalty contact creeps and slips early: without friction its own loop is -1.2 % of the work.
      EXPECT_NEAR(1e3 * *cycle.loop_energy, strip.loop_energy, 0.08 * strip.loop_energy) << strip.name();
    } else {
      EXPECT_NEAR(*cycle.loop_energy, 0.0, 1e-12) << strip.name();
    }
  }
}

/// What large displacements change is seen, and in the right size: with friction a strip of ten is 3.8 % softer.
TEST(StripOfFrames, SoftensLikeTheContinuum) {
  for (std::size_t i = 0; i < continuum_strips.size(); i += 2) {  // small, large
    const Continuum& small = continuum_strips[i];
    const Continuum& large = continuum_strips[i + 1];
    ASSERT_EQ(large.geometry, Geometry::nonlinear);
    const double expected = 1.0 - large.total / small.total;
    const double softening = 1.0 - compress(BumpFoilModel::frame, large).turning_point->max_force /
                                       compress(BumpFoilModel::frame, small).turning_point->max_force;
    EXPECT_NEAR(softening, expected, 0.25 * expected) << large.name();  // one element per half bump
  }
}

TEST(StripOfTrusses, IsAsFarFromTheContinuumAsDocumented) {
  // Made for rows of bumps: far off for one alone, whose ends are all there is. The second number is that of the page.
  const std::vector<std::pair<std::pair<int, double>, double>> documented{{{1, 0.0}, 1.262},  {{1, 0.1}, 1.266},
                                                                          {{3, 0.0}, 1.068},  {{3, 0.1}, 1.086},
                                                                          {{10, 0.0}, 1.019}, {{10, 0.1}, 1.045}};
  for (const auto& [which, ratio] : documented) {
    const auto strip = std::find_if(continuum_strips.begin(), continuum_strips.end(), [&](const Continuum& s) {
      return s.bumps == which.first && s.friction_coefficient == which.second && s.geometry == Geometry::linear;
    });
    const double total = compress(BumpFoilModel::truss, *strip).turning_point->max_force;
    EXPECT_NEAR(total / strip->total, ratio, 0.0006) << strip->name();  // its last digit
  }
}

}  // namespace
}  // namespace bumpfoil
