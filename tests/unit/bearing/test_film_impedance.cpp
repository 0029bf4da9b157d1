#include "bearing/film_impedance.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>
#include <random>

#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// J X + s S X = -(r + s a), force f X, with random values: reduce_forces() compared with the equations.
TEST(ReducedForces, SolveTheEquationsAtEveryRate) {
  constexpr Eigen::Index n = 40;
  constexpr double shift = 3.0;
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto drawn = [&](Eigen::Index rows, Eigen::Index columns) -> Matrix {
    return Matrix::NullaryExpr(rows, columns, [&] { return uniform(draw); });
  };
  const Matrix J = drawn(n, n) + 8.0 * Matrix::Identity(n, n);
  const Matrix S = drawn(n, n) + 4.0 * Matrix::Identity(n, n);
  const Matrix f = drawn(2, n);
  const Matrix r = drawn(n, 2);  // two motions
  const Matrix a = drawn(n, 2);

  const Eigen::PartialPivLU<Matrix> at_shift(J + shift * S);
  const auto force = [&](const Vector& X) -> Eigen::Vector2d { return f * X; };
  std::vector<FilmAnswer> moved;
  for (const Eigen::Index i : {0, 1}) {
    const Vector X0 = at_shift.solve(-(r.col(i) + shift * a.col(i)));
    moved.push_back({S * X0 + a.col(i), force(X0)});
  }
  const auto stored = [&](const std::vector<Vector>& rates) {
    std::vector<FilmAnswer> answers;
    for (const Vector& w : rates) {
      const Vector X = at_shift.solve(-w);
      answers.push_back({S * X, force(X)});
    }
    return answers;
  };
  const std::vector<Complex> rates{{0.0, 0.0}, {0.0, 3.0}, {0.0, -0.2}, {0.0, 40.0}, {2.0, 1.0}, {shift, 0.0}};
  std::vector<Complex> excess;
  for (const Complex s : rates) excess.push_back(s - shift);
  const auto found = reduce_forces(moved, stored, excess);
  ASSERT_TRUE(found.has_value());
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const Eigen::MatrixXcd system = J.cast<Complex>() + rates[i] * S.cast<Complex>();
    const Eigen::MatrixXcd X = system.partialPivLu().solve(-(r.cast<Complex>() + rates[i] * a.cast<Complex>()));
    for (const Eigen::Index motion : {0, 1}) {
      const Eigen::Vector2cd expected = f.cast<Complex>() * X.col(motion);
      const JournalVectorC of_motion = (*found)[static_cast<std::size_t>(motion)].at(excess[i]);
      EXPECT_LT((of_motion - expected).norm(), 1e-8 * expected.norm()) << rates[i] << ", motion " << motion;
    }
  }
}

TEST(ReducedForces, AreNotGivenWhereTheSpaceCannotHoldThem) {
  // The third node has storage that never appears in forces, but the space ends after one direction: no solution at
  // s = shift + 1.
  const auto stored = [](const std::vector<Vector>& rates) {
    return std::vector<FilmAnswer>{{rates.front(), Eigen::Vector2d::Zero()}};
  };
  EXPECT_FALSE(reduce_forces({{Vector::Ones(3), Eigen::Vector2d(1.0, 0.0)}}, stored, {{1.0, 0.0}}).has_value());
}

/// The journal whirls with an amplitude of a nanometre, marched in time by BDF2. With steps dt, the rate of e^{s t} is
/// (3 - 4 e^{-s dt} + e^{-2 s dt}) / (2 dt): after the initial transient, the force is that of the impedance at this
/// rate.
TEST(FilmImpedance, IsWhatMarchingInTimeFinds) {
  const double speed = speed_of_rpm(45000.0);
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4});
  FilmStepper stepper(bearing);
  BearingState rest;
  const Eigen::Vector2d position(0.6 * bearing.clearance, 0.2 * bearing.clearance);
  ASSERT_EQ(start_from_ambient(stepper, position, speed, rest).status, Status::converged);

  constexpr int steps = 24;
  constexpr int turns = 6;
  constexpr double amplitude = 1e-9;  // m; too small for a contact to change its mode
  const double dt = 2.0 * std::numbers::pi / (steps * speed);
  const Complex turn = std::polar(1.0, speed * dt);
  const Complex s = (3.0 - 4.0 / turn + 1.0 / (turn * turn)) / (2.0 * dt);
  const auto Z = stepper.impedances(rest, {s});
  ASSERT_TRUE(Z.has_value());

  const Eigen::Vector2cd motion(amplitude, Complex(0.0, -amplitude));  // from X to Y
  const Eigen::Vector2d still = film_bearing_outcome(bearing, rest).force;
  BearingState state = rest;
  Complex phase = 1.0;
  double largest = 0.0;
  for (int i = 1; i <= steps * turns; ++i) {
    phase *= turn;
    const OperatingPoint held = OperatingPoint::held_at(position + (motion * phase).real(), speed);
    ASSERT_EQ(stepper.advance(stepper.move_to(held, dt), state).status, Status::converged);
    EXPECT_NEAR(state.time - rest.time, i * dt, 1e-12 * state.time);
    if (i <= steps * (turns - 1)) continue;
    const Eigen::Vector2d expected = ((*Z)[0] * motion * phase).real();
    largest = std::max(largest, (film_bearing_outcome(bearing, state).force - still - expected).norm());
  }
  // Forces of tens of newtons have errors of 1e-9 N, and the amplitude is 3e-5 of the clearance.
  EXPECT_LT(largest, 1e-4 * ((*Z)[0] * motion).norm());
}

}  // namespace
}  // namespace bumpfoil
