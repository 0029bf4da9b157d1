#include "bumpfoil/rotor/rotor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <numbers>

#include "bumpfoil/rotor/shaft.hpp"
#include "core/linear_algebra.hpp"
#include "unit/rotor/rotor_on_springs.hpp"

namespace bumpfoil {
namespace {

RigidRotorDesign rigid_design() {
  return {
      .mass = 2.2, .transverse_inertia = 9e-3, .polar_inertia = 1.1e-3, .bearings = {-0.07, 0.09}, .planes = {-0.02}};
}

/// A steel shaft of 300 mm with a disc, on two bearings.
ShaftDesign shaft_design() {
  return {.sections = {{0.3, 0.03, 0.01, 210e9, 0.3, 7800.0}},
          .discs = {solid_disc(0.18, 0.02, 0.1, 0.03, 7800.0)},
          .bearings = {0.03, 0.27},
          .longest_element = 0.01};
}

/// The torque on a body is the rate of I_p Omega a + I_t a x a', where a is its axis: this gives the equations for
/// small angles independently of G. A force at z along X turns about Y, one along Y about -X.
TEST(RigidRotor, TurnsAsItsAngularMomentumSays) {
  const RigidRotorDesign design = rigid_design();
  const Rotor rotor = make_rigid_rotor(design);
  for (const double speed : {700.0, -700.0}) {
    const double size = 1e-5;
    const auto angles = [&](double t) {
      return Eigen::Vector2d(size * std::cos(300.0 * t), size * std::sin(110.0 * t));
    };
    const auto axis = [&](double t) {
      const Eigen::Vector2d phi = angles(t);
      return Eigen::Vector3d(phi.x(), phi.y(), 1.0).normalized();
    };
    const double h = 1e-5;
    const auto momentum = [&](double t) -> Eigen::Vector3d {
      const Eigen::Vector3d rate = (axis(t + h) - axis(t - h)) / (2.0 * h);
      return design.polar_inertia * speed * axis(t) + design.transverse_inertia * axis(t).cross(rate);
    };
    const double t = 0.0123;
    const Eigen::Vector3d torque = (momentum(t + h) - momentum(t - h)) / (2.0 * h);
    Eigen::Vector4d rate = Eigen::Vector4d::Zero();
    Eigen::Vector4d acceleration = Eigen::Vector4d::Zero();
    rate.tail<2>() = (angles(t + h) - angles(t - h)) / (2.0 * h);
    acceleration.tail<2>() = (angles(t + h) - 2.0 * angles(t) + angles(t - h)) / (h * h);
    const Eigen::Vector4d force = rotor.mass * acceleration + speed * rotor.gyroscopic * rate;
    // Differences have errors of (300 h)^2 / 3, angles of their squares.
    EXPECT_NEAR(force[2], torque.y(), 1e-5 * torque.norm());
    EXPECT_NEAR(force[3], -torque.x(), 1e-5 * torque.norm());
  }
}

TEST(Rotor, IsAValueWhoseMatricesHaveTheirSymmetry) {
  for (const Rotor& rotor :
       {make_point_mass(0.5), make_rigid_rotor(rigid_design()), make_flexible_rotor(shaft_design())}) {
    EXPECT_LT((rotor.mass - rotor.mass.transpose()).norm(), 1e-15 * rotor.mass.norm());
    EXPECT_LT((rotor.stiffness - rotor.stiffness.transpose()).norm(), 1e-15 * rotor.stiffness.norm() + 1e-300);
    EXPECT_LT((rotor.gyroscopic + rotor.gyroscopic.transpose()).norm(), 1e-15 * rotor.gyroscopic.norm() + 1e-300);
    // A rigid motion causes no strain, and all stations follow it. Round-off of stiffness times shaft length.
    EXPECT_LT((rotor.stiffness * rotor.rigid).norm(), 1e-12 * rotor.stiffness.norm() + 1e-300);
    for (const RotorStation& bearing : rotor.bearings) {
      const Eigen::MatrixXd moved = bearing.motion * rotor.rigid;
      EXPECT_TRUE(moved.leftCols(2).isIdentity(1e-15));
      if (moved.cols() > 2) {
        EXPECT_NEAR(moved(0, 2), bearing.z, 1e-15);
      }
    }
  }
}

/// The lever rule, for rigid and flexible rotors; a point mass is the load of one bearing.
TEST(Rotor, WeighsOnItsBearings) {
  const Eigen::Vector2d gravity(0.0, -9.81);
  const auto half = weights_on_bearings(make_point_mass(1.5), gravity);
  ASSERT_EQ(half.size(), 1U);
  EXPECT_NEAR(half[0].y(), -1.5 * 9.81, 1e-14);

  const auto rigid = weights_on_bearings(make_rigid_rotor(rigid_design()), {9.81, 0.0});
  ASSERT_EQ(rigid.size(), 2U);
  EXPECT_NEAR(rigid[0].x(), 12.139875, 1e-12);  // 2.2 kg times 90 mm over 160 mm
  EXPECT_NEAR(rigid[1].x(), 9.442125, 1e-12);
  EXPECT_NEAR(rigid[1].y(), 0.0, 1e-12);

  const ShaftDesign design = shaft_design();
  const Rotor shaft = make_flexible_rotor(design);
  const double of_shaft = 7800.0 * M_PI / 4.0 * (0.03 * 0.03 - 0.01 * 0.01) * 0.3;
  const double of_disc = 7800.0 * M_PI / 4.0 * (0.1 * 0.1 - 0.03 * 0.03) * 0.02;
  EXPECT_NEAR(shaft.total_mass(), of_shaft + of_disc, 1e-12);
  const auto loads = weights_on_bearings(shaft, gravity);
  const double moment = of_shaft * (0.15 - 0.03) + of_disc * (0.18 - 0.03);
  // Round-off of a solution whose condition number follows from the shaft length.
  EXPECT_NEAR(loads[1].y(), -9.81 * moment / 0.24, 1e-11);
  EXPECT_NEAR(loads[0].y() + loads[1].y(), -9.81 * (of_shaft + of_disc), 1e-11);
}

/// Whirl speeds on springs within the range of interest, with gyroscopic effects, agree with those of the full model
/// within a few times the error estimate of the reduction, which ignores gyroscopic terms. More modes reduce the error.
TEST(ReducedRotor, WhirlsAsTheWholeOneDoes) {
  const Rotor whole = make_flexible_rotor(shaft_design());
  const double range = 12000.0;
  double before = 1.0;
  for (const double kept : {1.0, 12.0, 50.0}) {
    const ReducedRotor reduced = reduce_rotor(whole, range, kept);
    EXPECT_LT(reduced.rotor.size(), whole.size() / 2);
    EXPECT_GT(reduced.frequency_error, 0.0);
    EXPECT_LT(reduced.frequency_error, 0.1 * before);
    before = reduced.frequency_error;
    EXPECT_NEAR(reduced.rotor.total_mass(), whole.total_mass(), 1e-9);
    const auto weights = weights_on_bearings(whole, {9.81, 0.0});
    const auto same = weights_on_bearings(reduced.rotor, {9.81, 0.0});
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) EXPECT_NEAR(same[i].x(), weights[i].x(), 1e-8);
    const auto expected = whirl_frequencies(on_springs(whole, 2e7, 3e7), 4000.0);
    const auto found = whirl_frequencies(on_springs(reduced.rotor, 2e7, 3e7), 4000.0);
    for (std::size_t i = 0; expected[i] < range; ++i) {
      EXPECT_NEAR(found[i], expected[i], 10.0 * reduced.frequency_error * expected[i]);
    }
  }
  EXPECT_LT(before, 1e-5);
  EXPECT_LT(reduce_rotor(whole, range).frequency_error, 1e-3);
}

TEST(RotorStation, MovesOnAnOrbitWithTheRotor) {
  RotorStation station{.name = "disc", .z = 0.0, .motion = Eigen::MatrixXd(2, 3)};
  station.motion << 1.0, 0.0, 2.0, 0.0, 3.0, 0.0;
  const std::complex<double> i(0.0, 1.0);
  const Eigen::Vector3cd y(1.0, i, -i);
  EXPECT_EQ(station.orbit(y), Eigen::Vector2cd(1.0 - 2.0 * i, 3.0 * i));
}

/// The whole mass in the direction of gravity; no moment about the centre of mass.
TEST(Rotor, HasAWeight) {
  const Eigen::Vector4d weight = make_rigid_rotor(rigid_design()).inertia_force({3.0, -9.81});
  EXPECT_LT((weight - Eigen::Vector4d(6.6, -21.582, 0.0, 0.0)).norm(), 1e-14 * 21.582);
}

/// A force of the bearing does the same work on the journal as on the rotor.
TEST(RotorStation, PutsWhatABearingDoesOnTheRotor) {
  RotorStation station = make_rigid_rotor(rigid_design()).bearings.back();
  station.half_width = 0.02;
  const Eigen::VectorXcd y =
      Eigen::VectorXd::LinSpaced(4, 1.0, -2.0) + std::complex<double>(0.0, 1.0) * Eigen::VectorXd::Ones(4);
  Eigen::MatrixXcd Z(4, 4);
  for (Eigen::Index i = 0; i < 16; ++i) Z.data()[i] = std::polar(1.0 + static_cast<double>(i), static_cast<double>(i));
  const Eigen::VectorXcd q = station.journal() * y;
  const Eigen::VectorXcd force = Z * q;
  const Eigen::VectorXcd on_rotor = station.on_rotor(Z) * y;
  EXPECT_LT(std::abs(y.dot(on_rotor) - q.dot(force)), 1e-13 * std::abs(q.dot(force)));
  EXPECT_GT(std::abs(q.dot(force).imag()), 1.0);
}

/// Under static loads at the bearings, stations move as those of the full model: no interior forces excite the modes.
TEST(ReducedRotor, BendsUnderStaticLoadsAsTheWholeOneDoes) {
  ShaftDesign design = shaft_design();
  design.bearings = {0.03, 0.15, 0.27};
  const Rotor whole = on_springs(make_flexible_rotor(design), 2e7, 3e7);
  const Rotor reduced = on_springs(reduce_rotor(make_flexible_rotor(design), 5000.0).rotor, 2e7, 3e7);
  const auto bent = [](const Rotor& rotor) -> Eigen::VectorXd {
    const Eigen::VectorXd load = rotor.bearings[1].motion.transpose() * Eigen::Vector2d(100.0, -50.0);
    return rotor.stations.back().motion * solve_symmetric(rotor.stiffness, load);
  };
  EXPECT_LT((bent(reduced) - bent(whole)).norm(), 1e-9 * bent(whole).norm());
}

/// A thin shaft in end bearings that are stiff against displacement and inclination vibrates as a beam clamped at both
/// ends, omega = 4.730041^2 sqrt(E I / (rho A l^4)); with bearings stiff against displacement only, as a pinned beam,
/// omega = pi^2 sqrt(...). The same holds for its reduced model.
TEST(ReducedRotor, IsClampedWhereBearingsResistInclination) {
  const ShaftSection thin{0.5, 0.005, 0.0, 210e9, 0.3, 7800.0};
  const double unit = std::sqrt(thin.youngs_modulus * 0.005 * 0.005 / 16.0 / thin.density) / (0.5 * 0.5);
  for (const double half_width : {0.0, 0.02}) {
    Rotor whole = make_flexible_rotor({.sections = {thin}, .bearings = {0.0, 0.5}, .longest_element = 0.02});
    for (RotorStation& bearing : whole.bearings) bearing.half_width = half_width;
    for (Rotor rotor : {whole, reduce_rotor(whole, 2000.0).rotor}) {
      for (const RotorStation& bearing : rotor.bearings) {
        const Eigen::MatrixXd B = bearing.journal();
        ASSERT_EQ(B.rows(), half_width > 0.0 ? 4 : 2);
        rotor.stiffness += 1e9 * B.transpose() * B;
      }
      const double root = half_width > 0.0 ? 4.730041 : std::numbers::pi;
      // Shear and rotary inertia reduce it by 1e-4 for a shaft this thin.
      EXPECT_NEAR(free_frequencies(rotor)[0], root * root * unit, 1e-3 * root * root * unit) << half_width;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
