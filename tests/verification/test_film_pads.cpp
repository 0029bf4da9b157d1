// The film of a bearing with pads, against bearings without pads, against single pads, and by identities.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/bearing_cases.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

constexpr double third_of_turn = 2.0 * std::numbers::pi / 3.0;
const double speed = speed_of_rpm(45000.0);
const FilmResolution coarse{.columns_per_pitch = 4, .rows = 6};

/// Pads of eight bumps each, at equal angles.
Case film_pads(std::size_t pads, const FilmResolution& resolution = coarse) {
  Case input = film_reference_case(resolution, 0.1);
  input.bump_foil.bumps = 8;
  input.pads.assign(pads, {.lobe = 8e-6});
  return input;
}

/// Pads that differ in every respect.
Case unlike_pads(const FilmResolution& resolution = coarse) {
  Case input = film_pads(3, resolution);
  input.pads[0].lobe = 4e-6;
  input.pads[1].weld_edge = WeldEdge::trailing;
  input.pads[2].bump_foil = input.bump_foil;
  input.pads[2].bump_foil->bumps = 6;
  input.pads[2].bump_foil->thickness = 0.12e-3;
  input.pads[2].bump_foil->height_errors = {0.0, 2e-6, -1e-6, 0.0, 1e-6, 0.0};
  input.pads[2].top_foil = input.top_foil;
  input.pads[2].top_foil->thickness = 0.12e-3;
  input.pads[2].arc = 1.8;
  return input;
}

/// A bearing with its journal held, from ambient pressure.
struct Running {
  Running(const Case& input, const Eigen::Vector2d& position, double rate = speed) : stepper(make_film_bearing(input)) {
    EXPECT_EQ(start_from_ambient(stepper, position, rate, state).status, Status::converged);
    outcome = film_bearing_outcome(stepper.bearing(), state);
  }
  FilmStepper stepper;
  BearingState state;
  FilmBearingOutcome outcome;
};

TEST(FilmPads, OneIsTheBearingWithoutPads) {
  const Case plain = film_reference_case(coarse, 0.1);
  Case padded = plain;
  padded.pads.resize(1);
  const Running a(plain, {15e-6, 4e-6});
  const Running b(padded, {15e-6, 4e-6});
  EXPECT_EQ(a.state.film.pressure, b.state.film.pressure);
  EXPECT_EQ(a.state.contacts.x, b.state.contacts.x);
  EXPECT_EQ(a.outcome.force, b.outcome.force);
  EXPECT_EQ(a.outcome.torque, b.outcome.torque);
  EXPECT_EQ(b.outcome.pad_forces.cols(), 0);
}

TEST(FilmPads, TurnWithTheLoadWhereTheyAreEqual) {
  const Case input = film_pads(3);
  const Eigen::Vector2d position(11e-6, 7e-6);
  const Eigen::Rotation2Dd turn(third_of_turn);
  Running here(input, position);
  Running there(input, turn * position);
  const double size = here.outcome.force.norm();
  ASSERT_GT(size, 10.0);
  EXPECT_LT((turn * here.outcome.force - there.outcome.force).norm(), 1e-9 * size);
  EXPECT_NEAR(here.outcome.torque, there.outcome.torque, 1e-9 * here.outcome.torque);
  // Pad 1 now carries the force of pad 2: pads are numbered against the turn.
  for (Eigen::Index k = 0; k < 3; ++k) {
    EXPECT_LT((turn * here.outcome.pad_forces.col((k + 1) % 3) - there.outcome.pad_forces.col(k)).norm(), 1e-9 * size);
  }
  const Eigen::Vector2d load(20.0, -30.0);
  ASSERT_EQ(follow(here.stepper, OperatingPoint::loaded_by(load, speed), here.state).status, Status::converged);
  ASSERT_EQ(follow(there.stepper, OperatingPoint::loaded_by(turn * load, speed), there.state).status,
            Status::converged);
  EXPECT_LT((film_force(here.stepper.film(), here.state.film.pressure) - load).norm(), 1e-7 * load.norm());
  EXPECT_LT((turn * here.state.position - there.state.position).norm(), 1e-9 * here.stepper.bearing().clearance);
}

TEST(FilmPads, ALobeIsAShiftedJournal) {
  Case lobed = film_pads(1);
  Case plain = lobed;
  plain.pads[0].lobe = 0.0;
  const Vector middle =
      polar_angles(plain.bearing, Vector::Constant(1, 0.5 * foil_angle(place_pads(plain).front().alone)));
  const Eigen::Vector2d shift = lobed.pads[0].lobe * Eigen::Vector2d(std::cos(middle[0]), std::sin(middle[0]));
  const Eigen::Vector2d position(-4e-6, 6e-6);
  const Running a(lobed, position);
  const Running b(plain, position + shift);
  ASSERT_GT(a.outcome.force.norm(), 1.0);
  EXPECT_LT((a.outcome.force - b.outcome.force).norm(), 1e-9 * a.outcome.force.norm());
  EXPECT_NEAR(a.outcome.power, b.outcome.power, 1e-9 * a.outcome.power);
}

/// A pad about X, welded at one edge or the other: with the speed reversed each is the mirror image of the other.
TEST(FilmPads, WeldedAtTheOtherEdgeMirrorTheForce) {
  Case leading = film_pads(1);
  leading.bearing.weld_angle = 0.5 * foil_angle(place_pads(leading).front().alone);
  Case trailing = leading;
  trailing.pads[0].weld_edge = WeldEdge::trailing;
  const Running a(leading, {14e-6, 5e-6});
  const Running b(trailing, {14e-6, -5e-6}, -speed);
  ASSERT_GT(std::abs(a.outcome.force.y()), 1.0);
  EXPECT_NEAR(a.outcome.force.x(), b.outcome.force.x(), 1e-9 * a.outcome.force.norm());
  EXPECT_NEAR(a.outcome.force.y(), -b.outcome.force.y(), 1e-9 * a.outcome.force.norm());
  EXPECT_NEAR(a.outcome.torque, -b.outcome.torque, 1e-9 * a.outcome.torque);
  // Not so without reversing the speed.
  EXPECT_GT((a.outcome.force - Running(trailing, {14e-6, 5e-6}).outcome.force).norm(), 0.01 * a.outcome.force.norm());
}

/// Forces, torque, flows, stiffness and impedances of pads add up, and foils deflect as in a single pad.
TEST(FilmPads, AddUp) {
  const Case input = unlike_pads();
  const Eigen::Vector2d position(9e-6, -8e-6);
  Running all(input, position);
  const std::vector<std::complex<double>> rates{{0.0, 0.5 * speed}, {0.0, speed}};
  const auto stiffness = all.stepper.stiffness(all.state);
  const auto impedances = all.stepper.impedances(all.state, rates);
  ASSERT_TRUE(stiffness && impedances);
  Eigen::Vector2d force(0.0, 0.0);
  double torque = 0.0;
  double sides = 0.0;
  double thinnest = 1.0;
  Eigen::Matrix2d K = Eigen::Matrix2d::Zero();
  Eigen::Matrix2cd Z = Eigen::Matrix2cd::Zero();
  const double size = all.outcome.force.norm();
  const Vector loads = bump_loads(all.stepper.bearing(), all.state);
  Eigen::Index bump = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Running one(pad_alone(input, k), position);
    force += one.outcome.force;
    torque += one.outcome.torque;
    sides += one.outcome.flows.sides;
    K += *one.stepper.stiffness(one.state);
    Z += one.stepper.impedances(one.state, rates)->back();
    // Newton's last step is below 1e-9 of c in each solution.
    EXPECT_LT((all.outcome.pad_forces.col(static_cast<Eigen::Index>(k)) - one.outcome.force).norm(), 1e-7 * size) << k;
    const Vector own = bump_loads(one.stepper.bearing(), one.state);
    EXPECT_LT((loads.segment(bump, own.size()) - own).cwiseAbs().maxCoeff(), 1e-6 * loads.maxCoeff()) << k;
    bump += own.size();
    if (one.outcome.thinnest.thickness < thinnest) {
      thinnest = one.outcome.thinnest.thickness;
      EXPECT_GE(all.outcome.thinnest_pad, static_cast<int>(k));
    }
  }
  EXPECT_EQ(bump, loads.size());
  EXPECT_LT((all.outcome.pad_forces.rowwise().sum() - all.outcome.force).norm(), 1e-13 * size);
  EXPECT_LT((force - all.outcome.force).norm(), 1e-7 * size);
  EXPECT_NEAR(torque, all.outcome.torque, 1e-7 * torque);
  EXPECT_NEAR(sides, all.outcome.flows.sides, 1e-7 * std::abs(sides));
  EXPECT_NEAR(thinnest, all.outcome.thinnest.thickness, 1e-7);
  EXPECT_LT((K - *stiffness).norm(), 1e-6 * K.norm());
  EXPECT_LT((Z - impedances->back()).norm(), 1e-6 * Z.norm());
}

/// The stiffness is the derivative of the force, and finds the journal position under a load.
TEST(FilmPads, CarryALoad) {
  Case input = unlike_pads();
  input.friction = {.top_bump = 0.0, .bump_sleeve = 0.0};
  Running pads(input, {6e-6, -6e-6});
  const Eigen::Vector2d load(25.0, -10.0);
  ASSERT_EQ(follow(pads.stepper, OperatingPoint::loaded_by(load, speed), pads.state).status, Status::converged);
  EXPECT_LT((film_bearing_outcome(pads.stepper.bearing(), pads.state).force - load).norm(), 1e-7 * load.norm());
  const auto K = pads.stepper.stiffness(pads.state);
  ASSERT_TRUE(K);
  const double step = 1e-9;
  for (const int axis : {0, 1}) {
    std::array<Eigen::Vector2d, 2> forces;
    for (const int side : {0, 1}) {
      BearingState moved = pads.state;
      const Eigen::Vector2d there = pads.state.position + (side == 0 ? -step : step) * Eigen::Vector2d::Unit(axis);
      ASSERT_EQ(pads.stepper.advance(OperatingPoint::held_at(there, speed), moved).status, Status::converged);
      forces[static_cast<std::size_t>(side)] = film_force(pads.stepper.film(), moved.film.pressure);
    }
    const Eigen::Vector2d rate = (forces[1] - forces[0]) / (2.0 * step);
    // Round-off in differences of 25 N over 2 nm, and curvature.
    EXPECT_LT((rate - K->col(axis)).norm(), 1e-4 * K->norm());
  }
}

TEST(FilmPads, KeepTheirBalances) {
  double energy[2], moments[2];
  for (const int i : {0, 1}) {
    const Running pads(unlike_pads({.columns_per_pitch = 6 << i, .rows = 8 << i}), {10e-6, 3e-6});
    const FilmFlows& flows = pads.outcome.flows;
    EXPECT_NEAR(flows.start, flows.end + flows.sides, 1e-12 * std::abs(flows.sides));
    energy[i] = std::abs(pads.outcome.dissipation / pads.outcome.power - 1.0);
    moments[i] = std::abs(pads.outcome.torque_of_moments / pads.outcome.torque - 1.0);
  }
  // Second order: a quarter.
  EXPECT_LT(energy[0], 1e-4);
  EXPECT_LT(moments[0], 1e-4);
  EXPECT_LT(energy[1], 0.4 * energy[0]);
  EXPECT_LT(moments[1], 0.4 * moments[0]);
}

/// Foils and bumps made 1e9 times stiffer act as rigid arcs.
TEST(FilmPads, TendToRigidArcs) {
  BearingModel bearing = make_film_bearing(unlike_pads());
  const Eigen::Vector2d position(6e-6, 4e-6);
  const Matrix H = undeformed_thickness(bearing, position);
  Eigen::Vector2d force(0.0, 0.0);
  constexpr double stiffer = 1e9;
  for (FilmPad& pad : bearing.film->pads) {
    const SolvedFilm rigid = solve_rigid_film(film_equation(*bearing.film, pad, speed), part_of(pad, H));
    ASSERT_EQ(rigid.report.status, Status::converged);
    Matrix pressure = bearing.film->field(1.0);
    pressure(Eigen::all, pad.columns()) = rigid.film.pressure;
    force += film_force(*bearing.film, pressure);
    pad.foil.top_foil.compliance_diagonal /= stiffer;
    pad.foil.top_foil.compliance_off /= stiffer;
    pad.foil.stiffness *= stiffer;
    pad.foil.load_scale /= stiffer;
  }
  for (Matrix& block : bearing.problem.K.diagonal) block *= stiffer;
  for (Matrix& block : bearing.problem.K.upper) block *= stiffer;
  BearingState state;
  // Heights differ: stiff foils would not reach the lower crests.
  bearing.assembled_gap.setZero();
  FilmStepper stepper(bearing);
  ASSERT_EQ(start_from_ambient(stepper, position, speed, state).status, Status::converged);
  const Eigen::Vector2d found = film_force(*bearing.film, state.film.pressure);
  EXPECT_LT((found - force).norm(), 5e-6 * force.norm());
  EXPECT_GT((found - force).norm(), 1e-12 * force.norm());
}

}  // namespace
}  // namespace bumpfoil
