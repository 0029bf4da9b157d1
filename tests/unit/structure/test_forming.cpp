#include "bumpfoil/structure/forming.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/foil_structure.hpp"

namespace bumpfoil {
namespace {

FoilDesign formed_design(double formed_radius, double seat_pressure = 0.0) {
  Case input = reference_case();
  input.top_foil.formed_radius = {FormedTo::radius, formed_radius};
  input.top_foil.seat_pressure = seat_pressure;
  return make_bearing_design(input);
}

/// Free shape without load or bending, inward positive, starting at the weld: u'' + u = R^2 kappa_0, u = u' = 0 at the
/// weld.
Vector free_shape(const TopFoilBeam& beam, const Forming& forming) {
  const double R = beam.radius;
  const double end = forming.end_angle;
  return beam.theta.unaryExpr([&](double theta) {
    const double graded =
        1.0 - std::cos(theta) - 0.5 * (theta * std::sin(theta - end) + std::sin(end) * std::sin(theta));
    return R * R * (forming.uniform * (1.0 - std::cos(theta)) + forming.graded * graded);
  });
}

/// D' u at all nodes with a moment.
Vector kinks(const TopFoilMoments& form, const Vector& u) {
  Vector kink(form.size());
  for (Eigen::Index k = 0; k < form.size(); ++k) {
    const double at = k > 0 ? u[k - 1] : 0.0;
    kink[k] = form.inverse_sine[k] * u[k];
    if (k == 0) continue;
    kink[k] += (k > 1 ? form.inverse_sine[k - 1] * u[k - 2] : 0.0) + form.load_diagonal(k) * at;
  }
  return kink;
}

TEST(Forming, IsThatOfTheRadiusAndOfThePressure) {
  const Case input = reference_case();
  const Forming none = make_forming(make_bearing_design(input));
  EXPECT_TRUE(none.is_none());
  EXPECT_NEAR(none.end_angle, 26.0 * 4.572e-3 / 19.05e-3, 1e-14);  // half a pitch beyond the last crest
  const Forming forming = make_forming(formed_design(1.01 * 19.05e-3, 300.0));
  EXPECT_NEAR(forming.uniform, 0.519737, 1e-6);  // from an independent prototype
  EXPECT_NEAR(forming.graded, 19.05e-3 * 19.05e-3 * 300.0 * 38.1e-3 / 0.0007872451, 1e-6);
}

/// Without loads the free shape has M = 0: T M + r = D' u holds for any spans.
TEST(Forming, LeavesTheFreeShapeWithoutMoments) {
  const TopFoilBeam crests = make_top_foil_beam(formed_design(20e-3));
  TopFoilBeam columns = crests;
  columns.theta = Vector::LinSpaced(311, 0.02, 6.22);
  columns.theta[17] += 0.007;
  for (const TopFoilBeam& beam : {crests, columns}) {
    for (const Forming& forming : {Forming{.uniform = 2.0, .graded = 0.0, .end_angle = 6.24},
                                   Forming{.uniform = 0.0, .graded = 3.0, .end_angle = 6.24}}) {
      const Vector rotations = forming_rotations(beam, forming);
      const Vector kink = kinks(make_top_foil_moments(beam), free_shape(beam, forming));
      // Differences of u, up to 4e-3 m, over spans of 4e-4 m and more.
      EXPECT_LT((kink - rotations).cwiseAbs().maxCoeff(), 1e-12 * rotations.cwiseAbs().maxCoeff() + 1e-13);
      EXPECT_GT(rotations.cwiseAbs().maxCoeff(), 1e-4);
    }
  }
}

/// x with the free shape of the top foil and an undeformed bump foil.
Vector with_top_foil(const FoilStructure& structure, const Vector& u) {
  Vector x = Vector::Zero(structure.K.rows());
  x(Eigen::seqN(Eigen::Index{structure.dofs.top_u}, u.size(), Eigen::Index{structure.dofs.size})) = u;
  return x;
}

TEST(FormedStructure, HasNeitherForcesNorEnergyInItsFreeShape) {
  const FoilDesign foils = formed_design(1.02 * 19.05e-3, 200.0);
  const FoilStructure structure = make_foil_structure(foils);
  const TopFoilBeam beam = make_top_foil_beam(foils);
  const Vector x = with_top_foil(structure, free_shape(beam, make_forming(foils)));
  const ElasticResponse flat = elastic_response(structure, Vector::Zero(structure.K.rows()));
  const ElasticResponse free = elastic_response(structure, x);
  EXPECT_LT(free.forces.cwiseAbs().maxCoeff(), 1e-9 * flat.forces.cwiseAbs().maxCoeff());
  EXPECT_NEAR(free.energy, 0.0, 1e-9 * flat.energy);
  // Held on the circle at its crests, the foil is bent by kappa_0 up to the last one: EI' kappa_0^2 / 2 per length,
  // except for the sag between crests.
  const double kappa = 1.029283;
  const ElasticResponse uniform =
      elastic_response(make_foil_structure(formed_design(1.02 * 19.05e-3)), Vector::Zero(structure.K.rows()));
  EXPECT_NEAR(uniform.energy, 0.5 * 0.0007872451 * kappa * kappa * 19.05e-3 * beam.theta[25], 0.02 * uniform.energy);
}

/// Forces are derivatives of the energy, and satisfy K x = forming + forces with compatible moments.
TEST(FormedStructure, ForcesAreDerivativesOfItsEnergy) {
  const FoilStructure structure = make_foil_structure(formed_design(1.02 * 19.05e-3, 200.0));
  const Vector u = 1e-5 * Vector::Random(26);
  const Vector forces = elastic_response(structure, with_top_foil(structure, u)).forces;
  for (const Eigen::Index crest : {0, 1, 12, 25}) {
    constexpr double step = 1e-7;
    Vector more = u;
    more[crest] += step;
    Vector less = u;
    less[crest] -= step;
    const double derivative = (elastic_response(structure, with_top_foil(structure, more)).energy -
                               elastic_response(structure, with_top_foil(structure, less)).energy) /
                              (2.0 * step);
    const double force = forces[crest * structure.dofs.size + structure.dofs.top_u];
    EXPECT_NEAR(derivative, force, 1e-6 * forces.cwiseAbs().maxCoeff());  // quadratic: round-off only
  }
}

TEST(FormedStructure, IsLaidFlatInAStrip) {
  Case input = reference_case();
  input.top_foil.formed_radius = {FormedTo::radius, 20e-3};
  const FoilDesign strip = make_strip_design(input, 5, StripWeld::one_end, true);
  EXPECT_EQ(make_foil_structure(strip).forming.cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace bumpfoil
