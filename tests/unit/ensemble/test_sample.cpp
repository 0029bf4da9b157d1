#include "bumpfoil/ensemble/sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/ensemble/statistics.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::ensemble_case;

const Distribution ten_micrometres{.kind = DistributionKind::normal, .sigma = 10e-6};

TEST(Sample, DependsOnSeedAndNumberAlone) {
  const Case input = ensemble_case({.samples = 10,
                                    .seed = 3,
                                    .bump_height = HeightScatter{ten_micrometres},
                                    .friction_top_bump = Distribution{.sigma = 0.01}});
  const Sample seventh = draw_sample(input, 7);
  EXPECT_NE(seventh, draw_sample(input, 8));
  EXPECT_EQ(seventh, draw_sample(input, 7));
  Case other = input;
  other.montecarlo->samples = 1'000'000;
  EXPECT_EQ(seventh, draw_sample(other, 7));
  // Other scatter makes no difference either.
  other.montecarlo->bump_foil_thickness = Distribution{.sigma = 1e-6};
  other.montecarlo->sleeve_waviness = WavinessScatter{3, 5e-6};
  EXPECT_EQ(seventh.height_deviations, draw_sample(other, 7).height_deviations);
  EXPECT_EQ(seventh.deviations.at(3), draw_sample(other, 7).deviations.at(3));
  other.montecarlo->seed = 4;
  EXPECT_NE(seventh.height_deviations, draw_sample(other, 7).height_deviations);
}

/// A random rotor has the same deviations in all of its bearings, each from its own nominal values.
TEST(Sample, DeviatesEveryBearingOfARotor) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres},
                              .radial_clearance = Distribution{.sigma = 1e-6},
                              .sleeve_waviness = WavinessScatter{3, 5e-6}});
  input.rotor_bearings.resize(2);
  input.rotor_bearings[1].bearing = input.bearing;
  input.rotor_bearings[1].bearing->radial_clearance = 20e-6;
  const Case drawn = sampled_case(input, draw_sample(input, 3));
  const Case first = bearing_at(drawn, 0);
  const Case second = bearing_at(drawn, 1);
  EXPECT_EQ(static_cast<const BearingDesign&>(first), static_cast<const BearingDesign&>(drawn));
  EXPECT_EQ(first.bump_foil, second.bump_foil);
  EXPECT_EQ(second.bump_foil.height_errors.size(), 26U);
  EXPECT_NEAR(second.bearing.radial_clearance - 20e-6, drawn.bearing.radial_clearance - 31.8e-6, 1e-18);
  EXPECT_EQ(second.bearing.sleeve, first.bearing.sleeve);
  EXPECT_FALSE(second.bearing.sleeve.waves.empty());
}

TEST(Sample, DrawsEveryBumpOfEveryPad) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres},
                              .bump_foil_thickness = Distribution{.sigma = 1e-6},
                              .top_foil_thickness = Distribution{.sigma = 1e-6}});
  input.bump_foil.bumps = 7;
  input.bump_foil.height_errors.assign(7, 1e-6);
  input.pads.resize(2);
  input.pads[1].bump_foil = input.bump_foil;
  input.pads[1].bump_foil->bumps = 5;
  input.pads[1].bump_foil->height_errors.clear();
  input.pads[1].bump_foil->thickness = 0.12e-3;
  input.pads[1].top_foil = TopFoil{.thickness = 0.2e-3, .youngs_modulus = 214e9, .poisson_ratio = 0.29};
  const Sample sample = draw_sample(input, 3);
  ASSERT_EQ(sample.height_deviations.size(), 12U);
  const Case drawn = sampled_case(input, sample);
  ASSERT_TRUE(drawn.pads[0].bump_foil && drawn.pads[1].bump_foil);
  for (std::size_t bump = 0; bump < 7; ++bump) {
    EXPECT_EQ(drawn.pads[0].bump_foil->height_errors[bump], 1e-6 + sample.height_deviations[bump]);
  }
  for (std::size_t bump = 0; bump < 5; ++bump) {
    EXPECT_EQ(drawn.pads[1].bump_foil->height_errors[bump], sample.height_deviations[7 + bump]);
  }
  // Each sheet, of bump foil and top foil, is thicker by its own number.
  const double thicker = sample.deviations[0];
  EXPECT_EQ(drawn.pads[0].bump_foil->thickness.at(0, 7), 0.102e-3 + thicker);
  EXPECT_EQ(drawn.pads[1].bump_foil->thickness.at(0, 5), 0.12e-3 + thicker);
  EXPECT_EQ(drawn.pads[1].top_foil->thickness, 0.2e-3 + sample.deviations[1]);
  // With a common foil and no scatter of heights, the common foil is changed.
  input.montecarlo->bump_height.reset();
  const Case common = sampled_case(input, draw_sample(input, 3));
  EXPECT_FALSE(common.pads[0].bump_foil);
  EXPECT_EQ(common.bump_foil.thickness.at(0, 7), 0.102e-3 + thicker);
  // Heights correlate along a pad but not between pads: the first of each is independent.
  input.montecarlo->bump_height = HeightScatter{ten_micrometres, 20e-3};
  const std::vector<double> correlated = draw_sample(input, 3).height_deviations;
  EXPECT_NEAR(correlated[0], sample.height_deviations[0], 1e-15);
  EXPECT_NE(correlated[1], sample.height_deviations[1]);
  EXPECT_NEAR(correlated[7], sample.height_deviations[7], 1e-15);
}

TEST(Sample, DrawsEveryBumpOfEveryStripThatMovesByItself) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres}});
  input.bump_foil.bumps = 5;
  input.bump_foil.strips = 2;
  const std::vector<double> common = draw_sample(input, 3).height_deviations;
  EXPECT_EQ(common.size(), 5U);  // a top foil that is uniform over the width does not distinguish strips
  input.width.modes = 2;
  input.bump_foil.strip = {FoilStrip{}, FoilStrip{.stagger = 0.0, .height_errors = -1e-6}};
  const Sample sample = draw_sample(input, 3);
  ASSERT_EQ(sample.height_deviations.size(), 10U);
  const Case drawn = sampled_case(input, sample);
  EXPECT_TRUE(drawn.bump_foil.height_errors.empty());
  ASSERT_EQ(drawn.bump_foil.strip.size(), 2U);
  for (std::size_t bump = 0; bump < 5; ++bump) {
    EXPECT_EQ(sample.height_deviations[bump], common[bump]);
    EXPECT_EQ(drawn.bump_foil.strip[0].height_errors.at(bump, 5), common[bump]);
    EXPECT_EQ(drawn.bump_foil.strip[1].height_errors.at(bump, 5), -1e-6 + sample.height_deviations[5 + bump]);
  }
  // With two pads, all bumps of a strip come before those of the next strip.
  input.pads.resize(2);
  const Sample of_pads = draw_sample(input, 3);
  ASSERT_EQ(of_pads.height_deviations.size(), 20U);
  const Case pads = sampled_case(input, of_pads);
  ASSERT_TRUE(pads.pads[1].bump_foil);
  EXPECT_EQ(pads.pads[1].bump_foil->strip[0].height_errors.at(2, 5), of_pads.height_deviations[7]);
  EXPECT_EQ(pads.pads[0].bump_foil->strip[1].height_errors.at(2, 5), -1e-6 + of_pads.height_deviations[12]);
}

TEST(Sample, HeightsHaveTheMomentsOfTheirDistribution) {
  const Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres}});
  constexpr int samples = 2000;
  std::vector<double> heights;
  double neighbours = 0.0;
  for (std::uint64_t i = 0; i < samples; ++i) {
    const std::vector<double> drawn = draw_sample(input, i).height_deviations;
    ASSERT_EQ(drawn.size(), 26U);
    heights.insert(heights.end(), drawn.begin(), drawn.end());
    for (std::size_t b = 1; b < drawn.size(); ++b) neighbours += drawn[b] * drawn[b - 1];
  }
  const auto n = static_cast<double>(heights.size());
  const Statistics found = statistics_of(heights);
  // Five standard errors: sigma / sqrt(n) of the mean, sigma / sqrt(2 n) of sigma, sigma^2 / sqrt(n) of a covariance.
  EXPECT_NEAR(found.mean, 0.0, 5.0 * 10e-6 / std::sqrt(n));
  EXPECT_NEAR(found.deviation, 10e-6, 5.0 * 10e-6 / std::sqrt(2.0 * n));
  EXPECT_NEAR(neighbours / (samples * 25), 0.0, 5.0 * 1e-10 / std::sqrt(samples * 25));
  EXPECT_NEAR(found.percentile[5], 16.449e-6, 5.0 * std::sqrt(0.05 * 0.95 / n) / 0.1031 * 10e-6);  // density there
}

TEST(Sample, CorrelatedHeightsLoseTheirCorrelationOverItsLength) {
  const Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres, 10e-3}});
  const double rho = std::exp(-4.572 / 10.0);
  constexpr int samples = 20'000;
  std::array<double, 4> covariance{};
  double last = 0.0;
  for (std::uint64_t i = 0; i < samples; ++i) {
    const std::vector<double> drawn = draw_sample(input, i).height_deviations;
    for (std::size_t lag = 0; lag < covariance.size(); ++lag) covariance[lag] += drawn[5] * drawn[5 + lag];
    last += drawn[25] * drawn[25];
  }
  // Five standard errors of a covariance of normal numbers, sigma^2 sqrt((1 + rho^2) / n).
  for (std::size_t lag = 0; lag < covariance.size(); ++lag) {
    const double expected = std::pow(rho, lag);
    EXPECT_NEAR(covariance[lag] / samples / 1e-10, expected, 5.0 * std::sqrt((1.0 + expected * expected) / samples));
  }
  EXPECT_NEAR(last / samples / 1e-10, 1.0, 5.0 * std::sqrt(2.0 / samples));
}

TEST(Sample, CorrelationFallsWithTheDistanceBetweenCrests) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres}});
  input.bump_foil.pitch = PerBump(4e-3, 4.8e-3, Grading::linear);
  const std::vector<double> fresh = draw_sample(input, 3).height_deviations;
  input.montecarlo->bump_height->correlation_length = 10e-3;
  const std::vector<double> drawn = draw_sample(input, 3).height_deviations;
  EXPECT_NEAR(drawn[0], fresh[0], 1e-18);
  for (std::size_t n = 1; n < drawn.size(); ++n) {
    const double distance = 4.0 + 0.8 / 25.0 * (static_cast<double>(n) - 0.5);  // half of both pitches, mm
    const double rho = std::exp(-distance / 10.0);
    // Normal quantiles and probabilities agree to 1e-9.
    EXPECT_NEAR(drawn[n], rho * drawn[n - 1] + std::sqrt(1.0 - rho * rho) * fresh[n], 1e-9 * 10e-6) << n;
  }
}

TEST(Sample, CorrelationLeavesTheDistributionAsItIs) {
  const Distribution uniform{.kind = DistributionKind::uniform, .lower = -1e-6, .upper = 3e-6};
  const Case input = ensemble_case({.bump_height = HeightScatter{uniform, 20e-3}});
  constexpr int samples = 10'000;
  std::vector<double> heights;
  for (std::uint64_t i = 0; i < samples; ++i) heights.push_back(draw_sample(input, i).height_deviations[13]);
  const Statistics found = statistics_of(heights);
  // Five standard errors: of the mean, and sqrt(p (1 - p) / n) over the density of a percentile.
  EXPECT_NEAR(found.mean, 1e-6, 5.0 * 4e-6 / std::sqrt(12.0 * samples));
  for (std::size_t i = 0; i < percentiles.size(); ++i) {
    const double p = 0.01 * percentiles[i];
    EXPECT_NEAR(found.percentile[i], (4.0 * p - 1.0) * 1e-6, 5.0 * std::sqrt(p * (1.0 - p) / samples) * 4e-6);
  }
}

TEST(Sample, DeviationsAreAddedToTheCase) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres},
                              .bump_foil_thickness = Distribution{.sigma = 1e-6},
                              .radial_clearance = Distribution{.sigma = 2e-6},
                              .sleeve_waviness = WavinessScatter{3, 5e-6}});
  input.bump_foil.height_errors.assign(26, 1e-6);
  input.bump_foil.strips = 2;
  input.bump_foil.strip.resize(2);
  input.bump_foil.strip[1].thickness = 0.127e-3;
  input.bump_foil.strip[1].sections = {{.from = 2, .to = 3, .length = 3.4e-3},
                                       {.from = 4, .to = 5, .thickness = 0.11e-3}};
  const Sample sample = draw_sample(input, 5);
  const Case sampled = sampled_case(input, sample);
  EXPECT_FALSE(sampled.montecarlo);
  EXPECT_EQ(sampled.bump_foil.height_errors[25], 1e-6 + sample.height_deviations[25]);
  EXPECT_EQ(sampled.bump_foil.thickness.values,
            std::vector{input.bump_foil.thickness.values.front() + sample.deviations[0]});
  EXPECT_NE(sampled.bump_foil.thickness.values, input.bump_foil.thickness.values);
  EXPECT_EQ(sampled.bump_foil.strip[1].thickness, 0.127e-3 + sample.deviations[0]);
  EXPECT_FALSE(sampled.bump_foil.strip[0].thickness);
  EXPECT_FALSE(sampled.bump_foil.strip[1].sections[0].thickness);
  EXPECT_EQ(sampled.bump_foil.strip[1].sections[1].thickness, 0.11e-3 + sample.deviations[0]);
  EXPECT_EQ(sampled.top_foil, input.top_foil);
  EXPECT_EQ(sampled.friction, input.friction);
  EXPECT_EQ(sampled.bearing.radial_clearance, input.bearing.radial_clearance + sample.deviations[5]);
  EXPECT_EQ(sampled.bearing.sleeve.waves, (std::vector<Waviness>{{3, 5e-6, sample.waviness_phase}}));
  EXPECT_GT(sample.waviness_phase, 0.0);
  EXPECT_LT(sample.waviness_phase, 2.0 * std::numbers::pi);
}

}  // namespace
}  // namespace bumpfoil
