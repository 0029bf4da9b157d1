#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/path/path.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "support/bearing_cases.hpp"

/// Bearings with pads, against bearings without pads and against single pads.
namespace bumpfoil {
namespace {

using std::numbers::pi;
constexpr double third = 2.0 * pi / 3.0;

/// Pads of seven bumps each, at equal angles, with an interference that loads all of them.
Case pressed_pads(std::size_t pads, BumpFoilModel model = BumpFoilModel::truss) {
  Case input = reference_case();
  input.bearing.radial_clearance = -3e-6;
  input.bump_foil.model = model;
  input.bump_foil.bumps = 7;
  input.pads.resize(pads);
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.amplitude.value = 20e-6;
  cycle.steps = 8;
  return input;
}

/// @param part  tolerance over the largest force
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
    plain.settings.get<CycleSettings>().steps = 8;
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
  both.settings.get<CycleSettings>().amplitude.value = 40e-6;
  const Cycle cycle = run_single_cycle(both, 0.0);
  expect_forces(cycle, {run_single_cycle(pad_alone(both, 0), 0.0)}, 1e-9);
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
      for (std::size_t k = 0; k < 3; ++k) each.push_back(run_single_cycle(pad_alone(input, k), direction));
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
  expect_forces(cycle, {run_single_cycle(pad_alone(input, 0), 0.3), run_single_cycle(pad_alone(input, 1), 0.3)}, 1e-7);
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

/// Rotation T by an angle: vectors become T v, matrices T K T^T.
Eigen::Matrix2d turning(double angle) {
  return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

/// @param part  tolerance over the largest entry of `expected`
void expect_near(const Eigen::Matrix2d& matrix, const Eigen::Matrix2d& expected, double part) {
  EXPECT_LT((matrix - expected).cwiseAbs().maxCoeff(), part * expected.cwiseAbs().maxCoeff()) << matrix << "\nis not\n"
                                                                                              << expected;
}

/// Three equal pads with a journal that orbits about `centre` (m).
Case orbited_pads(const Eigen::Vector2d& centre) {
  Case input = pressed_pads(3);
  for (Pad& pad : input.pads) pad.lobe = 5e-6;
  PathSettings& path = input.settings.set(PathSettings{});
  path.centre.value = centre;
  path.semi_axes.value = {8e-6, 4e-6};
  path.tilt = 0.3;
  path.orbits = 1;
  path.steps = 12;
  return input;
}

TEST(Pads, EqualOnesAtEqualAnglesTurnThePathOfTheForceWithThatOfTheJournal) {
  const Case input = orbited_pads({9e-6, -5e-6});
  Case turned = input;
  PathSettings& turned_path = turned.settings.get<PathSettings>();
  turned_path.centre.value = turning(third) * turned_path.centre.value;
  turned_path.tilt += third;
  const Cycle one = run_path(input).cycles.front();
  const Cycle other = run_path(turned).cycles.front();
  ASSERT_TRUE(one.converged() && other.converged());
  double largest = 0.0;
  for (const Increment& increment : one.increments) {
    largest = std::max(largest, std::hypot(increment.force_x, increment.force_y));
  }
  ASSERT_GT(largest, 10.0);
  ASSERT_EQ(other.increments.size(), one.increments.size());
  for (std::size_t k = 0; k < one.increments.size(); ++k) {
    const Increment& a = one.increments[k];
    const Increment& b = other.increments[k];
    const Eigen::Vector2d expected = turning(third) * Eigen::Vector2d(a.force_x, a.force_y);
    EXPECT_NEAR(b.force_x, expected.x(), 1e-9 * largest) << k;
    EXPECT_NEAR(b.force_y, expected.y(), 1e-9 * largest) << k;
    EXPECT_NEAR(b.dissipated_energy, a.dissipated_energy, 1e-9 * one.increments.back().dissipated_energy) << k;
    ASSERT_TRUE(a.tangents.unloading && b.tangents.unloading);
    expect_near(*b.tangents.unloading, turning(third) * *a.tangents.unloading * turning(-third), 1e-7);
    const auto row = static_cast<Eigen::Index>(k);
    EXPECT_NEAR(one.fields.pad_force_x.row(row).sum(), a.force_x, 1e-9 * largest) << k;
    EXPECT_NEAR(one.fields.pad_force_y.row(row).sum(), a.force_y, 1e-9 * largest) << k;
    // Pads are numbered clockwise: pad 1 now carries the force of pad 2.
    for (Eigen::Index pad = 0; pad < 3; ++pad) {
      const Eigen::Index was = (pad + 1) % 3;
      const Eigen::Vector2d taken{one.fields.pad_force_x(row, was), one.fields.pad_force_y(row, was)};
      EXPECT_NEAR(other.fields.pad_force_x(row, pad), (turning(third) * taken).x(), 1e-9 * largest) << k;
      EXPECT_NEAR(other.fields.pad_force_y(row, pad), (turning(third) * taken).y(), 1e-9 * largest) << k;
    }
  }
}

/// A matrix that does not change under a third of a turn is the same in all directions.
TEST(Pads, EqualOnesAtEqualAnglesAreAsStiffInAllDirectionsAboutTheCentre) {
  Case input = pressed_pads(3);
  input.settings.set(PathSettings{}).points.values = {{0.0, 0.0}, {1e-6, 0.0}};
  const Cycle path = run_path(input).cycles.front();
  ASSERT_TRUE(path.converged() && path.increments.front().tangents.unloading);
  const Eigen::Matrix2d stiffness = *path.increments.front().tangents.unloading;
  ASSERT_GT(stiffness(0, 0), 1e6);
  expect_near(stiffness, turning(third) * stiffness * turning(-third), 1e-9);
  EXPECT_NEAR(stiffness(0, 0), stiffness(1, 1), 1e-9 * stiffness(0, 0));
  EXPECT_NEAR(path.increments.front().force_x, 0.0, 1e-8);
  EXPECT_NEAR(path.increments.front().force_y, 0.0, 1e-8);
}

LinearFoils vibrating(const Case& input) {
  const VibrationResult result = run_vibration(input);
  EXPECT_TRUE(result.converged());
  return linear_foils(input.settings.get<VibrationSettings>(), result).front();
}

/// Pads under a load, with vibrations along two directions.
Case vibrating_pads() {
  Case input = pressed_pads(3);
  input.settings.set(VibrationSettings{.loads = {50.0 * unit_vector(0.4)},
                                       .directions = {0.2, 0.2 + 0.5 * pi},
                                       .amplitudes = {1e-6},
                                       .frequencies = {2.0 * pi * 200.0},
                                       .steps = 12});
  return input;
}

TEST(Pads, EqualOnesAtEqualAnglesTurnTheirCoefficientsWithTheLoad) {
  const Case input = vibrating_pads();
  const LinearFoils one = vibrating(input);
  ASSERT_GT(one.loss.norm(), 0.01 * one.stiffness.norm());
  Case turned = input;
  turned.settings.get<VibrationSettings>().loads.front() =
      turning(third) * input.settings.get<VibrationSettings>().loads.front();
  for (double& direction : turned.settings.get<VibrationSettings>().directions) direction += third;
  const LinearFoils other = vibrating(turned);
  // Loads are reached to 1e-9, loops settle to 1e-6 of their energy.
  expect_near(other.stiffness, turning(third) * one.stiffness * turning(-third), 1e-5);
  expect_near(other.loss, turning(third) * one.loss * turning(-third), 1e-5);
}

/// For orbits and straight vibrations, also with the event solver.
TEST(Pads, AddTheirForcesAtEveryPointOfAVibration) {
  Case input = vibrating_pads();
  input.pads[0].lobe = 4e-6;
  for (const SolverName solver : {SolverName::newton, SolverName::events}) {
    input.solver.name = solver;
    for (const bool orbits : {false, true}) {
      VibrationSettings& settings = input.settings.get<VibrationSettings>();
      settings.motion = orbits ? Motion::orbit : Motion::line;
      settings.directions =
          orbits ? std::vector<double>{} : vibrating_pads().settings.get<VibrationSettings>().directions;
      const VibrationResult result = run_vibration(input);
      ASSERT_TRUE(result.converged());
      for (const StaticLoad& load : result.loads) {
        EXPECT_LT((load.pad_forces.rowwise().sum() - load.load).norm(), 1e-8 * load.load.norm());
      }
      for (const Vibration& vibration : result.vibrations) {
        const Vector largest = largest_pad_forces(vibration);
        ASSERT_EQ(largest.size(), 3);
        Vector met = Vector::Zero(3);
        for (const LoopPoint& point : vibration.cycle.curve) {
          EXPECT_LT((point.pad_forces.rowwise().sum() - point.force).norm(), 1e-9 * point.force.norm());
          for (Eigen::Index k = 0; k < 3; ++k) met[k] = std::max(met[k], point.pad_forces.col(k).norm());
        }
        EXPECT_EQ(largest, met);
        EXPECT_GT(largest.minCoeff(), 1.0);
      }
    }
  }
}

TEST(Pads, EqualOnesAtEqualAnglesTurnTheirForcesWithTheVibration) {
  const Case input = vibrating_pads();
  Case turned = input;
  turned.settings.get<VibrationSettings>().loads.front() =
      turning(third) * input.settings.get<VibrationSettings>().loads.front();
  for (double& direction : turned.settings.get<VibrationSettings>().directions) direction += third;
  const VibrationResult one = run_vibration(input);
  const VibrationResult other = run_vibration(turned);
  ASSERT_TRUE(one.converged() && other.converged());
  for (std::size_t i = 0; i < one.vibrations.size(); ++i) {
    const Vector a = largest_pad_forces(one.vibrations[i]);
    const Vector b = largest_pad_forces(other.vibrations[i]);
    // Pad 1 now carries the force of pad 2; loads are reached to 1e-9, loops settle to 1e-6 of their energy.
    for (Eigen::Index pad = 0; pad < 3; ++pad) EXPECT_NEAR(b[pad], a[(pad + 1) % 3], 1e-6 * a.maxCoeff());
    EXPECT_GT(a.maxCoeff(), 1.1 * a.minCoeff());
  }
}

TEST(Pads, OfTheMirrorImageHaveMirroredCoefficients) {
  Case input = vibrating_pads();
  input.pads[0].lobe = 4e-6;
  input.pads[1].weld_edge = WeldEdge::trailing;
  input.pads[2].bump_foil = input.bump_foil;
  input.pads[2].bump_foil->thickness = 0.12e-3;
  const LinearFoils one = vibrating(input);
  // Foils wrapped clockwise and counterclockwise from a weld on the X axis are mirror images about it.
  Case mirrored = input;
  mirrored.bearing.wrap = Wrap::counterclockwise;
  mirrored.settings.get<VibrationSettings>().loads.front().y() *= -1.0;
  for (double& direction : mirrored.settings.get<VibrationSettings>().directions) direction *= -1.0;
  const LinearFoils other = vibrating(mirrored);
  const Eigen::Matrix2d mirror = Eigen::Vector2d(1.0, -1.0).asDiagonal();
  expect_near(other.stiffness, mirror * one.stiffness * mirror, 1e-5);
  expect_near(other.loss, mirror * one.loss * mirror, 1e-5);
}

TEST(Pads, AreNearerByTheirLobe) {
  // Without friction the force of a pad depends only on the journal position.
  Case plain = pressed_pads(1);
  plain.friction = {};
  CycleSettings& cycle = plain.settings.get<CycleSettings>();
  cycle.steps = 40;
  cycle.amplitude.value = 40e-6;
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
