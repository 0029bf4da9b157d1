#include "bumpfoil/structure/top_foil.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The reference foil with N crests over the same arc of 25.5 pitches.
TopFoilBeam reference_beam(int crests) {
  Case input = reference_case();
  input.bearing.radius *= (crests - 0.5) / 25.5;
  input.bump_foil.bumps = crests;
  return make_top_foil_beam(make_bearing_design(input));
}

/// The published compliance (sign changed) in long double: 2048 times the precision of the code under test.
LongMatrix printed_compliance(const TopFoilBeam& beam) {
  const Eigen::Index n = beam.theta.size();
  const auto radius = static_cast<long double>(beam.radius);
  const long double scale = radius * radius * radius / static_cast<long double>(beam.bending_stiffness);
  LongMatrix S(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      const auto a = static_cast<long double>(beam.theta[i]);
      const auto b = static_cast<long double>(beam.theta[j]);
      S(i, j) = S(j, i) = scale * (b * std::cos(a - b) / 2 - std::cos(a) * std::sin(b) / 2);
    }
  }
  return S;
}

/// K_t column by column.
Matrix moment_stiffness(const TopFoilMoments& form) {
  const Matrix identity = Matrix::Identity(form.size(), form.size());
  Matrix K(form.size(), form.size());
  for (Eigen::Index j = 0; j < form.size(); ++j) K.col(j) = top_foil_loads(form, identity.col(j));
  return K;
}

TEST(TopFoilCompliance, EqualsThePrintedForm) {
  for (const int crests : {1, 2, 26, 60}) {
    const TopFoilBeam beam = reference_beam(crests);
    const LongMatrix S = printed_compliance(beam);
    const LongMatrix error = top_foil_compliance(beam).cast<long double>() - S;
    // Double-precision round-off in angles up to 6 rad; entries of both signs cancel in places.
    EXPECT_LT((error.array().abs() / S.array().abs().max(1e-3L * S.diagonal().maxCoeff())).maxCoeff(), 1e-13L);
    EXPECT_LT(std::abs(error(0, 0) / S(0, 0)), 1e-13L);
  }
}

TEST(TopFoilCompliance, IsThatOfAStraightCantileverNearTheWeld) {
  TopFoilBeam beam = reference_beam(1);
  beam.theta[0] = 1e-4;
  const double length = beam.radius * beam.theta[0];
  // Curvature affects it by theta^2 = 1e-8.
  EXPECT_NEAR(top_foil_compliance(beam)(0, 0) * 3.0 * beam.bending_stiffness / std::pow(length, 3), 1.0, 1e-8);
}

TEST(TopFoilMoments, AgreeWithTheInverseOfTheCompliance) {
  for (const int crests : {1, 2, 3, 10, 26, 60}) {
    const TopFoilBeam beam = reference_beam(crests);
    const Matrix K = moment_stiffness(make_top_foil_moments(beam));
    const Matrix exact = printed_compliance(beam).inverse().cast<double>();
    EXPECT_LT((K - exact).norm(), 1e-12 * exact.norm()) << crests;
    // cond(S) = 4e6 at 60 crests times machine precision.
    EXPECT_LT((top_foil_stiffness(beam) - exact).norm(), 1e-10 * exact.norm()) << crests;
  }
}

TEST(FlatTopFoilMoments, AreTheLimitOfALargeRadius) {
  TopFoilBeam beam = reference_beam(6);
  const Vector spans{{2e-3, 4e-3, 5e-3, 4e-3, 3e-3, 4e-3}};
  beam.radius = 1e3;
  double place = 0.0;
  for (Eigen::Index k = 0; k < 6; ++k) beam.theta[k] = (place += spans[k]) / beam.radius;
  const TopFoilMoments flat = make_flat_top_foil_moments(beam.bending_stiffness, spans, true);
  EXPECT_TRUE(flat.welded);
  const Matrix K = moment_stiffness(flat);
  // Angles of 1e-5 at a radius of 1 km.
  EXPECT_LT((K - moment_stiffness(make_top_foil_moments(beam))).norm(), 1e-9 * K.norm());
  EXPECT_LT((K * top_foil_compliance(beam) - Matrix::Identity(6, 6)).norm(), 1e-6);
  EXPECT_FALSE(make_flat_top_foil_moments(beam.bending_stiffness, spans, false).welded);
}

TEST(TopFoilMoments, AgreeWithTheInverseForUnevenSpans) {
  TopFoilBeam beam = reference_beam(4);
  beam.theta << 0.3, 0.31, 1.2, 2.6;
  const Matrix exact = printed_compliance(beam).inverse().cast<double>();
  EXPECT_LT((moment_stiffness(make_top_foil_moments(beam)) - exact).norm(), 1e-12 * exact.norm());
}

TEST(TopFoilMoments, StayAccurateForTwoThousandCrestsWhereInversionDoesNot) {
  constexpr int crests = 2000;
  const TopFoilBeam beam = reference_beam(crests);
  const TopFoilMoments form = make_top_foil_moments(beam);

  // A displaced crest affects few neighbours (factor 2 - sqrt(3) from one to the next): far from the weld, its column
  // of K_t equals that of the last 60 crests welded before the first of them, which long double can invert.
  constexpr Eigen::Index last = 60;
  TopFoilBeam end = beam;
  end.theta = beam.theta.tail(last).array() - beam.theta[crests - last - 1];
  const Vector exact = printed_compliance(end).inverse().col(last / 2).cast<double>();
  const Vector u = Vector::Unit(crests, crests - last / 2);
  const Vector loads = top_foil_loads(form, u);
  const double moment_error = (loads.tail(last) - exact).norm() / exact.norm();
  // Angles near 6 rad have errors of 1e-15 in spans of 3e-3, and K_t scales with their cube.
  EXPECT_LT(moment_error, 1e-9);

  const Vector inverted = solve_symmetric(top_foil_compliance(beam), u);
  const double inversion_error = (inverted.tail(last) - exact).norm() / exact.norm();
  EXPECT_GT(inversion_error, 1e-6);

  // Loads along the whole foil: K_t (S f) returns f up to round-off of u = S f.
  const Vector f = Vector::LinSpaced(crests, 0.0, 40.0).array().sin();
  const Vector displaced_foil = top_foil_compliance(beam) * f;
  const double stiffest = 16.0 * loads.norm();
  EXPECT_LT((top_foil_loads(form, displaced_foil) - f).norm(), 1e-15 * stiffest * displaced_foil.norm());
}

TEST(TopFoilMoments, AreThoseOfTheStaticallyDeterminateCantilever) {
  const TopFoilBeam beam = reference_beam(12);
  const TopFoilMoments form = make_top_foil_moments(beam);
  const Vector f = Vector::LinSpaced(12, 1.0, -0.7);
  const Vector moments = top_foil_moments(form, top_foil_compliance(beam) * f);
  for (Eigen::Index k = 0; k < 12; ++k) {
    const double theta = k > 0 ? beam.theta[k - 1] : 0.0;
    double lever_sum = 0.0;
    for (Eigen::Index j = k; j < 12; ++j) lever_sum += f[j] * beam.radius * std::sin(beam.theta[j] - theta);
    EXPECT_NEAR(moments[k], lever_sum, 1e-9 * moments.cwiseAbs().maxCoeff());  // cond(S) of 12 crests is 6e3
  }
}

TEST(TopFoilMoments, SoftestAndStiffestModeOfTheReferenceFoil) {
  const Matrix K = moment_stiffness(make_top_foil_moments(make_bearing_design(reference_case())));
  const Vector modes = symmetric_eigenvalues(K);
  EXPECT_NEAR(modes.minCoeff(), 4.88, 0.005);  // known to three digits
  EXPECT_NEAR(modes.maxCoeff(), 6.43e5, 0.005e5);
}

TEST(SolveTridiagonal, MatchesADenseSolve) {
  const Vector diagonal{{4.0, 5.0, 3.0}};
  const Vector off{{1.0, -2.0}};
  const Vector right{{1.0, 2.0, 3.0}};
  Matrix dense = diagonal.asDiagonal();
  dense(0, 1) = dense(1, 0) = off[0];
  dense(1, 2) = dense(2, 1) = off[1];
  EXPECT_LT((dense * solve_tridiagonal(diagonal, off, right) - right).norm(), 1e-14);
}

TEST(TopFoilOfADesign, RestsOnCrestsAtTheirOwnPlaces) {
  FoilDesign foils = make_bearing_design(reference_case());
  foils.bumps[3].pitch = 6e-3;
  foils.bumps[9].pitch = 3e-3;
  const Matrix expected = top_foil_compliance({.radius = *foils.radius,
                                               .bending_stiffness = make_top_foil_section(foils).bending_stiffness,
                                               .theta = crest_positions(foils) / *foils.radius});
  const Matrix K = moment_stiffness(make_top_foil_moments(foils));
  EXPECT_LT((K * expected - Matrix::Identity(26, 26)).norm(), 1e-8);  // cond 1e5, 26 columns
}

TEST(TopFoilOfADesign, FlatOneHasTheFlexibilityOfACantilever) {
  FoilDesign foils = make_bearing_design(reference_case());
  foils.radius.reset();
  foils.bumps.resize(4);
  foils.bumps[1].pitch = 6e-3;
  foils.bumps[3].pitch = 3e-3;
  const double stiffness = make_top_foil_section(foils).bending_stiffness;
  const Matrix K = moment_stiffness(make_top_foil_moments(foils));
  // u_i = P_j a^2 (3 b - a) / (6 EI'), a the smaller and b the larger distance from the weld.
  const Vector place = crest_positions(foils);
  Matrix S(4, 4);
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      const double a = std::min(place[i], place[j]);
      S(i, j) = a * a * (3.0 * std::max(place[i], place[j]) - a) / (6.0 * stiffness);
    }
  }
  EXPECT_LT((K * S - Matrix::Identity(4, 4)).norm(), 1e-11);
  foils.welded = false;
  EXPECT_FALSE(make_top_foil_moments(foils).welded);
}

TEST(TopFoilOfADesign, MomentsAreScaledByTheReferenceLength) {
  FoilDesign foils = make_bearing_design(reference_case());
  foils.bumps[0].pitch = 2e-3;
  EXPECT_DOUBLE_EQ(top_moment_scale(foils), make_top_foil_section(foils).bending_stiffness / 4e-6);
}

}  // namespace
}  // namespace bumpfoil
