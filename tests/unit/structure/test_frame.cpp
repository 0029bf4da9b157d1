#include "bumpfoil/structure/frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "core/linear_algebra.hpp"
#include "structure/planar_frame.hpp"

namespace bumpfoil {
namespace {

FoilDesign frame_foils(int bumps, WeldPosition weld_at) {
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.bumps = bumps;
  input.bump_foil.weld_at = weld_at;
  return make_bearing_design(input);
}

/// Dense matrix of the bump foil alone, without the unknowns of the top foil: 9 unknowns per bump.
Matrix bump_foil_stiffness(const FrameModel& model) {
  const auto bumps = static_cast<int>(model.arcs.size());
  BlockTridiagonal K(bumps, frame_dofs().size);
  assemble_frame(model, K);
  std::vector<Eigen::Index> own;
  for (Eigen::Index n = 0; n < bumps; ++n) {
    for (Eigen::Index dof = 0; dof < 9; ++dof) own.push_back(n * frame_dofs().size + dof);
  }
  return K.dense()(own, own);
}

TEST(FrameModel, IsPositiveDefiniteAndSymmetric) {
  for (const WeldPosition weld_at : {WeldPosition::mid_flat, WeldPosition::arc_start}) {
    for (const int bumps : {1, 2, 10}) {
      const Matrix K = bump_foil_stiffness(make_frame_model(frame_foils(bumps, weld_at)));
      EXPECT_EQ(K, K.transpose());
      EXPECT_GT(symmetric_eigenvalues(K).minCoeff(), 0.0);
    }
  }
}

TEST(FrameModel, RigidMotionOfTheFoilAfterTheWeldStrainsTheFirstFlatOnly) {
  const FrameModel model = make_frame_model(frame_foils(4, WeldPosition::mid_flat));
  const double angle = 1e-3;
  Vector x(36);
  for (Eigen::Index n = 0; n < 4; ++n) {
    const double crest = (static_cast<double>(n) + 0.5) * model.rotation_scale;
    const double l0 = model.arcs[0].half_length;
    const double turned = angle * model.rotation_scale;
    x.segment(9 * n, 9) << 0.0, angle * (crest - l0), turned, angle * model.arcs[0].rise, angle * crest, turned, 0.0,
        angle * (crest + l0), turned;
  }
  const Matrix K = bump_foil_stiffness(model);
  const Vector forces = K * x;
  EXPECT_LT(forces.tail(33).norm(), 1e-13 * K.norm() * x.norm());
  // Half a flat, clamped at one end, its other end turned by `angle` about the clamp: 6 EI / l^2 - 12 EI / l^2.
  const double l = 0.5 * model.arcs[0].flat;
  const double expected = (12.0 * l - 6.0 * l) * model.sections[0].bending_stiffness / (l * l * l) * angle;
  EXPECT_NEAR(forces[1], expected, 1e-10 * expected);
}

TEST(FrameModel, ClampedArcStartIsCoupledToNothing) {
  const Matrix K = bump_foil_stiffness(make_frame_model(frame_foils(3, WeldPosition::arc_start)));
  EXPECT_EQ(K.topRightCorner(3, 24).norm(), 0.0);
  EXPECT_TRUE(K.topLeftCorner(3, 3).isDiagonal(0.0));
  // The result is the same foil with a rigid flat before it.
  FrameModel flat_weld = make_frame_model(frame_foils(3, WeldPosition::mid_flat));
  const Matrix with_flat = bump_foil_stiffness(flat_weld);
  EXPECT_LT((K.bottomRightCorner(24, 24) - with_flat.bottomRightCorner(24, 24)).norm(), 1e-15 * K.norm());
}

TEST(FrameModel, BumpOfItsOwnHeightChangesItsArcAlone) {
  FoilDesign foils = frame_foils(3, WeldPosition::mid_flat);
  const Matrix nominal = bump_foil_stiffness(make_frame_model(foils));
  foils.bumps[1].rise += 20e-6;
  const Matrix own = bump_foil_stiffness(make_frame_model(foils));
  // The crest of the second bump changes by a few per cent for 5 % more rise; entries without a contribution of its
  // arcs do not change.
  EXPECT_GT(std::abs(own(13, 13) / nominal(13, 13) - 1.0), 0.01);
  EXPECT_EQ(own.topLeftCorner(6, 6), nominal.topLeftCorner(6, 6));
}

/// Three different bumps.
FoilDesign graded_foils() {
  FoilDesign foils = frame_foils(3, WeldPosition::mid_flat);
  foils.bumps[1] = {.pitch = 5e-3, .half_length = 2.1e-3, .rise = 0.5e-3, .thickness = 0.13e-3};
  foils.bumps[2] = {.pitch = 4.2e-3, .half_length = 1.5e-3, .rise = 0.3e-3, .thickness = 0.09e-3};
  return foils;
}

TEST(FrameModel, OfDifferentBumpsIsThatOfItsElements) {
  // By hand: each half flat is a separate element; the nodes in the middle of the flats are condensed afterwards.
  const FoilDesign foils = graded_foils();
  PlanarFrame by_hand(1 + 3 * 4);
  PlanarFrame::Unknowns kept;
  for (int n = 0; n < 3; ++n) {
    const BumpShape& bump = foils.bumps[static_cast<std::size_t>(n)];
    const double foot = bump.half_length;
    const double radius = (foot * foot + bump.rise * bump.rise) / (2.0 * bump.rise);
    const double angle = std::asin(foot / radius);
    const double half_flat = 0.5 * bump.pitch - foot;
    const Section section = make_bump_section(foils, bump);
    by_hand.add(4 * n, 4 * n + 1, section, {{half_flat, 0.0}, 0.0});
    by_hand.add(4 * n + 1, 4 * n + 2, section, {{foot, -bump.rise}, angle});
    by_hand.add(4 * n + 2, 4 * n + 3, section, {{foot, bump.rise}, angle});
    if (n < 2) by_hand.add(4 * n + 3, 4 * n + 4, section, {{half_flat, 0.0}, 0.0});
    for (int k = 0; k < 9; ++k) kept.push_back(3 * (4 * n + 1) + k);
  }
  // Nothing follows the last arc: its node is unconnected, and eliminated with the weld.
  Matrix expected = by_hand.condense(kept, {0, 1, 2, 36, 37, 38});
  for (Eigen::Index i = 0; i < 9; ++i) {
    expected.row(3 * i + 2) /= foils.bumps[0].pitch;
    expected.col(3 * i + 2) /= foils.bumps[0].pitch;
  }
  const Matrix K = bump_foil_stiffness(make_frame_model(foils));
  EXPECT_LT((K - expected).norm(), 1e-12 * expected.norm());
}

TEST(FrameModel, MirroredFoilIsTheMirrorImage) {
  FoilDesign foils = graded_foils();
  foils.welded = false;
  FrameModel model = make_frame_model(foils);
  const Matrix K = bump_foil_stiffness(model);
  std::reverse(foils.bumps.begin(), foils.bumps.end());
  FrameModel mirrored = make_frame_model(foils);
  mirrored.rotation_scale = model.rotation_scale;
  Matrix image(27, 27);
  const Matrix other = bump_foil_stiffness(mirrored);
  for (Eigen::Index i = 0; i < 27; ++i) {
    for (Eigen::Index j = 0; j < 27; ++j) {
      // Nodes in reverse order; u and rotations change sign.
      const double sign = (i % 3 == 1 ? 1.0 : -1.0) * (j % 3 == 1 ? 1.0 : -1.0);
      image(i, j) = sign * other(3 * (8 - i / 3) + i % 3, 3 * (8 - j / 3) + j % 3);
    }
  }
  EXPECT_LT((K - image).norm(), 1e-14 * K.norm());
}

TEST(FrameModel, GroupsOfBumpsRepeatTheirOwnRows) {
  FoilDesign thin = frame_foils(12, WeldPosition::mid_flat);
  FoilDesign thick = thin;
  for (BumpShape& bump : thick.bumps) {
    bump.rise = 0.5e-3;
    bump.thickness = 0.12e-3;
  }
  FoilDesign groups = thin;
  std::copy(thick.bumps.begin() + 6, thick.bumps.end(), groups.bumps.begin() + 6);
  const Matrix K = bump_foil_stiffness(make_frame_model(groups));
  const Matrix before = bump_foil_stiffness(make_frame_model(thin));
  const Matrix after = bump_foil_stiffness(make_frame_model(thick));
  // All except the arc ends at the flat between the groups, bumps 6 and 7.
  EXPECT_EQ(K.topLeftCorner(51, 51), before.topLeftCorner(51, 51));
  EXPECT_EQ(K.bottomRightCorner(51, 51), after.bottomRightCorner(51, 51));
  EXPECT_NE(K(51, 51), before(51, 51));
  EXPECT_NE(K(51, 51), after(51, 51));
}

TEST(FrameStress, TakesTheSectionOfItsBump) {
  // A force at the free end of two cantilevered bumps: moments follow from statics for any thickness.
  FoilDesign foils = frame_foils(2, WeldPosition::arc_start);
  foils.bumps[1].thickness *= 1.5;
  const FrameModel model = make_frame_model(foils);
  const double force = 2.0;
  const Matrix K = bump_foil_stiffness(model);
  const Vector moved = solve_symmetric(K, force * Vector::Unit(18, 16));
  Vector x = Vector::Zero(22);
  x.head(9) = moved.head(9);
  x.segment(11, 9) = moved.tail(9);
  const FrameStress stress = frame_stress(model, x);
  const double l0 = model.arcs[0].half_length;
  const double p = foils.bumps[0].pitch;
  EXPECT_NEAR(stress.crest[0], force * (p + l0) / model.sections[0].modulus, 1e-9 * stress.crest[0]);
  EXPECT_NEAR(stress.crest[1], force * l0 / model.sections[1].modulus, 1e-9 * stress.crest[0]);
  EXPECT_NEAR(stress.arc_start[1], force * 2.0 * l0 / model.sections[1].modulus, 1e-9 * stress.crest[0]);
}

TEST(FrameStress, OfABumpPressedBetweenSlidingFeet) {
  // A symmetric bump far from the weld: the middle one of five, all crests equally loaded. Its moments must balance the
  // crest load, with the maximum at the crest.
  const FrameModel model = make_frame_model(frame_foils(5, WeldPosition::mid_flat));
  const Matrix K = bump_foil_stiffness(model);
  std::vector<Eigen::Index> free;
  Vector load = Vector::Zero(45);
  const double crest_load = 30.0;
  for (Eigen::Index n = 0; n < 5; ++n) {
    load[9 * n + 4] = crest_load;
    for (Eigen::Index dof = 0; dof < 9; ++dof) {
      if (dof != 1 && dof != 7) free.push_back(9 * n + dof);
    }
  }
  const Matrix stiffness = K(free, free);
  const Vector load_free = load(free);
  const Vector moved = solve_symmetric(stiffness, load_free);
  Vector x = Vector::Zero(55);
  for (std::size_t i = 0; i < free.size(); ++i) {
    x[free[i] / 9 * 11 + free[i] % 9] = moved[static_cast<Eigen::Index>(i)];
  }
  const FrameStress stress = frame_stress(model, x);
  // Mirror symmetry; neighbours differ by end effects, which decay to less than a tenth per bump.
  EXPECT_NEAR(stress.arc_start[2], stress.arc_end[2], 0.05 * stress.crest[2]);
  EXPECT_GE(stress.largest[2], stress.crest[2]);
  // No thrust except that of the flats, which vanishes for a free pitch: crest and foot share P l0 / 2.
  const double static_moment = 0.5 * crest_load * model.arcs[2].half_length / model.sections[0].modulus;
  EXPECT_NEAR(stress.crest[2] + 0.5 * (stress.arc_start[2] + stress.arc_end[2]), static_moment, 0.02 * static_moment);
  EXPECT_GT(stress.weld, 0.0);
}

TEST(FrameStress, IsFreeOfRigidMotionUnderLargeDisplacements) {
  // Everything after the first flat is turned about the weld by a finite angle: only this flat is bent.
  FrameModel model = make_frame_model(frame_foils(2, WeldPosition::mid_flat));
  const double angle = 0.2;
  const double l = 0.5 * model.arcs[0].flat;
  const double l0 = model.arcs[0].half_length;
  Vector x = Vector::Zero(22);
  for (Eigen::Index node = 0; node < 6; ++node) {
    const double along = l + static_cast<double>(node / 3) * model.rotation_scale + static_cast<double>(node % 3) * l0;
    const double out = node % 3 == 1 ? -model.arcs[0].rise : 0.0;
    x.segment<3>(11 * (node / 3) + 3 * (node % 3)) << along * (std::cos(angle) - 1.0) - out * std::sin(angle),
        along * std::sin(angle) + out * (std::cos(angle) - 1.0), angle * model.rotation_scale;
  }
  model.geometry = Geometry::nonlinear;
  const FrameStress turned = frame_stress(model, x);
  EXPECT_LT(turned.largest.maxCoeff(), 1e-9 * turned.weld);
  // The chord length of the flat is unchanged, and its end turns with the chord; its start is held by the weld.
  EXPECT_NEAR(turned.weld, 4.0 * model.sections[0].bending_stiffness / l * angle / model.sections[0].modulus,
              1e-9 * turned.weld);
  model.geometry = Geometry::linear;
  EXPECT_GT(frame_stress(model, x).largest.maxCoeff(), 0.01 * turned.weld);
}

TEST(FrameStress, CantileveredBumpUnderAnEndForceIsStaticallyDeterminate) {
  // One bump clamped at its start, force F along v at its free end: M = F * distance, zero at the end.
  const FrameModel model = make_frame_model(frame_foils(1, WeldPosition::arc_start));
  const double force = 2.0;
  const Vector moved = solve_symmetric(bump_foil_stiffness(model), force * Vector::Unit(9, 7));
  Vector x = Vector::Zero(11);
  x.head(9) = moved;
  const FrameStress stress = frame_stress(model, x);
  const double at_weld = force * 2.0 * model.arcs[0].half_length / model.sections[0].modulus;
  EXPECT_NEAR(stress.weld, at_weld, 1e-9 * at_weld);
  EXPECT_NEAR(stress.arc_start[0], at_weld, 1e-9 * at_weld);
  EXPECT_NEAR(stress.crest[0], 0.5 * at_weld, 1e-9 * at_weld);
  EXPECT_NEAR(stress.arc_end[0], 0.0, 1e-9 * at_weld);
  EXPECT_NEAR(stress.largest[0], at_weld, 1e-9 * at_weld);
}

}  // namespace
}  // namespace bumpfoil
