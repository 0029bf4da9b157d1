// docs/verification/film.md: films on the meshes of an independent prototype.

#include <gtest/gtest.h>

#include <cmath>

#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

/// The prototype stops at residuals of 1e-8.
constexpr double same_mesh = 1e-7;

void expect_level(const ReferenceFilm& reference, const ReferenceFilm::Values& level) {
  SCOPED_TRACE(reference.name() + ", " + std::to_string(level.columns) + " columns");
  const SolvedFilm solved = solve_reference_film(reference, level.columns, level.rows);
  ASSERT_EQ(solved.report.status, Status::converged);
  const FilmIntegrals sums = film_integrals(solved.equation, solved.film);
  const double load = std::hypot(level.cosine, level.sine);
  EXPECT_NEAR(sums.cosine, level.cosine, same_mesh * load);
  EXPECT_NEAR(sums.sine, level.sine, same_mesh * load);
  EXPECT_NEAR(solved.film.pressure.maxCoeff(), level.max_pressure, same_mesh * level.max_pressure);
  if (level.torque != 0.0) {
    EXPECT_NEAR(sums.torque(reference.bearing_number), level.torque, same_mesh * level.torque);
  }
}

TEST(FilmTables, CoarsestMeshes) {
  for (const ReferenceFilm& reference : reference_films()) expect_level(reference, reference.levels.front());
}

}  // namespace
}  // namespace bumpfoil
