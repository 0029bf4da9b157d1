#include "bumpfoil/bearing/impedance.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// One direction: w = start / (1 - e H).
TEST(ReducedForces, AnswerAtAnyRate) {
  const ReducedForces reduced{.moved = Eigen::Vector2d(3.0, -1.0),
                              .start = 2.0,
                              .hessenberg = Matrix::Constant(1, 1, -0.5),
                              .forces = Eigen::Matrix2Xd::Constant(2, 1, 4.0)};
  const Complex e(1.0, 2.0);
  const Complex w = 2.0 / (1.0 + 0.5 * e);
  EXPECT_LT((reduced.at(e) - Eigen::Vector2cd(3.0 + 4.0 * e * w, -1.0 + 4.0 * e * w)).norm(), 1e-14);
  EXPECT_LT((reduced.at(0.0) - Eigen::Vector2cd(3.0, -1.0)).norm(), 1e-15);
}

/// Two directions, (1 - e H)^-1 by hand; central differences have an error of their step squared.
TEST(ReducedForces, SlopeIsTheDerivative) {
  ReducedForces reduced{.moved = Eigen::Vector2d(3.0, -1.0), .start = 2.0, .hessenberg = {}, .forces = Matrix(2, 2)};
  reduced.hessenberg = Matrix(2, 2);
  reduced.hessenberg << -0.5, 0.3, 2.0, -1.0;
  reduced.forces << 4.0, 1.0, 0.0, -2.0;
  const Complex e(0.4, 2.0);
  const double step = 1e-5;
  const FilmImpedance impedance{.shift = 0.0, .squeeze_time = 0.5, .along = {reduced, reduced}};
  const Eigen::Vector2cd difference = (reduced.at(e + step) - reduced.at(e - step)) / (2.0 * step);
  EXPECT_GT(difference.norm(), 0.1);
  EXPECT_LT((reduced.slope(e) - difference).norm(), 1e-9);
  EXPECT_LT((impedance.slope(2.0 * e).col(1) - 0.5 * difference).norm(), 1e-9);
}

TEST(FilmImpedance, HasAColumnForEachDirection) {
  ReducedForces along{.moved = Eigen::Vector2d(1.0, 2.0),
                      .start = 1.0,
                      .hessenberg = Matrix::Constant(1, 1, -1.0),
                      .forces = Eigen::Matrix2Xd::Zero(2, 1)};
  FilmImpedance impedance{.shift = 3.0, .squeeze_time = 0.5, .along = {along, along}};
  impedance.along[1].moved = Eigen::Vector2d(5.0, 7.0);
  impedance.along[1].forces.setConstant(1.0);
  const Complex e = 0.5 * Complex(0.0, 8.0) - 3.0;
  Eigen::Matrix2cd expected;
  expected << 1.0, 5.0 + e / (1.0 + e), 2.0, 7.0 + e / (1.0 + e);
  EXPECT_LT((impedance.at({0.0, 8.0}) - expected).norm(), 1e-14);
}

}  // namespace
}  // namespace bumpfoil
