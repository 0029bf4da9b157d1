#include "bumpfoil/experiments/cycle/cycle_settings.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::nan;
using test_support::wrong_keys;

TEST(CycleSettings, ChecksTheCycleThatThereIs) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.remove<CycleSettings>(); }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.get<CycleSettings>().directions.clear(); }),
            Keys{"cycle.directions"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.get<CycleSettings>().steps = 0; }), Keys{"cycle.steps"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.get<CycleSettings>().steps = 1'000'001; }),
            Keys{"cycle.steps"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.get<CycleSettings>().steps = 1'000'000; }), Keys{"cycle.steps"})
      << "memory";
  EXPECT_EQ(wrong_keys([](Case& input) {
              CycleSettings& cycle = input.settings.get<CycleSettings>();
              cycle.steps = 1'000'000;
              cycle.directions = {0.0};
              input.bump_foil.bumps = 10;
            }),
            Keys{});
  // Clearance and rise together are 0.4378 mm.
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.get<CycleSettings>().amplitude.value = 0.437e-3; }), Keys{});
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.get<CycleSettings>().amplitude.value = 0.438e-3; }),
            Keys{"cycle.amplitude"});
}

TEST(CycleSettings, ChecksWhatCyclesGoAbout) {
  const auto course = [](const auto& change) {
    return wrong_keys([&](Case& input) { change(input.settings.get<CycleSettings>()); });
  };
  EXPECT_EQ(course([](CycleSettings& c) { c.preload = PlaneTarget{Control::load, {0.0, -50.0}}; }), Keys{});
  EXPECT_EQ(course([](CycleSettings& c) { c.preload = PlaneTarget{Control::displacement, {0.0, 0.0}}; }), Keys{});
  EXPECT_EQ(course([](CycleSettings& c) {
              c.preload = PlaneTarget{Control::load, {0.0, 0.0}};
            }),
            Keys{"cycle.preload"});
  EXPECT_EQ(course([](CycleSettings& c) {
              c.preload = PlaneTarget{Control::load, {nan, 1.0}};
            }),
            Keys{"cycle.preload"});
  EXPECT_EQ(course([](CycleSettings& c) {
              c.preload = PlaneTarget{Control::displacement, {0.0, 0.44e-3}};
            }),
            Keys{"cycle.preload"});
  // Together they would flatten the bumps.
  EXPECT_EQ(course([](CycleSettings& c) {
              c.preload = PlaneTarget{Control::displacement, {0.0, 0.37e-3}};
            }),
            Keys{"cycle.amplitude"});
  EXPECT_EQ(course([](CycleSettings& c) { c.amplitude = {Control::load, 100.0}; }), Keys{});
  EXPECT_EQ(course([](CycleSettings& c) { c.amplitude = {Control::load, -1.0}; }), Keys{"cycle.load"});
  EXPECT_EQ(course([](CycleSettings& c) {
              c.amplitude = {Control::load, 100.0};
              c.preload = PlaneTarget{Control::displacement, {1e-5, 0.0}};
            }),
            Keys{"cycle.preload"});
  EXPECT_EQ(course([](CycleSettings& c) { c.cycles = 0; }), Keys{"cycle.cycles"});
  EXPECT_EQ(course([](CycleSettings& c) { c.clearance_forces = {5.0, -1.0}; }), Keys{"cycle.clearance_forces[2]"});
}

TEST(CycleSettings, PushesTheFormerModelFromTheCentreAlone) {
  const auto former = [](const auto& change) {
    return wrong_keys([&](Case& input) {
      input.bump_foil.model = BumpFoilModel::former;
      change(input.settings.get<CycleSettings>());
    });
  };
  EXPECT_EQ(former([](CycleSettings&) {}), Keys{});
  EXPECT_EQ(former([](CycleSettings& c) { c.cycles = 2; }), Keys{"bump_foil.model"});
  EXPECT_EQ(former([](CycleSettings& c) { c.swing = true; }), Keys{"bump_foil.model"});
  EXPECT_EQ(former([](CycleSettings& c) { c.amplitude = {Control::load, 10.0}; }), Keys{"bump_foil.model"});
}

TEST(CycleSettings, WantsEveryDirectionOnce) {
  const auto directions = [](std::vector<double> list) {
    return wrong_keys([&](Case& input) { input.settings.get<CycleSettings>().directions = list; });
  };
  using std::numbers::pi;
  const double degree = pi / 180.0;
  EXPECT_EQ(directions({0.0, pi, 0.5 * pi, -0.25 * pi}), Keys{});
  EXPECT_EQ(directions({0.0, 1e-6}), Keys{});  // close, but different
  EXPECT_EQ(directions({1.0, 2.0, 1.0}), Keys{"cycle.directions[3]"});
  EXPECT_EQ(directions({0.0, 2.0 * pi}), Keys{"cycle.directions[2]"});
  EXPECT_EQ(directions({-90.0 * degree, 1.0, 270.0 * degree}), Keys{"cycle.directions[3]"});
  EXPECT_EQ(directions({-1e-17, 0.0}), Keys{"cycle.directions[2]"});
  // In the order of the case, not of the angles.
  EXPECT_EQ(directions({3.0, 1.0, 3.0, 1.0}), (Keys{"cycle.directions[3]", "cycle.directions[4]"}));
  EXPECT_EQ(directions({1.0, 1.0, 1.0}), (Keys{"cycle.directions[2]", "cycle.directions[3]"}));
  EXPECT_EQ(directions({nan, nan}), (Keys{"cycle.directions[1]", "cycle.directions[2]"}));  // already reported
}

TEST(CycleSettings, AreFullyReversedAboutAPreloadOrWhereAsked) {
  CycleSettings cycle;
  EXPECT_FALSE(cycle.is_fully_reversed());
  cycle.swing = true;
  EXPECT_TRUE(cycle.is_fully_reversed());
  cycle = {.directions = {}, .amplitude = {}, .preload = PlaneTarget{}};
  EXPECT_TRUE(cycle.is_fully_reversed());
}

}  // namespace
}  // namespace bumpfoil
