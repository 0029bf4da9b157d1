#include "bumpfoil/structure/bump_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Nine bumps in the frame model.
FoilDesign nine_bumps() {
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.bumps = 9;
  return make_bearing_design(PadDesign(input));
}

/// v_2 of crests, m, under P_2 N/mm on some of them; feet free to slide.
Vector loaded_crests(const FoilDesign& foils, const std::vector<int>& loaded) {
  const FoilStructure structure = make_foil_structure(foils);
  const BumpDofs& dofs = structure.dofs;
  const BlockTridiagonal sheet = bump_sheet_stiffness(foils, {2});
  constexpr double square = 1.0 / 5.0;  // mean square of P_2 over the width
  Matrix K = sheet.dense();
  const Matrix slices = square * structure.K.dense();
  std::vector<Eigen::Index> free, crests, of_slices;
  for (int bump = 0; bump < structure.bumps(); ++bump) {
    for (int i = 0; i < sheet.block_size(); ++i) {
      const Eigen::Index row = Eigen::Index{bump} * sheet.block_size() + i;
      if (i < dofs.size) of_slices.push_back(row);
      const auto is_foot = std::ranges::find(dofs.foot_v, i) != dofs.foot_v.end();
      if (i == dofs.top_u || i == dofs.top_moment || is_foot) continue;
      if (i == dofs.crest_v) crests.push_back(std::ssize(free));
      free.push_back(row);
    }
  }
  K(of_slices, of_slices) += slices;
  Vector load = Vector::Zero(std::ssize(free));
  for (const int bump : loaded) load[crests[static_cast<std::size_t>(bump)]] = square * 1e3 * foils.axial_length;
  const Matrix unknown = K(free, free);
  const Vector moved = solve(unknown, load);
  return moved(crests);
}

const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8};

void expect_um(const Vector& found, const std::vector<double>& reference) {
  ASSERT_EQ(found.size(), std::ssize(reference));
  const double largest = *std::ranges::max_element(reference);
  for (std::size_t i = 0; i < reference.size(); ++i) {
    EXPECT_NEAR(1e6 * found[static_cast<Eigen::Index>(i)], reference[i], 1e-5 * largest) << "bump " << i + 1;
  }
}

/// Reference values of an independent program.
TEST(BumpSheet, GivesWayUnderAParabolaAsTheIndependentProgramSays) {
  const FoilDesign foils = nine_bumps();
  expect_um(loaded_crests(foils, all),
            {1.763611, 1.647922, 1.705478, 1.61218, 1.327028, 1.150361, 2.42214, 7.821618, 22.39211});
  expect_um(loaded_crests(foils, {4}),
            {0.3053204, 0.01722161, -1.333097, -3.260407, 10.27416, -3.250126, -1.351148, -0.1195701, 0.04467539});
}

}  // namespace
}  // namespace bumpfoil
