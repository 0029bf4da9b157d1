// The strips of docs/verification/strip.md: ours against continuum finite elements.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
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
  input.settings.set(settings);
  const CycleResult result = run_strip(input);
  EXPECT_TRUE(result.converged()) << strip.name();
  return result.cycles.at(0);
}

TEST(StripOfFrames, MeetsTheContinuum) {
  for (const Continuum& strip : continuum_strips) {
    const Cycle cycle = compress(BumpFoilModel::frame, strip);
    ASSERT_TRUE(cycle.turning_point) << strip.name();
    const bool large = strip.geometry == Geometry::nonlinear;
    // The beam neglects shear and its thickness against the radius (0.102 mm to 3.4 mm): errors below 1 %. At large
    // displacements contacts stay at the nodes of the mid-surface while the continuum rolls on its skin.
    EXPECT_NEAR(cycle.turning_point->max_force, strip.total, (large ? 0.008 : 0.005) * strip.total) << strip.name();
    const Vector loads = turning_increment(cycle).top_bump.normal_force;
    for (Eigen::Index n = 0; n < loads.size(); ++n) {
      const double expected = strip.loads[static_cast<std::size_t>(n)];
      EXPECT_NEAR(loads[n], expected, (large ? 0.015 : 0.01) * expected) << strip.name() << ", bump " << n + 1;
    }
    if (strip.friction_coefficient > 0.0) {
      // The penalty contact of CalculiX creeps and slips early: without friction its loop is -1.2 % of the work.
      EXPECT_NEAR(1e3 * *cycle.loop_energy, strip.loop_energy, 0.08 * strip.loop_energy) << strip.name();
    } else {
      EXPECT_NEAR(*cycle.loop_energy, 0.0, 1e-12) << strip.name();
    }
  }
}

/// Large displacements have an effect of the right size: with friction a strip of ten is 3.8 % softer.
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
  // Made for rows of bumps: a single bump, which consists of ends, is far off. The second number is from the page.
  const std::vector<std::pair<std::pair<int, double>, double>> documented{{{1, 0.0}, 1.262},  {{1, 0.1}, 1.266},
                                                                          {{3, 0.0}, 1.068},  {{3, 0.1}, 1.086},
                                                                          {{10, 0.0}, 1.019}, {{10, 0.1}, 1.045}};
  for (const auto& [which, ratio] : documented) {
    const auto strip = std::find_if(continuum_strips.begin(), continuum_strips.end(), [&](const Continuum& s) {
      return s.bumps == which.first && s.friction_coefficient == which.second && s.geometry == Geometry::linear;
    });
    const double total = compress(BumpFoilModel::truss, *strip).turning_point->max_force;
    EXPECT_NEAR(total / strip->total, ratio, 0.0006) << strip->name();  // last printed digit
  }
}

/// The strip of [Larsen2014], as the preset larsen-strip has it.
Case shallow_strip() {
  Case input = reference_case();
  input.bearing.radius = 33.5e-3;
  input.bearing.axial_length = 53e-3;
  BumpFoil& foil = input.bump_foil;
  foil.model = BumpFoilModel::frame;
  foil.bumps = 10;
  foil.pitch = 7e-3;
  foil.length = 6.6e-3;
  foil.height = 0.9e-3;
  foil.thickness = 0.127e-3;
  foil.height_reference = HeightReference::midsurface;
  foil.youngs_modulus = 207e9;
  foil.poisson_ratio = 0.3;
  input.top_foil = {.thickness = 0.254e-3, .youngs_modulus = 207e9, .poisson_ratio = 0.3};
  input.settings.set(StripSettings{.bumps = 10, .amplitude = {.value = 20e-6}, .cycles = 2});
  return input;
}

/// From docs/theory/frame_and_identification.md: force, loop energy and load on the first bump, in per cent.
TEST(Strip, OfShallowBumpsIsNearTheFrameWhereSpringsAddUpToTheSameSum) {
  struct Difference {
    double friction;
    StripWeld weld;
    double force, loop_energy, first_bump;
  };
  const std::vector<Difference> table{{0.1, StripWeld::one_end, 2.0, -0.2, 12.0},
                                      {0.0, StripWeld::one_end, 3.4, 0.0, 35.0},
                                      {0.1, StripWeld::none, 0.5, 0.6, 3.0}};
  for (const Difference& expected : table) {
    Case frame = shallow_strip();
    frame.friction = {.top_bump = expected.friction, .bump_sleeve = expected.friction};
    frame.settings.get<StripSettings>().weld = expected.weld;
    Case truss = frame;
    truss.bump_foil.model = BumpFoilModel::truss;
    truss.bump_foil.truss.k2 = 0.8e6;
    truss.bump_foil.truss.k3 = 2.387e6;
    truss.bump_foil.truss.k4 = 11.13e6;
    const Cycle a = run_strip(frame).cycles.back();
    const Cycle b = run_strip(truss).cycles.back();
    ASSERT_TRUE(a.converged() && b.converged());
    const auto percent = [](double of_truss, double of_frame) { return 100.0 * (of_truss / of_frame - 1.0); };
    EXPECT_NEAR(percent(b.turning_point->max_force, a.turning_point->max_force), expected.force, 0.06);
    if (expected.friction > 0.0) {
      EXPECT_NEAR(percent(*b.loop_energy, *a.loop_energy), expected.loop_energy, 0.06);
    }
    EXPECT_NEAR(percent(b.turning_point->bump_loads[0], a.turning_point->bump_loads[0]), expected.first_bump, 0.6);
    for (Eigen::Index bump = 1; bump < 9; ++bump) {
      EXPECT_NEAR(percent(b.turning_point->bump_loads[bump], a.turning_point->bump_loads[bump]), 0.0, 0.35) << bump;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
