#include "bumpfoil/structure/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

Case small_case(BumpFoilModel model, int bumps) {
  Case input = reference_case();
  input.bump_foil.model = model;
  input.bump_foil.bumps = bumps;
  return input;
}

/// Displacements under these loads on the top foil, one per crest.
Vector under_top_loads(const Case& input, const Vector& loads) {
  const FoilStructure structure = make_foil_structure(make_bearing_design(input));
  Vector right = Vector::Zero(structure.K.rows());
  right(Eigen::seqN(structure.dofs.top_u, structure.bumps(), structure.dofs.size)) = loads;
  return solve(structure.K.dense(), right);
}

TEST(FoilStress, OfTheTopFoilIsThatOfAStaticallyDeterminateCantilever) {
  const Vector loads{{3.0, -1.0, 4.0, 1.5}};
  for (const int bumps : {1, 2, 4}) {
    const Case input = small_case(BumpFoilModel::truss, bumps);
    const FoilStress stress =
        foil_stress(make_stress_model(make_bearing_design(input)), under_top_loads(input, loads.head(bumps)));
    const Vector theta = crest_angles(input);
    const auto expected = [&](double at) {
      double moment = 0.0;
      for (Eigen::Index j = 0; j < bumps; ++j) {
        if (theta[j] > at) moment += loads[j] * input.bearing.radius * std::sin(theta[j] - at);
      }
      const double e = input.top_foil.thickness;
      return std::abs(moment) * 0.5 * e / (input.bearing.axial_length * e * e * e / 12.0);
    };
    // Round-off of a system with a condition number of 1e5.
    const double tolerance = 1e-9 * expected(0.0);
    EXPECT_NEAR(stress.top_weld.value(), expected(0.0), tolerance);
    ASSERT_EQ(stress.top_crest.size(), bumps);
    for (Eigen::Index i = 0; i < bumps; ++i) EXPECT_NEAR(stress.top_crest[i], expected(theta[i]), tolerance) << i;
    EXPECT_EQ(stress.top_crest[bumps - 1], 0.0);  // nothing beyond the last crest
  }
}

TEST(FoilStress, OfTheFrameStandsFootByFoot) {
  const Case input = small_case(BumpFoilModel::frame, 3);
  Vector x = Vector::Zero(3 * 11);
  x[11 + 3] = 1e-6;  // second crest along the foil, so that its two feet differ
  x[11 + 4] = -5e-6;
  const FoilStress stress = foil_stress(make_stress_model(make_bearing_design(input)), x);
  const FrameStress frame = frame_stress(make_frame_model(make_bearing_design(input)), x);
  EXPECT_EQ(stress.bump_crest, frame.crest);
  EXPECT_EQ(stress.bump_largest, frame.largest);
  EXPECT_EQ(stress.bump_weld, frame.weld);
  ASSERT_EQ(stress.bump_foot.size(), 6);
  for (Eigen::Index i = 0; i < 3; ++i) {
    EXPECT_EQ(stress.bump_foot[2 * i], frame.arc_start[i]);
    EXPECT_EQ(stress.bump_foot[2 * i + 1], frame.arc_end[i]);
  }
  EXPECT_NE(stress.bump_foot[2], stress.bump_foot[3]);
  EXPECT_EQ(stress.top_crest, Vector::Zero(3));
}

TEST(FoilStress, OfALooseStripStandsBumpByBump) {
  // The block before bump 1 is only a foot: its other entries are not moments.
  FoilDesign foils = make_bearing_design(small_case(BumpFoilModel::truss, 3));
  foils.radius.reset();
  foils.welded = false;
  const StressModel model = make_stress_model(foils);
  Vector x = Vector::Zero(4 * 6);
  x[2 * 6 + 5] = 3e-6;  // over bump 2
  const FoilStress stress = foil_stress(model, x);
  ASSERT_EQ(stress.top_crest.size(), 3);
  const Section section = make_top_foil_section(foils);
  const double p = foils.bumps[0].pitch;
  const double expected = 3e-6 * section.bending_stiffness / (p * p) / section.modulus;
  EXPECT_NEAR(stress.top_crest[1], expected, 1e-12 * expected);
  EXPECT_EQ(stress.top_crest[0], 0.0);
  EXPECT_EQ(stress.top_crest[2], 0.0);
  EXPECT_FALSE(stress.top_weld);

  foils.model = BumpFoilModel::frame;
  const FoilStress frame = foil_stress(make_stress_model(foils), Vector::Zero(3 * 11));
  EXPECT_EQ(frame.top_crest.size(), 3);
  EXPECT_EQ(frame.bump_foot.size(), 6);
  EXPECT_FALSE(frame.bump_weld);
}

TEST(FoilStress, IsAbsentWhereTheModelKnowsNone) {
  const FoilStress truss =
      foil_stress(make_stress_model(make_bearing_design(small_case(BumpFoilModel::truss, 2))), Vector::Zero(12));
  EXPECT_EQ(truss.bump_crest.size(), 0);
  EXPECT_EQ(truss.bump_foot.size(), 0);
  EXPECT_FALSE(truss.bump_weld);
  EXPECT_EQ(truss.top_crest.size(), 2);
  const FoilStress former =
      foil_stress(make_stress_model(make_bearing_design(small_case(BumpFoilModel::former, 2))), Vector::Zero(8));
  EXPECT_EQ(former.top_crest.size(), 0);
  EXPECT_FALSE(former.top_weld);
}

}  // namespace
}  // namespace bumpfoil
