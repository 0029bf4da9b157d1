#include "bumpfoil/structure/single_bump.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "bumpfoil/structure/frame_element.hpp"

namespace bumpfoil {
namespace {

const Section bump_section = make_section(214e9, 0.29, 38.1e-3, 0.102e-3);

BumpArc arc_of_rise(double rise) {
  return make_bump_arc({.pitch = 4.572e-3, .half_length = 1.778e-3, .rise = rise, .thickness = 0.102e-3});
}

/// Crest stiffness of a bump from its falling half: crest guided (u = 0, no rotation), foot on the sleeve (v = 0),
/// friction force of mu times half the load at the foot, opposing outward sliding.
double frame_stiffness(const BumpArc& arc, double friction_coefficient, bool foot_turns) {
  const Section inextensible{.bending_stiffness = 1.0, .axial_stiffness = 1e14, .modulus = 1.0};
  const ElementMatrix K = frame_element_stiffness(inextensible, falling_half(arc));
  const std::array<int, 3> turning{1, 3, 5};  // crest v, foot u, foot rotation
  Eigen::Matrix3d kept = K(turning, turning);
  if (!foot_turns) kept(2, 2) *= 1e9;
  const Eigen::Vector3d load(0.5, -0.5 * friction_coefficient, 0.0);
  return bump_section.bending_stiffness / kept.inverse().row(0).dot(load);
}

TEST(SingleBump, ForcesHaveTheSizeOfStiffnessTimesRise) {
  FoilDesign foils;
  foils.bumps = {{.pitch = 4.572e-3, .half_length = 1.778e-3, .rise = 0.508e-3, .thickness = 0.102e-3}};
  foils.youngs_modulus = 214e9;
  foils.poisson_ratio = 0.29;
  foils.axial_length = 38.1e-3;
  EXPECT_DOUBLE_EQ(bump_force_scale(foils), 0.508e-3 * shallow_bump_stiffness(arc_of_rise(0.508e-3), bump_section));
}

TEST(SingleBump, ReferenceNumbers) {
  const BumpArc arc = arc_of_rise(0.508e-3);
  // Known to three digits.
  EXPECT_NEAR(shallow_bump_stiffness(arc, bump_section), 0.840e6, 0.0005e6);
  EXPECT_NEAR(sliding_bump_stiffness(arc, bump_section, 0.0).value(), 0.828e6, 0.0005e6);
  EXPECT_NEAR(guided_bump_stiffness(arc, bump_section), 3.156e6, 0.0005e6);
}

TEST(SingleBump, AgreesWithTheArcElement) {
  for (const double rise : {0.05e-3, 0.508e-3, 1.778e-3, 2.5e-3}) {
    const BumpArc arc = arc_of_rise(rise);
    for (const double mu : {-0.3, 0.0, 0.1, 0.2}) {
      const double K = sliding_bump_stiffness(arc, bump_section, mu).value();
      EXPECT_NEAR(frame_stiffness(arc, mu, true), K, 1e-6 * K) << rise << ' ' << mu;  // remaining axial strain
    }
    const double guided = guided_bump_stiffness(arc, bump_section);
    EXPECT_NEAR(frame_stiffness(arc, 0.0, false), guided, 1e-6 * guided) << rise;
  }
}

TEST(SingleBump, TendsToTheShallowLimit) {
  const BumpArc arc = arc_of_rise(1e-7);
  // (h / l0)^2 = 3e-9.
  EXPECT_NEAR(sliding_bump_stiffness(arc, bump_section, 0.0).value() / shallow_bump_stiffness(arc, bump_section), 1.0,
              1e-8);
  EXPECT_NEAR(guided_bump_stiffness(arc, bump_section) / shallow_bump_stiffness(arc, bump_section), 4.0, 1e-7);
}

TEST(SingleBump, FrictionStiffensLoadingAndSoftensUnloading) {
  const BumpArc arc = arc_of_rise(0.508e-3);
  const double K = sliding_bump_stiffness(arc, bump_section, 0.0).value();
  EXPECT_GT(sliding_bump_stiffness(arc, bump_section, 0.1).value(), K);
  EXPECT_LT(sliding_bump_stiffness(arc, bump_section, -0.1).value(), K);
}

TEST(SingleBump, FrictionLocksTheFeetOfSteepBumps) {
  const BumpArc steep = arc_of_rise(2.5e-3);
  EXPECT_GT(frame_stiffness(steep, 0.45, true), 0.0);
  EXPECT_TRUE(sliding_bump_stiffness(steep, bump_section, 0.45).has_value());
  EXPECT_LT(frame_stiffness(steep, 0.5, true), 0.0);
  EXPECT_FALSE(sliding_bump_stiffness(steep, bump_section, 0.5).has_value());
}

}  // namespace
}  // namespace bumpfoil
