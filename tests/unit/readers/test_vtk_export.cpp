#include "bumpfoil/readers/vtk_export.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "readers/foil_shapes.hpp"
#include "support/bearing_cases.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

/// result.nc of an experiment.
std::string stored(const std::string& command, const Case& input) {
  for (ResultFile& file : test_support::files_of(command, input)) {
    if (file.name == "result.nc") return std::move(file.contents);
  }
  return {};
}

Case pushed() {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0};
  cycle.steps = 2;
  return input;
}

const ShapedGrid& part_of(const std::vector<ShapedGrid>& grids, ShapedPart part) {
  for (const ShapedGrid& grid : grids) {
    if (grid.part == part) return grid;
  }
  ADD_FAILURE() << "no part " << static_cast<int>(part);
  return grids.front();
}

TEST(VtkExport, PutsFoilsWhereTheResultHasThem) {
  const NetcdfImage image(stored("cycle", pushed()), "result.nc");
  const FoilShapes shapes(image);
  ASSERT_EQ(shapes.states(), 5U);
  ASSERT_EQ(shapes.pads().size(), 1U);
  const ShapedPad& pad = shapes.pads().front();
  EXPECT_NEAR(pad.weld, std::numbers::pi, 1e-12);
  EXPECT_EQ(pad.sense, -1.0);
  const std::size_t turned = 2;
  EXPECT_NEAR(shapes.numbers_of(turned).at("displacement"), 79.5e-6, 1e-15);
  const std::vector<ShapedGrid> grids = shapes.foils(turned, pad);
  const ShapedGrid& top = part_of(grids, ShapedPart::top_foil);
  const ShapedGrid& foil = part_of(grids, ShapedPart::bump_foil);
  EXPECT_EQ(top.points.size(), 2U * 28U);
  double force = 0.0;
  double touched = 0.0;
  for (const ShapedPoint& point : part_of(grids, ShapedPart::journal_top).points) {
    const double polar = pad.weld + pad.sense * point.along;
    force += point.force_outward * std::cos(polar);
    if (point.force_outward > 0.0) touched = std::max(touched, point.radius);
    // The foil cannot penetrate the journal, R - C + x cos(phi).
    EXPECT_GE(point.radius, 19.05e-3 - 31.8e-6 + 79.5e-6 * std::cos(polar) - 1e-15);
    EXPECT_NEAR(point.radius, 19.05e-3 + point.outward, 1e-12);
  }
  EXPECT_NEAR(force, shapes.numbers_of(turned).at("force_x"), 1e-6 * force);
  EXPECT_GT(touched, 19.05e-3 + 20e-6);
  // Crests stay below the top foil and lift it where no load presses on it; feet stay on the sleeve.
  const auto by_radius = [](const ShapedPoint& a, const ShapedPoint& b) { return a.radius < b.radius; };
  const double innermost = std::min_element(top.points.begin(), top.points.end(), by_radius)->radius;
  double highest = 1.0;
  double lowest = 0.0;
  for (const ShapedPoint& point : foil.points) {
    highest = std::min(highest, point.radius);
    lowest = std::max(lowest, point.radius);
  }
  EXPECT_LT(innermost, 19.05e-3 - 50e-6);
  EXPECT_NEAR(highest, innermost, 1e-9);
  EXPECT_NEAR(lowest, shapes.sleeve_radius(), 2e-6);
  EXPECT_NEAR(shapes.sleeve_radius(), 19.05e-3 + 0.508e-3 - 0.102e-3, 1e-12);
}

TEST(VtkExport, DrawsDryFoilsAsTheyAreTilted) {
  Case tilted = pushed();
  tilted.width = {.modes = 2, .tilt = {1e-4, 0.0}};
  const NetcdfImage image(stored("cycle", tilted), "result.nc");
  const FoilShapes shapes(image);
  const std::vector<ShapedGrid> grids = shapes.foils(2, shapes.pads().front());
  const ShapedGrid& top = part_of(grids, ShapedPart::top_foil);
  constexpr std::size_t along = 28;
  ASSERT_EQ(top.points.size(), 9 * along);
  double steepest = 0.0;
  for (std::size_t i = 0; i < along; ++i) {
    const auto outward = [&](std::size_t line) { return top.points[line * along + i].outward; };
    EXPECT_NEAR(outward(0) + outward(8), 2.0 * outward(4), 1e-15);  // linear over the width
    steepest = std::max(steepest, outward(8) - outward(0));
  }
  EXPECT_GT(steepest, 1e-6);                    // on the side that the journal presses outward
  EXPECT_LT(steepest, 1e-4 * 38.1e-3 + 1e-12);  // limited by the tilt
}

TEST(VtkExport, WritesAllStatesAndReplacesNoneUnasked) {
  const test_support::TemporaryFolder folder;
  const std::string bytes = stored("cycle", pushed());
  const std::filesystem::path vtk = folder.path() / "deep" / "vtk";
  EXPECT_EQ(write_vtk(bytes, "result.nc", vtk, Existing::refuse), 5U);
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(vtk)) names.insert(file.path().filename().string());
  EXPECT_EQ(names.size(), 12U);
  EXPECT_TRUE(names.contains("unwrapped_0004.vtu"));
  EXPECT_THROW(write_vtk(bytes, "result.nc", vtk, Existing::refuse), Error);
  EXPECT_EQ(write_vtk(bytes, "result.nc", vtk, Existing::replace), 5U);
}

TEST(VtkExport, RefusesWhatHasNoShapes) {
  const test_support::TemporaryFolder folder;
  Case strip = reference_case();
  strip.settings.set(StripSettings{.bumps = 4, .amplitude = {Control::displacement, 5e-6}, .steps = 2});
  try {
    write_vtk(stored("strip", strip), "result.nc", folder.path(), Existing::refuse);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("is a result of strip"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bumpfoil
