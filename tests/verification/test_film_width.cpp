// docs/theory/width.md: the film over foils that vary over the width, against an independent prototype.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bumpfoil/bearing/film_bearing_energy.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

/// Equilibria of the reference bearing at 45,000 rpm under a load along +X, without friction, 6 x 16.
struct Reference {
  double load{};                         ///< N
  Eigen::Vector2d position{0.0, 0.0};    ///< um
  double least{}, least_in_mid_plane{};  ///< um
  double max_pressure{};                 ///< P
  double inner[4], outer[4];             ///< loads of bumps 11 to 14 at zeta = 0.34 and 0.861, N
  double parabola[4];                    ///< deflection by P_2 over these crests, um
};
constexpr int first_of_bumps = 10;
const Reference references[]{
    {.load = 50.0,
     .position = {19.081118876, 10.477256725},
     .least = 13.854005821,
     .least_in_mid_plane = 14.028735542,
     .max_pressure = 1.6736144905,
     .inner = {5.4366, 5.9126, 5.8123, 5.271},
     .outer = {2.0506, 2.2837, 2.2875, 2.1081},
     .parabola = {-0.11649, -0.11934, -0.11148, -0.09647}},
    {.load = 100.0,
     .position = {31.507259935, 9.563440462},
     .least = 7.4094685881,
     .least_in_mid_plane = 7.7444266798,
     .max_pressure = 2.4606841118,
     .inner = {10.5863, 12.2009, 12.4065, 11.3353},
     .outer = {4.1333, 4.8798, 5.0328, 4.6486},
     .parabola = {-0.20758, -0.22331, -0.21737, -0.1917}},
    {.load = 150.0,
     .position = {39.995717852, 8.413915657},
     .least = 4.2794198361,
     .least_in_mid_plane = 4.7187796738,
     .max_pressure = 3.2535718638,
     .inner = {15.2194, 18.1904, 18.9961, 17.6728},
     .outer = {6.1969, 7.5671, 7.9675, 7.4236},
     .parabola = {-0.26349, -0.29291, -0.29694, -0.27473}},
};

const FilmResolution parabola_on_6x16{.columns_per_pitch = 6, .rows = 16, .width_modes = 2};

RunningState under(double load, const FilmResolution& resolution, SharedFilmBearing& bearing,
                   const std::optional<PerBump>& pitch = {}) {
  Case input = film_reference_case(resolution);
  if (pitch) input.bump_foil.pitch = *pitch;
  input.equilibrium =
      EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{load, 0.0}}, .paths = ComparedPaths::one};
  EquilibriumResult result = run_equilibrium(input);
  bearing = result.bearing;
  return result.states.front();
}

TEST(FilmOverTheWidth, MeetsThePrototype) {
  for (const Reference& reference : references) {
    SCOPED_TRACE(reference.load);
    SharedFilmBearing bearing;
    const RunningState found = under(reference.load, parabola_on_6x16, bearing);
    ASSERT_TRUE(found.found());
    const BearingState& state = *found.last;
    expect_solved(*bearing, state);
    const double um = 1e6 * bearing->scales.thickness;
    EXPECT_LT((1e6 * state.position - reference.position).norm(), 1e-4 * reference.least);
    EXPECT_NEAR(um * found.outcome->thinnest.thickness, reference.least, 1e-4 * reference.least);
    EXPECT_EQ(found.outcome->thinnest.row, 16);  // at the side
    EXPECT_NEAR(um * state.film.thickness.row(0).minCoeff(), reference.least_in_mid_plane, 1e-4 * reference.least);
    EXPECT_NEAR(found.outcome->max_pressure, reference.max_pressure, 1e-4);
    const FoilFilm& foil = bearing->pads.front().foil;
    const Vector loads = bump_loads(*bearing, state);
    for (int i = 0; i < 4; ++i) {
      const int bump = first_of_bumps + i;
      const Eigen::Index contact = Eigen::Index{bump} * bearing->contacts_per_block();
      // Printed to four digits behind the point, and its contacts give way by a proximal term.
      EXPECT_NEAR(state.contacts.normal_force[contact], reference.inner[i], 2e-3);
      EXPECT_NEAR(state.contacts.normal_force[contact + 1], reference.outer[i], 2e-3);
      EXPECT_NEAR(loads[bump], reference.inner[i] + reference.outer[i], 4e-3);
      const int crest = foil.supports[static_cast<std::size_t>(bump)];
      EXPECT_NEAR(um * (foil.varying * state.film.lift.col(crest))[0], reference.parabola[i], 1e-4);
    }
  }
}

/// A foil that does not stretch stays uniform over the width, but for its free end.
TEST(FilmOverTheWidth, OfAFoilThatDoesNotStretchIsUniform) {
  const FilmResolution coarse{.columns_per_pitch = 4, .rows = 6};
  SharedFilmBearing uniform;
  const RunningState reference = under(80.0, coarse, uniform);
  ASSERT_TRUE(reference.found());
  FilmResolution with_parabola = coarse;
  with_parabola.width_modes = 2;
  FilmBearing bearing = film_reference_bearing(with_parabola);
  FoilFilm& foil = bearing.pads.front().foil;
  const double R = bearing.scales.radius / foil.pitch;
  const double half_width = foil.mesh.rows * foil.mesh.dzeta * R;
  foil.membrane =
      membrane_rows(make_membrane({2}, half_width, R, 1e12, 0.29), R * foil.mesh.dtheta * foil.mesh.intervals);
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(cold_start(stepper, reference.last->position, reference.last->speed, state).status, Status::converged);
  const Vector parabola = (foil.varying * state.film.lift).row(0).transpose();
  EXPECT_LT(parabola.head(foil.mesh.columns).cwiseAbs().maxCoeff(), 1e-6);  // of c; 0.01 with the foil's own stretch
  // Both came to the same state, by other paths.
  EXPECT_LT((film_bearing_outcome(bearing, state).force - reference.outcome->force).norm(), 1e-5 * 80.0);
}

/// Pitches that are equal are those of any foil, to the last bit; where they differ columns stand at distances of their
/// own, and the film is thinner than under a uniform foil by about as much as with equal ones.
TEST(FilmOverTheWidth, TakesPitchesThatDiffer) {
  const FilmResolution coarse{.columns_per_pitch = 4, .rows = 6, .width_modes = 2};
  SharedFilmBearing bearing;
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
    SharedFilmBearing uniform;
    return 1.0 -
           with_parabola.outcome->thinnest.thickness / under(80.0, plain, uniform, pitch).outcome->thinnest.thickness;
  };
  EXPECT_GT(thinning(equal, {}), 5e-3);
  EXPECT_NEAR(thinning(varying, graded), thinning(equal, {}), 5e-3);
}

/// Stiffness is the derivative of the force, with all that varies over the width.
TEST(FilmOverTheWidth, StiffnessIsTheDerivativeOfTheForce) {
  const FilmBearing bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4, .width_modes = 2});
  FilmStepper stepper(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  const Eigen::Vector2d position(0.8 * bearing.clearance, 0.2 * bearing.clearance);
  ASSERT_EQ(cold_start(stepper, position, speed, state).status, Status::converged);
  const auto K = stepper.stiffness(state);
  ASSERT_TRUE(K.has_value());
  const auto held = stepper.held_motion(state);
  ASSERT_TRUE(held.has_value());  // its residual in the equations of all unknowns is small, or there is none
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

/// With friction all lines of a crest slide as one, and carry no more than f times their loads.
TEST(FilmOverTheWidth, CrestsSlideAsOneOverTheWidth) {
  const FilmBearing bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4, .width_modes = 2}, 0.1);
  FilmStepper stepper(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  ASSERT_EQ(cold_start(stepper, {0.1 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
  for (int i = 2; i <= 10; ++i) {
    const Eigen::Vector2d position(0.1 * i * bearing.clearance, 0.0);
    ASSERT_EQ(stepper.advance(OperatingPoint::held_at(position, speed), state).status, Status::converged) << i;
  }
  expect_solved(bearing, state);
  const Eigen::Index size = bearing.problem.K.block_size();
  double largest = 0.0;
  double largest_difference = 0.0;
  for (Eigen::Index b = 0; b < bearing.bumps(); ++b) {
    const double inner = state.contacts.x[b * size + bearing.crest_lines[0].crest_u];
    const double outer = state.contacts.x[b * size + bearing.crest_lines[1].crest_u];
    largest = std::max(largest, std::abs(inner));
    largest_difference = std::max(largest_difference, std::abs(inner - outer));
  }
  EXPECT_GT(largest, 1e-7);
  EXPECT_LT(largest_difference, 1e-2 * largest);
}

}  // namespace
}  // namespace bumpfoil
