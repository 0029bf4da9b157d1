#include "bumpfoil/structure/identification.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/frame.hpp"
#include "core/linear_algebra.hpp"
#include "structure/planar_frame.hpp"

namespace bumpfoil {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
const Section identified_foil = make_section(214e9, 0.29, 38.1e-3, 0.102e-3);

BumpArc reference_arc(HeightReference reference) {
  BumpFoil bump = reference_case().bump_foil;
  bump.height_reference = reference;
  return make_bump_arc(nominal_bump(bump));
}

TEST(Identification, ReferenceBumpWithTheHeightOfTheMidSurface) {
  const BumpArc arc = reference_arc(HeightReference::midsurface);  // rise 0.508 mm
  const BumpCell cell = make_bump_cell(arc, identified_foil);
  const TrussConstants truss = identify_truss_constants(arc, identified_foil);
  // Published with three or four digits; met to 0.1 %.
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
  const BumpCell cell = make_bump_cell(arc, identified_foil);
  const TrussConstants truss = identify_truss_constants(arc, identified_foil);
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
  const BumpCell cell = make_bump_cell(arc, identified_foil);
  const TrussConstants truss = identify_truss_constants(arc, identified_foil);
  // One bump of an endless truss with crest displacement v and pitch extension e: elongations of the four springs.
  const double v = 3e-6;
  const double e = -2e-6;
  const double rod = 0.5 * e * std::cos(truss.theta_d) - v * std::sin(truss.theta_d);
  const double energy = truss.k1 * rod * rod + 0.5 * (truss.k2 + truss.k3) * e * e;
  EXPECT_NEAR(energy, 0.5 * cell.a * v * v - cell.b * v * e + 0.5 * cell.d * e * e, 1e-12 * energy);
}

/// Crest loads of a foil in the frame model with all crests displaced by 1 m, feet sliding on the sleeve.
Vector frame_crest_loads(const FoilDesign& foils) {
  const FrameModel model = make_frame_model(foils);
  const BumpDofs dofs = frame_dofs();
  const auto bumps = std::ssize(foils.bumps);
  BlockTridiagonal K(static_cast<int>(bumps), dofs.size);
  assemble_frame(model, K);
  std::vector<Eigen::Index> free;
  std::vector<Eigen::Index> crests;
  for (Eigen::Index n = 0; n < bumps; ++n) {
    for (const Eigen::Index dof : {0, 2, 3, 5, 6, 8}) free.push_back(n * dofs.size + dof);
    crests.push_back(n * dofs.size + dofs.crest_v);
  }
  const Matrix dense = K.dense();
  const Vector pressed = Vector::Ones(bumps);
  const Matrix stiffness = dense(free, free);
  const Vector moved = solve_symmetric(stiffness, -(dense(free, crests) * pressed));
  return dense(crests, crests) * pressed + dense(crests, free) * moved;
}

/// The same in the truss model.
Vector truss_crest_loads(const FoilDesign& foils) {
  const BumpDofs dofs{.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};
  const auto bumps = std::ssize(foils.bumps);
  BlockTridiagonal K(static_cast<int>(bumps), dofs.size);
  assemble_springs(make_truss_springs(make_truss_constants(foils), dofs), K);
  const Matrix dense = K.dense();
  const auto crest_v = Eigen::seqN(1, bumps, 4);
  std::vector<Eigen::Index> free;
  for (Eigen::Index n = 0; n < bumps; ++n) free.insert(free.end(), {4 * n, 4 * n + 2});
  const Vector pressed = Vector::Ones(bumps);
  const Matrix stiffness = dense(free, free);
  const Matrix pressed_free = dense(free, crest_v);
  const Vector moved = solve_symmetric(stiffness, -(pressed_free * pressed));
  const Matrix pressing = dense(crest_v, crest_v);
  const Matrix coupling = dense(crest_v, free);
  return pressing * pressed + coupling * moved;
}

TEST(Identification, CellIsThatOfALongFrame) {
  // Twelve bumps repeat the cell between weld and free end. The load of a middle bump is the crest stiffness of a cell
  // with free pitch.
  Case input = reference_case();
  input.bump_foil.bumps = 12;
  const double cell = make_bump_cell(make_bump_arc(nominal_bump(input.bump_foil)), identified_foil).crest_stiffness();
  const Vector loads = frame_crest_loads(make_bearing_design(input));
  EXPECT_NEAR(loads[6], cell, 1e-4 * cell);  // end effects decay to less than a tenth per bump
}

/// Twelve bumps of one shape, then twelve of another.
FoilDesign two_groups() {
  FoilDesign foils = make_bearing_design(reference_case());
  foils.bumps.resize(24);
  for (std::size_t n = 12; n < 24; ++n) {
    foils.bumps[n] = {.pitch = 5e-3, .half_length = 2e-3, .rise = 0.5e-3, .thickness = 0.12e-3};
  }
  return foils;
}

TEST(Identification, EachGroupOfBumpsHasItsOwnCell) {
  const FoilDesign foils = two_groups();
  const Vector frame = frame_crest_loads(foils);
  const Vector truss = truss_crest_loads(foils);
  for (const std::size_t inside : {6U, 18U}) {
    const BumpShape& bump = foils.bumps[inside];
    const double cell = make_bump_cell(make_bump_arc(bump), make_bump_section(foils, bump)).crest_stiffness();
    EXPECT_NEAR(frame[static_cast<Eigen::Index>(inside)], cell, 1e-4 * cell);
    EXPECT_NEAR(truss[static_cast<Eigen::Index>(inside)], cell, 1e-4 * cell);
  }
}

/// Minus the coupling of u between the crests of bumps 5 and 6 of ten, condensed to u and v of crests and mid-flats.
double dense_crest_coupling(const FoilDesign& foils, const BumpShape& bump) {
  PlanarFrame strip(4 * 10 + 1);
  PlanarFrame::Unknowns kept{0, 1};
  const BumpArc arc = make_bump_arc(bump);
  const Section section = make_bump_section(foils, bump);
  for (int n = 0; n < 10; ++n) {
    strip.add(4 * n, 4 * n + 1, section, flat_element(0.5 * arc.flat));
    strip.add(4 * n + 1, 4 * n + 2, section, rising_half(arc));
    strip.add(4 * n + 2, 4 * n + 3, section, falling_half(arc));
    strip.add(4 * n + 3, 4 * n + 4, section, flat_element(0.5 * arc.flat));
    for (const int node : {4 * n + 2, 4 * n + 4}) kept.insert(kept.end(), {3 * node, 3 * node + 1});
  }
  return -strip.condense(kept, {})(4 * 4 + 2, 4 * 5 + 2);
}

TEST(TrussConstants, CrestsAreCoupledAsInALongStrip) {
  const FoilDesign groups = two_groups();
  const std::vector<TrussConstants> constants = make_truss_constants(groups);
  const double first = dense_crest_coupling(groups, groups.bumps[0]);
  const double second = dense_crest_coupling(groups, groups.bumps[12]);
  EXPECT_NEAR(constants[11].k3, first, 1e-10 * first);  // condition number of the strip
  EXPECT_NEAR(constants[13].k3, second, 1e-10 * second);
  EXPECT_GT(std::abs(second / first - 1.0), 0.1);
  // Between the groups: the mean of both.
  EXPECT_NEAR(constants[12].k3, 0.5 * (first + second), 1e-10 * first);
}

TEST(TrussConstants, OfAGroupAreThoseOfItsUniformFoil) {
  const FoilDesign groups = two_groups();
  const std::vector<TrussConstants> constants = make_truss_constants(groups);
  for (const std::size_t n : {0U, 10U, 13U, 23U}) {
    FoilDesign uniform = groups;
    uniform.bumps.assign(24, groups.bumps[n]);
    const TrussConstants own = make_truss_constants(uniform)[n];
    EXPECT_EQ(constants[n].k1, own.k1);
    EXPECT_EQ(constants[n].k2, own.k2);
    EXPECT_EQ(constants[n].k3, own.k3);
    EXPECT_EQ(constants[n].theta_d, own.theta_d);
  }
  EXPECT_NE(constants[0].k1, constants[23].k1);
}

TEST(TrussConstants, FeetCarryWhatCrestsDoNot) {
  // With single bumps of three shapes, k3 varies from bump to bump; each cell keeps its k2 + k3.
  FoilDesign foils = make_bearing_design(reference_case());
  for (std::size_t n = 0; n < foils.bumps.size(); ++n) {
    foils.bumps[n].half_length += 0.03e-3 * static_cast<double>(n % 3);
    foils.bumps[n].thickness += 5e-6 * static_cast<double>(n % 2);
  }
  const std::vector<TrussConstants> row = make_truss_constants(foils);
  for (std::size_t n = 1; n + 1 < row.size(); ++n) {
    const BumpShape& bump = foils.bumps[n];
    const TrussConstants own = identify_truss_constants(make_bump_arc(bump), make_bump_section(foils, bump));
    const double sum = own.k2 + own.k3;
    EXPECT_NEAR(row[n].k2 + 0.5 * (row[n].k3 + row[n + 1].k3), sum, 1e-12 * sum);
    EXPECT_GT(std::abs(row[n].k2 / own.k2 - 1.0), 0.01);
  }
}

TEST(TrussConstants, ErrorsNameTheBump) {
  FoilDesign foils = two_groups();
  foils.bumps[7].pitch = 2.0 * foils.bumps[7].half_length + 4e-3;  // k2 < 0; k4 is not checked without a weld
  const std::vector<InputError> errors = find_truss_errors(foils);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].key, "bump_foil.truss.k2");
  EXPECT_NE(errors[0].what.find("for bump 8 among its neighbours"), std::string::npos) << errors[0].what;
}

TEST(Identification, FirstBumpOfTrussAndFrameAreEquallyStiff) {
  Case input = reference_case();
  input.bump_foil.bumps = 1;
  const std::vector<TrussConstants> truss = make_truss_constants(make_bearing_design(input));
  const BumpDofs dofs{.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};
  BlockTridiagonal K(1, 4);
  assemble_springs(make_truss_springs(truss, dofs), K);
  const Eigen::Matrix3d sliding = K.dense().topLeftCorner<3, 3>();
  const double stiffness = 1.0 / sliding.inverse()(1, 1);

  // The frame from a weld to the next mid-flat; half a flat after the arc is added by hand.
  const FrameModel model = make_frame_model(make_bearing_design(input));
  BlockTridiagonal frame(1, 11);
  assemble_frame(model, frame);
  Matrix dense = Matrix::Zero(12, 12);
  dense.topLeftCorner(9, 9) = frame.dense().topLeftCorner(9, 9);
  const ElementMatrix flat = frame_element_stiffness(model.sections[0], flat_element(0.5 * model.arcs[0].flat));
  Eigen::Matrix<double, 6, 1> scale;
  scale << 1, 1, 1 / model.rotation_scale, 1, 1, 1 / model.rotation_scale;
  dense.bottomRightCorner(6, 6) += scale.asDiagonal() * flat * scale.asDiagonal();
  const std::vector<int> free{0, 2, 3, 4, 5, 6, 8, 9, 10};  // sleeve under rows 1 and 7, slope 11 zero
  const Matrix kept = dense(free, free);
  const Matrix compliance = solve_symmetric(kept, Matrix::Identity(9, 9));
  EXPECT_NEAR(stiffness, 1.0 / compliance(3, 3), 1e-9 * stiffness);
}

TEST(TrussConstants, GivenOnesReplaceTheIdentifiedOnes) {
  Case input = reference_case();
  const TrussConstants identified = make_truss_constants(make_bearing_design(input)).at(7);
  input.bump_foil.truss.k2 = 4e6;
  input.bump_foil.truss.theta_d = 0.3;
  const TrussConstants mixed = make_truss_constants(make_bearing_design(input)).at(7);
  EXPECT_EQ(mixed.k1, identified.k1);
  EXPECT_EQ(mixed.k2, 4e6);
  EXPECT_EQ(mixed.k3, identified.k3);
  EXPECT_EQ(mixed.k4, identified.k4);
  EXPECT_EQ(mixed.theta_d, 0.3);
}

TEST(TrussConstants, ShapesThatATrussCannotFollowAreRefusedWithAdvice) {
  Case input = reference_case();
  input.bump_foil.pitch = input.bump_foil.length.values.front() + 4e-3;  // flats longer than the bumps: k2 < 0
  try {
    make_truss_constants(make_bearing_design(input));
    FAIL() << "accepted";
  } catch (const Error& error) {
    ASSERT_EQ(error.errors().size(), 1U);
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.errors()[0].key, "bump_foil.truss.k2");
    EXPECT_NE(error.errors()[0].advice.find("frame"), std::string::npos);
  }
  const std::vector<InputError> errors = find_truss_errors(make_bearing_design(input));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_TRUE(find_truss_errors(make_bearing_design(reference_case())).empty());
  input.bump_foil.truss.k2 = 1e6;
  const TrussConstants given = make_truss_constants(make_bearing_design(input)).front();
  EXPECT_EQ(given.k2, 1e6);
  // The reported k2 and the k2 + k3 of the advice, to the digits of messages.
  const std::string& advice = errors[0].advice;
  const double k2 = std::stod(errors[0].what.substr(errors[0].what.find("as ") + 3));
  const double sum = std::stod(advice.substr(advice.rfind("= ") + 2));
  EXPECT_LT(k2, 0.0);
  EXPECT_NEAR(sum, k2 + given.k3, 1e-3 * sum);
}

}  // namespace
}  // namespace bumpfoil
