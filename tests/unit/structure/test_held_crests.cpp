#include "bumpfoil/structure/held_crests.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

FoilDesign reference_foils(BumpFoilModel model) {
  Case input = reference_case();
  input.bump_foil.model = model;
  return make_bearing_design(PadDesign(input));
}

/// Reference values of an independent program for the frame.
TEST(HeldCrests, OfTheFrameTurnTogether) {
  const Matrix K = held_crest_stiffness(make_foil_structure(reference_foils(BumpFoilModel::frame)), 0);
  ASSERT_EQ(K.rows(), 26);
  EXPECT_LT((K - K.transpose()).norm(), 1e-9 * K.norm());
  EXPECT_NEAR(K(13, 13), 24.70172946e6, 5e-6 * 24.7e6);
  EXPECT_NEAR(K(13, 14), -0.24560410e6, 5e-6 * 24.7e6);
}

TEST(HeldCrests, OfTheTrussStandAlone) {
  FoilDesign design = reference_foils(BumpFoilModel::truss);
  design.truss = {.k1 = 150e6, .k2 = 5.43e6, .k3 = 1.36e6, .k4 = 11.25e6, .theta_d = 0.3};
  const Matrix K = held_crest_stiffness(make_foil_structure(design), 0);
  const double spring = 2.0 * 150e6 * std::pow(std::sin(0.3), 2);
  EXPECT_LT((K - spring * Matrix::Identity(26, 26)).norm(), 1e-9 * K.norm());
}

}  // namespace
}  // namespace bumpfoil
