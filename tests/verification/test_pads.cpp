#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/analysis/foils.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/pads.hpp"
#include "support/bearing_cases.hpp"

/// Bearings of pads against bearings without, and against pads alone.
namespace bumpfoil {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double third = 2.0 * pi / 3.0;

/// Pads of seven bumps each, at equal angles, in an interference that presses all of them.
Case pressed_pads(std::size_t pads, BumpFoilModel model = BumpFoilModel::truss) {
  Case input = reference_case();
  input.bearing.radial_clearance = -3e-6;
  input.bump_foil.model = model;
  input.bump_foil.bumps = 7;
  input.pads.resize(pads);
  input.cycle.amplitude.value = 20e-6;
  input.cycle.steps = 8;
  return input;
}

/// The pad alone where it is.
Case alone(const Case& input, std::size_t pad) {
  Case one = place_pads(input)[pad].alone;
  one.pads.push_back({.lobe = input.pads[pad].lobe});
  return one;
}

/// @param part  of the largest force
void expect_forces(const Cycle& cycle, const std::vector<Cycle>& summands, double part) {
  ASSERT_TRUE(cycle.converged());
  const double largest = cycle.turning_point->max_force;
  ASSERT_GT(largest, 1.0);
  for (std::size_t k = 0; k < cycle.increments.size(); ++k) {
    double x = 0.0;
    double y = 0.0;
    for (const Cycle& summand : summands) {
      ASSERT_TRUE(summand.converged());
      x += summand.increments[k].force_x;
      y += summand.increments[k].force_y;
    }
    ASSERT_NEAR(cycle.increments[k].force_x, x, part * largest) << k;
    ASSERT_NEAR(cycle.increments[k].force_y, y, part * largest) << k;
  }
}

TEST(Pads, OneIsTheBearingWithoutPads) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case plain = reference_case();
    plain.bump_foil.model = model;
    plain.cycle.steps = 8;
    Case padded = plain;
    padded.pads.resize(1);
    const Cycle a = run_single_cycle(plain, 0.5 * pi);
    const Cycle b = run_single_cycle(padded, 0.5 * pi);
    ASSERT_TRUE(a.converged() && b.converged());
    for (std::size_t k = 0; k < a.increments.size(); ++k) {
      EXPECT_EQ(a.increments[k].force_x, b.increments[k].force_x);
      EXPECT_EQ(a.increments[k].force_y, b.increments[k].force_y);
      EXPECT_EQ(a.increments[k].elastic_energy, b.increments[k].elastic_energy);
    }
    EXPECT_EQ(a.fields.foot_u, b.fields.foot_u);
    EXPECT_EQ(a.fields.stress.top_weld, b.fields.stress.top_weld);
    EXPECT_EQ(b.fields.pad_force_x.cols(), 0);
  }
}

TEST(Pads, ThatNothingTouchesChangeNothing) {
  Case both = pressed_pads(2);
  both.bearing.radial_clearance = 10e-6;  // the journal leaves pad 2, which faces -X
  both.bearing.weld_angle = 0.5 * 7 * both.bump_foil.pitch.values.front() / both.bearing.radius;
  both.cycle.amplitude.value = 40e-6;
  const Cycle cycle = run_single_cycle(both, 0.0);
  expect_forces(cycle, {run_single_cycle(alone(both, 0), 0.0)}, 1e-9);
  EXPECT_EQ(cycle.fields.pad_force_x.col(1).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(cycle.turning_point->pad_forces_x[0], cycle.turning_point->max_force);
}

TEST(Pads, AddTheirForces) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    for (const SolverName solver : {SolverName::newton, SolverName::events}) {
      Case input = pressed_pads(3, model);
      input.solver.name = solver;
      input.pads[0].lobe = 4e-6;
      input.pads[1].weld_edge = WeldEdge::trailing;
      input.pads[2].bump_foil = input.bump_foil;
      input.pads[2].bump_foil->bumps = 5;
      input.pads[2].bump_foil->pitch = 4.6e-3;
      input.pads[2].bump_foil->thickness = 0.12e-3;
      const double direction = 0.7;
      const Cycle cycle = run_single_cycle(input, direction);
      std::vector<Cycle> each;
      for (std::size_t k = 0; k < 3; ++k) each.push_back(run_single_cycle(alone(input, k), direction));
      expect_forces(cycle, each, 1e-9);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto pad = static_cast<Eigen::Index>(k);
        for (std::size_t i = 0; i < cycle.increments.size(); ++i) {
          EXPECT_NEAR(cycle.fields.pad_force_y(static_cast<Eigen::Index>(i), pad), each[k].increments[i].force_y,
                      1e-9 * cycle.turning_point->max_force);
        }
        const double weld = each[k].fields.stress.top_weld.maxCoeff();
        EXPECT_NEAR(cycle.fields.stress.top_weld.col(pad).maxCoeff(), weld, 1e-9 * weld);
      }
      Eigen::Index first = 0;
      for (const Cycle& one : each) {
        const Eigen::Index bumps = one.fields.compression.cols();
        const auto part = cycle.fields.compression.middleCols(first, bumps);
        EXPECT_LT((part - one.fields.compression).cwiseAbs().maxCoeff(), 1e-9 * one.fields.compression.maxCoeff());
        const auto stress = cycle.fields.stress.top_crest.middleCols(first, bumps);
        const FieldMatrix& alone_stress = one.fields.stress.top_crest;
        EXPECT_LT((stress - alone_stress).cwiseAbs().maxCoeff(), 1e-9 * alone_stress.maxCoeff());
        first += bumps;
      }
    }
  }
}

TEST(Pads, OfLargeDisplacementsAddTheirForces) {
  Case input = pressed_pads(2, BumpFoilModel::frame);
  input.bump_foil.geometry = Geometry::nonlinear;
  input.pads[1].bump_foil = input.bump_foil;
  input.pads[1].bump_foil->pitch = 5e-3;
  const Cycle cycle = run_single_cycle(input, 0.3);
  expect_forces(cycle, {run_single_cycle(alone(input, 0), 0.3), run_single_cycle(alone(input, 1), 0.3)}, 1e-7);
}

TEST(Pads, EqualOnesAtEqualAnglesTurnTheForceWithTheLoad) {
  Case input = pressed_pads(3);
  for (Pad& pad : input.pads) pad.lobe = 5e-6;
  const Cycle first = run_single_cycle(input, 0.2);
  for (const double turned : {third, 2.0 * third}) {
    const Cycle other = run_single_cycle(input, 0.2 + turned);
    ASSERT_TRUE(first.converged() && other.converged());
    for (std::size_t k = 0; k < first.increments.size(); ++k) {
      EXPECT_NEAR(other.increments[k].force_direct, first.increments[k].force_direct,
                  1e-9 * first.turning_point->max_force);
      EXPECT_NEAR(other.increments[k].force_cross, first.increments[k].force_cross,
                  1e-9 * first.turning_point->max_force);
    }
  }
}

TEST(Pads, AreNearerByTheirLobe) {
  // Without friction the force of a pad depends on the place of the journal alone.
  Case plain = pressed_pads(1);
  plain.friction = {};
  plain.cycle.steps = 40;
  plain.cycle.amplitude.value = 40e-6;
  Case lobed = plain;
  lobed.pads[0].lobe = 5e-6;
  const double middle = pi - 0.5 * 7 * plain.bump_foil.pitch.values.front() / plain.bearing.radius;
  const Cycle far = run_single_cycle(plain, middle);
  const Cycle near = run_single_cycle(lobed, middle);
  ASSERT_TRUE(far.converged() && near.converged());
  for (std::size_t k = 0; k + 5 <= 40; ++k) {
    EXPECT_NEAR(near.increments[k].force_direct, far.increments[k + 5].force_direct,
                1e-9 * far.turning_point->max_force);
  }
}

TEST(Pads, WeldedAtTheOtherEdgeMirrorTheForce) {
  Case leading = pressed_pads(1);
  const double half = 0.5 * 7 * leading.bump_foil.pitch.values.front() / leading.bearing.radius;
  leading.bearing.weld_angle = half;  // clockwise from there: the pad lies about X
  Case trailing = leading;
  trailing.pads[0].weld_edge = WeldEdge::trailing;
  const Cycle a = run_single_cycle(leading, 0.4);
  const Cycle b = run_single_cycle(trailing, -0.4);
  ASSERT_TRUE(a.converged() && b.converged());
  ASSERT_GT(std::abs(a.turning_point->cross_force), 0.01 * a.turning_point->max_force);
  for (std::size_t k = 0; k < a.increments.size(); ++k) {
    EXPECT_NEAR(a.increments[k].force_direct, b.increments[k].force_direct, 1e-9 * a.turning_point->max_force);
    EXPECT_NEAR(a.increments[k].force_cross, -b.increments[k].force_cross, 1e-9 * a.turning_point->max_force);
  }
}

}  // namespace
}  // namespace bumpfoil
