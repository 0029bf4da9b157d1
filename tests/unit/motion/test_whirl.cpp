#include "bumpfoil/motion/whirl.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Cross-coupled springs q against dampers c: forward whirl grows, backward whirl decays, with
/// m s^2 + (c s + k) -+ i q = 0.
TEST(Whirl, IsThatOfACrossCoupledRotor) {
  constexpr double m = 0.8;
  constexpr double k = 3e6;
  constexpr double q = 4e5;
  constexpr double c = 100.0;
  Eigen::Matrix2d K;
  K << k, q, -q, k;
  const FilmImpedance impedance = linear_impedance(K, c * Eigen::Matrix2d::Identity(), 1000.0);
  ASSERT_LT((impedance.at({-30.0, 700.0}) - (K + Complex(-30.0, 700.0) * c * Eigen::Matrix2d::Identity())).norm(),
            1e-9 * k);
  for (const double speed : {2000.0, -2000.0}) {
    const auto whirls = whirls_on(make_point_mass(m), speed, {impedance}, usual_window(speed));
    ASSERT_EQ(whirls.size(), 2U);
    for (const double turn : {1.0, -1.0}) {
      // x + i y = e^{s t} turns from X to Y where y = -i x for Im s > 0.
      const Complex stiffness(k, -turn * q);
      const Complex s = (-c + std::sqrt(Complex(c * c, 0.0) - 4.0 * m * stiffness)) / (2.0 * m);
      const Complex expected = s.imag() > 0.0 ? s : -c / m - s;
      const Whirl& found =
          std::abs(whirls[0].rate - expected) < std::abs(whirls[1].rate - expected) ? whirls[0] : whirls[1];
      EXPECT_LT(std::abs(found.rate - expected), 1e-9 * std::abs(expected));
      EXPECT_NEAR(found.direction, turn * std::copysign(1.0, speed), 1e-9);
      EXPECT_LT(found.residual, 1e-12);
      EXPECT_NEAR(found.log_decrement(), -2.0 * std::numbers::pi * expected.real() / expected.imag(), 1e-9);
      EXPECT_NEAR(found.damping_ratio(), -expected.real() / std::abs(expected), 1e-9);
      // 2 m s + c: the motion is almost entirely that of the rotor.
      EXPECT_NEAR(found.rotor_share, 1.0 / (1.0 + c / std::abs(2.0 * m * expected)), 1e-9);
    }
    EXPECT_GT(whirls[0].rate.real(), 0.0);
    EXPECT_FALSE(whirls[0].is_of_foils());
  }
}

/// Bearings with different squeeze times and shifts are combined correctly: two half springs act as one.
TEST(Whirl, AddsBearings) {
  const Eigen::Matrix2d K = Eigen::Vector2d(2e6, 1e6).asDiagonal();
  const Eigen::Matrix2d C = Eigen::Vector2d(50.0, 20.0).asDiagonal();
  const Rotor rotor =
      make_rigid_rotor({.mass = 2.0, .transverse_inertia = 1e-2, .polar_inertia = 2e-3, .bearings = {-0.1, 0.1}});
  const auto whirls =
      whirls_on(rotor, 1500.0, {linear_impedance(K, C, 1000.0), linear_impedance(K, C, 2500.0)}, usual_window(1500.0));
  // Without tilt: m s^2 + 2 c s + 2 k = 0 along X and Y.
  for (const int axis : {0, 1}) {
    const double k = K(axis, axis);
    const double c = C(axis, axis);
    const Complex expected(-c / 2.0, std::sqrt(k - c * c / 4.0));
    EXPECT_TRUE(std::any_of(whirls.begin(), whirls.end(), [&](const Whirl& whirl) {
      return std::abs(whirl.rate - expected) < 1e-8 * std::abs(expected);
    }));
  }
}

/// A spring in parallel with a spring and damper in series, k + g e / (1 + 2 e) with e = T0 s, which has its own motion
/// near the pole, s = -1 / (2 T0). The weaker its force g on the journal, the smaller the rotor's share in it, down to
/// round-off.
TEST(Whirl, LeavesOutWhatExertsNoForceOnTheJournal) {
  constexpr double m = 1.0;
  constexpr double k = 1e6;
  constexpr double unit = 1e-3;  // T0, s
  for (const double coupling : {1e-2, 1e-4, 1e-6, 1e-11, 1e-12, 1e-13, 1e-14}) {
    SCOPED_TRACE(coupling);
    FilmImpedance impedance{.shift = 0.0, .squeeze_time = unit};
    for (const int axis : {0, 1}) {
      const bool along_x = axis == 0;
      ReducedForces forces;
      forces.moved = Eigen::Vector2d(along_x ? k : 0.0, along_x ? 0.0 : 3.0 * k);
      forces.start = 1.0;
      forces.hessenberg = Matrix::Constant(1, 1, -2.0);
      forces.forces = Eigen::Vector2d(along_x ? coupling * k : 0.0, 0.0);
      impedance.along.push_back(forces);
    }
    const auto whirls = whirls_on(make_point_mass(m), 2000.0, {impedance}, usual_window(2000.0));
    const auto real = std::find_if(whirls.begin(), whirls.end(), [](const Whirl& w) { return w.rate.imag() == 0.0; });
    ASSERT_EQ(whirls.size(), coupling < 1e-9 ? 2U : 3U);
    if (coupling < 1e-9) continue;
    ASSERT_NE(real, whirls.end());
    const double e = unit * real->rate.real();
    const double of_series = coupling * k / (1.0 + 2.0 * e);
    // The root is accurate to 1e-12 and as close as 4e-7 to the pole.
    EXPECT_LT(std::abs(m * std::pow(real->rate.real(), 2) + k + e * of_series), 1e-4 * k);
    const double of_rotor = 2.0 * m * std::abs(real->rate.real());
    const double of_films = unit * coupling * k / std::pow(1.0 + 2.0 * e, 2);
    EXPECT_NEAR(real->rotor_share, of_rotor / (of_rotor + of_films), 1e-4 * real->rotor_share);
  }
}

/// Springs against displacement, k, and inclination, h^2 k_t, at distance l on both sides:
/// I_t s^2 + 2 h^2 (k_t + s c_t) + 2 l^2 (k + s c) = 0. One of the two bearings does not resist inclination, h = 0.
TEST(Whirl, TiltsOnSpringsThatResistIt) {
  constexpr double h = 0.02;
  constexpr double l = 0.03;
  constexpr double inertia = 2e-3;
  const Eigen::Vector4d k(2e6, 1e6, 3e6, 2e6);
  const Eigen::Vector4d c(50.0, 20.0, 90.0, 40.0);
  const FilmImpedance tilting = linear_impedance(k.asDiagonal().toDenseMatrix(), c.asDiagonal().toDenseMatrix(), 1e3);
  const FilmImpedance straight =
      linear_impedance(k.head<2>().asDiagonal().toDenseMatrix(), c.head<2>().asDiagonal().toDenseMatrix(), 1e3);
  for (const bool both : {true, false}) {
    Rotor rotor =
        make_rigid_rotor({.mass = 2.0, .transverse_inertia = inertia, .polar_inertia = 0.0, .bearings = {-l, l}});
    rotor.bearings[0].half_width = h;
    if (both) rotor.bearings[1].half_width = h;
    const auto whirls = whirls_on(rotor, 2000.0, {tilting, both ? tilting : straight}, usual_window(2000.0));
    for (const int axis : {0, 1}) {
      const double count = both ? 2.0 : 1.0;
      const double stiffness = count * h * h * k[axis + 2] + 2.0 * l * l * k[axis];
      const double damping = count * h * h * c[axis + 2] + 2.0 * l * l * c[axis];
      const Complex expected =
          (-damping + std::sqrt(Complex(damping * damping - 4.0 * inertia * stiffness, 0.0))) / (2.0 * inertia);
      EXPECT_TRUE(
          std::any_of(whirls.begin(), whirls.end(),
                      [&](const Whirl& whirl) { return std::abs(whirl.rate - expected) < 1e-8 * std::abs(expected); }))
          << both << axis;
    }
  }
}

/// On equal springs k at l on both sides a rigid rotor tilts with I_t w^2 -+ Omega I_p w = 2 l^2 k: faster forward.
TEST(Whirl, SplitsByTheGyroscopicEffect) {
  constexpr double k = 1e6;
  constexpr double l = 0.05;
  constexpr double inertia = 2e-3;
  constexpr double polar = 1e-3;
  constexpr double speed = 2000.0;
  const Rotor rotor =
      make_rigid_rotor({.mass = 2.0, .transverse_inertia = inertia, .polar_inertia = polar, .bearings = {-l, l}});
  const FilmImpedance spring = linear_impedance(k * Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero(), 1000.0);
  const auto whirls = whirls_on(rotor, speed, {spring, spring}, usual_window(speed));
  for (const double turn : {1.0, -1.0}) {
    const double gyroscopic = turn * speed * polar;
    const double frequency =
        (gyroscopic + std::sqrt(gyroscopic * gyroscopic + 8.0 * inertia * l * l * k)) / (2.0 * inertia);
    EXPECT_TRUE(std::any_of(whirls.begin(), whirls.end(), [&](const Whirl& whirl) {
      return std::abs(whirl.rate - Complex(0.0, frequency)) < 1e-8 * frequency &&
             std::abs(whirl.direction - turn) < 1e-6;
    })) << frequency;
  }
}

/// Forward whirl that grows, however slowly, is found up to 8 times the speed, decaying whirl up to twice the speed.
TEST(Whirl, IsSeenFartherOutWhereItGrows) {
  constexpr double m = 0.8;
  constexpr double c = 100.0;
  constexpr double growth = 0.5;
  constexpr double frequency = 2000.0;
  constexpr double k = m * (frequency * frequency - growth * growth) - c * growth;
  constexpr double q = frequency * (2.0 * m * growth + c);
  Eigen::Matrix2d K;
  K << k, q, -q, k;
  const FilmImpedance impedance = linear_impedance(K, c * Eigen::Matrix2d::Identity(), 1000.0);
  constexpr double speed = 700.0;
  const auto whirls = whirls_on(make_point_mass(m), speed, {impedance}, usual_window(speed));
  ASSERT_EQ(whirls.size(), 1U);
  EXPECT_LT(std::abs(whirls[0].rate - Complex(growth, frequency)), 1e-9 * frequency);
  EXPECT_GT(whirls[0].residual, 0.0);  // round-off
}

/// The coefficients of a spring and a damper are their own stiffness and damping, at any speed.
TEST(Whirl, OnCoefficientsOfSpringsIsThatOnSprings) {
  const Eigen::Matrix2d K = (Eigen::Matrix2d() << 3e6, 4e5, -3e5, 2e6).finished();
  const std::vector<FilmImpedance> springs{linear_impedance(K, Eigen::Vector2d(80.0, 60.0).asDiagonal(), 1000.0)};
  const WhirlWindow window = usual_window(-2500.0);
  const auto exact = whirls_on(make_point_mass(0.8), -2500.0, springs, window);
  const auto found = whirls_on_coefficients(make_point_mass(0.8), -2500.0, springs, window);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(std::abs(found[i].rate - exact.at(i).rate), 1e-9 * std::abs(exact[i].rate));
  }
}

TEST(Onset, IsWhereTheGrowthChangesItsSign) {
  int calls = 0;
  const auto rate = [&](double speed) -> std::optional<Complex> {
    ++calls;
    return Complex(speed * speed - 9e4, 0.5 * speed);
  };
  const auto onset = find_onset(rate, 100.0, 1000.0);
  ASSERT_TRUE(onset.has_value());
  EXPECT_NEAR(onset->speed, 300.0, 1e-6);
  EXPECT_NEAR(onset->whirl_ratio, 0.5, 1e-9);
  EXPECT_FALSE(onset->jumps);
  EXPECT_LT(calls, 20);
  EXPECT_FALSE(find_onset(rate, 400.0, 1000.0).has_value());
  EXPECT_FALSE(find_onset([](double) { return std::optional<Complex>(); }, 100.0, 1000.0).has_value());
}

/// Contacts that change their modes at a speed.
TEST(Onset, SaysWhereTheGrowthJumps) {
  const auto onset =
      find_onset([](double speed) { return std::optional(Complex(speed < 400.0 ? -2.0 : 7.0, 100.0)); }, 100.0, 1000.0);
  ASSERT_TRUE(onset.has_value());
  EXPECT_NEAR(onset->speed, 400.0, 1e-6);
  EXPECT_TRUE(onset->jumps);
  // A jump of the size of round-off, relative to the speed.
  const auto rounded = find_onset(
      [](double speed) { return std::optional(Complex(speed < 400.0 ? -2e-5 : 7e-5, 100.0)); }, 100.0, 1000.0);
  ASSERT_TRUE(rounded.has_value());
  EXPECT_FALSE(rounded->jumps);
}

}  // namespace
}  // namespace bumpfoil
