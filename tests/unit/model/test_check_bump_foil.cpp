// Validation of bump foils.

#include "bumpfoil/model/validation.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(FindErrors, LetsOnlyTheFrameHaveBumpsOfTheirOwnShape) {
  const auto change = [](BumpFoilModel model, std::vector<double> errors) {
    return [=](Case& input) {
      input.bump_foil.model = model;
      input.bump_foil.stiffness_follows_height = true;
      input.bump_foil.bumps = 3;
      input.bump_foil.height_errors = errors;
      // Slightly less than a half circle, 0.072 mm from its neighbours.
      input.bump_foil.length = 4.5e-3;
      input.bump_foil.height = 2.3e-3;
    };
  };
  EXPECT_EQ(wrong_keys(change(BumpFoilModel::frame, {0.0, 0.1e-3, -0.1e-3})), Keys{});
  EXPECT_EQ(wrong_keys(change(BumpFoilModel::frame, {0.0, 0.9e-3, -0.1e-3})), Keys{"bump_foil.height_errors[2]"});
  EXPECT_EQ(wrong_keys(change(BumpFoilModel::truss, {0.0, 0.1e-3, -0.1e-3})),
            Keys{"bump_foil.stiffness_follows_height"});
}

TEST(FindErrors, KeepsBumpsApart) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.length = input.bump_foil.pitch; }), Keys{"bump_foil.length"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.bumps = 27; }), Keys{"bump_foil.bumps"});
  // A foil that covers the circumference exactly, except for round-off.
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bearing.radius =
                  26 * input.bump_foil.pitch.values.front() / (2.0 * std::numbers::pi) * (1.0 - 1e-15);
            }),
            Keys{});
  // Arcs of more than half a circle are wider than their chord.
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.height = 2.2e-3; }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.height = 4.5e-3; }), Keys{"bump_foil.height"});
}

TEST(FindErrors, ChecksEveryBumpOfAVariableFoil) {
  using List = std::vector<double>;
  // One value per bump, each of them valid.
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.pitch = PerBump(List(26, 4.5e-3)); }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.pitch = PerBump(List(25, 4.5e-3)); }),
            Keys{"bump_foil.pitch"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.length = PerBump(List{}); }), Keys{"bump_foil.length"});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.length = PerBump(List(26, 3.5e-3));
              input.bump_foil.length.values[4] = -1.0;
            }),
            Keys{"bump_foil.length[5]"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.height = PerBump(0.5e-3, 0.0, Grading::linear); }),
            Keys{"bump_foil.height.end"});
  // Each bump separately, reported at its key.
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.length = PerBump(List(26, 3.5e-3));
              input.bump_foil.length.values[9] = 4.6e-3;
            }),
            Keys{"bump_foil.length[10]"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.sections = {{.from = 3, .to = 9, .height = 0.1e-3}}; }),
            Keys{"bump_foil.section[1].height"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.sections = {{.from = 3, .to = 9, .thickness = 3e-3}}; }),
            (Keys{"bump_foil.section[1].thickness", "bump_foil.height"}));
  // All bumps together around the circumference.
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.pitch = PerBump(4.5e-3, 4.9e-3, Grading::linear); }),
            Keys{"bump_foil.bumps"});
}

TEST(FindErrors, WantsSectionsAndShimsApartAndOnTheFoil) {
  const auto with_shims = [](std::vector<Shim> shims) {
    return wrong_keys([&shims](Case& input) { input.bump_foil.shims = shims; });
  };
  EXPECT_EQ(with_shims({{1, 3, 20e-6}, {4, 26, 10e-6}}), Keys{});
  EXPECT_EQ(with_shims({{0, 3, 20e-6}}), Keys{"bump_foil.shim[1].from"});
  EXPECT_EQ(with_shims({{3, 2, 20e-6}}), Keys{"bump_foil.shim[1].to"});
  EXPECT_EQ(with_shims({{3, 27, 20e-6}}), Keys{"bump_foil.shim[1].to"});
  EXPECT_EQ(with_shims({{10, 12, 20e-6}, {3, 10, 20e-6}}), Keys{"bump_foil.shim[2].from"});
  EXPECT_EQ(with_shims({{3, 4, -20e-6}}), Keys{"bump_foil.shim[1].thickness"});
  EXPECT_EQ(with_shims({{3, 4, 1e-3}}), Keys{"bump_foil.shim[1].thickness"});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.sections = {{.from = 1, .to = 5, .pitch = 4.5e-3}, {.from = 5, .to = 6, .pitch = 4.4e-3}};
            }),
            Keys{"bump_foil.section[2].from"});
}

TEST(FindErrors, WantsAStripWithinWhatIsGradedOrListed) {
  const auto strip_of = [](int bumps, const PerBump& height) {
    return wrong_keys([&](Case& input) {
      input.bump_foil.height = height;
      input.settings.set(StripSettings{.bumps = bumps, .amplitude = {.value = 20e-6}});
    });
  };
  const PerBump list(std::vector<double>(26, 0.5e-3));
  EXPECT_EQ(strip_of(26, list), Keys{});
  EXPECT_EQ(strip_of(27, list), Keys{"strip.bumps"});
  EXPECT_EQ(strip_of(26, PerBump(0.5e-3, 0.4e-3, Grading::geometric)), Keys{});
  EXPECT_EQ(strip_of(27, PerBump(0.5e-3, 0.4e-3, Grading::geometric)), Keys{"strip.bumps"});
  EXPECT_EQ(strip_of(27, 0.5e-3), Keys{});
}

TEST(FindErrors, CountsBumps) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.bumps = 1; }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.bumps = 0; }), Keys{"bump_foil.bumps"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.bumps = -5; }), Keys{"bump_foil.bumps"});
  const auto scaled = [](int bumps) {
    return [bumps](Case& input) {
      input.bump_foil.bumps = bumps;
      input.bearing.radius *= bumps / 26.0;
      input.settings.get<CycleSettings>().steps = 10;
    };
  };
  EXPECT_EQ(wrong_keys(scaled(10'000)), Keys{});
  EXPECT_EQ(wrong_keys(scaled(most_bumps)), Keys{});
  EXPECT_EQ(wrong_keys(scaled(most_bumps + 1)), Keys{"bump_foil.bumps"});
}

TEST(FindErrors, WantsARise) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.height = input.bump_foil.thickness; }),
            Keys{"bump_foil.height"});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.height_reference = HeightReference::midsurface;
              input.bump_foil.height = input.bump_foil.thickness;
            }),
            Keys{});
}

TEST(FindErrors, WantsThinFoils) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.top_foil.thickness = 2e-3; }), Keys{"top_foil.thickness"});
  // Studies include top foils ten times thicker and thinner.
  EXPECT_EQ(wrong_keys([](Case& input) { input.top_foil.thickness = 1.02e-3; }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.top_foil.thickness = 0.0102e-3; }), Keys{});
}

TEST(FindErrors, ComparesListsWithTheBumps) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.height_errors.assign(26, 60e-6); }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.height_errors.assign(25, 0.0); }),
            Keys{"bump_foil.height_errors"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.sleeve_gaps.assign(27, 0.0); }),
            Keys{"bump_foil.sleeve_gaps"});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.height_errors.assign(26, 0.0);
              input.bump_foil.height_errors[2] = not_a_number;
              input.bump_foil.height_errors[25] = -0.41e-3;  // the rise is 0.406 mm
            }),
            (Keys{"bump_foil.height_errors[3]", "bump_foil.height_errors[26]"}));
}

TEST(FindErrors, WantsPositiveSpringsAndSlantingRods) {
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.truss = {.k1 = 1e8, .k2 = 1e6, .k3 = 1e6, .k4 = 1e6, .theta_d = 0.2};
            }),
            Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.truss = {.k1 = 0.0, .k2 = -1.0, .k3 = not_a_number, .k4 = infinite, .theta_d = 0.0};
            }),
            (Keys{"bump_foil.truss.k1", "bump_foil.truss.k2", "bump_foil.truss.k3", "bump_foil.truss.k4",
                  "bump_foil.truss.theta_d"}));
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.truss.theta_d = 0.5 * std::numbers::pi; }),
            Keys{"bump_foil.truss.theta_d"});
}

TEST(FindErrors, WeldsTheArcOfTheFrameAlone) {
  const auto welded = [](BumpFoilModel model) {
    return wrong_keys([model](Case& input) {
      input.bump_foil.model = model;
      input.bump_foil.weld_at = WeldPosition::arc_start;
    });
  };
  EXPECT_EQ(welded(BumpFoilModel::truss), Keys{"bump_foil.weld_at"});
  EXPECT_EQ(welded(BumpFoilModel::frame), Keys{});
}

}  // namespace
}  // namespace bumpfoil
