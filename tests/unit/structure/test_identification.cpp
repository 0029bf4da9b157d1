#include "bumpfoil/structure/identification.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/structure/frame.hpp"

namespace bumpfoil {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
const Section foil = make_section(214e9, 0.29, 38.1e-3, 0.102e-3);

BumpArc reference_arc(HeightReference reference) {
  BumpFoil bump = reference_case().bump_foil;
  bump.height_reference = reference;
  return make_bump_arc(bump);
}

TEST(Identification, ReferenceBumpWithTheHeightOfTheMidSurface) {
  const BumpArc arc = reference_arc(HeightReference::midsurface);  // rise 0.508 mm
  const BumpCell cell = make_bump_cell(arc, foil);
  const TrussConstants truss = identify_truss_constants(arc, foil);
  // Published to three or four digits; they are met to 0.1 %.
  EXPECT_NEAR(cell.a, 24.53e6, 1e-3 * 24.53e6);
  EXPECT_NEAR(cell.b, 34.92e6, 1e-3 * 34.92e6);
  EXPECT_NEAR(cell.d, 54.07e6, 1e-3 * 54.07e6);
  EXPECT_NEAR(cell.crest_stiffness(), 1.972e6, 1e-3 * 1.972e6);
  EXPECT_NEAR(truss.k1, 111.7e6, 1e-3 * 111.7e6);
  EXPECT_NEAR(truss.theta_d, 19.35 * degree, 0.01 * degree);
  EXPECT_NEAR(truss.k2, 3.556e6, 1e-3 * 3.556e6);
  EXPECT_NEAR(truss.k3, 0.791e6, 1e-3 * 0.791e6);
  EXPECT_NEAR(truss.k4, 6.67e6, 1e-3 * 6.67e6);
}

TEST(Identification, ReferenceBumpWithTheOverallHeight) {
  const BumpArc arc = reference_arc(HeightReference::overall);  // rise 0.406 mm
  const BumpCell cell = make_bump_cell(arc, foil);
  const TrussConstants truss = identify_truss_constants(arc, foil);
  EXPECT_NEAR(cell.a, 22.32e6, 1e-3 * 22.32e6);
  EXPECT_NEAR(cell.b, 39.36e6, 1e-3 * 39.36e6);
  EXPECT_NEAR(cell.d, 76.21e6, 1e-3 * 76.21e6);
  EXPECT_NEAR(cell.crest_stiffness(), 1.988e6, 1e-3 * 1.988e6);
  EXPECT_NEAR(truss.k1, 150.0e6, 1e-3 * 150.0e6);
  EXPECT_NEAR(truss.theta_d, 15.83 * degree, 0.01 * degree);
  EXPECT_NEAR(truss.k2, 5.450e6, 1e-3 * 5.450e6);
  EXPECT_NEAR(truss.k3, 1.340e6, 1e-3 * 1.340e6);
  EXPECT_NEAR(truss.k4, 11.15e6, 1e-3 * 11.15e6);
}

TEST(Identification, TrussIsExactForTheUniformCell) {
  const BumpArc arc = reference_arc(HeightReference::overall);
  const BumpCell cell = make_bump_cell(arc, foil);
  const TrussConstants truss = identify_truss_constants(arc, foil);
  // One bump of an endless truss whose crests move by v and whose pitch grows by e: elongations of the four springs.
  const double v = 3e-6;
  const double e = -2e-6;
  const double rod = 0.5 * e * std::cos(truss.theta_d) - v * std::sin(truss.theta_d);
  const double energy = truss.k1 * rod * rod + 0.5 * (truss.k2 + truss.k3) * e * e;
  EXPECT_NEAR(energy, 0.5 * cell.a * v * v - cell.b * v * e + 0.5 * cell.d * e * e, 1e-12 * energy);
}

TEST(Identification, CellIsThatOfALongFrame) {
  // Ten bumps of the frame model between the welds' neighbourhoods repeat the cell: all crests pressed by 1 m, feet on
  // the sleeve and sliding. The load of a middle bump is the crest stiffness of the cell whose pitch adapts.
  Case input = reference_case();
  input.bump_foil.bumps = 12;
  const FrameModel model = make_frame_model(input);
  const BumpDofs dofs = frame_dofs();
  BlockTridiagonal K(input.bump_foil.bumps, dofs.size);
  assemble_frame(model, K);
  std::vector<Eigen::Index> free;
  std::vector<Eigen::Index> crests;
  for (Eigen::Index n = 0; n < 12; ++n) {
    for (const Eigen::Index dof : {0, 2, 3, 5, 6, 8}) free.push_back(n * dofs.size + dof);
    crests.push_back(n * dofs.size + dofs.crest_v);
  }
  const Matrix dense = K.dense();
  const Vector pressed = Vector::Ones(12);
  const Matrix stiffness = dense(free, free);
  const Vector moved = stiffness.ldlt().solve(-(dense(free, crests) * pressed));
  const Vector loads = dense(crests, crests) * pressed + dense(crests, free) * moved;
  const double cell = make_bump_cell(make_bump_arc(input.bump_foil), foil).crest_stiffness();
  EXPECT_NEAR(loads[6], cell, 1e-4 * cell);  // the ends are felt by less than a tenth per bump
}

TEST(Identification, FirstBumpOfTrussAndFrameAreEquallyStiff) {
  Case input = reference_case();
  const TrussConstants truss = make_truss_constants(input);
  const BumpDofs dofs{.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};
  BlockTridiagonal K(1, 4);
  assemble_springs(make_truss_springs(truss, dofs, 1), K);
  const Eigen::Matrix3d sliding = K.dense().topLeftCorner<3, 3>();
  const double stiffness = 1.0 / sliding.inverse()(1, 1);

  // The frame from a weld to the next mid-flat; half a flat is added by hand after the arc.
  input.bump_foil.bumps = 1;
  const FrameModel model = make_frame_model(input);
  BlockTridiagonal frame(1, 11);
  assemble_frame(model, frame);
  Matrix dense = Matrix::Zero(12, 12);
  dense.topLeftCorner(9, 9) = frame.dense().topLeftCorner(9, 9);
  const ElementMatrix flat = frame_element_stiffness(model.section, flat_element(0.5 * model.arcs[0].flat));
  Eigen::Matrix<double, 6, 1> scale;
  scale << 1, 1, 1 / model.pitch, 1, 1, 1 / model.pitch;
  dense.bottomRightCorner(6, 6) += scale.asDiagonal() * flat * scale.asDiagonal();
  const std::vector<int> free{0, 2, 3, 4, 5, 6, 8, 9, 10};  // sleeve under rows 1 and 7, slope 11 zero
  const Matrix kept = dense(free, free);
  const Matrix compliance = kept.inverse();
  EXPECT_NEAR(stiffness, 1.0 / compliance(3, 3), 1e-9 * stiffness);
}

TEST(TrussConstants, GivenOnesReplaceTheIdentifiedOnes) {
  Case input = reference_case();
  const TrussConstants identified = make_truss_constants(input);
  input.bump_foil.truss.k2 = 4e6;
  input.bump_foil.truss.theta_d = 0.3;
  const TrussConstants mixed = make_truss_constants(input);
  EXPECT_EQ(mixed.k1, identified.k1);
  EXPECT_EQ(mixed.k2, 4e6);
  EXPECT_EQ(mixed.k3, identified.k3);
  EXPECT_EQ(mixed.k4, identified.k4);
  EXPECT_EQ(mixed.theta_d, 0.3);
}

TEST(TrussConstants, ShapesThatATrussCannotFollowAreRefusedWithAdvice) {
  Case input = reference_case();
  input.bump_foil.pitch = input.bump_foil.length + 4e-3;  // flats longer than the bumps: k2 < 0
  try {
    make_truss_constants(input);
    FAIL() << "accepted";
  } catch (const Error& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.faults()[0].key, "bump_foil.truss.k2");
    EXPECT_NE(error.faults()[0].advice.find("frame"), std::string::npos);
  }
  EXPECT_EQ(find_truss_faults(input).size(), 1U);
  EXPECT_TRUE(find_truss_faults(reference_case()).empty());
  input.bump_foil.truss.k2 = 1e6;
  EXPECT_EQ(make_truss_constants(input).k2, 1e6);
}

}  // namespace
}  // namespace bumpfoil
