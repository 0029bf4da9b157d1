#include "bumpfoil/case/case_writer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/key_list.hpp"
#include "case/presets.hpp"

namespace bumpfoil {
namespace {

/// Any double of the interval, with all its digits.
double between(double least, double most) {
  const auto fraction = static_cast<double>(*rc::gen::inRange<std::int64_t>(0, 1'000'000'007)) / 1'000'000'007.0;
  return least + (most - least) * fraction;
}

std::vector<double> lengths(int count, double scale) {
  std::vector<double> list(static_cast<std::size_t>(count));
  for (double& length : list) length = between(-scale, scale);
  return list;
}

std::optional<double> maybe(double least, double most) {
  if (*rc::gen::arbitrary<bool>()) return std::nullopt;
  return between(least, most);
}

PerBump arbitrary_dimension(int bumps, double least, double most) {
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return between(least, most);
    case 1:
      return {between(least, most), between(least, most), *rc::gen::element(Grading::linear, Grading::geometric)};
    default:
      break;
  }
  std::vector<double> each(static_cast<std::size_t>(bumps));
  for (double& one : each) one = between(least, most);
  // A list of one is a number.
  return bumps == 1 ? PerBump(each.front()) : PerBump(std::move(each));
}

StripSettings arbitrary_strip(int bumps) {
  StripSettings strip;
  strip.bumps = *rc::gen::inRange(1, bumps + 1);
  strip.weld = *rc::gen::element(StripWeld::one_end, StripWeld::none);
  strip.top_foil = *rc::gen::arbitrary<bool>();
  const bool by_load = *rc::gen::arbitrary<bool>();
  strip.amplitude =
      by_load ? Target{Control::load, between(1.0, 100.0)} : Target{Control::displacement, between(1e-6, 100e-6)};
  if (*rc::gen::arbitrary<bool>()) {
    strip.preload = by_load || *rc::gen::arbitrary<bool>() ? Target{Control::load, between(100.0, 200.0)}
                                                           : Target{Control::displacement, between(1e-6, 100e-6)};
  }
  strip.cycles = *rc::gen::inRange(1, 10);
  strip.steps = *rc::gen::inRange(1, 1000);
  return strip;
}

Case arbitrary_case() {
  Case input = reference_case();
  input.title = *rc::gen::string<std::string>();
  std::erase_if(input.title, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });  // may be no UTF-8
  input.bearing.radius = between(19.05e-3, 40e-3);
  input.bearing.axial_length = between(1e-3, 1.0);
  input.bearing.radial_clearance = between(-50e-6, 50e-6);
  input.bearing.weld_angle = between(-6.0, 6.0);
  input.bearing.wrap = *rc::gen::element(Wrap::clockwise, Wrap::counterclockwise);
  BumpFoil& foil = input.bump_foil;
  foil.model = *rc::gen::element(BumpFoilModel::truss, BumpFoilModel::frame);
  foil.weld_at = foil.model == BumpFoilModel::frame ? *rc::gen::element(WeldPosition::mid_flat, WeldPosition::arc_start)
                                                    : WeldPosition::mid_flat;
  foil.geometry =
      foil.model == BumpFoilModel::frame ? *rc::gen::element(Geometry::linear, Geometry::nonlinear) : Geometry::linear;
  foil.stiffness_follows_height = foil.model == BumpFoilModel::frame && *rc::gen::arbitrary<bool>();
  foil.yield_stress = maybe(1e8, 2e9);
  foil.bumps = *rc::gen::inRange(1, 27);
  foil.height = arbitrary_dimension(foil.bumps, 0.4e-3, 0.6e-3);
  foil.pitch = arbitrary_dimension(foil.bumps, 4.3e-3, 4.6e-3);
  foil.height_reference = *rc::gen::element(HeightReference::overall, HeightReference::midsurface);
  // Between bumps that are much thicker no truss can be identified for a thin one.
  foil.thickness = arbitrary_dimension(foil.bumps, 0.1e-3, 0.11e-3);
  if (*rc::gen::arbitrary<bool>()) {
    const int from = *rc::gen::inRange(1, foil.bumps + 1);
    foil.sections = {{.from = from, .to = from, .length = maybe(3.4e-3, 3.6e-3), .thickness = maybe(0.1e-3, 0.11e-3)}};
    foil.shims = {{.from = from, .to = foil.bumps, .thickness = between(1e-6, 50e-6)}};
    if (from > 1) foil.shims.push_back({.from = 1, .to = from - 1, .thickness = between(1e-6, 50e-6)});
  }
  foil.youngs_modulus = between(1e9, 1e12);
  foil.poisson_ratio = between(0.0, 0.5);
  if (*rc::gen::arbitrary<bool>()) foil.height_errors = lengths(foil.bumps, 50e-6);
  if (*rc::gen::arbitrary<bool>()) foil.sleeve_gaps = lengths(foil.bumps, 20e-6);
  foil.truss = {.k1 = maybe(1e6, 1e9),
                .k2 = maybe(1e6, 1e9),
                .k3 = maybe(1e6, 1e9),
                .k4 = maybe(1e6, 1e9),
                .theta_d = maybe(0.1, 1.5)};
  input.top_foil.thickness = between(0.01e-3, 1e-3);
  input.top_foil.formed_radius = *rc::gen::element(FormedRadius{}, FormedRadius{FormedTo::radius, 20e-3});
  if (input.bearing.radial_clearance > 0.0 && *rc::gen::arbitrary<bool>()) {
    input.top_foil.formed_radius = {FormedTo::seated};
  }
  input.top_foil.seat_pressure = maybe(0.0, 1e3);
  if (foil.bumps < 26) input.top_foil.overhang = maybe(1e-3, 2e-3);
  input.top_foil.yield_stress = foil.yield_stress ? between(1e8, 2e9) : maybe(1e8, 2e9);
  input.friction = {.top_bump = between(0.0, 1.0), .bump_sleeve = between(0.0, 1.0)};
  if (*rc::gen::arbitrary<bool>()) input.solver.name = SolverName::newton;
  input.solver.uzawa = {
      .eps_alm = maybe(1e6, 1e10), .eps_f = maybe(1e8, 1e12), .eps_r = maybe(1e10, 1e14), .tau_f = maybe(1e-12, 1e-6)};
  if (*rc::gen::arbitrary<bool>()) {
    input.settings.remove<CycleSettings>();
  } else {
    CycleSettings& cycle = input.settings.get<CycleSettings>();
    cycle.directions = lengths(*rc::gen::inRange(1, 5), 6.0);
    cycle.amplitude.value = between(1e-9, 100e-6);
    cycle.steps = *rc::gen::inRange(1, 1000);
    cycle.cycles = *rc::gen::inRange(1, 9);
    cycle.clearance_forces = {between(1.0, 20.0)};
    if (*rc::gen::arbitrary<bool>()) {
      cycle.preload = PlaneTarget{.control = Control::displacement, .value = {between(0.0, 50e-6), -20e-6}};
    } else {
      cycle.swing = *rc::gen::arbitrary<bool>();
      cycle.preload = PlaneTarget{.control = Control::load, .value = {-30.0, between(1.0, 100.0)}};
      if (*rc::gen::arbitrary<bool>()) cycle.amplitude = {Control::load, between(1.0, 100.0)};
    }
  }
  if (*rc::gen::arbitrary<bool>()) input.settings.set(arbitrary_strip(foil.bumps));
  return input;
}

RC_GTEST_PROP(CaseToToml, IsReadBackToTheLastBit, ()) {
  const Case input = arbitrary_case();
  RC_ASSERT(find_errors(input).empty());
  RC_ASSERT(parse_case(case_to_toml(input), "written") == input);
}

TEST(CaseToToml, KeepsHostileTitles) {
  Case input = reference_case();
  for (const char* title :
       {"", "\"quoted\" \\ back", "line\nbreak\ttab", "\x01\x1b[2J\x7f", "\xc2\xb5m \xe2\x80\xa6", "'''"}) {
    input.title = title;
    EXPECT_EQ(parse_case(case_to_toml(input), "written").title, title);
  }
}

TEST(CaseToToml, NamesUnits) {
  const std::string text = case_to_toml(reference_case());
  EXPECT_NE(text.find("radius = 0.01905  # m\n"), std::string::npos);
  EXPECT_NE(text.find("youngs_modulus = 214000000000.0  # Pa\n"), std::string::npos);
  EXPECT_NE(text.find("weld_angle = 3.141592653589793  # rad\n"), std::string::npos);
}

TEST(CaseToJson, HasTheKeysOfTheCaseFile) {
  const auto json = nlohmann::json::parse(case_to_json(reference_case()));
  EXPECT_EQ(json.at("bearing").at("radius"), 19.05e-3);
  EXPECT_EQ(json.at("bump_foil").at("model"), "truss");
  EXPECT_EQ(json.at("friction").at("bump_sleeve"), 0.1);
  EXPECT_EQ(json.at("cycle").at("directions").size(), 4U);
  EXPECT_FALSE(json.at("bump_foil").contains("truss"));
}

TEST(CaseTemplate, IsTheReferenceCase) {
  EXPECT_EQ(parse_case(case_template("gen1"), "template"), reference_case());
}

TEST(CaseKeyNames, AreThoseThatChangesGoBy) {
  const std::vector<std::string> names = case_key_names();
  const auto has = [&](const std::string& name) { return std::count(names.begin(), names.end(), name) == 1; };
  for (const char* name : {"title", "bearing.radius", "bearing.diameter", "bump_foil.truss.k1", "friction.top_bump"}) {
    EXPECT_TRUE(has(name)) << name;
  }
  EXPECT_FALSE(has("bump_foil.truss"));
  EXPECT_FALSE(has("bump_foil.shim.thickness"));  // of which shim?
  const auto reaches = [](const std::string& name) {
    // Whatever is wrong with the value: for a key that does not exist the message says unknown key.
    try {
      static_cast<void>(parse_case(case_template("gen1"), "case.toml", {.overrides = {name + "=?"}, .commands = {}}));
    } catch (const Error& error) {
      return std::string(error.what()).find("unknown key") == std::string::npos;
    }
    return true;
  };
  EXPECT_FALSE(reaches("bearing.radios"));
  for (const std::string& name : names) EXPECT_TRUE(reaches(name)) << name;
}

TEST(CaseTemplate, IsThePresetOfItsName) {
  for (const Preset& preset : presets()) {
    // To the last bit: numbers are written as people do.
    EXPECT_EQ(parse_case(case_template(preset.name), std::string(preset.name)), preset.input) << preset.name;
  }
}

TEST(CaseTemplate, ShowsWhatThePresetHoldsAndWhatItAssumes) {
  const std::string strip = case_template("larsen-strip");
  const auto holds = [&strip](const std::string& line) {
    EXPECT_NE(strip.find("\n" + line), std::string::npos) << line;
  };
  holds("thickness = \"0.254 mm\"\n");
  holds("youngs_modulus = \"207 GPa\"      # assumed; default: bump_foil.youngs_modulus");
  holds("model = \"frame\"                 # no truss can be identified");
  holds("poisson_ratio = 0.3             # assumed\n");
  holds("displacement = \"20 um\"          # assumed; displacement of the plate");
  holds("# [cycle]");
  holds("# amplitude = \"79.5 um\" ");
}

TEST(CaseTemplate, RemarksAreOnKeysThatThePresetHolds) {
  for (const Preset& preset : presets()) {
    const std::vector<ListedKey> keys = list_keys(preset.input);
    for (const auto& remark : preset.remarks) {
      const std::string path(remark.first);
      const auto found = std::find_if(keys.begin(), keys.end(), [&](const ListedKey& one) { return one.path == path; });
      ASSERT_NE(found, keys.end()) << path;
      EXPECT_TRUE(found->live) << path;
    }
  }
}

TEST(CaseTemplate, WhatItCommentsOutIsRightToo) {
  std::string text = case_template("gen1");
  // All comments that are assignments or tables, but those that contradict others, as pads, shafts and strips do.
  bool in_pad = false;
  for (std::size_t at = text.find("\n# "); at != std::string::npos; at = text.find("\n# ", at + 1)) {
    const std::string line = text.substr(at + 3, text.find('\n', at + 1) - at - 3);
    if (line.starts_with('[')) {
      in_pad = line.starts_with("[[pad") || line.starts_with("[pad") || line.starts_with("[[rotor.shaft") ||
               line.starts_with("[[rotor.disk") || line.starts_with("[[rotor.bearing") ||
               line.starts_with("[[rotor.matrix") || line.starts_with("[rotor.matrix") ||
               line.starts_with("[rotor.bearing") || line.starts_with("[[bump_foil.strip");
    }
    const bool contradicts = in_pad || line.starts_with("pad_gap") || line.starts_with("height_errors") ||
                             line.find("_profile_file") < line.find(' ') || line.starts_with("sleeve_gaps") ||
                             line.starts_with("top_bump") || line.starts_with("bump_sleeve") ||
                             line.starts_with("load ") || line.starts_with("diameter ") ||
                             line.starts_with("grade_speed ");
    const bool assigns = line.starts_with('[') || line.find(" = ") < line.find('#');
    if (assigns && !contradicts) text.erase(at + 1, 2);
  }
  const Case input = parse_case(text, "template");
  EXPECT_EQ(input.bump_foil.truss.k4, 11.25e6);
  EXPECT_TRUE(input.bump_foil.truss.theta_d);
  // The penalties that are shown are those that follow from the stiffness of this bearing, to a round number.
  const UzawaParameters shown{.eps_alm = 1e8, .eps_f = 1e10, .eps_r = 1e12, .tau_f = 1e-10};
  EXPECT_EQ(input.solver, (SolverSettings{.name = SolverName::newton, .uzawa = shown}));
  ASSERT_NE(input.settings.find<StripSettings>(), nullptr);
  EXPECT_EQ(input.settings.get<StripSettings>().amplitude, (Target{Control::displacement, 20e-6}));
  EXPECT_EQ(input.settings.get<StripSettings>().preload, (Target{Control::load, 50.0}));
}

TEST(CaseTemplate, KeepsWhatContradictsItsTableOutOfIt) {
  // Whoever takes in the strip line by line gets one amplitude.
  EXPECT_NE(case_template("gen1").find("\n# displacement = \"20 um\" "), std::string::npos);
  EXPECT_NE(case_template("gen1").find("\n# # load = \"100 N\" "), std::string::npos);
}

TEST(CaseTemplate, FitsOnAScreen) {
  for (const std::string& preset : preset_names()) {
    std::istringstream lines(case_template(preset));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120U) << line;
  }
}

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(CaseTemplate, IsTheExample) {
  for (const std::string& preset : preset_names()) {
    // bumpfoil init --preset gen1 > examples/gen1.toml
    EXPECT_EQ(content_of("../examples/" + preset + ".toml"), case_template(preset)) << preset;
  }
}

TEST(CaseReference, IsThePage) {
  EXPECT_EQ(content_of("../docs/case_file.md"), case_reference());  // bumpfoil init --keys > docs/case_file.md
}

TEST(CaseReference, SaysWhatAKeyIsWithoutItsLine) {
  const std::string page = case_reference();
  const auto says = [&](const std::string& row) { return page.find("\n| " + row) != std::string::npos; };
  EXPECT_TRUE(says("`radius` | length | required | R of the circle"));
  EXPECT_TRUE(says("`diameter` | length | – | instead"));
  EXPECT_TRUE(says("`weld_angle` | angle | `\"180 deg\"` |"));  // as an author would write it
  EXPECT_TRUE(says("`wrap` | \"clockwise\", \"counterclockwise\" | `\"clockwise\"` |"));
  EXPECT_TRUE(says("`yield_stress` | pressure | none |"));
  EXPECT_TRUE(says("`youngs_modulus` | pressure | that of `bump_foil.youngs_modulus` |"));
  EXPECT_TRUE(says("`eps_alm` | stiffness | none |"));
  EXPECT_TRUE(says("`sleeve_gaps` | list of lengths | none |"));
}

TEST(CaseTemplate, KnowsItsPresets) {
  for (const std::string& preset : preset_names()) EXPECT_NO_THROW((void)case_template(preset));
  EXPECT_THROW((void)case_template("gen9"), Error);
}

}  // namespace
}  // namespace bumpfoil
