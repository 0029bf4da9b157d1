#include "bumpfoil/bearing/film_bearing_solver.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "bumpfoil/contact/residual.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

constexpr FilmResolution coarse{.columns_per_pitch = 4, .rows = 4};

/// The equations themselves, judged without any part of the solver: the film, the foil with its contact forces, the
/// bump foil, and every inequality of the contacts.
void expect_solved(const FilmBearing& bearing, const BearingState& state) {
  const FilmMesh& mesh = bearing.pads.front().foil.mesh;
  EXPECT_GT(state.film.pressure.minCoeff(), 0.0);
  EXPECT_GT(state.film.thickness.minCoeff(), 0.0);
  Matrix H = bearing.undeformed_thickness(state.position);
  H.rowwise() += state.film.lift.transpose();
  EXPECT_LT((H - state.film.thickness).cwiseAbs().maxCoeff(), 1e-12);

  FoilFilmResidual residual;
  foil_film_residual(bearing.pads.front().foil, film_equation(bearing, bearing.pads.front(), state.speed), state.film,
                     residual);
  const double area = mesh.dtheta * mesh.dzeta;
  EXPECT_LT(residual.film.block(0, 1, mesh.rows, mesh.columns - 1).cwiseAbs().maxCoeff(), 1e-9 * area);
  EXPECT_LT(residual.compatibility.cwiseAbs().maxCoeff(), 1e-10);

  // What the film and the foil leave over the crests is what the contacts bear.
  const double unit = bearing.pads.front().foil.stiffness * bearing.scales.thickness;
  const Vector forces = contact_forces(bearing.problem, state.contacts.normal_force, state.contacts.friction_force);
  const int size = bearing.problem.K.block_size();
  Vector elastic = bearing.problem.K.multiply(state.contacts.x);
  elastic.tail(size).setZero();
  for (std::size_t i = 0; i < bearing.pads.front().foil.supports.size(); ++i) {
    const Eigen::Index place = static_cast<Eigen::Index>(i) * size + bearing.dofs().top_u;
    double& balance = residual.balance[bearing.pads.front().foil.supports[i]];
    elastic[place] = balance * unit;
    balance = 0.0;
    EXPECT_NEAR(state.contacts.x[place],
                state.film.lift[bearing.pads.front().foil.supports[i]] * bearing.scales.thickness, 1e-15);
  }
  EXPECT_LT(residual.balance.cwiseAbs().maxCoeff() * unit, 1e-8);  // N
  const ContactLoading loading{.initial_gap = bearing.initial_gap, .load = Vector::Zero(forces.size())};
  const ContactResiduals residuals =
      contact_residuals(bearing.problem, elastic, loading, state.slip_origin, state.contacts);
  EXPECT_TRUE(residuals.within(1e-7, 1e-11)) << residuals.equilibrium << ' ' << residuals.penetration;
}

TEST(FilmBearingSolver, ColdStartsAndFollowsToSolutions) {
  const FilmBearing bearing = film_reference_bearing(coarse);
  FilmBearingSolver solver(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  const Eigen::Vector2d position(0.7 * bearing.clearance, 0.0);
  ASSERT_EQ(solver.cold_start(position, speed, state).status, FilmStatus::converged);
  EXPECT_EQ(state.position, position);
  expect_solved(bearing, state);
  ASSERT_EQ(solver.follow(OperatingPoint::held_at(2.0 * position, speed), state).status, FilmStatus::converged);
  EXPECT_EQ(state.position, 2.0 * position);
  expect_solved(bearing, state);
  ASSERT_EQ(solver.follow(OperatingPoint::held_at(2.0 * position, 0.5 * speed), state).status, FilmStatus::converged);
  EXPECT_EQ(state.speed, 0.5 * speed);
  expect_solved(bearing, state);
}

TEST(FilmBearingSolver, KeepsTheHistoryOfFriction) {
  const FilmBearing bearing = film_reference_bearing(coarse, 0.1);
  FilmBearingSolver solver(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  const auto at = [&](double e) { return Eigen::Vector2d(e * bearing.clearance, 0.0); };
  ASSERT_EQ(solver.cold_start(at(0.5), speed, state).status, FilmStatus::converged);
  expect_solved(bearing, state);
  const double loaded = film_bearing_outcome(bearing, state).force.x();
  for (const double e : {0.8, 0.5}) {
    ASSERT_EQ(solver.solve(OperatingPoint::held_at(at(e), speed), state).status, FilmStatus::converged);
    expect_solved(bearing, state);
  }
  EXPECT_LT(film_bearing_outcome(bearing, state).force.x(),
            0.95 * loaded);  // there and back: friction holds bumps down
}

TEST(FilmBearingSolver, SaysWhenThereIsNoRoomAndLeavesTheStateAsItWas) {
  const FilmBearing bearing = film_reference_bearing(coarse);
  FilmBearingSolver solver(bearing);
  const BearingState rest = resting(bearing, Eigen::Vector2d::Zero(), 0.0);
  BearingState state = rest;
  const Eigen::Vector2d outside(1.2 * bearing.clearance, 0.0);
  EXPECT_EQ(solver.cold_start(outside, 1000.0, state).status, FilmStatus::no_room);
  EXPECT_EQ(state.film.pressure, rest.film.pressure);
  EXPECT_EQ(state.position, rest.position);
  // With foils that give way on the way there is.
  ASSERT_EQ(solver.follow(OperatingPoint::held_at(outside, 4000.0), state).status, FilmStatus::converged);
  EXPECT_EQ(state.position, outside);
}

/// Gas that enters at the weld, off which the load takes the journal. Judged by the equations of the bearing as it is:
/// nothing of the way there enters them.
TEST(FilmBearingSolver, ClosesTheClearanceOfAJournalAtWork) {
  const double speed = speed_of_rpm(-45000.0);
  const Eigen::Vector2d load(150.0, 0.0);
  for (const double clearance : {5e-6, 0.0, -3e-6}) {
    for (const double f : {0.0, 0.1}) {
      if (clearance < 0.0 && f > 0.0) continue;  // touches
      SCOPED_TRACE(testing::Message() << clearance << ' ' << f);
      Case input = film_reference_case(coarse, f);
      input.bearing.radial_clearance = clearance;
      const FilmBearing bearing = make_film_bearing(input);
      FilmBearingSolver solver(bearing);
      BearingState state;
      const double opening = 10e-6 - clearance;
      ASSERT_EQ(solver.cold_start({5e-6, 0.0}, speed, state, opening).status, FilmStatus::converged);
      EXPECT_EQ(state.opening, opening);
      OperatingPoint loaded = OperatingPoint::loaded_by(load, speed, opening);
      ASSERT_EQ(solver.follow(loaded, state).status, FilmStatus::converged);
      EXPECT_EQ(state.opening, opening);
      loaded.opening = 0.0;
      ASSERT_EQ(solver.follow(loaded, state).status, FilmStatus::converged);
      EXPECT_EQ(state.opening, 0.0);
      expect_solved(bearing, state);
      EXPECT_LT((film_force(bearing, state.film.pressure) - load).norm(), 1e-7);  // N
      EXPECT_GT(state.position.x(), -clearance);
      if (clearance <= 0.0) {
        EXPECT_GT(bump_loads(bearing, state).minCoeff(), -1e-9);  // N
        continue;
      }
      if (f > 0.0) continue;
      // A clearance that need not be opened: the same state.
      BearingState direct;
      ASSERT_EQ(solver.cold_start({0.6 * clearance, 0.0}, speed, direct).status, FilmStatus::converged);
      ASSERT_EQ(solver.follow(loaded, direct).status, FilmStatus::converged);
      EXPECT_LT((direct.position - state.position).norm(), 1e-8 * clearance);
      EXPECT_LT((direct.film.pressure - state.film.pressure).cwiseAbs().maxCoeff(), 1e-7);
    }
  }
}

TEST(FilmBearingSolver, SaysWhenSurfacesTouch) {
  const FilmBearing bearing = film_reference_bearing(coarse);
  FilmBearingSolver solver(bearing, {.newton = {.thickness_floor = 0.5}});
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  ASSERT_EQ(solver.cold_start({0.2 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
  EXPECT_EQ(solver.follow(OperatingPoint::held_at({0.9 * bearing.clearance, 0.0}, speed), state).status,
            FilmStatus::touchdown);
  EXPECT_GE(state.film.thickness.minCoeff(), 0.5);  // the last good state
  EXPECT_GT(state.position.x(), 0.2 * bearing.clearance);
}

TEST(FilmBearingSolver, StiffnessIsTheDerivativeOfTheForce) {
  const double speed = speed_of_rpm(45000.0);
  const FilmBearing bearing = film_reference_bearing(coarse);
  FilmBearingSolver solver(bearing);
  BearingState state;
  const Eigen::Vector2d position(0.6 * bearing.clearance, 0.1 * bearing.clearance);
  ASSERT_EQ(solver.cold_start(position, speed, state).status, FilmStatus::converged);
  const auto motion = solver.slow_motion(state);
  const auto K = solver.stiffness(state);
  ASSERT_TRUE(motion && K && motion->stiffness == *K);
  double response = 0.0;      // of the foil
  constexpr double h = 1e-9;  // m; no contact changes its mode over so little
  for (const int axis : {0, 1}) {
    Eigen::Vector2d force[2];
    Vector lift[2];
    for (const int side : {0, 1}) {
      BearingState moved = state;
      const Eigen::Vector2d there = position + (side == 0 ? -h : h) * Eigen::Vector2d::Unit(axis);
      ASSERT_EQ(solver.solve(OperatingPoint::held_at(there, speed), moved).status, FilmStatus::converged);
      force[side] = film_bearing_outcome(bearing, moved).force;
      lift[side] = bearing.scales.thickness * moved.film.lift;
    }
    response = std::max(response, (lift[1] - lift[0]).cwiseAbs().maxCoeff() / (2.0 * h));
    // Forces of tens of newtons are good to 1e-9 N: 1e-6 of a few MN/m.
    EXPECT_LT(((force[1] - force[0]) / (2.0 * h) - K->col(axis)).norm(), 3e-6 * K->norm());
  }
  EXPECT_NEAR(motion->foil_response, response, 1e-5 * response);
}

/// Near the end of a branch the tangent leads nowhere: under the load that lies behind it the foil jumps, once, and
/// says so. (Newton's method reaches a state there in one solve, too: any.)
TEST(FilmBearingSolver, JumpsWhereTheBranchUnderALoadEnds) {
  const double speed = speed_of_rpm(45000.0);
  const FilmBearing bearing = film_reference_bearing({.columns_per_pitch = 6, .rows = 8}, 0.1);
  const auto end_of = [&](int steps) {
    FilmBearingSolver solver(bearing);
    BearingState state;
    EXPECT_EQ(solver.cold_start({0.6 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
    const Eigen::Vector2d from = film_force(bearing, state.film.pressure);
    int jumps = 0;
    for (int i = 1; i <= steps; ++i) {
      const Eigen::Vector2d load = from + static_cast<double>(i) / steps * (Eigen::Vector2d(20.0, 0.0) - from);
      const FilmReport report = solver.follow(OperatingPoint::loaded_by(load, speed), state);
      EXPECT_EQ(report.status, FilmStatus::converged);
      jumps += report.jumps;
    }
    return std::pair(jumps, film_bearing_outcome(bearing, state).loaded_bumps);
  };
  EXPECT_EQ(end_of(10), end_of(30));
  EXPECT_GT(end_of(10).first, 0);
}

TEST(FilmBearingSolver, StuckContactsAreStiffer) {
  const double speed = speed_of_rpm(45000.0);
  const FilmBearing bearing = film_reference_bearing(coarse, 0.1);
  FilmBearingSolver solver(bearing);
  BearingState state;
  ASSERT_EQ(solver.cold_start({0.8 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
  const auto slipping = solver.stiffness(state);
  const auto stuck = solver.stiffness(state, true);
  ASSERT_TRUE(slipping.has_value() && stuck.has_value());
  EXPECT_GT((*stuck)(0, 0), 1.1 * (*slipping)(0, 0));
}

TEST(FilmBearingSolver, ImpedanceAtRestIsTheStiffness) {
  const double speed = speed_of_rpm(45000.0);
  const FilmBearing bearing = film_reference_bearing(coarse, 0.1);
  FilmBearingSolver solver(bearing);
  BearingState state;
  ASSERT_EQ(solver.cold_start({0.8 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
  for (const bool stuck : {false, true}) {
    const auto K = solver.stiffness(state, stuck);
    const std::complex<double> whirl(0.0, speed);
    const auto Z = solver.impedances(state, {0.0, whirl, std::conj(whirl)}, stuck);
    ASSERT_TRUE(K.has_value() && Z.has_value() && Z->size() == 3);
    EXPECT_LT(((*Z)[0] - *K).norm(), 1e-8 * K->norm());
    EXPECT_LT(((*Z)[1] - (*Z)[2].conjugate()).norm(), 1e-12 * K->norm());
    EXPECT_GT((*Z)[1].imag()(0, 0), 0.0);
    // What else is asked for decides where the equations are factored.
    const auto alone = solver.impedances(state, {whirl / 7.0}, stuck);
    const auto with_others = solver.impedances(state, {whirl / 7.0, 5.0 * whirl}, stuck);
    ASSERT_TRUE(alone.has_value() && with_others.has_value());
    EXPECT_LT(((*alone)[0] - (*with_others)[0]).norm(), 1e-8 * K->norm());
    EXPECT_GT(((*alone)[0] - (*Z)[0]).norm(), 1e-3 * K->norm());
  }
}

TEST(FilmBearingSolver, FindsThePositionThatCarriesALoad) {
  const FilmBearing bearing = film_reference_bearing(coarse);
  FilmBearingSolver solver(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  ASSERT_EQ(solver.cold_start({0.6 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
  const Eigen::Vector2d load(40.0, 0.0);
  const BearingState start = state;
  ASSERT_EQ(solver.follow(OperatingPoint::loaded_by(load, 0.8 * speed), state).status, FilmStatus::converged);
  EXPECT_EQ(state.speed, 0.8 * speed);
  // Newton's last step moved P by less than 1e-9: some 1e-8 N.
  EXPECT_LT((film_bearing_outcome(bearing, state).force - load).norm(), 1e-7);
  EXPECT_GT(state.position.y(), 0.0);  // the journal leans in the sense of rotation
  expect_solved(bearing, state);

  // Let go, the journal comes to rest where it carries the load, if not in the same state.
  BearingState released = start;
  ASSERT_EQ(solver.settle(OperatingPoint::loaded_by(load, 0.8 * speed), released).status, FilmStatus::converged);
  EXPECT_LT((film_bearing_outcome(bearing, released).force - load).norm(), 1e-7);
  expect_solved(bearing, released);
}

TEST(FilmBearingSolver, StopsWhenTold) {
  const FilmBearing bearing = film_reference_bearing(coarse);
  int solves = 0;
  FilmBearingSolver solver(bearing, {.keep_going = [&] { return ++solves < 5; }});
  BearingState state;
  EXPECT_EQ(solver.cold_start({0.6 * bearing.clearance, 0.0}, 4000.0, state).status, FilmStatus::interrupted);
  EXPECT_EQ(solves, 5);
}

}  // namespace
}  // namespace bumpfoil
