#include "bumpfoil/structure/top_foil_on_lines.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

FoilDesign some_foils(int bumps) {
  Case input = reference_case();
  input.bump_foil.bumps = bumps;
  return make_bearing_design(PadDesign(input));
}

/// Indices of the unknowns of the crests, u of all lines, crest after crest, and of all others.
/// @param stride  from one station to the next; none: only the first station
std::array<std::vector<Eigen::Index>, 2> parted(const BlockTridiagonal& K, Eigen::Index lines, Eigen::Index stride) {
  std::array<std::vector<Eigen::Index>, 2> parts;
  const Eigen::Index period = stride > 0 ? stride : K.block_size();
  for (Eigen::Index i = 0; i < K.rows(); ++i) parts[i % period < lines ? 0 : 1].push_back(i);
  return parts;
}

/// Stiffness condensed to the crests.
Matrix of_crests(const BlockTridiagonal& K, Eigen::Index lines, Eigen::Index stride = 0) {
  const auto [kept, other] = parted(K, lines, stride);
  const Matrix all = K.dense();
  const Matrix across = all(other, kept);
  const Matrix out = all(other, other);
  return all(kept, kept) - across.transpose() * solve(out, across);
}

/// Loads of a formed foil condensed to the crests.
Vector pressed_by(const TopFoilOnLines& foil, Eigen::Index lines) {
  const auto [kept, other] = parted(foil.K, lines, 0);
  const Matrix all = foil.K.dense();
  const Matrix out = all(other, other);
  const Vector load = foil.forming(other);
  return foil.forming(kept) - all(kept, other) * solve(out, load);
}

FoilDesign some_formed_foils(int bumps) {
  FoilDesign foils = some_foils(bumps);
  foils.top_foil->flattening = 0.02 / foils.radius.value();
  foils.top_foil->seat_pressure = 200.0;
  return foils;
}

TEST(TopFoilOnLines, IsABeamUnderEachLineWithoutAMembrane) {
  for (const int bumps : {1, 4}) {
    const FoilDesign foils = some_foils(bumps);
    const Matrix beam = top_foil_stiffness(make_top_foil_beam(foils));
    const WidthLines lines = make_width_lines(2, WidthPart::whole);
    const Matrix K = of_crests(top_foil_on_lines(foils, lines).K, 2);
    for (Eigen::Index s = 0; s < 2; ++s) {
      for (Eigen::Index r = 0; r < 2; ++r) {
        const Matrix block = K(Eigen::seqN(s, bumps, 2), Eigen::seqN(r, bumps, 2));
        const Matrix expected = s == r ? Matrix(lines.weight[s] * beam) : Matrix::Zero(bumps, bumps);
        EXPECT_LT((block - expected).norm(), 1e-8 * beam.norm());
      }
    }
  }
}

/// Displacements uniform or linear over the width do not stretch the foil; a parabola does, which is stiffer than
/// separate slices.
TEST(TopFoilOnLines, StretchesUnderAParabolaAlone) {
  const int bumps = 4;
  FoilDesign foils = some_foils(bumps);
  const WidthLines lines = make_width_lines(3, WidthPart::whole);
  const Matrix beam = top_foil_stiffness(make_top_foil_beam(foils));
  const auto of_mode = [&](int k) {
    const Matrix K = of_crests(top_foil_on_lines(foils, lines).K, 3);
    Matrix sum = Matrix::Zero(bumps, bumps);
    for (Eigen::Index s = 0; s < 3; ++s) {
      for (Eigen::Index r = 0; r < 3; ++r) {
        sum += legendre(k, lines.zeta[s]) * legendre(k, lines.zeta[r]) *
               K(Eigen::seqN(s, bumps, 3), Eigen::seqN(r, bumps, 3));
      }
    }
    return sum;
  };
  EXPECT_LT((of_mode(0) - beam).norm(), 1e-8 * beam.norm());
  EXPECT_LT((of_mode(1) - beam / 3.0).norm(), 1e-8 * beam.norm());
  const Matrix stretched = of_mode(2);
  EXPECT_LT((stretched - stretched.transpose()).norm(), 1e-9 * stretched.norm());
  const Vector alike = Vector::Ones(bumps);
  const Vector of_slices = beam * alike / 5.0;
  const Vector of_sheet = stretched * alike;
  EXPECT_GT(alike.dot(of_sheet), 1.1 * alike.dot(of_slices));
  foils.top_foil->youngs_modulus *= 1e3;  // scales bending and membrane alike
  EXPECT_LT((of_mode(2) / 1e3 - stretched).norm(), 1e-8 * stretched.norm());
}

TEST(TopFoilOnLines, KeepsColumnsBetweenTheCrests) {
  const int bumps = 4;
  FoilDesign foils = some_foils(bumps);
  const double R = foils.radius.value();
  const double pitch = foils.bumps.front().pitch;
  // Supported at half the distance: a beam under each line over twice as many crests.
  const WidthLines two = make_width_lines(2, WidthPart::whole);
  TopFoilBeam beam = make_top_foil_beam(foils);
  beam.theta = Vector::LinSpaced(2 * bumps, 0.5 * pitch / R, bumps * pitch / R);
  const Matrix expected = top_foil_stiffness(beam);
  foils.top_foil->stagger = 0.5 * pitch;
  const Matrix found = of_crests(top_foil_on_lines(foils, two, {0, 3}).K, 2, 4);
  ASSERT_EQ(found.rows(), 4 * bumps);
  for (Eigen::Index s = 0; s < 2; ++s) {
    const auto line = Eigen::seqN(s, 2 * bumps, 2);
    EXPECT_LT((found(line, line) - two.weight[s] * expected).norm(), 1e-8 * expected.norm());
  }
  // Unloaded stations can be eliminated; the foil extends by the same length beyond its last crest.
  const WidthLines three = make_width_lines(3, WidthPart::whole);
  for (const std::vector<int>& stations : {std::vector<int>{0, 3}, std::vector<int>{0, 2, 3}}) {
    const Matrix kept = of_crests(top_foil_on_lines(foils, three, stations).K, 3);
    FoilDesign longer = foils;
    longer.top_foil->stagger = 0.0;
    longer.top_foil->overhang += 0.5 * pitch;
    const Matrix without = of_crests(top_foil_on_lines(longer, three).K, 3);
    EXPECT_LT((kept - without).norm(), 1e-8 * without.norm());
  }
}

TEST(TopFoilOnLines, IsFormedAsTheUniformFoil) {
  const int bumps = 5;
  const FoilDesign foils = some_formed_foils(bumps);
  const FoilStructure uniform = make_foil_structure(foils);
  const WidthLines lines = make_width_lines(2, WidthPart::whole);
  const TopFoilOnLines found = top_foil_on_lines(foils, lines);
  const BumpDofs& dofs = uniform.dofs;
  const auto of_uniform = [&](int unknown) -> Vector {
    return uniform.forming(Eigen::seqN(Eigen::Index{uniform.first_bump * dofs.size + unknown}, Eigen::Index{bumps},
                                       Eigen::Index{dofs.size}));
  };
  for (Eigen::Index s = 0; s < 2; ++s) {
    const auto on_line = [&](Eigen::Index first) -> Vector {
      return found.forming(Eigen::seqN(first + s, Eigen::Index{bumps}, Eigen::Index{found.K.block_size()}));
    };
    EXPECT_LT((on_line(0) - lines.weight[s] * of_uniform(dofs.top_u)).norm(), 1e-9 * uniform.forming.norm());
    EXPECT_LT((on_line(2) - of_uniform(dofs.top_moment)).norm(), 1e-9 * uniform.forming.norm());
  }
  EXPECT_NEAR(found.forming_energy, uniform.forming_energy, 1e-9 * uniform.forming_energy);
}

/// A station without support can be omitted; the foil ends at the same distance from its last crest.
TEST(TopFoilOnLines, IsFormedBetweenTheCrests) {
  FoilDesign foils = some_formed_foils(4);
  const double pitch = foils.bumps.front().pitch;
  const WidthLines lines = make_width_lines(3, WidthPart::whole);
  FoilDesign longer = foils;
  longer.top_foil->overhang += 0.5 * pitch;
  const Vector without = pressed_by(top_foil_on_lines(longer, lines), 3);
  foils.top_foil->stagger = 0.5 * pitch;
  for (const std::vector<int>& stations : {std::vector<int>{0, 3}, std::vector<int>{0, 2, 3}}) {
    const Vector kept = pressed_by(top_foil_on_lines(foils, lines, stations), 3);
    EXPECT_LT((kept - without).norm(), 1e-8 * without.norm());
  }
}

}  // namespace
}  // namespace bumpfoil
