#include "bumpfoil/experiments/path/path.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "results/netcdf_image.hpp"
#include "support/temporary_folder.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

Case along(const std::vector<Eigen::Vector2d>& points, Control control = Control::displacement) {
  Case input = reference_case();
  input.settings.set(PathSettings{}).points = {.control = control, .values = points};
  return input;
}

/// An ellipse about a journal that is pressed into the foils.
Case orbiting(SolverName solver = SolverName::newton) {
  Case input = reference_case();
  input.solver.name = solver;
  PathSettings& path = input.settings.set(PathSettings{});
  path.centre.value = {5e-6, -50e-6};
  path.semi_axes.value = {10e-6, 4e-6};
  path.tilt = 0.4;
  path.orbits = 3;
  path.steps = 40;
  return input;
}

const Cycle& only(const CycleResult& result) {
  EXPECT_EQ(result.cycles.size(), 1U);
  return result.cycles.front();
}

/// All of its legs.
Program path_program(const PathSettings& path) {
  Program program;
  const Schedule next_leg = path_schedule(path);
  while (const Leg* leg = next_leg()) program.push_back(*leg);
  EXPECT_EQ(path_increments(path), increments_of(program));
  return program;
}

TEST(PathProgram, BeginsWithTheWayToTheFirstPoint) {
  const Program through = path_program(along({{1e-6, 0.0}, {1e-6, 2e-6}}).settings.get<PathSettings>());
  ASSERT_EQ(through.size(), 2U);
  EXPECT_EQ(through[1].line.place(through[1].begin), Eigen::Vector2d(1e-6, 0.0));
  EXPECT_EQ(through[1].line.place(through[1].end), Eigen::Vector2d(1e-6, 2e-6));
  // The assembly is the first point where that is the centre of the bearing.
  EXPECT_EQ(increments_of(path_program(along({{0.0, 0.0}, {1e-6, 0.0}}).settings.get<PathSettings>())), 2);
  EXPECT_EQ(increments_of(path_program(along({{1e-6, 0.0}, {0.0, 0.0}}).settings.get<PathSettings>())), 3);
}

TEST(PathProgram, GoesRoundAnEllipseInItsSense) {
  PathSettings path = orbiting().settings.get<PathSettings>();
  for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
    path.sense = sense;
    const Program program = path_program(path);
    ASSERT_EQ(program.size(), 1U + 3U * 40U);
    EXPECT_EQ(program[0].steps, 40);
    const Eigen::Vector2d axis = unit_vector(0.4);
    const Eigen::Vector2d across{-axis.y(), axis.x()};
    double area = 0.0;
    for (std::size_t k = 1; k <= 40; ++k) {
      const Eigen::Vector2d from = program[k].line.place(program[k].begin) - path.centre.value;
      const Eigen::Vector2d to = program[k].line.place(program[k].end) - path.centre.value;
      EXPECT_NEAR(std::hypot(to.dot(axis) / 10e-6, to.dot(across) / 4e-6), 1.0, 1e-12);
      area += 0.5 * (from.x() * to.y() - from.y() * to.x());
    }
    EXPECT_EQ(area > 0.0, sense == Sense::counterclockwise);
    EXPECT_LT((program[40].line.place(program[40].end) - program[1].line.place(0.0)).norm(), 1e-18);
  }
}

TEST(RunPath, AlongALineIsACycle) {
  for (const SolverName solver : {SolverName::newton, SolverName::events}) {
    Case input = reference_case();
    input.solver.name = solver;
    CycleSettings& settings = input.settings.get<CycleSettings>();
    settings.directions = {0.7};
    settings.steps = 20;
    const Cycle cycle = run_cycles(input).cycles[0];
    PathSettings& path = input.settings.set(PathSettings{});
    for (const Increment& increment : cycle.increments) path.points.values.emplace_back(increment.x, increment.y);
    const CycleResult result = run_path(input);
    const Cycle& same = only(result);
    ASSERT_TRUE(same.converged());
    ASSERT_EQ(same.increments.size(), cycle.increments.size());
    for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
      const Increment& a = cycle.increments[k];
      const Increment& b = same.increments[k];
      // Of the largest force, 800 N, and the largest energies, 15 mJ.
      EXPECT_NEAR(a.force_x, b.force_x, 1e-8);
      EXPECT_NEAR(a.force_y, b.force_y, 1e-8);
      EXPECT_NEAR(a.dissipated_energy, b.dissipated_energy, 1e-12);
      EXPECT_NEAR(a.work, b.work, 1e-12);
      EXPECT_NEAR(a.displacement, b.displacement, 1e-17);
      EXPECT_EQ(b.orbit, 0);
    }
  }
}

/// A bearing with foils in the opposite direction from the same weld is its mirror image about X.
TEST(RunPath, OfTheMirrorImageIsTheMirrorImage) {
  const Case input = orbiting();
  Case mirrored = input;
  mirrored.bearing.wrap = Wrap::counterclockwise;
  PathSettings& path = mirrored.settings.get<PathSettings>();
  path.centre.value.y() *= -1.0;
  path.tilt *= -1.0;
  path.sense = Sense::clockwise;
  const CycleResult one = run_path(input);
  const CycleResult other = run_path(mirrored);
  ASSERT_TRUE(one.converged() && other.converged());
  for (std::size_t k = 0; k < only(one).increments.size(); ++k) {
    const Increment& a = only(one).increments[k];
    const Increment& b = only(other).increments[k];
    EXPECT_NEAR(a.force_x, b.force_x, 1e-8);
    EXPECT_NEAR(a.force_y, -b.force_y, 1e-8);
    EXPECT_NEAR(a.dissipated_energy, b.dissipated_energy, 1e-13);
  }
}

TEST(RunPath, OrbitsTakeWhatFrictionTakes) {
  const CycleResult result = run_path(orbiting(SolverName::events));
  const Cycle& cycle = only(result);
  ASSERT_TRUE(cycle.converged());
  ASSERT_EQ(cycle.increments.size(), 1U + 4U * 40U);
  EXPECT_EQ(cycle.increments[40].orbit, 0);
  EXPECT_EQ(cycle.increments[41].orbit, 1);
  EXPECT_EQ(cycle.increments.back().orbit, 3);
  ASSERT_EQ(cycle.orbits.size(), 3U);
  const Increment& begin = cycle.increments[120];
  const Increment& end = cycle.increments[160];
  const OrbitLoop& last = cycle.orbits.back();
  EXPECT_EQ(last.position_defect, 0.0);
  EXPECT_NEAR(last.force_defect, std::hypot(end.force_x - begin.force_x, end.force_y - begin.force_y), 1e-9);
  // What is not stored at the end is dissipated.
  EXPECT_NEAR(last.energy, end.elastic_energy - begin.elastic_energy + end.dissipated_energy - begin.dissipated_energy,
              1e-10);
  EXPECT_GT(last.energy, 0.0);
}

TEST(RunPath, OrbitsWithoutFrictionTakeNothing) {
  Case input = orbiting(SolverName::events);
  input.friction = {};
  input.settings.get<PathSettings>().orbits = 1;
  const CycleResult result = run_path(input);
  ASSERT_TRUE(result.converged());
  const Increment& begin = only(result).increments[40];
  EXPECT_NEAR(only(result).orbits.front().energy, 0.0, 1e-9 * begin.elastic_energy);
  EXPECT_NEAR(only(result).orbits.front().force_defect, 0.0, 1e-8);
}

/// The trapezoidal rule has an error for a force that is not linear over an increment.
TEST(RunPath, OrbitsWithoutFrictionTakeExactlyNothing) {
  for (const SolverName solver : {SolverName::newton, SolverName::events}) {
    for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
      for (const Eigen::Vector2d& axes : {Eigen::Vector2d(10e-6, 4e-6), {3e-6, 30e-6}, {45e-6, 45e-6}}) {
        for (const int steps : {8, 40, 41}) {
          Case input = orbiting(solver);
          input.friction = {};
          PathSettings& path = input.settings.get<PathSettings>();
          path.sense = sense;
          path.semi_axes.value = axes;
          path.steps = steps;
          const CycleResult result = run_path(input);
          ASSERT_TRUE(result.converged());
          for (const OrbitLoop& orbit : only(result).orbits) EXPECT_EQ(orbit.energy, 0.0) << axes << ' ' << steps;
        }
      }
    }
  }
}

TEST(RunPath, OrbitsWithFrictionTakeTheirWork) {
  for (const int steps : {8, 40}) {
    Case input = orbiting();
    input.settings.get<PathSettings>().steps = steps;
    const CycleResult result = run_path(input);
    const auto& increments = only(result).increments;
    const auto at = [&](int orbit) { return increments[static_cast<std::size_t>((orbit + 1) * steps)].work; };
    for (int i = 0; i < 3; ++i) EXPECT_EQ(only(result).orbits[static_cast<std::size_t>(i)].energy, at(i + 1) - at(i));
  }
}

TEST(RunPath, FollowsLoadsInThePlane) {
  Case input = orbiting();
  PathSettings& path = input.settings.get<PathSettings>();
  path.centre = {Control::load, {0.0, -80.0}};
  path.semi_axes = {Control::load, {20.0, 20.0}};
  path.orbits = 1;
  const CycleResult result = run_path(input);
  ASSERT_TRUE(result.converged());
  for (std::size_t k = 40; k <= 80; ++k) {
    const Increment& increment = only(result).increments[k];
    const double t = 0.4 + 2.0 * pi * static_cast<double>(k - 40) / 40.0;
    EXPECT_NEAR(increment.force_x, 20.0 * std::cos(t), 1e-6);
    EXPECT_NEAR(increment.force_y, -80.0 + 20.0 * std::sin(t), 1e-6);
    EXPECT_GT(increment.tangents.loading.value().determinant(), 0.0);
  }
  EXPECT_GT(only(result).orbits.front().position_defect, 0.0);  // friction has moved it
}

/// Slipping contacts go on to slip along the last direction alone; all closed ones stick on reversal. One-sided
/// differences over 0.01 nm see both. On reversal one contact, whose load falls faster than its friction, goes on to
/// slip: that is worth 0.7 %, where the two tangents differ by a factor of eight.
TEST(RunPath, TangentsAreThoseOfOneSidedDifferences) {
  const std::vector<Eigen::Vector2d> points{{2e-6, -20e-6}, {4e-6, -40e-6}, {5e-6, -50e-6}, {5.8e-6, -58e-6}};
  const Case input = along(points);
  const CycleResult result = run_path(input);
  ASSERT_TRUE(result.converged());
  const TangentMatrices& tangents = only(result).increments.back().tangents;
  const Eigen::Vector2d direction = (points[3] - points[2]).normalized();
  for (const double sense : {1.0, -1.0}) {
    Case beyond = input;
    beyond.settings.get<PathSettings>().points.values.push_back(points[3] + sense * 1e-11 * direction);
    const CycleResult further = run_path(beyond);
    const Increment& a = only(further).increments[4];
    const Increment& b = only(further).increments[5];
    const Eigen::Vector2d difference = Eigen::Vector2d(b.force_x - a.force_x, b.force_y - a.force_y) / (sense * 1e-11);
    const Eigen::Vector2d tangent = (sense > 0.0 ? *tangents.loading : *tangents.unloading) * direction;
    EXPECT_LT((difference - tangent).norm(), (sense > 0.0 ? 1e-3 : 1e-2) * tangent.norm()) << sense;
  }
}

TEST(RunPath, StopsWhenItIsTold) {
  int calls = 0;
  const CycleResult result = run_path(orbiting(), [&](double) { return ++calls < 50; });
  EXPECT_EQ(only(result).status, Status::interrupted);
  EXPECT_EQ(only(result).increments.size(), 50U);
  EXPECT_EQ(only(result).fields.increments(), 50);
}

TEST(RunPath, SaysThatALoadIsOutOfReach) {
  const CycleResult result = run_path(along({{0.0, -50.0}, {0.0, -1e7}}, Control::load));
  EXPECT_EQ(only(result).status, Status::load_out_of_reach);
  EXPECT_EQ(only(result).increments.size(), 3U);
  EXPECT_FALSE(only(result).increments.back().converged());
}

TEST(RunPath, NeedsAPath) {
  EXPECT_THROW(run_path(reference_case()), Error);
}

/// An orbit of some thousand increments of three pads, which stresses, pads and contacts of are recorded.
Case long_orbit() {
  Case input = orbiting(SolverName::events);
  input.bump_foil.bumps = 8;
  input.bump_foil.model = BumpFoilModel::frame;
  input.pads.resize(3);
  PathSettings& path = input.settings.get<PathSettings>();
  path.orbits = 4;
  path.steps = 700;
  return input;
}

TEST(RunPath, ForgetsWhatItHasPassedOn) {
  const Case input = long_orbit();
  const CycleResult whole = run_path(input);
  std::vector<Increment> increments;
  std::vector<CycleEvent> events;
  Eigen::Index rows = 0;
  std::size_t calls = 0;
  std::size_t most = 0;
  const CycleResult streamed = run_path(input, {}, [&](const CycleResult& recorded) {
    const Cycle& cycle = recorded.cycles.back();
    ASSERT_EQ(cycle.fields.increments(), std::ssize(cycle.increments));
    EXPECT_EQ(cycle.fields.crest_v, only(whole).fields.crest_v.middleRows(rows, cycle.fields.increments()));
    rows += cycle.fields.increments();
    increments.insert(increments.end(), cycle.increments.begin(), cycle.increments.end());
    events.insert(events.end(), cycle.events.begin(), cycle.events.end());
    most = std::max(most, cycle.increments.size());
    ++calls;
  });
  ASSERT_TRUE(whole.converged() && streamed.converged());
  ASSERT_EQ(increments.size(), 1U + 5U * 700U);
  EXPECT_GT(calls, 2U);
  // However long the path is: 32,768 bumps at a time.
  EXPECT_EQ(most, 32'768U / 24U);
  EXPECT_LE(only(streamed).increments.capacity(), most);
  EXPECT_EQ(events.size(), only(whole).events.size());
  for (std::size_t k = 0; k < increments.size(); ++k) {
    EXPECT_EQ(increments[k].index, static_cast<int>(k));
    EXPECT_EQ(increments[k].force_x, only(whole).increments[k].force_x);
    EXPECT_EQ(increments[k].work, only(whole).increments[k].work);
  }
  // Totals do not need discarded increments.
  EXPECT_EQ(only(streamed).top_foil_stress, only(whole).top_foil_stress);
  EXPECT_EQ(only(streamed).bump_foil_stress, only(whole).bump_foil_stress);
  EXPECT_EQ(only(streamed).compression, only(whole).compression);
  EXPECT_EQ(only(streamed).largest_pad_forces, only(whole).largest_pad_forces);
  EXPECT_EQ(only(streamed).orbits, only(whole).orbits);
  EXPECT_EQ(only(whole).largest_pad_forces, largest_pad_forces(only(whole).fields));
}

TEST(RunPath, RefusesPathsThatTheMemoryDoesNotHold) {
  Case input = orbiting();
  input.settings.get<PathSettings>().orbits = 1'000'000;
  try {
    run_path(input);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("40000041 increments of 26 bumps would not fit in memory"),
              std::string::npos)
        << error.what();
  }
}

/// What is written as the run goes is what a run that is kept writes.
void expect_same_files(const Case& input, const ProgressCallback& progress = {}) {
  const ExperimentInfo& path = experiment_named("path");
  const test_support::TemporaryFolder scratch;
  const Provenance provenance{.command_line = "bumpfoil path", .case_text = "case"};
  ResultFolder folder(scratch.path() / "results", Existing::refuse, path.files);
  int calls = 0;
  const auto until = [&](double) { return !progress || progress(++calls); };
  const Outcome staged = path.staged(input, {provenance, folder}, until);
  folder.publish();
  calls = 0;
  const Outcome kept = path.run(input, until);
  EXPECT_EQ(staged.status, kept.status);
  EXPECT_EQ(staged.failures, kept.failures);
  EXPECT_EQ(staged.warnings, kept.warnings);
  std::map<std::string, std::string> expected;
  for (const ResultFile& file : result_files(path, input, kept, provenance)) expected[file.name] = file.contents;
  EXPECT_EQ(scratch.read("results/path.csv"), expected.at("path.csv"));
  const NetcdfImage is(scratch.read("results/result.nc"), "is");
  const NetcdfImage be(expected.at("result.nc"), "to be");
  ASSERT_EQ(is.variables().size(), be.variables().size());
  for (const auto& [name, variable] : be.variables()) {
    if (name == "wall_time") continue;
    const StoredVariable& same = is.variables().at(name);
    EXPECT_EQ(same.dims, variable.dims) << name;
    ASSERT_EQ(same.extents, variable.extents) << name;
    EXPECT_EQ(same.type, variable.type) << name;
    EXPECT_EQ(same.fill, variable.fill) << name;
    EXPECT_EQ(same.units + same.long_name + same.flag_meanings,
              variable.units + variable.long_name + variable.flag_meanings);
    const std::vector<double> a = is.numbers(same);
    const std::vector<double> b = be.numbers(variable);
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_TRUE(a[k] == b[k] || (std::isnan(a[k]) && std::isnan(b[k]))) << name << ' ' << k;
    }
  }
  for (const char* text : {"status", "status_message", "warnings", "bumpfoil_command", "case_understood"}) {
    ASSERT_EQ(is.texts().contains(text), be.texts().contains(text)) << text;
    if (!be.texts().contains(text)) continue;
    EXPECT_EQ(is.texts().at(text), be.texts().at(text));
  }
  auto a = nlohmann::json::parse(scratch.read("results/summary.json"));
  auto b = nlohmann::json::parse(expected.at("summary.json"));
  EXPECT_EQ(a.at("run_id"), is.texts().at("run_id"));
  EXPECT_EQ(a.at("files").size(), b.at("files").size());
  for (nlohmann::json* one : {&a, &b}) {
    for (const char* own : {"run_id", "files", "xxh3_128"}) one->erase(own);
    (*one)["cycles"][0].erase("wall_time_s");
  }
  EXPECT_EQ(a, b);
}

/// Opposite tilts give opposite moments, with all forces and friction the same; result.nc has them, and the slopes.
TEST(PathExperiment, HoldsATilt) {
  Case input = along({{0.0, -50e-6}, {20e-6, -50e-6}});
  input.width = {.modes = 3, .tilt = {2e-4, 1e-4}};
  const Cycle cycle = only(run_path(input));
  ASSERT_TRUE(cycle.converged());
  const Increment& end = cycle.increments.back();
  EXPECT_GT(std::hypot(end.moment_x, end.moment_y), 0.02);
  input.width.tilt = {-2e-4, -1e-4};
  const Increment other = only(run_path(input)).increments.back();
  EXPECT_NEAR(other.force_y, end.force_y, 1e-9 * std::abs(end.force_y));
  EXPECT_NEAR(other.dissipated_energy, end.dissipated_energy, 1e-9 * end.elastic_energy);
  EXPECT_NEAR(other.moment_y, -end.moment_y, 1e-9 * std::abs(end.moment_y));
  const Dataset data = experiment_named("path").run(input, {}).dataset();
  const auto has = [&](std::string_view name) {
    const auto named = [name](const Variable& variable) { return variable.meaning.name == name; };
    return std::any_of(data.variables.begin(), data.variables.end(), named);
  };
  for (const char* const name :
       {"moment_x", "moment_y", "top_slope", "top_parabola", "crest_v_slope", "foot_u_slope", "crest_v_parabola"}) {
    EXPECT_TRUE(has(name)) << name;
  }
}

TEST(PathExperiment, WritesAsItGoesWhatAKeptRunWrites) {
  expect_same_files(long_orbit());
}

TEST(PathExperiment, WritesPartialResultsAsItGoes) {
  expect_same_files(long_orbit(), [](double calls) { return calls < 2000.0; });
  expect_same_files(orbiting(), [](double calls) { return calls < 50.0; });
  expect_same_files(along({{0.0, -50.0}, {0.0, -1e7}}, Control::load));
}

TEST(PathSettings, KnowsPathsThroughPointsOrRoundAnEllipse) {
  const auto path = [](const PathSettings& settings) {
    return test_support::wrong_keys([&](Case& input) { input.settings.set(settings); });
  };
  PathSettings orbit;
  orbit.centre.value = {0.0, -40e-6};
  orbit.semi_axes.value = {10e-6, 0.0};
  EXPECT_EQ(path(orbit), test_support::Keys{});
  PathSettings points;
  points.points.values = {{0.0, -40e-6}};
  EXPECT_EQ(path(points), test_support::Keys{});
  points.semi_axes = orbit.semi_axes;
  EXPECT_EQ(path(points), test_support::Keys{"path.semi_axes"});
  points.centre = orbit.centre;
  EXPECT_EQ(path(points), test_support::Keys{"path.centre"});
  orbit.centre.control = Control::load;
  EXPECT_EQ(path(orbit), test_support::Keys{"path.semi_axes"});
}

}  // namespace
}  // namespace bumpfoil
