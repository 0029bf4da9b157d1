#include "bumpfoil/experiments/strip/strip_settings.hpp"

#include <gtest/gtest.h>

#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

TEST(StripSettings, AreNotForTheFormerModel) {
  const auto former = [](Case& input) {
    input.bump_foil.model = BumpFoilModel::former;
    input.settings.set(StripSettings{.bumps = 10, .amplitude = {Control::displacement, 20e-6}});
  };
  EXPECT_EQ(wrong_keys(former), Keys{"bump_foil.model"});
}

TEST(StripSettings, AreForOneUniformFoil) {
  const auto with_strip = [](const auto& change) {
    return wrong_keys([&](Case& input) {
      input.settings.set(StripSettings{.bumps = 5, .amplitude = {Control::displacement, 20e-6}});
      change(input);
    });
  };
  EXPECT_EQ(with_strip([](Case&) {}), Keys{});
  EXPECT_EQ(with_strip([](Case& input) {
              input.bump_foil.bumps = 8;
              input.pads.resize(3);
            }),
            Keys{"strip"});
  EXPECT_EQ(with_strip([](Case& input) {
              input.bump_foil.strips = 2;
              input.bump_foil.strip = {FoilStrip{}, FoilStrip{.stagger = 0.0, .height_errors = -1e-6}};
              input.width.modes = 2;
            }),
            Keys{"bump_foil.strip"});
}

}  // namespace
}  // namespace bumpfoil
