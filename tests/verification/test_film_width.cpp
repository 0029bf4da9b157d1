// docs/verification/width.md: the film over foils that vary over the width, against an independent prototype.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "bumpfoil/bearing/film_bearing_energy.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

/// Equilibria of the reference bearing at 45,000 rpm under a load along +X, without friction, 6 x 16.
struct Reference {
  SheetModel sheet{};
  double load{};                         ///< N
  Eigen::Vector2d position{0.0, 0.0};    ///< um
  double least{}, least_in_mid_plane{};  ///< um
  double max_pressure{};                 ///< P
  double inner[4], outer[4];             ///< loads of bumps 11 to 14 at zeta = 0.34 and 0.861, N
  double parabola[4];                    ///< deflection by P_2 over these crests, um
};
constexpr int first_of_bumps = 10;
const Reference references[]{
    {.sheet = SheetModel::held,
     .load = 50.0,
     .position = {19.081118876, 10.477256725},
     .least = 13.854005821,
     .least_in_mid_plane = 14.028735542,
     .max_pressure = 1.6736144905,
     .inner = {5.4366, 5.9126, 5.8123, 5.271},
     .outer = {2.0506, 2.2837, 2.2875, 2.1081},
     .parabola = {-0.11649, -0.11934, -0.11148, -0.09647}},
    {.sheet = SheetModel::held,
     .load = 100.0,
     .position = {31.507259935, 9.563440462},
     .least = 7.4094685881,
     .least_in_mid_plane = 7.7444266798,
     .max_pressure = 2.4606841118,
     .inner = {10.5863, 12.2009, 12.4065, 11.3353},
     .outer = {4.1333, 4.8798, 5.0328, 4.6486},
     .parabola = {-0.20758, -0.22331, -0.21737, -0.1917}},
    {.sheet = SheetModel::held,
     .load = 150.0,
     .position = {39.995717852, 8.413915657},
     .least = 4.2794198361,
     .least_in_mid_plane = 4.7187796738,
     .max_pressure = 3.2535718638,
     .inner = {15.2194, 18.1904, 18.9961, 17.6728},
     .outer = {6.1969, 7.5671, 7.9675, 7.4236},
     .parabola = {-0.26349, -0.29291, -0.29694, -0.27473}},
    {.sheet = SheetModel::elastic,
     .load = 50.0,
     .position = {19.083771982, 10.477598004},
     .least = 13.821961196,
     .least_in_mid_plane = 14.040531429,
     .max_pressure = 1.673272538,
     .inner = {5.42, 5.8986, 5.8029, 5.2666},
     .outer = {2.0662, 2.2976, 2.2972, 2.113},
     .parabola = {-0.14571, -0.13832, -0.12248, -0.09943}},
    {.sheet = SheetModel::elastic,
     .load = 100.0,
     .position = {31.512777856, 9.561913375},
     .least = 7.364491353,
     .least_in_mid_plane = 7.760067586,
     .max_pressure = 2.458769688,
     .inner = {10.5487, 12.1683, 12.3799, 11.3184},
     .outer = {4.169, 4.9123, 5.0598, 4.666},
     .parabola = {-0.25924, -0.26372, -0.25416, -0.21795}},
    {.sheet = SheetModel::elastic,
     .load = 150.0,
     .position = {40.003874695, 8.409028203},
     .least = 4.229999588,
     .least_in_mid_plane = 4.736009928,
     .max_pressure = 3.250971606,
     .inner = {15.1699, 18.1484, 18.9564, 17.6349},
     .outer = {6.2433, 7.6105, 8.0097, 7.4624},
     .parabola = {-0.32358, -0.33734, -0.34416, -0.33221}},
};

RunningState under(double load, const FilmResolution& resolution, SharedBearing& bearing,
                   const std::optional<PerBump>& pitch = {}) {
  Case input = film_reference_case(resolution);
  if (pitch) input.bump_foil.pitch = *pitch;
  input.settings.set(
      EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{load, 0.0}}, .paths = ComparedPaths::one});
  EquilibriumResult result = run_equilibrium(input);
  bearing = result.bearing;
  return result.states.front();
}

TEST(FilmOverTheWidth, MeetsThePrototype) {
  for (const Reference& reference : references) {
    SCOPED_TRACE(testing::Message() << reference.load << " N, elastic " << (reference.sheet == SheetModel::elastic));
    SharedBearing bearing;
    const FilmResolution resolution{.columns_per_pitch = 6, .rows = 16, .width_modes = 3, .sheet = reference.sheet};
    const RunningState found = under(reference.load, resolution, bearing);
    ASSERT_TRUE(found.found());
    const BearingState& state = *found.last;
    expect_solved(*bearing, state);
    const double um = 1e6 * bearing->film->scales.thickness;
    EXPECT_LT((1e6 * state.position - reference.position).norm(), 1e-4 * reference.least);
    EXPECT_NEAR(um * found.outcome->thinnest.thickness, reference.least, 1e-4 * reference.least);
    EXPECT_EQ(found.outcome->thinnest.row, 16);  // at the side
    EXPECT_NEAR(um * state.film.thickness.row(0).minCoeff(), reference.least_in_mid_plane, 1e-4 * reference.least);
    EXPECT_NEAR(found.outcome->max_pressure, reference.max_pressure, 1e-4);
    const FoilFilm& foil = bearing->film->pads.front().foil;
    const Vector loads = bump_loads(*bearing, state);
    for (int i = 0; i < 4; ++i) {
      const int bump = first_of_bumps + i;
      const Eigen::Index contact = Eigen::Index{bump} * bearing->contacts_per_block();
      // The prototype prints four decimals, and its contacts are compliant by a proximal term.
      EXPECT_NEAR(state.contacts.normal_force[contact], reference.inner[i], 2e-3);
      EXPECT_NEAR(state.contacts.normal_force[contact + 1], reference.outer[i], 2e-3);
      EXPECT_NEAR(loads[bump], reference.inner[i] + reference.outer[i], 4e-3);
      const int crest = foil.supports[static_cast<std::size_t>(bump)];
      EXPECT_NEAR(um * (foil.stretching * state.film.deflection.col(crest))[0], reference.parabola[i], 1e-4);
    }
  }
}

/// A foil that does not stretch stays uniform over the width, except at its free end.
TEST(FilmOverTheWidth, OfAFoilThatDoesNotStretchIsUniform) {
  const FilmResolution coarse{.columns_per_pitch = 4, .rows = 6};
  SharedBearing uniform;
  const RunningState reference = under(80.0, coarse, uniform);
  ASSERT_TRUE(reference.found());
  FilmResolution with_parabola = coarse;
  with_parabola.width_modes = 3;
  BearingModel bearing = film_reference_bearing(with_parabola);
  FoilFilm& foil = bearing.film->pads.front().foil;
  const double R = bearing.film->scales.radius / foil.pitch;
  const double half_width = foil.mesh.rows * foil.mesh.dzeta * R;
  foil.membrane =
      membrane_rows(make_membrane({2}, half_width, R, 1e12, 0.29), R * foil.mesh.dtheta * foil.mesh.intervals);
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, reference.last->position, reference.last->speed, state).status,
            Status::converged);
  const Vector parabola = (foil.stretching * state.film.deflection).row(0).transpose();
  EXPECT_LT(parabola.head(foil.mesh.columns).cwiseAbs().maxCoeff(), 1e-6);  // of c; 0.01 with the foil's own stretch
  // Both reach the same state by different paths.
  EXPECT_LT((film_bearing_outcome(bearing, state).force - reference.outcome->force).norm(), 1e-5 * 80.0);
}

/// Equal pitches given one by one change no bit. Where pitches differ, columns have their own distances, and the film
/// is thinner than under a uniform foil by about as much as with equal pitches.
TEST(FilmOverTheWidth, TakesPitchesThatDiffer) {
  const FilmResolution coarse{.columns_per_pitch = 4, .rows = 6, .width_modes = 3};
  SharedBearing bearing;
  const RunningState equal = under(80.0, coarse, bearing);
  const RunningState said_one_by_one = under(80.0, coarse, bearing, PerBump(4.572e-3, 4.572e-3, Grading::linear));
  ASSERT_TRUE(equal.found() && said_one_by_one.found());
  EXPECT_EQ(equal.last->position, said_one_by_one.last->position);
  EXPECT_EQ(equal.last->film.membrane, said_one_by_one.last->film.membrane);

  const PerBump graded(4.3e-3, 4.8e-3, Grading::linear);
  const RunningState varying = under(80.0, coarse, bearing, graded);
  ASSERT_TRUE(varying.found());
  expect_solved(*bearing, *varying.last);
  FilmResolution plain = coarse;
  plain.width_modes = 1;
  const auto thinning = [&](const RunningState& with_parabola, const std::optional<PerBump>& pitch) {
    SharedBearing uniform;
    return 1.0 -
           with_parabola.outcome->thinnest.thickness / under(80.0, plain, uniform, pitch).outcome->thinnest.thickness;
  };
  EXPECT_GT(thinning(equal, {}), 5e-3);
  EXPECT_NEAR(thinning(varying, graded), thinning(equal, {}), 5e-3);
}

/// Stiffness is the derivative of the force, with all modes over the width.
TEST(FilmOverTheWidth, StiffnessIsTheDerivativeOfTheForce) {
  for (const SheetModel sheet : {SheetModel::held, SheetModel::elastic}) {
    const BearingModel bearing =
        film_reference_bearing({.columns_per_pitch = 4, .rows = 4, .width_modes = 3, .sheet = sheet});
    FilmStepper stepper(bearing);
    BearingState state;
    const double speed = speed_of_rpm(45000.0);
    const Eigen::Vector2d position(0.8 * bearing.clearance, 0.2 * bearing.clearance);
    ASSERT_EQ(start_from_ambient(stepper, position, speed, state).status, Status::converged);
    const auto K = stepper.stiffness(state);
    ASSERT_TRUE(K.has_value());
    const auto held = stepper.held_motion(state);
    ASSERT_TRUE(held.has_value());  // present only if its residual in all equations is small
    constexpr double h = 1e-9;
    for (const int axis : {0, 1}) {
      Eigen::Vector2d force[2];
      double energy[2];
      for (const int side : {0, 1}) {
        BearingState moved = state;
        const Eigen::Vector2d there = position + (side == 0 ? -h : h) * Eigen::Vector2d::Unit(axis);
        ASSERT_EQ(stepper.advance(OperatingPoint::held_at(there, speed), moved).status, Status::converged);
        force[side] = film_bearing_outcome(bearing, moved).force;
        energy[side] = bearing_energy(bearing, moved).foils;
      }
      EXPECT_LT(((force[1] - force[0]) / (2.0 * h) - K->col(axis)).norm(), 3e-6 * K->norm());
      EXPECT_GT(std::abs(energy[1] - energy[0]), 0.0);
    }
  }
}

/// With friction all lines of a crest slide together, and friction is at most f times their loads.
TEST(FilmOverTheWidth, CrestsSlideAsOneUnlessTheSheetGivesWay) {
  const auto largest_difference = [](SheetModel sheet) {
    const BearingModel bearing =
        film_reference_bearing({.columns_per_pitch = 4, .rows = 4, .width_modes = 3, .sheet = sheet}, 0.1);
    FilmStepper stepper(bearing);
    BearingState state;
    const double speed = speed_of_rpm(45000.0);
    EXPECT_EQ(start_from_ambient(stepper, {0.1 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
    for (int i = 2; i <= 10; ++i) {
      const Eigen::Vector2d position(0.1 * i * bearing.clearance, 0.0);
      EXPECT_EQ(stepper.advance(OperatingPoint::held_at(position, speed), state).status, Status::converged) << i;
    }
    expect_solved(bearing, state);
    const Eigen::Index size = bearing.problem.K.block_size();
    double difference = 0.0;
    for (Eigen::Index b = 0; b < bearing.bumps(); ++b) {
      const double inner = state.contacts.x[b * size + bearing.place(0, bearing.structure.dofs.crest_u)];
      const double outer = state.contacts.x[b * size + bearing.place(1, bearing.structure.dofs.crest_u)];
      EXPECT_NE(inner, 0.0);
      difference = std::max(difference, std::abs(inner - outer));
    }
    return difference;
  };
  const double held = largest_difference(SheetModel::held);
  const double elastic = largest_difference(SheetModel::elastic);
  EXPECT_LT(held, 1e-9);
  EXPECT_GT(elastic, 5e-8);
}

/// Equilibria under 100 N along +X of a journal tilted by 5 um over the width towards +X; otherwise as above, with 24
/// rows on the whole width.
struct TiltedReference {
  int modes{};
  Eigen::Vector2d position{0.0, 0.0};            ///< um
  std::array<double, 5> least_over_the_width{};  ///< minimum film thickness at zeta = -1, -1/2, 0, 1/2, 1, um
  Eigen::Vector2d moment{0.0, 0.0};              ///< N mm
  double max_pressure{};                         ///< P
};
const TiltedReference tilted_references[]{
    {.modes = 1,
     .position = {31.503559626048062, 9.703652052142651},
     .least_over_the_width = {9.93649, 8.7764, 7.61631, 6.45622, 5.29612},
     .moment = {124.489, -14.368},
     .max_pressure = 2.5759932738307163},
    {.modes = 2,
     .position = {31.5746482927182, 9.723730188540252},
     .least_over_the_width = {8.90187, 8.21445, 7.52703, 6.83961, 6.15218},
     .moment = {63.3843, 3.94346},
     .max_pressure = 2.538883567999486},
    {.modes = 3,
     .position = {31.4892982774176, 9.553019415928036},
     .least_over_the_width = {8.78831, 8.3606, 7.76596, 7.00439, 6.07589},
     .moment = {64.4868, 4.22233},
     .max_pressure = 2.4791739540025746},
    {.modes = 4,
     .position = {31.4884941035751, 9.551466814694303},
     .least_over_the_width = {8.79215, 8.34419, 7.76705, 7.02305, 6.07452},
     .moment = {65.5138, 4.9961},
     .max_pressure = 2.4778272087600834},
};

RunningState tilted(const Case& input, SharedBearing& bearing) {
  EquilibriumResult result = run_equilibrium(input);
  bearing = result.bearing;
  return result.states.front();
}

Case tilted_case(const FilmResolution& resolution, double load) {
  Case input = film_reference_case(resolution);
  input.width.tilt = {5e-6 / input.bearing.axial_length, 0.0};
  input.settings.set(
      EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{load, 0.0}}, .paths = ComparedPaths::one});
  return input;
}

TEST(FilmUnderATiltedJournal, MeetsThePrototype) {
  for (const TiltedReference& reference : tilted_references) {
    SCOPED_TRACE(reference.modes);
    SharedBearing bearing;
    const RunningState found =
        tilted(tilted_case({.columns_per_pitch = 6, .rows = 12, .width_modes = reference.modes}, 100.0), bearing);
    ASSERT_TRUE(found.found());
    expect_solved(*bearing, *found.last);
    const double um = 1e6 * bearing->film->scales.thickness;
    const double least = reference.least_over_the_width.back();
    EXPECT_LT((1e6 * found.last->position - reference.position).norm(), 1e-4 * least);
    for (std::size_t i = 0; i < 5; ++i) {
      const Eigen::Index row = 6 * static_cast<Eigen::Index>(i);
      EXPECT_NEAR(um * found.last->film.thickness.row(row).minCoeff(), reference.least_over_the_width[i], 1e-4 * least);
    }
    EXPECT_LT((1e3 * found.outcome->moment - reference.moment).norm(), 1e-4 * reference.moment.norm());
    EXPECT_NEAR(found.outcome->max_pressure, reference.max_pressure, 1e-4);
    EXPECT_EQ(found.outcome->thinnest.row, 24);
  }
}

const FilmResolution coarse_with_slopes{.columns_per_pitch = 4, .rows = 4, .width_modes = 3};

/// The opposite tilt gives the mirror image, and a journal with that moment applied tilts as far.
TEST(FilmUnderATiltedJournal, IsTheMirrorImageOfTheOppositeTilt) {
  Case input = tilted_case(coarse_with_slopes, 80.0);
  input.width.tilt[1] = 0.4 * input.width.tilt[0];
  SharedBearing bearing;
  const RunningState found = tilted(input, bearing);
  ASSERT_TRUE(found.found());
  EXPECT_LT(
      (found.last->tilt - 0.5 * input.bearing.axial_length * Eigen::Vector2d(input.width.tilt[0], input.width.tilt[1]))
          .norm(),
      1e-18);
  Case opposite = input;
  for (double& slope : opposite.width.tilt) slope *= -1.0;
  SharedBearing same;
  const RunningState mirrored = tilted(opposite, same);
  ASSERT_TRUE(mirrored.found());
  // Searches end when steps are below 1e-9.
  EXPECT_LT((mirrored.last->film.pressure.colwise().reverse() - found.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((mirrored.outcome->moment + found.outcome->moment).norm(), 1e-8 * found.outcome->moment.norm());

  Case by_moment = input;
  by_moment.width.moment = {found.outcome->moment.x(), found.outcome->moment.y()};
  const RunningState free = tilted(by_moment, same);
  ASSERT_TRUE(free.found());
  EXPECT_LT((free.last->tilt - found.last->tilt).norm(), 1e-6 * found.last->tilt.norm());
  EXPECT_LT((free.last->position - found.last->position).norm(), 1e-6 * found.last->position.norm());
}

/// Opposite cones give mirror images. A cone loads one side more than the other: held level, the journal needs a
/// moment; free, it tilts until the axis is closer to parallel with the film's surface.
TEST(FilmUnderAConicalJournal, IsTheMirrorImageOfTheOppositeCone) {
  Case input = tilted_case(coarse_with_slopes, 80.0);
  input.width.tilt = {0.0, 0.0};
  input.width.conicity = 4e-6;
  SharedBearing bearing;
  const RunningState held = tilted(input, bearing);
  ASSERT_TRUE(held.found());
  expect_solved(*bearing, *held.last);
  Case opposite = input;
  opposite.width.conicity *= -1.0;
  const RunningState mirrored = tilted(opposite, bearing);
  ASSERT_TRUE(mirrored.found());
  EXPECT_LT((mirrored.last->film.pressure.colwise().reverse() - held.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((mirrored.outcome->moment + held.outcome->moment).norm(), 1e-8 * held.outcome->moment.norm());

  // The wide side carries less: the force applied along X against the film must act at z < 0.
  EXPECT_LT(held.outcome->moment.x(), 0.0);
  input.width.moment = {0.0, 0.0};
  const RunningState free = tilted(input, bearing);
  ASSERT_TRUE(free.found());
  EXPECT_GT(free.last->tilt.x(), 0.0);
  EXPECT_LT(free.outcome->moment.norm(), 1e-6 * held.outcome->moment.norm());
}

/// A barrel-shaped journal gives the same result on half and on the whole width; with uniform foils it moves the
/// minimum film thickness from the sides to the mid-plane.
TEST(FilmUnderABarrelShapedJournal, IsTheSameOnHalfTheWidthAndOnAllOfIt) {
  Case input = tilted_case(coarse_with_slopes, 80.0);
  input.width.tilt = {0.0, 0.0};
  input.width.crowning = 3e-6;
  SharedBearing half;
  const RunningState reference = tilted(input, half);
  ASSERT_TRUE(reference.found());
  ASSERT_FALSE(half->film->tilts());
  input.width.moment = {0.0, 0.0};
  SharedBearing whole;
  const RunningState found = tilted(input, whole);
  ASSERT_TRUE(found.found());
  EXPECT_LT((found.last->film.pressure.bottomRows(5) - reference.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(found.last->tilt.norm(), 1e-9 * half->film->scales.thickness);
  input.width.moment.clear();
  input.width.crowning = 0.0;
  SharedBearing straight;
  const RunningState cylinder = tilted(input, straight);
  EXPECT_EQ(cylinder.outcome->thinnest.row, 4);  // at the side
  EXPECT_EQ(reference.outcome->thinnest.row, 0);
}

/// Where foils are uniform, a journal without tilt gives the film of half the width.
TEST(FilmUnderATiltedJournal, IsThatOfHalfTheWidthWithoutTilt) {
  const FilmResolution half{.columns_per_pitch = 4, .rows = 4};
  SharedBearing bearing;
  const RunningState reference = under(80.0, half, bearing);
  Case input = tilted_case(half, 80.0);
  input.width.moment = {0.0, 0.0};
  SharedBearing whole;
  const RunningState found = tilted(input, whole);
  ASSERT_TRUE(reference.found() && found.found());
  EXPECT_LT((found.last->film.pressure.bottomRows(5) - reference.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(found.last->tilt.norm(), 1e-9 * bearing->film->scales.thickness);
  EXPECT_LT((found.stiffness->topLeftCorner<2, 2>() - *reference.stiffness).norm(), 1e-6 * reference.stiffness->norm());
  // Force and tilt are uncoupled there.
  EXPECT_LT(found.stiffness->topRightCorner(2, 2).norm(), 1e-8 * reference.stiffness->norm());
  EXPECT_LT(std::abs(found.held.sliding->rate - reference.held.sliding->rate),
            1e-6 * std::abs(reference.held.sliding->rate));
}

/// Four by four: derivatives of forces and moments by displacements and tilts.
TEST(FilmUnderATiltedJournal, StiffnessIsTheDerivativeOfForceAndMoment) {
  for (const SheetModel sheet : {SheetModel::held, SheetModel::elastic}) {
    FilmResolution resolution = coarse_with_slopes;
    resolution.sheet = sheet;
    resolution.width = WidthPart::whole;
    const BearingModel bearing = film_reference_bearing(resolution);
    FilmStepper stepper(bearing);
    BearingState state;
    const double speed = speed_of_rpm(45000.0);
    ASSERT_EQ(start_from_ambient(stepper, {0.7 * bearing.clearance, 0.2 * bearing.clearance}, speed, state).status,
              Status::converged);
    OperatingPoint point = point_of(bearing, state, {});
    point.tilt.value = {3e-6, 1e-6};
    ASSERT_EQ(stepper.advance(point, state).status, Status::converged);
    expect_solved(bearing, state);
    expect_stiffness_of_differences(stepper, point, state);
    // At slow motions the impedance is the stiffness, and it has no motions of its own.
    const auto K = stepper.stiffness(state);
    const auto Z = stepper.impedances(state, {{0.0, 1e-3 * speed}, {0.0, speed}});
    ASSERT_TRUE(K && Z);
    EXPECT_LT((Z->front().real() - *K).norm(), 1e-4 * K->norm());
    EXPECT_GT(Z->back().imag().diagonal().minCoeff(), 0.0);  // all four are damped
  }
}

/// With friction crests and feet slide linearly over the width: their three lines stay collinear.
TEST(FilmUnderATiltedJournal, SlidesLinearlyOverTheWidth) {
  Case input = tilted_case(coarse_with_slopes, 100.0);
  input.friction = {.top_bump = 0.1, .bump_sleeve = 0.1};
  SharedBearing bearing;
  const RunningState found = tilted(input, bearing);
  ASSERT_TRUE(found.found());
  expect_solved(*bearing, *found.last);
  const Eigen::Index size = bearing->problem.K.block_size();
  double slope = 0.0;
  double bow = 0.0;
  for (const int unknown : {bearing->structure.dofs.crest_u, bearing->structure.dofs.foot_u.front()}) {
    for (Eigen::Index b = 0; b < bearing->bumps(); ++b) {
      const auto on_line = [&](Eigen::Index s) {
        return found.last->contacts.x[b * size + bearing->place(s, unknown)];
      };
      slope = std::max(slope, std::abs(on_line(2) - on_line(0)));
      bow = std::max(bow, std::abs(on_line(2) - 2.0 * on_line(1) + on_line(0)));
    }
  }
  EXPECT_GT(slope, 1e-8);
  EXPECT_LT(bow, 2e-2 * slope);
}

/// Pads tilt with the journal like a single foil: the moments of three pads add up.
TEST(FilmUnderATiltedJournal, ActsOnPads) {
  Case input = tilted_case({.columns_per_pitch = 4, .rows = 3, .width_modes = 3}, 40.0);
  input.bump_foil.bumps = 8;
  input.pads.resize(3);
  for (std::size_t k = 0; k < 3; ++k) input.pads[k].weld_angle = static_cast<double>(k) * 2.0 * std::numbers::pi / 3.0;
  SharedBearing bearing;
  const RunningState found = tilted(input, bearing);
  ASSERT_TRUE(found.found());
  EXPECT_LT((journal_force(*bearing->film, found.last->film, found.last->speed).head<2>() - Eigen::Vector2d(40.0, 0.0))
                .norm(),
            1e-6);
  EXPECT_GT(found.outcome->moment.x(), 0.0);  // it resists the tilt
}

/// Gas flows through the bearing from the side of higher pressure: inflow at both ends and one side is outflow at the
/// other. Exchanging both pressures gives the mirror image.
TEST(FilmBetweenSidePressures, CarriesGasFromSideToSide) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4, .width_modes = 3});
  input.settings.set(
      EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{50.0, 0.0}}, .paths = ComparedPaths::one});
  const double ambient = input.gas.ambient_pressure;
  input.film.side_pressure = {1.2 * ambient, ambient};
  SharedBearing bearing;
  const RunningState found = tilted(input, bearing);
  ASSERT_TRUE(found.found());
  expect_solved(*bearing, *found.last);
  const FilmFlows& flows = found.outcome->flows;
  EXPECT_LT(flows.sides - flows.right_side, 0.0);
  EXPECT_GT(flows.right_side, 0.0);
  EXPECT_NEAR(flows.start - flows.end - flows.sides, 0.0, 1e-8 * flows.right_side);
  EXPECT_EQ(found.last->tilt.norm(), 0.0);
  EXPECT_GT(found.outcome->moment.norm(), 1e-3);  // N m: the pressure of the fed side presses on it

  std::swap(input.film.side_pressure[0], input.film.side_pressure[1]);
  SharedBearing same;
  const RunningState mirrored = tilted(input, same);
  ASSERT_TRUE(mirrored.found());
  EXPECT_LT((mirrored.last->film.pressure.colwise().reverse() - found.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((mirrored.outcome->moment + found.outcome->moment).norm(), 1e-8 * found.outcome->moment.norm());
}

}  // namespace
}  // namespace bumpfoil
