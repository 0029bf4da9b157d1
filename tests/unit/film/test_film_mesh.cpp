#include "bumpfoil/film/film_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bumpfoil {
namespace {

double area(const FilmMesh& mesh) {
  double sum = 0.0;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      sum += mesh.column_weight(k) * mesh.row_weight(j) * mesh.dtheta * mesh.dzeta;
    }
  }
  return sum;
}

TEST(FilmMesh, VolumesFillTheFilm) {
  EXPECT_NEAR(area(make_closed_mesh(7, 3, 0.4)), 2.0 * std::numbers::pi * 0.4, 1e-14);
  EXPECT_NEAR(area(make_slotted_mesh(7, 3, 0.4, 5.5)), 5.5 * 0.4, 1e-14);
}

TEST(FilmMesh, CoversHalfTheWidthOrAllOfIt) {
  const FilmMesh half = make_slotted_mesh(7, 3, 0.4, 5.5);
  const FilmMesh whole = make_slotted_mesh(7, 6, 0.4, 5.5, WidthPart::whole);
  EXPECT_NEAR(whole.copies() * area(whole), half.copies() * area(half), 1e-14);
  EXPECT_NEAR(whole.dzeta, half.dzeta, 1e-16);
  for (const FilmMesh& mesh : {half, whole}) {
    EXPECT_NEAR(mesh.half_width(), 0.4, 1e-16);
    EXPECT_EQ(mesh.zeta(mesh.rows), 1.0);
    // Pressures are prescribed at the sides only.
    for (int j = 0; j <= mesh.rows; ++j) {
      const bool unknown = j >= mesh.first_unknown_row() && j < mesh.first_unknown_row() + mesh.unknown_rows();
      EXPECT_EQ(unknown, !mesh.is_side(j));
      EXPECT_EQ(mesh.is_side(j), std::abs(mesh.zeta(j)) == 1.0);
    }
    Matrix field = mesh.field(0.0);
    mesh.unknown(field).setOnes();
    EXPECT_EQ(field.sum(), mesh.unknown_rows() * mesh.unknown_columns());
    EXPECT_EQ(field.row(mesh.rows).sum() + field.col(0).sum(), 0.0);
  }
  EXPECT_EQ(half.zeta(0), 0.0);
  EXPECT_EQ(whole.zeta(0), -1.0);
}

TEST(FilmMesh, ClosedFilmsHaveNoEdgeAlongTheta) {
  const FilmMesh mesh = make_closed_mesh(7, 3, 0.4);
  EXPECT_EQ(mesh.nodes(), 7);
  EXPECT_EQ(mesh.next(5), 6);
  EXPECT_EQ(mesh.next(6), 0);
  EXPECT_EQ(mesh.first_unknown(), 0);
  EXPECT_EQ(mesh.unknown_columns(), 7);
  EXPECT_NEAR(mesh.angles()[6], 2.0 * std::numbers::pi * 6.0 / 7.0, 1e-14);
}

TEST(FilmMesh, SlottedFilmsBeginAndEndWithAnEdge) {
  const FilmMesh mesh = make_slotted_mesh(7, 3, 0.4, 5.5);
  EXPECT_EQ(mesh.nodes(), 8);
  EXPECT_EQ(mesh.next(6), 7);
  EXPECT_EQ(mesh.first_unknown(), 1);
  EXPECT_EQ(mesh.unknown_columns(), 6);
  EXPECT_NEAR(mesh.angles()[7], 5.5, 1e-14);
  EXPECT_EQ(mesh.field(2.0), Matrix::Constant(4, 8, 2.0));
}

TEST(FilmMesh, IntervalsMayDiffer) {
  const FilmMesh mesh = make_slotted_mesh(Vector{{1.0, 2.0, 0.5}}, 0.1, 3, 0.4);
  EXPECT_EQ(mesh.nodes(), 4);
  EXPECT_TRUE(mesh.angles().isApprox(Vector{{0.0, 0.1, 0.3, 0.35}}, 1e-15));
  EXPECT_TRUE(mesh.weights.isApprox(Vector{{0.5, 1.5, 1.25, 0.25}}, 1e-15));
  EXPECT_NEAR(mesh.interval(1), 0.2, 1e-16);
  EXPECT_NEAR(area(mesh), 0.35 * 0.4, 1e-15);
}

/// Bit-identical: foils of equal pitches use such meshes.
TEST(FilmMesh, EqualIntervalsAreUnits) {
  const FilmMesh mesh = make_slotted_mesh(5, 3, 0.4, 1.0);
  EXPECT_EQ(mesh.weights, (Vector{{0.5, 1.0, 1.0, 1.0, 1.0, 0.5}}));
  for (int k = 0; k < mesh.nodes(); ++k) EXPECT_EQ(mesh.angles()[k], k * mesh.dtheta);
}

}  // namespace
}  // namespace bumpfoil
