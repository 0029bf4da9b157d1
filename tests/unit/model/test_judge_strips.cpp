// What is wrong with the strips of a bump foil.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "bumpfoil/model/validation.hpp"
#include "support/faulty_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::faulty_keys;
using test_support::Keys;

/// Three strips that differ, on a foil with room behind its last bump.
void split(Case& input) {
  input.bump_foil.bumps = 25;
  input.bump_foil.strips = 3;
  input.bump_foil.strip_gap = 2e-3;
  input.bump_foil.strip.resize(3);
  input.bump_foil.strip[1].stagger = 0.5;
  input.width.modes = 3;
}

Keys with(const std::function<void(Case&)>& change) {
  return faulty_keys([&](Case& input) {
    split(input);
    change(input);
  });
}

TEST(JudgeStrips, LetsStripsBe) {
  EXPECT_EQ(faulty_keys(split), Keys{});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip.clear(); }), Keys{});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip[2].stagger = 0.33; }), Keys{});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip[2].height_errors = PerBump(std::vector<double>(25, 1e-6)); }),
            Keys{});
  EXPECT_EQ(with([](Case& input) {
              input.bump_foil.strip.clear();
              input.bump_foil.geometry = Geometry::nonlinear;
              input.bump_foil.model = BumpFoilModel::frame;
              input.top_foil.formed_radius = {FormedTo::seated};
            }),
            Keys{});
}

TEST(JudgeStrips, CountsThemAndLeavesThemWidth) {
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strips = 0; }), Keys{"bump_foil.strips"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strips = 2; }), Keys{"bump_foil.strip"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip_gap = -1e-3; }), Keys{"bump_foil.strip_gap"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip_gap = 19e-3; }), Keys{"bump_foil.strip_gap"});
  EXPECT_EQ(faulty_keys([](Case& input) { input.bump_foil.strip_gap = 1e-3; }), Keys{"bump_foil.strip_gap"});
  EXPECT_EQ(faulty_keys([](Case& input) { input.bump_foil.strip.resize(1); }), Keys{});  // of a whole foil: as it is
  EXPECT_EQ(faulty_keys([](Case& input) { input.bump_foil.strip.resize(2); }), Keys{"bump_foil.strip"});
  Case whole = reference_case();
  whole.bump_foil.strip = {FoilStrip{.stagger = 0.0, .height_errors = -1e-6}};
  EXPECT_NE(find_faults(whole, {"cycle"}).front().what.find("this one is whole"), std::string::npos);
}

TEST(JudgeStrips, StaggersOnTheMesh) {
  for (const double stagger : {-0.5, 0.25, 1.0, 7.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(with([=](Case& input) { input.bump_foil.strip[1].stagger = stagger; }),
              Keys{"bump_foil.strip[2].stagger"})
        << stagger;
  }
  EXPECT_EQ(with([](Case& input) {
              for (FoilStrip& strip : input.bump_foil.strip) strip.stagger = 0.5;
            }),
            Keys{"bump_foil.strip[1].stagger"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.bumps = 26; }), Keys{"bump_foil.strip"});  // no room is left
  EXPECT_EQ(with([](Case& input) { input.bearing.taper = 1e-6; }), Keys{"bump_foil.strip"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.pitch = PerBump(4.3e-3, 4.5e-3, Grading::linear); }),
            Keys{"bump_foil.strip"});
}

TEST(JudgeStrips, TellsAllThatIsWrongWithTheirHeights) {
  EXPECT_EQ(with([](Case& input) {
              input.bump_foil.strip[0].height_errors = 1e-3;
              input.bump_foil.strip[1].height_errors = PerBump(std::vector<double>(24, 0.0));
            }),
            (Keys{"bump_foil.strip[1].height_errors", "bump_foil.strip[2].height_errors"}));
}

TEST(JudgeStrips, RefusesWhatIsNotComputedWithThem) {
  EXPECT_EQ(with([](Case& input) { input.top_foil.formed_radius = {FormedTo::seated}; }), Keys{"bump_foil.strip"});
  EXPECT_EQ(with([](Case& input) {
              input.bump_foil.model = BumpFoilModel::frame;
              input.bump_foil.geometry = Geometry::nonlinear;
            }),
            Keys{"bump_foil.strip"});
  Case input = reference_case();
  split(input);
  for (const char* const command : {"cycle", "path", "vibration"}) {
    EXPECT_TRUE(find_faults(input, {command}).empty()) << command;
  }
  ASSERT_EQ(find_faults(input, {"equilibrium"}).size(), 1U);  // staggered
  Case level = input;
  for (FoilStrip& strip : level.bump_foil.strip) strip = {.stagger = 0.0, .height_errors = -1e-6};
  EXPECT_TRUE(find_faults(level, {"equilibrium"}).empty());
  level.top_foil.formed_radius = {FormedTo::seated};
  EXPECT_TRUE(find_faults(level, {"equilibrium"}).empty());
  level.width.modes = 1;
  ASSERT_EQ(find_faults(level, {"equilibrium"}).size(), 1U);
  level.width.modes = 3;
  for (const char* const command : {"equilibrium", "stability", "unbalance", "transient"}) {
    const auto blames_strips = [&](const Case& one) {
      const std::vector<Fault> faults = find_faults(one, {command});
      return std::any_of(faults.begin(), faults.end(),
                         [](const Fault& fault) { return fault.key == "bump_foil.strip"; });
    };
    EXPECT_TRUE(blames_strips(input)) << command;  // staggered
    EXPECT_FALSE(blames_strips(level)) << command;
  }
  input.width.modes = 1;
  for (const char* const command : {"cycle", "path", "vibration"}) {
    ASSERT_EQ(find_faults(input, {command}).size(), 1U) << command;
  }
  input.bump_foil.strip.clear();
  EXPECT_TRUE(find_faults(input, {"equilibrium"}).empty());
  input.width.modes = 3;
  EXPECT_TRUE(find_faults(input, {"equilibrium"}).empty());
}

TEST(JudgeStrips, HaveOneStaggerOnAllPads) {
  EXPECT_EQ(with([](Case& input) {
              input.bump_foil.bumps = 8;
              input.pads.resize(2);
              input.pads[1].bump_foil = input.bump_foil;
              input.pads[1].bump_foil->strip[1].stagger = 0.0;
              input.pads[1].bump_foil->strip_gap = 1e-3;
            }),
            (Keys{"pad[2].bump_foil.strip_gap", "pad[2].bump_foil.strip"}));
}

}  // namespace
}  // namespace bumpfoil
