// Validation of the strips of a bump foil.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/validation.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

/// Three different strips, on a foil with space after its last bump.
void split(Case& input) {
  input.bump_foil.bumps = 25;
  input.bump_foil.strips = 3;
  input.bump_foil.strip_gap = 2e-3;
  input.bump_foil.strip.resize(3);
  input.bump_foil.strip[1].stagger = 0.5;
  input.width.modes = 3;
}

Keys with(const std::function<void(Case&)>& change) {
  return wrong_keys([&](Case& input) {
    split(input);
    change(input);
  });
}

TEST(CheckStrips, LetsStripsBe) {
  EXPECT_EQ(with([](Case& input) { input.top_foil.formed_radius = {FormedTo::seated}; }), Keys{});

  EXPECT_EQ(wrong_keys(split), Keys{});
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

TEST(CheckStrips, CountsThemAndLeavesThemWidth) {
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strips = 0; }), Keys{"bump_foil.strips"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strips = 2; }), Keys{"bump_foil.strip"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip_gap = -1e-3; }), Keys{"bump_foil.strip_gap"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.strip_gap = 19e-3; }), Keys{"bump_foil.strip_gap"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.strip_gap = 1e-3; }), Keys{"bump_foil.strip_gap"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.strip.resize(1); }), Keys{});  // a whole foil is unchanged
  EXPECT_EQ(wrong_keys([](Case& input) { input.bump_foil.strip.resize(2); }), Keys{"bump_foil.strip"});
  Case whole = reference_case();
  whole.bump_foil.strip = {FoilStrip{.stagger = 0.0, .height_errors = -1e-6}};
  EXPECT_NE(find_errors(whole, {"cycle"}).front().what.find("this one is not split"), std::string::npos);
}

TEST(CheckStrips, StaggersOnTheMesh) {
  for (const double stagger : {-0.5, 0.25, 1.0, 7.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(with([=](Case& input) { input.bump_foil.strip[1].stagger = stagger; }),
              Keys{"bump_foil.strip[2].stagger"})
        << stagger;
  }
  EXPECT_EQ(with([](Case& input) {
              for (FoilStrip& strip : input.bump_foil.strip) strip.stagger = 0.5;
            }),
            Keys{"bump_foil.strip[1].stagger"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.bumps = 26; }), Keys{"bump_foil.strip"});  // no space left
  EXPECT_EQ(with([](Case& input) { input.bearing.taper = 1e-6; }), Keys{"bump_foil.strip"});
  EXPECT_EQ(with([](Case& input) { input.bump_foil.pitch = PerBump(4.3e-3, 4.5e-3, Grading::linear); }),
            Keys{"bump_foil.strip"});
}

TEST(CheckStrips, TellsAllThatIsWrongWithTheirHeights) {
  EXPECT_EQ(with([](Case& input) {
              input.bump_foil.strip[0].height_errors = 1e-3;
              input.bump_foil.strip[1].height_errors = PerBump(std::vector<double>(24, 0.0));
            }),
            (Keys{"bump_foil.strip[1].height_errors", "bump_foil.strip[2].height_errors"}));
}

TEST(CheckStrips, FitsTheirThicknessToTheBumps) {
  const auto of_thickness = [](double thickness, const std::function<void(Case&)>& change = {}) {
    return with([&](Case& input) {
      input.bump_foil.strip[2].thickness = thickness;
      if (change) change(input);
    });
  };
  const Keys of_strip{"bump_foil.strip[3].thickness"};
  EXPECT_EQ(of_thickness(0.127e-3), Keys{});
  EXPECT_EQ(of_thickness(-1.0), of_strip);
  EXPECT_EQ(of_thickness(0.6e-3), of_strip);  // more than the bump height
  EXPECT_EQ(of_thickness(0.127e-3, [](Case& input) { input.bump_foil.truss.k1 = 1.5e8; }), of_strip);
  EXPECT_EQ(of_thickness(0.127e-3, [](Case& input) { input.bump_foil.height_reference = HeightReference::midsurface; }),
            of_strip);
}

TEST(CheckStrips, FitsTheirSectionsToTheBumps) {
  const auto of_sections = [](std::vector<BumpSection> sections, const std::function<void(Case&)>& change = {}) {
    return with([&](Case& input) {
      input.bump_foil.strip[1].sections = std::move(sections);
      if (change) change(input);
    });
  };
  const BumpSection longer{.from = 3, .to = 8, .length = 3.7e-3, .thickness = 0.11e-3};
  EXPECT_EQ(of_sections({longer}), Keys{});
  EXPECT_EQ(of_sections({{.from = 1, .to = 2, .length = 3.3e-3}, {.from = 20, .to = 26, .length = 3.4e-3}}),
            Keys{"bump_foil.strip[2].section[2].to"});
  EXPECT_EQ(of_sections({{.from = 1, .to = 2, .length = 9e-3}}), Keys{"bump_foil.strip[2].section[1].length"});
  EXPECT_EQ(of_sections({longer, {.from = 9, .to = 9, .height = 0.5e-3}}), Keys{"bump_foil.strip[2].section[2]"});
  EXPECT_EQ(of_sections({{.from = 9, .to = 9, .pitch = 4.5e-3}}), Keys{"bump_foil.strip[2].section[1]"});
  const Keys of_strip{"bump_foil.strip[2].section"};
  EXPECT_EQ(of_sections({longer}, [=](Case& input) { input.bump_foil.sections = {longer}; }), of_strip);
  EXPECT_EQ(of_sections({longer}, [](Case& input) { input.bump_foil.truss.k1 = 1.5e8; }), of_strip);
  const auto of_rises = [](Case& input) { input.bump_foil.height_reference = HeightReference::midsurface; };
  EXPECT_EQ(of_sections({longer}, of_rises), of_strip);
  EXPECT_EQ(of_sections({{.from = 1, .to = 2, .length = 3.3e-3}}, of_rises), Keys{});
}

TEST(CheckStrips, SplitsTheTopFoilOverThem) {
  EXPECT_EQ(wrong_keys([](Case& input) { input.top_foil.split = true; }), Keys{"top_foil.split"});
  Case input = reference_case();
  split(input);
  input.top_foil.split = true;
  input.width.modes = 1;             // split foils have no modes
  input.film.columns_per_pitch = 4;  // each strip has its own mesh
  input.bump_foil.strip[1].stagger = 0.33;
  for (const char* const command : {"cycle", "path", "vibration", "equilibrium"}) {
    EXPECT_TRUE(find_errors(input, {command}).empty()) << command;
  }
}

TEST(CheckStrips, RefusesWhatIsNotComputedWithThem) {
  EXPECT_EQ(with([](Case& input) {
              input.bump_foil.model = BumpFoilModel::frame;
              input.bump_foil.geometry = Geometry::nonlinear;
            }),
            Keys{"bump_foil.strip"});
  Case input = reference_case();
  split(input);
  for (const char* const command : {"cycle", "path", "vibration"}) {
    EXPECT_TRUE(find_errors(input, {command}).empty()) << command;
  }
  for (const int columns : {4, 6, 8, 12}) {
    for (const double stagger : {0.5, 0.33}) {
      Case running = input;
      running.film.columns_per_pitch = columns;
      running.bump_foil.strip[1].stagger = stagger;
      const std::vector<InputError> errors = find_errors(running, {"equilibrium"});
      const bool all_crests = stagger == 0.5 || columns % 6 == 0;
      ASSERT_EQ(errors.size(), all_crests ? 0U : 1U) << columns << ' ' << stagger;
      if (!all_crests) {
        EXPECT_EQ(errors.front().key, "film.columns_per_pitch");
      }
    }
  }
  Case level = input;
  for (FoilStrip& strip : level.bump_foil.strip) strip = {.stagger = 0.0, .height_errors = -1e-6};
  EXPECT_TRUE(find_errors(level, {"equilibrium"}).empty());
  level.top_foil.formed_radius = {FormedTo::seated};
  EXPECT_TRUE(find_errors(level, {"equilibrium"}).empty());
  level.width.modes = 1;
  ASSERT_EQ(find_errors(level, {"equilibrium"}).size(), 1U);
  level.width.modes = 3;
  for (const char* const command : {"equilibrium", "stability", "unbalance", "transient"}) {
    for (const Case* one : {&level, &input}) {  // also staggered
      const std::vector<InputError> errors = find_errors(*one, {command});
      EXPECT_FALSE(std::any_of(errors.begin(), errors.end(), [](const InputError& error) {
        return error.key == "bump_foil.strip";
      })) << command;
    }
  }
  input.width.modes = 1;
  for (const char* const command : {"cycle", "path", "vibration"}) {
    ASSERT_EQ(find_errors(input, {command}).size(), 1U) << command;
  }
  input.bump_foil.strip.clear();
  EXPECT_TRUE(find_errors(input, {"equilibrium"}).empty());
  input.width.modes = 3;
  EXPECT_TRUE(find_errors(input, {"equilibrium"}).empty());
}

TEST(CheckStrips, HaveOneStaggerOnAllPads) {
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
