#include "bumpfoil/structure/foil_structure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/frame.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "bumpfoil/structure/truss.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

Case given_constants(int bumps) {
  Case input = reference_case();
  input.bearing.radius *= std::max(1.0, bumps / 26.0);
  input.bump_foil.bumps = bumps;
  input.bump_foil.truss = {
      .k1 = 150e6, .k2 = 5.43e6, .k3 = 1.36e6, .k4 = 11.25e6, .theta_d = 15.83 * std::numbers::pi / 180.0};
  return input;
}

Vector any_displacements(const FoilStructure& structure) {
  return 1e-5 * Vector::LinSpaced(structure.K.rows(), 0.3, 40.0).array().sin();
}

auto every(const FoilStructure& structure, int dof) {
  return Eigen::seqN(Eigen::Index{dof}, Eigen::Index{structure.bumps()}, Eigen::Index{structure.dofs.size});
}

TEST(FoilStructure, SolvesTheTopFoilLikeItsCompliance) {
  for (const int bumps : {1, 2, 3, 26, 60}) {
    const Case input = given_constants(bumps);
    const FoilStructure structure = make_foil_structure(make_bearing_design(input));
    const Vector load = Vector::LinSpaced(bumps, 1.0, -2.0);
    Vector right = Vector::Zero(structure.K.rows());
    right(every(structure, structure.dofs.top_u)) = load;
    const Vector x = solve(structure.K.dense(), right);
    const Vector expected = top_foil_compliance(make_top_foil_beam(make_bearing_design(input))) * load;
    // Condition number of the foil, 4e6 at 60 bumps, times machine precision.
    EXPECT_LT((x(every(structure, structure.dofs.top_u)) - expected).norm(), 1e-9 * expected.norm()) << bumps;
  }
}

TEST(FoilStructure, MomentsAreScaledByThePitchAndTheBendingStiffness) {
  const Case input = given_constants(26);
  const FoilStructure structure = make_foil_structure(make_bearing_design(input));
  const TopFoilBeam beam = make_top_foil_beam(make_bearing_design(input));
  Vector right = Vector::Zero(structure.K.rows());
  right(every(structure, structure.dofs.top_u)).setOnes();
  const Vector x = solve(structure.K.dense(), right);
  const Vector u = x(every(structure, structure.dofs.top_u));
  const Vector moments = top_foil_moments(make_top_foil_moments(beam), u);
  const Vector scaled = x(every(structure, structure.dofs.top_moment));
  const double p = input.bump_foil.pitch.values.front();
  EXPECT_LT((scaled.head(25) * beam.bending_stiffness / (p * p) - moments.tail(25)).norm(), 1e-9 * moments.norm());
  EXPECT_EQ(scaled[25], 0.0);
}

TEST(FoilStructure, ForcesAreThoseOfTheTwoFoils) {
  for (const int bumps : {1, 2, 26}) {
    const Case input = given_constants(bumps);
    const FoilStructure structure = make_foil_structure(make_bearing_design(input));
    const Vector x = any_displacements(structure);
    const Vector forces = elastic_response(structure, x).forces;

    const Vector top =
        top_foil_loads(make_top_foil_moments(make_bearing_design(input)), x(every(structure, structure.dofs.top_u)));
    EXPECT_LT((forces(every(structure, structure.dofs.top_u)) - top).norm(), 1e-12 * top.norm()) << bumps;
    EXPECT_EQ(forces(every(structure, structure.dofs.top_moment)).norm(), 0.0);

    const std::vector<Spring> springs =
        make_truss_springs(make_truss_constants(make_bearing_design(input)), structure.dofs);
    const double truss_energy = spring_energy(springs, structure.dofs.size, x);
    const double top_energy = 0.5 * top.dot(x(every(structure, structure.dofs.top_u)));
    EXPECT_NEAR(elastic_response(structure, x).energy, truss_energy + top_energy, 1e-13 * truss_energy);
    EXPECT_GT(top_energy, 1e-6 * truss_energy);  // large enough to be significant
  }
}

TEST(FoilStructure, ForcesDoNotDependOnTheMomentsGiven) {
  const FoilStructure structure = make_foil_structure(make_bearing_design(given_constants(5)));
  Vector x = any_displacements(structure);
  const Vector forces = elastic_response(structure, x).forces;
  x(every(structure, structure.dofs.top_moment)).setConstant(1.0);
  EXPECT_EQ(elastic_response(structure, x).forces, forces);
}

TEST(FoilStructure, IsWellScaledAndQuasidefinite) {
  const FoilStructure structure = make_foil_structure(make_bearing_design(given_constants(26)));
  const Matrix K = structure.K.dense();
  const Vector modes = symmetric_eigenvalues(K);
  EXPECT_EQ((modes.array() < 0.0).count(), 26);  // one per moment

  // The truss alone has a condition number of 2e9; the top foil of the same bearing has 1.3e5 with K_t, and less in the
  // moment form.
  std::vector<Eigen::Index> top;
  for (Eigen::Index b = 0; b < structure.bumps(); ++b) {
    top.push_back(b * structure.dofs.size + structure.dofs.top_u);
    top.push_back(b * structure.dofs.size + structure.dofs.top_moment);
  }
  const Matrix top_part = K(top, top);
  const Vector magnitudes = symmetric_eigenvalues(top_part).cwiseAbs();
  EXPECT_LT(magnitudes.maxCoeff() / magnitudes.minCoeff(), 5e4);
}

TEST(FoilStructure, FrameModelHasTheSameTopFoil) {
  for (const WeldPosition weld_at : {WeldPosition::mid_flat, WeldPosition::arc_start}) {
    Case input = given_constants(5);
    input.bump_foil.model = BumpFoilModel::frame;
    input.bump_foil.weld_at = weld_at;
    const FoilStructure structure = make_foil_structure(make_bearing_design(input));
    EXPECT_EQ(structure.dofs.size, 11);
    EXPECT_EQ(structure.dofs.feet(), 2);
    const Vector x = any_displacements(structure);
    const Vector forces = elastic_response(structure, x).forces;

    BlockTridiagonal bump_foil(5, structure.dofs.size);
    assemble_frame(make_frame_model(make_bearing_design(input)), bump_foil);
    Vector expected = bump_foil.multiply(x);
    expected(every(structure, structure.dofs.top_u)) =
        top_foil_loads(make_top_foil_moments(make_bearing_design(input)), x(every(structure, structure.dofs.top_u)));
    EXPECT_LT((forces - expected).norm(), 1e-13 * expected.norm());
    const Vector top = expected(every(structure, structure.dofs.top_u));
    EXPECT_LT((forces(every(structure, structure.dofs.top_u)) - top).norm(), 1e-12 * top.norm());
  }
}

/// Frame of five bumps, with or without large displacements.
FoilStructure frame_structure(Geometry geometry, WeldPosition weld_at) {
  Case input = given_constants(5);
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.geometry = geometry;
  input.bump_foil.weld_at = weld_at;
  return make_foil_structure(make_bearing_design(input));
}

TEST(LargeDisplacements, TangentAndEnergyBelongToTheForces) {
  for (const WeldPosition weld_at : {WeldPosition::mid_flat, WeldPosition::arc_start}) {
    const FoilStructure structure = frame_structure(Geometry::nonlinear, weld_at);
    const Vector x = any_displacements(structure);
    const Vector direction = Vector::LinSpaced(x.size(), -1.0, 2.0).array().cos();
    const Vector slope = tangent_stiffness(structure, x).multiply(direction);
    const Vector forces = elastic_response(structure, x).forces;
    double best_slope = 1.0;
    double best_energy = 1.0;
    for (const double h : {1e-6, 1e-7, 1e-8}) {  // m; central differences, from truncation to round-off
      const Vector difference =
          (internal_forces(structure, x + h * direction) - internal_forces(structure, x - h * direction)) / (2.0 * h);
      best_slope = std::min(best_slope, (difference - slope).norm() / slope.norm());
      const double gain =
          elastic_response(structure, x + h * direction).energy - elastic_response(structure, x - h * direction).energy;
      best_energy = std::min(best_energy, std::abs(gain / (2.0 * h) / forces.dot(direction) - 1.0));
    }
    EXPECT_LT(best_slope, 1e-8);
    EXPECT_LT(best_energy, 1e-7);
  }
}

TEST(LargeDisplacements, AreSmallNearTheUndeformedFoils) {
  for (const WeldPosition weld_at : {WeldPosition::mid_flat, WeldPosition::arc_start}) {
    const FoilStructure linear = frame_structure(Geometry::linear, weld_at);
    const FoilStructure large = frame_structure(Geometry::nonlinear, weld_at);
    EXPECT_EQ(large.K.dense(), linear.K.dense());
    const Vector at_rest = Vector::Zero(linear.K.rows());
    EXPECT_LT((tangent_stiffness(large, at_rest).dense() - linear.K.dense()).norm(), 1e-15 * linear.K.dense().norm());
    EXPECT_EQ(stable_tangent_stiffness(large, at_rest).dense(), tangent_stiffness(large, at_rest).dense());
    EXPECT_EQ(tangent_stiffness(linear, any_displacements(linear)).dense(), linear.K.dense());
    for (const double factor : {1e-2, 1e-3}) {
      const Vector x = factor * any_displacements(linear);
      const Vector forces = elastic_response(linear, x).forces;
      // Displacements of about 1e-5 m in elements of 1e-3 m: second order.
      EXPECT_LT((elastic_response(large, x).forces - forces).norm(), 0.1 * factor * forces.norm());
      EXPECT_NEAR(elastic_response(large, x).energy, elastic_response(linear, x).energy,
                  0.1 * factor * elastic_response(linear, x).energy);
      EXPECT_GT((elastic_response(large, x).forces - forces).norm(), 1e-4 * factor * forces.norm());
    }
  }
}

TEST(LargeDisplacements, LeaveTheTopFoilLinear) {
  const FoilStructure linear = frame_structure(Geometry::linear, WeldPosition::mid_flat);
  const FoilStructure large = frame_structure(Geometry::nonlinear, WeldPosition::mid_flat);
  const Vector x = any_displacements(linear);
  const auto top = every(linear, linear.dofs.top_u);
  EXPECT_EQ(Vector(elastic_response(large, x).forces(top)), Vector(elastic_response(linear, x).forces(top)));
  EXPECT_EQ(elastic_response(large, x).forces(every(large, large.dofs.top_moment)).norm(), 0.0);
}

TEST(FoilStructure, OfDifferentBumpsIsTheSumOfItsFoils) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    FoilDesign foils = make_bearing_design(reference_case());
    foils.model = model;
    foils.bumps.resize(3);
    foils.bumps[1] = {.pitch = 5e-3, .half_length = 2e-3, .rise = 0.5e-3, .thickness = 0.11e-3};
    foils.bumps[2] = {.pitch = 4e-3, .half_length = 1.5e-3, .rise = 0.35e-3, .thickness = 0.09e-3};
    const FoilStructure structure = make_foil_structure(foils);
    const Vector x = any_displacements(structure);
    BlockTridiagonal bump_foil(3, structure.dofs.size);
    if (model == BumpFoilModel::frame) {
      assemble_frame(make_frame_model(foils), bump_foil);
    } else {
      assemble_springs(make_truss_springs(make_truss_constants(foils), structure.dofs), bump_foil);
    }
    const Vector top = top_foil_loads(make_top_foil_moments(foils), x(every(structure, structure.dofs.top_u)));
    Vector expected = bump_foil.multiply(x);
    expected(every(structure, structure.dofs.top_u)) = top;
    const Vector forces = elastic_response(structure, x).forces;
    EXPECT_LT((forces - expected).norm(), 1e-13 * expected.norm());
    EXPECT_LT((forces(every(structure, structure.dofs.top_u)) - top).norm(), 1e-12 * top.norm());
  }
}

TEST(LargeDisplacements, OfDifferentBumpsAreSmallNearTheUndeformedFoils) {
  FoilDesign foils = make_bearing_design(reference_case());
  foils.model = BumpFoilModel::frame;
  foils.bumps.resize(3);
  foils.bumps[1].thickness = 0.12e-3;
  foils.bumps[2].pitch = 5e-3;
  const FoilStructure linear = make_foil_structure(foils);
  foils.geometry = Geometry::nonlinear;
  const FoilStructure large = make_foil_structure(foils);
  EXPECT_EQ(large.K.dense(), linear.K.dense());
  const Vector x = 1e-3 * any_displacements(linear);
  const Vector forces = elastic_response(linear, x).forces;
  EXPECT_LT((elastic_response(large, x).forces - forces).norm(), 1e-4 * forces.norm());  // second order, as above
}

TEST(FoilStructure, TakesTheFoilsOfFurtherPads) {
  for (const Geometry geometry : {Geometry::linear, Geometry::nonlinear}) {
    Case input = reference_case();
    input.top_foil.formed_radius = {FormedTo::radius, 1.02 * 19.05e-3};
    FoilDesign design = make_bearing_design(input);
    design.model = BumpFoilModel::frame;
    design.geometry = geometry;
    design.bumps.resize(3);
    const FoilStructure first = make_foil_structure(design);
    design.bumps.resize(2);
    design.bumps[0].pitch = design.bumps[1].pitch = 5e-3;
    const FoilStructure second = make_foil_structure(design);
    FoilStructure both = first;
    append(second, both);
    EXPECT_EQ(both.pads, (std::vector<int>{0, 3}));
    EXPECT_EQ(both.bumps(), 5);
    EXPECT_EQ(both.blocks_of(0).count, 3);
    EXPECT_EQ(both.blocks_of(1).first, 3);
    EXPECT_EQ(both.blocks_of(1).count, 2);
    const Vector a = any_displacements(first);
    const Vector b = any_displacements(second);
    Vector x(a.size() + b.size());
    x << a, b;
    Vector forces(x.size());
    forces << internal_forces(first, a), internal_forces(second, b);
    EXPECT_LT((internal_forces(both, x) - forces).norm(), 1e-14 * forces.norm());
    EXPECT_NEAR(elastic_response(both, x).energy,
                elastic_response(first, a).energy + elastic_response(second, b).energy,
                1e-13 * elastic_response(both, x).energy);
    BlockTridiagonal tangent = tangent_stiffness(first, a);
    tangent.append(tangent_stiffness(second, b));
    EXPECT_LT((tangent_stiffness(both, x).dense() - tangent.dense()).norm(), 1e-14 * tangent.dense().norm());
  }
}

TEST(FoilStructure, FormerModelHasNoTopFoil) {
  Case input = given_constants(3);
  input.bump_foil.model = BumpFoilModel::former;
  const FoilStructure structure = make_foil_structure(make_bearing_design(input));
  EXPECT_EQ(structure.dofs.size, 4);
  EXPECT_EQ(structure.dofs.top_u, -1);
  const Vector x = any_displacements(structure);
  EXPECT_EQ(elastic_response(structure, x).forces, structure.K.multiply(x));
}

TEST(FoilStructure, KeepsUnusedPlacesApart) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = given_constants(3);
    input.bump_foil.model = model;
    const FoilStructure with = make_foil_structure(make_bearing_design(input));
    FoilDesign without_top_foil = make_bearing_design(input);
    without_top_foil.top_foil.reset();
    const FoilStructure without = make_foil_structure(without_top_foil);
    EXPECT_EQ(without.dofs.top_u, -1);
    EXPECT_EQ(without.dofs.size, with.dofs.size);
    const Matrix a = with.K.dense();
    const Matrix b = without.K.dense();
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      const auto place = static_cast<int>(i % with.dofs.size);
      if (place == with.dofs.top_u || place == with.dofs.top_moment) {
        EXPECT_GT(b(i, i), 1e6);
        EXPECT_EQ(b.row(i).cwiseAbs().sum(), b(i, i));
      } else {
        EXPECT_EQ(a.row(i), b.row(i));
      }
    }
  }
}

TEST(FoilStructure, WithoutAWeldIsHeldLooselyAndNotAtAllInside) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = given_constants(4);
    input.bump_foil.model = model;
    FoilDesign foils = make_bearing_design(input);
    foils.radius.reset();
    foils.welded = false;
    const FoilStructure structure = make_foil_structure(foils);
    EXPECT_EQ(structure.bumps(), 4);
    EXPECT_EQ(structure.first_bump, model == BumpFoilModel::truss ? 1 : 0);
    // A shift of all along the foil, and of the top foil across it with a tilt, strains only the weak restraining
    // springs.
    Vector x = Vector::Zero(structure.K.rows());
    const Eigen::Index size = structure.dofs.size;
    for (Eigen::Index b = 0; b < structure.K.blocks(); ++b) {
      for (const int u : structure.dofs.foot_u) x[b * size + u] = 1e-6;
      if (b < structure.first_bump) continue;
      x[b * size + structure.dofs.crest_u] = 1e-6;
      x[b * size + structure.dofs.top_u] = 1e-6 * static_cast<double>(b);
    }
    // Round-off of 1e8 N/m times a micrometre is far below.
    EXPECT_LT(elastic_response(structure, x).forces.cwiseAbs().maxCoeff(), 4e-6 * loose_hold + 1e-13 * 1e2);
    EXPECT_GT(elastic_response(structure, x).energy, 0.0);
  }
}

}  // namespace
}  // namespace bumpfoil
