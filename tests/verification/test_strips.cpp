// docs/verification/width.md: bump foils split into strips, without a film.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/cycle_energies.hpp"

namespace bumpfoil {
namespace {

constexpr double gap = 2e-3;
const Eigen::Vector2d some_slope(3e-4, -2e-4);

/// The reference bearing, with room for staggered strips at its free end.
Case whole_case(double friction) {
  Case input = reference_case();
  input.bump_foil.bumps = 25;
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  return input;
}

Case split_case(double friction) {
  Case input = whole_case(friction);
  input.bump_foil.strips = 3;
  input.bump_foil.strip_gap = gap;
  return input;
}

/// Strips of different heights, two of them staggered.
Case differing_case(double friction) {
  Case input = split_case(friction);
  input.bump_foil.strip = {FoilStrip{.stagger = 0.0, .height_errors = PerBump(-4e-6, 3e-6, Grading::linear)},
                           FoilStrip{.stagger = 1.0 / 3.0, .height_errors = 0.0},
                           FoilStrip{.stagger = 0.5, .height_errors = -6e-6}};
  return input;
}

/// The same bearing with a whole bump foil as wide as all strips together.
Case of_their_width(const Case& split) {
  Case input = split;
  const BumpFoil& strips = split.bump_foil;
  const double part = 1.0 - (strips.strips - 1) * strips.strip_gap / split.bearing.axial_length;
  input.bump_foil.strips = 1;
  input.bump_foil.strip_gap = 0.0;
  input.bump_foil.strip.clear();
  input.bump_foil.youngs_modulus *= part;  // all stiffness of a bump foil is proportional to modulus times width
  if (split.top_foil.split) input.top_foil.youngs_modulus *= part;
  input.top_foil.split = false;
  return input;
}

struct Taken {
  Increment last;
  Vector strips;  ///< loads, N
  FoilFields fields;
};

/// Moves the journal from the assembled state through `places`.
Taken taken_to(const BearingModel& foils, const std::vector<Eigen::Vector2d>& places) {
  FoilStepper stepper = make_stepper(std::make_shared<const BearingModel>(foils), {});
  Step step;
  stepper.assemble({}, step);
  for (const Eigen::Vector2d& place : places) {
    const BearingState from = step.state;
    stepper.advance(from, {.position = place}, step);
    EXPECT_TRUE(step.converged());
  }
  Taken taken{.last = place_increment(foils, step, Eigen::Vector2d::UnitX()),
              .strips = strip_loads(foils, step.state.contacts),
              .fields = make_fields(foils, 1)};
  check_increment(foils, step.state, taken.last);
  EXPECT_TRUE(taken.last.residuals.within());
  record(foils, step.state, 0, taken.fields);
  return taken;
}

const std::vector<Eigen::Vector2d> on_the_way{{40e-6, 5e-6}, {60e-6, -10e-6}};

void expect_same(const Increment& one, const Increment& other, double tolerance) {
  const double force = std::hypot(other.force_x, other.force_y);
  const double moment = 0.5 * reference_case().bearing.axial_length * force;
  EXPECT_NEAR(one.force_x, other.force_x, tolerance * force);
  EXPECT_NEAR(one.force_y, other.force_y, tolerance * force);
  EXPECT_NEAR(one.moment_x, other.moment_x, tolerance * moment);
  EXPECT_NEAR(one.moment_y, other.moment_y, tolerance * moment);
  EXPECT_NEAR(one.elastic_energy, other.elastic_energy, tolerance * other.elastic_energy);
  EXPECT_NEAR(one.dissipated_energy, other.dissipated_energy, tolerance * other.elastic_energy);
}

/// A whole bump foil that moves linearly over the width equals its slices at two points: the same bearing with other
/// unknowns.
TEST(Strips, OfOneAreTheLinearFoilOnTwoLines) {
  Case truss = whole_case(0.1);
  Case frame = truss;
  frame.bump_foil.model = BumpFoilModel::frame;
  Case formed = truss;
  formed.bump_foil.bumps = 8;
  formed.pads.resize(3);
  formed.top_foil.formed_radius = {FormedTo::seated};
  std::vector<Case> cases{truss, frame, formed};
  for (Case input : {truss, frame, formed}) {
    input.top_foil.split = true;  // into one strip: slices, too
    cases.push_back(input);
  }
  for (const Case& input : cases) {
    const Taken one = taken_to(on_strips(make_foils(input), 2, {.slope = some_slope}), on_the_way);
    const Taken other = taken_to(on_lines(make_foils(input), 2, {.slope = some_slope}), on_the_way);
    expect_same(one.last, other.last, 1e-7);  // each to the tolerance of its solver
    EXPECT_GT(one.last.dissipated_energy, 0.01 * one.last.elastic_energy);
    EXPECT_LT((one.fields.crest_v_slope - other.fields.crest_v_slope).norm(), 1e-6 * other.fields.crest_v_slope.norm());
    EXPECT_LT((one.fields.stress.top_crest - other.fields.stress.top_crest).norm(),
              1e-6 * other.fields.stress.top_crest.norm());
  }
}

/// For an aligned journal, equal strips act as one foil of their total width.
TEST(Strips, ThatAreAlikeAreOneOfTheirWidth) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = split_case(0.1);
    input.bump_foil.model = model;
    const Taken whole = taken_to(make_foils(of_their_width(input)), on_the_way);
    expect_same(taken_to(make_foils(input), on_the_way).last, whole.last, 1e-9);
    for (const int modes : {1, 2, 3}) {
      // A parabola bulges slightly over the gaps, where the journal does not hold it.
      const double bulge = modes == 3 ? 1e-3 : 1e-6;
      const Taken split = taken_to(on_strips(make_foils(input), modes, {}), on_the_way);
      expect_same(split.last, whole.last, modes == 3 ? 1e-5 : 1e-7);
      const double each = whole.fields.top_bump.normal_force.sum() / 3.0;
      for (const double load : split.strips) EXPECT_NEAR(load, each, bulge * each) << modes;
      EXPECT_LT((split.fields.top_displacement - whole.fields.top_displacement).norm(),
                bulge * whole.fields.top_displacement.norm());
      EXPECT_LT((split.fields.crest_v - whole.fields.crest_v).norm(), bulge * whole.fields.crest_v.norm());
    }
    input.top_foil.split = true;
    const Taken split = taken_to(on_strips(make_foils(input), 1, {}), on_the_way);
    const Taken narrow = taken_to(make_foils(of_their_width(input)), on_the_way);
    expect_same(split.last, narrow.last, 1e-7);
    EXPECT_LT((split.fields.top_displacement - narrow.fields.top_displacement).norm(),
              1e-6 * narrow.fields.top_displacement.norm());
    const double narrower = taken_to(make_foils(whole_case(0.1)), on_the_way).last.force_x;
    EXPECT_LT(whole.last.force_x, 0.97 * narrower);
  }
}

/// Points represent the width of their strips, and integrate quadratic functions over it exactly.
TEST(Strips, HavePointsThatIntegrateOverTheirWidth) {
  for (const int strips : {1, 2, 3, 5}) {
    Case input = split_case(0.0);
    input.bump_foil.strips = strips;
    if (strips == 1) input.bump_foil.strip_gap = 0.0;
    const double length = input.bearing.axial_length;
    const double width = strip_width(input);
    EXPECT_NEAR(strips * width + (strips - 1) * input.bump_foil.strip_gap, length, 1e-15);
    const BearingModel foils = on_strips(make_foils(input), 3, {});
    ASSERT_EQ(std::ssize(foils.points), 2 * strips);
    double sum = 0.0;
    double first = 0.0;
    double second = 0.0;
    double expected = 0.0;
    for (const FoilLine& point : foils.points) {
      const double z = 0.5 * length * point.zeta;
      sum += point.weight;
      first += point.weight * z;
      second += point.weight * z * z;
      EXPECT_LT(std::abs(z - strip_middle(input, point.strip)), 0.5 * width);
    }
    for (int k = 0; k < strips; ++k) {
      const double middle = -0.5 * length + 0.5 * width + k * (width + input.bump_foil.strip_gap);
      expected += (middle * middle + width * width / 12.0) / strips;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(first, 0.0, 1e-14 * length);
    EXPECT_NEAR(second, expected, 1e-13 * expected);
  }
}

/// Under a top foil of negligible stiffness each strip is a bearing of its own under the same journal, with its heights
/// and with its weld shifted by its stagger. Where only one strip touches, at the ends of the loaded arc, the foil may
/// turn.
TEST(Strips, AreBearingsOfTheirOwnUnderASoftTopFoil) {
  Case input = differing_case(0.0);
  input.top_foil.youngs_modulus *= 1e-7;
  input.bump_foil.strip[2].stagger = 0.0;  // the journal holds the foil over these crests at both sides, too
  input.bump_foil.strip[1].sections = {{.from = 5, .to = 15, .thickness = 0.1e-3}};
  const Taken split = taken_to(on_strips(make_foils(input), 3, {}), on_the_way);
  const double length = input.bearing.axial_length;
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  Vector loads(3);
  for (int k = 0; k < 3; ++k) {
    Case alone = of_their_width(input);
    const FoilStrip& strip = input.bump_foil.strip[static_cast<std::size_t>(k)];
    alone.bump_foil.sections = strip.sections;
    alone.bump_foil.height_errors.resize(25);
    for (std::size_t n = 0; n < 25; ++n) alone.bump_foil.height_errors[n] = strip.height_errors.at(n, 25);
    alone.bearing.weld_angle -= strip.stagger * alone.bump_foil.pitch.values.front() / alone.bearing.radius;
    const Taken one = taken_to(make_foils(alone), on_the_way);
    const Eigen::Vector2d part = Eigen::Vector2d(one.last.force_x, one.last.force_y) / 3.0;
    const double z = (k - 1) * (length + gap) / 3.0;
    force += part;
    moment += z * part;
    loads[k] = one.fields.top_bump.normal_force.sum() / 3.0;
  }
  const double scale = force.norm();
  EXPECT_GT(scale, 100.0);
  EXPECT_NEAR(split.last.force_x, force.x(), 1e-4 * scale);
  EXPECT_NEAR(split.last.force_y, force.y(), 1e-4 * scale);
  EXPECT_NEAR(split.last.moment_x, moment.x(), 1e-4 * length * scale);
  EXPECT_NEAR(split.last.moment_y, moment.y(), 1e-4 * length * scale);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(split.strips[k], loads[k], 1e-4 * scale);
  EXPECT_LT(loads[2], 0.9 * loads[1]);  // the lower strip carries less
}

/// With a split top foil each strip is a narrow bearing of its own: with its heights and thickness, its weld shifted by
/// its stagger, and the local position of the journal.
TEST(Strips, OfASplitTopFoilAreBearingsOfTheirOwn) {
  const Eigen::Vector2d aligned(0.0, 0.0);
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    for (const Eigen::Vector2d& slope : {aligned, some_slope}) {
      Case input = differing_case(0.1);
      input.bump_foil.model = model;
      input.bump_foil.strip[1].thickness = 0.12e-3;
      input.bump_foil.strip[2].sections = {{.from = 1, .to = 12, .length = 3.5e-3, .thickness = 0.1e-3}};
      input.top_foil.split = true;
      const Taken split = taken_to(on_strips(make_foils(input), 1, {.slope = slope}), on_the_way);
      Increment sum;
      Vector loads(3);
      FieldMatrix bump_stress = FieldMatrix::Zero(1, split.fields.stress.bump_largest.cols());
      for (int k = 0; k < 3; ++k) {
        const FoilStrip& strip = input.bump_foil.strip[static_cast<std::size_t>(k)];
        Case alone = whole_case(0.1);
        alone.bump_foil.model = model;
        alone.bearing.axial_length = strip_width(input);
        if (strip.thickness) alone.bump_foil.thickness = *strip.thickness;
        alone.bump_foil.sections = strip.sections;
        alone.bump_foil.height_errors.resize(25);
        for (std::size_t n = 0; n < 25; ++n) alone.bump_foil.height_errors[n] = strip.height_errors.at(n, 25);
        alone.bearing.weld_angle -= strip.stagger * alone.bump_foil.pitch.values.front() / alone.bearing.radius;
        const double z = strip_middle(input, k);
        std::vector<Eigen::Vector2d> places = on_the_way;
        for (Eigen::Vector2d& place : places) place += z * slope;
        const Taken one = taken_to(on_lines(make_foils(alone), 2, {.slope = slope}), places);
        sum.force_x += one.last.force_x;
        sum.force_y += one.last.force_y;
        sum.moment_x += one.last.moment_x + z * one.last.force_x;
        sum.moment_y += one.last.moment_y + z * one.last.force_y;
        sum.elastic_energy += one.last.elastic_energy;
        sum.dissipated_energy += one.last.dissipated_energy;
        loads[k] = one.fields.top_bump.normal_force.sum();
        if (bump_stress.cols() > 0) bump_stress = bump_stress.cwiseMax(one.fields.stress.bump_largest).eval();
      }
      expect_same(split.last, sum, 1e-7);  // each to the tolerance of its solver
      EXPECT_GT(sum.dissipated_energy, 0.01 * sum.elastic_energy);
      EXPECT_LT((split.strips - loads).norm(), 1e-6 * loads.norm());
      EXPECT_LT((split.fields.stress.bump_largest - bump_stress).norm(), 1e-6 * bump_stress.norm() + 1e-9);
      EXPECT_GT(loads[1], 1.2 * loads[2]);  // thicker and taller
    }
  }
}

TEST(Strips, AreMirroredWithTheBearing) {
  Case input = differing_case(0.1);
  const Taken one = taken_to(on_strips(make_foils(input), 3, {.slope = some_slope}), on_the_way);
  std::reverse(input.bump_foil.strip.begin(), input.bump_foil.strip.end());
  const Taken other = taken_to(on_strips(make_foils(input), 3, {.slope = -some_slope}), on_the_way);
  const double force = std::abs(one.last.force_x);
  EXPECT_NEAR(one.last.force_x, other.last.force_x, 1e-8 * force);
  EXPECT_NEAR(one.last.force_y, other.last.force_y, 1e-8 * force);
  EXPECT_NEAR(one.last.moment_x, -other.last.moment_x, 1e-8 * std::abs(one.last.moment_x));
  EXPECT_NEAR(one.last.moment_y, -other.last.moment_y, 1e-8 * std::abs(one.last.moment_x));
  EXPECT_LT((one.strips - other.strips.reverse()).norm(), 1e-8 * one.strips.norm());
  EXPECT_LT((one.fields.crest_v_slope + other.fields.crest_v_slope).norm(), 1e-7 * one.fields.crest_v_slope.norm());
}

TEST(Strips, AnswerWithTheDerivativesOfTheirEnergyWithoutFriction) {
  Case formed = differing_case(0.0);
  formed.top_foil.formed_radius = {FormedTo::seated};
  formed.top_foil.seat_pressure = 200.0;
  for (const Case& input : {differing_case(0.0), formed}) {
    const Eigen::Vector2d place = on_the_way.back();
    const auto at = [&input](const Eigen::Vector2d& slope, const Eigen::Vector2d& position) {
      return taken_to(on_strips(make_foils(input), 3, {.slope = slope}), {position}).last;
    };
    const Increment here = at(some_slope, place);
    const auto difference = [](auto&& energy, double step) { return (energy(step) - energy(-step)) / (2.0 * step); };
    const double force = std::hypot(here.force_x, here.force_y);
    const double moment = std::hypot(here.moment_x, here.moment_y);
    for (const int axis : {0, 1}) {
      const Eigen::Vector2d unit = Eigen::Vector2d::Unit(axis);
      const double by_slope =
          difference([&](double step) { return at(some_slope + step * unit, place).elastic_energy; }, 1e-8);
      const double by_place =
          difference([&](double step) { return at(some_slope, place + step * unit).elastic_energy; }, 1e-10);
      EXPECT_NEAR(by_slope, axis == 0 ? here.moment_x : here.moment_y, 1e-6 * moment);
      EXPECT_NEAR(by_place, axis == 0 ? here.force_x : here.force_y, 1e-6 * force);
    }
  }
}

/// The work of the journal is stored or dissipated: exact to round-off, as steps end at contact events.
TEST(Strips, BalanceTheEnergiesOfACycle) {
  for (const bool split : {false, true}) {
    Case input = differing_case(0.1);
    input.top_foil.split = split;
    input.width = {.modes = 3, .tilt = {1e-4, 0.0}};
    input.solver.name = SolverName::events;
    CycleSettings& settings = input.settings.get<CycleSettings>();
    settings.directions = {0.3};
    settings.steps = 10;
    const CycleResult result = run_cycles(input);
    ASSERT_TRUE(result.converged());
    const Cycle& cycle = result.cycles.front();
    const double most = largest_work(cycle);
    EXPECT_LT(plain_balance_defect(cycle), 1e-8 * most);
    EXPECT_GT(cycle.increments.back().dissipated_energy, 0.05 * most);
    ASSERT_EQ(cycle.turning_point->strip_loads.size(), 3);
    EXPECT_NEAR(cycle.turning_point->strip_loads.sum(), cycle.turning_point->bump_loads.sum(),
                1e-9 * cycle.turning_point->max_force);
    EXPECT_EQ(cycle.fields.strip_load.cols(), 3);
  }
}

/// A push between two crests touches a staggered crest first, if it lies there.
TEST(Strips, AreTouchedFirstWhereACrestIs) {
  Case input = split_case(0.0);
  input.width.modes = 2;
  input.bump_foil.strip = {FoilStrip{}, FoilStrip{.stagger = 0.5, .height_errors = {}}, FoilStrip{}};
  const double half = 0.5 * input.bump_foil.pitch.values.front() / input.bearing.radius;
  const double clearance = input.bearing.radial_clearance;
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.steps = 2;
  cycle.directions = {std::numbers::pi - 12.0 * 2.0 * half};  // half way between crests 12 and 13
  EXPECT_NEAR(*run_cycles(input).cycles.front().first_contact, clearance, 1e-9 * clearance);
  input.bump_foil.strip.clear();
  EXPECT_NEAR(*run_cycles(input).cycles.front().first_contact, clearance / std::cos(half), 1e-9 * clearance);
}

}  // namespace
}  // namespace bumpfoil
