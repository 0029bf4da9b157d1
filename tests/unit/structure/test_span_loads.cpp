#include "bumpfoil/structure/span_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// The top foil of the reference bearing, with its crest positions.
struct Foil {
  TopFoilBeam beam = make_top_foil_beam(make_bearing_design(reference_case()));
  TopFoilMoments form = make_top_foil_moments(beam);
  Eigen::Index crests = beam.theta.size();
  double end_angle = 26 * 4.572e-3 / 19.05e-3;
};

/// A free cantilever under a uniform load q over its length. With a = end_angle, u'' + u = R^2 M / EI' and
/// M = R^2 q (1 - cos(a - theta)) give, clamped at theta = 0,
///
///     u = (R^4 q / EI') (1 - cos(theta) - (theta sin(theta - a) + sin(a) sin(theta)) / 2)
Vector cantilever_loads(const TopFoilBeam& beam, double a, double q) {
  const double scale = std::pow(beam.radius, 4) * q / beam.bending_stiffness;
  return beam.theta.unaryExpr(
      [=](double t) { return scale * (1.0 - std::cos(t) - 0.5 * (t * std::sin(t - a) + std::sin(a) * std::sin(t))); });
}

TEST(CrestLoads, UniformLoadDisplacesTheCrestsAsTheClosedFormSays) {
  const Foil foil;
  const Vector uniform = Vector::Constant(foil.crests + 1, 3.0);
  const Vector loads = crest_loads(foil.beam, foil.form, foil.end_angle, uniform);
  const Vector expected = top_foil_loads(foil.form, cantilever_loads(foil.beam, foil.end_angle, 3.0));
  // Loads follow from small differences of displacements of 200 mm: the closed form loses some of its 16 digits.
  EXPECT_LT((loads - expected).cwiseAbs().maxCoeff(), 1e-8 * loads.cwiseAbs().maxCoeff());
  const Vector u = top_foil_compliance(foil.beam) * loads;
  const Vector exact = cantilever_loads(foil.beam, foil.end_angle, 3.0);
  EXPECT_LT((u - exact).cwiseAbs().maxCoeff(), 1e-9 * exact.cwiseAbs().maxCoeff());
}

/// Each span separately: the load of one span compared with many closely spaced point loads.
TEST(CrestLoads, EachSpanIsTheSumOfItsPointLoads) {
  const Foil foil;
  constexpr double q = 5.0;
  constexpr int points = 400;
  for (const Eigen::Index span : {Eigen::Index{0}, Eigen::Index{1}, Eigen::Index{12}, foil.crests - 1, foil.crests}) {
    const double begin = span == 0 ? 0.0 : foil.beam.theta[span - 1];
    const double end = span == foil.crests ? foil.end_angle : foil.beam.theta[span];
    // Crest displacements under loads elsewhere: compliance of a beam with one more angle, midpoint rule.
    Vector u = Vector::Zero(foil.crests);
    for (int i = 0; i < points; ++i) {
      const double at = begin + (i + 0.5) * (end - begin) / points;
      TopFoilBeam with = foil.beam;
      with.theta.resize(foil.crests + 1);
      with.theta << foil.beam.theta.head(span), at, foil.beam.theta.tail(foil.crests - span);
      const Vector column = top_foil_compliance(with).col(span);
      const double load = q * foil.beam.radius * (end - begin) / points;
      u.head(span) += load * column.head(span);
      u.tail(foil.crests - span) += load * column.tail(foil.crests - span);
    }
    Vector line_load = Vector::Zero(foil.crests + 1);
    line_load[span] = q;
    const Vector found = top_foil_compliance(foil.beam) * crest_loads(foil.beam, foil.form, foil.end_angle, line_load);
    // Error of the midpoint rule for a smooth function: (1/400)^2 / 24 of its curvature.
    EXPECT_LT((found - u).cwiseAbs().maxCoeff(), 2e-6 * u.cwiseAbs().maxCoeff()) << "span " << span;
  }
}

TEST(CrestLoads, AreThoseOfOneSpanWhereThereIsOneCrest) {
  TopFoilBeam beam{.radius = 0.02, .bending_stiffness = 0.003, .theta = Vector::Constant(1, 0.3)};
  const Vector loads = crest_loads(beam, make_top_foil_moments(beam), 0.4, Vector::Constant(2, 7.0));
  const Vector u = top_foil_compliance(beam) * loads;
  EXPECT_NEAR(u[0], cantilever_loads(beam, 0.4, 7.0)[0], 1e-10 * std::abs(u[0]));
}

}  // namespace
}  // namespace bumpfoil
