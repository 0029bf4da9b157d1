#include "bumpfoil/structure/section.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(Section, IsThatOfAPlate) {
  // E' = 3 / (1 - 1/4) = 4; L = 5, e = 2.
  const Section section = make_section(3.0, 0.5, 5.0, 2.0);
  EXPECT_DOUBLE_EQ(section.bending_stiffness, 4.0 * 5.0 * 8.0 / 12.0);
  EXPECT_DOUBLE_EQ(section.axial_stiffness, 4.0 * 5.0 * 2.0);
  EXPECT_DOUBLE_EQ(section.modulus, 5.0 * 4.0 / 6.0);
}

TEST(Section, OfAFoilHasItsOwnThickness) {
  FoilDesign foils;
  foils.bumps = {{.thickness = 2.0}, {.thickness = 3.0}};
  foils.youngs_modulus = 3.0;
  foils.poisson_ratio = 0.5;
  foils.axial_length = 5.0;
  foils.top_foil = {.thickness = 1.0, .youngs_modulus = 6.0, .poisson_ratio = 0.0};
  EXPECT_EQ(make_bump_section(foils, foils.bumps[1]), make_section(3.0, 0.5, 5.0, 3.0));
  EXPECT_EQ(make_top_foil_section(foils), make_section(6.0, 0.0, 5.0, 1.0));
}

TEST(Section, SurfaceStressIsModulusTimesCurvatureTimesHalfTheThickness) {
  const double E = 214e9;
  const double nu = 0.29;
  const double e = 0.102e-3;
  const Section section = make_section(E, nu, 38.1e-3, e);
  const double moment = 0.02;
  const double curvature = moment / section.bending_stiffness;
  EXPECT_DOUBLE_EQ(moment / section.modulus, E / (1.0 - nu * nu) * curvature * e / 2.0);
}

}  // namespace
}  // namespace bumpfoil
