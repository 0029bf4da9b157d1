#include "bumpfoil/experiments/vibration/vibration_settings.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::nan;
using test_support::wrong_keys;

TEST(VibrationSettings, AreChecked) {
  const auto vibration = [](const auto& change) {
    return wrong_keys([&](Case& input) {
      input.settings.set(VibrationSettings{.loads = {{0.0, -50.0}},
                                           .directions = {0.0, 0.5 * std::numbers::pi},
                                           .amplitudes = {1e-6},
                                           .frequencies = {1000.0}});
      change(input.settings.get<VibrationSettings>());
    });
  };
  using Settings = VibrationSettings;
  EXPECT_EQ(vibration([](Settings&) {}), Keys{});
  EXPECT_EQ(vibration([](Settings& v) { v = {}; }),
            (Keys{"vibration.loads", "vibration.directions", "vibration.amplitudes", "vibration.frequencies"}));
  EXPECT_EQ(vibration([](Settings& v) { v.loads.emplace_back(0.0, 0.0); }), Keys{"vibration.loads[2]"});
  EXPECT_EQ(vibration([](Settings& v) { v.loads[0].x() = nan; }), Keys{"vibration.loads[1]"});
  EXPECT_EQ(vibration([](Settings& v) { v.directions = {1.0}; }), Keys{});
  EXPECT_EQ(vibration([](Settings& v) { v.directions = {1.0, 1.0 - 0.5 * std::numbers::pi}; }), Keys{});
  EXPECT_EQ(vibration([](Settings& v) { v.directions = {0.0, 1.5}; }), Keys{"vibration.directions"});
  EXPECT_EQ(vibration([](Settings& v) { v.directions.push_back(std::numbers::pi); }), Keys{"vibration.directions"});
  EXPECT_EQ(vibration([](Settings& v) { v.directions[1] = nan; }), Keys{"vibration.directions[2]"});
  EXPECT_EQ(vibration([](Settings& v) {
              v.amplitudes = {-1e-6, 0.44e-3};
            }),
            (Keys{"vibration.amplitudes[1]", "vibration.amplitudes[2]"}));
  EXPECT_EQ(vibration([](Settings& v) { v.frequencies = {0.0, 1.0}; }), Keys{"vibration.frequencies[1]"});
  EXPECT_EQ(vibration([](Settings& v) { v.steps = 0; }), Keys{"vibration.steps"});
  EXPECT_EQ(vibration([](Settings& v) { v.motion = Motion::orbit; }), Keys{"vibration.directions"});
  EXPECT_EQ(vibration([](Settings& v) {
              v.motion = Motion::orbit;
              v.directions.clear();
            }),
            Keys{});
  EXPECT_EQ(vibration([](Settings& v) {
              v.steps = 1'000'000;
              v.amplitudes.resize(3, 1e-6);
            }),
            Keys{"vibration.steps"});
  EXPECT_EQ(vibration([](Settings& v) { v.frequencies.resize(1'000'001, 1.0); }), Keys{"vibration.frequencies"});
  EXPECT_EQ(wrong_keys([](Case& input) {
              input.bump_foil.model = BumpFoilModel::former;
              input.settings.set(VibrationSettings{
                  .loads = {{0.0, -50.0}}, .directions = {0.0}, .amplitudes = {1e-6}, .frequencies = {1000.0}});
            }),
            Keys{"bump_foil.model"});
}

TEST(VibrationSettings, MoveAlongEachDirectionOrInBothSenses) {
  VibrationSettings vibration;
  vibration.directions = {0.3};
  EXPECT_EQ(vibration.motions(), 1U);
  vibration.motion = Motion::orbit;
  EXPECT_EQ(vibration.motions(), 2U);
}

}  // namespace
}  // namespace bumpfoil
