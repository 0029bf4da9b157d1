#include "bumpfoil/bearing/film_model.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

TEST(FilmModel, IsFedAtItsSides) {
  const Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3});
  const BearingModel bearing = make_film_bearing(make_foils(input), gas_of(input.gas),
                                                 {.columns_per_pitch = 4, .rows = 4, .width = WidthPart::whole},
                                                 {.side_pressure = Eigen::Vector2d(1.2, 1.5)});
  const Matrix pressure = bearing.film->resting_pressure();
  EXPECT_EQ(pressure(0, 7), 1.2);
  EXPECT_EQ(pressure(pressure.rows() - 1, 7), 1.5);
  EXPECT_EQ(pressure(1, 7), 1.0);
}

TEST(FilmModel, HasAScaleWithoutClearanceToo) {
  EXPECT_EQ(film_thickness_scale(30e-6), 30e-6);
  EXPECT_EQ(film_thickness_scale(1e-9), 10e-6);
  EXPECT_EQ(film_thickness_scale(0.0), 10e-6);
  EXPECT_EQ(film_thickness_scale(-2e-6), 10e-6);
  EXPECT_EQ(film_thickness_scale(-15e-6), 15e-6);
}

/// The thickness over a journal that moves and tilts changes by what it does alone: it is linear in both.
TEST(FilmModel, IsThinnerWhereTheJournalMovesAndTilts) {
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 3, .width = WidthPart::whole});
  JournalVector there(4);
  there << 3e-6, -2e-6, 1e-6, 4e-6;
  const Matrix change = undeformed_thickness(bearing, there) - undeformed_thickness(bearing, JournalVector::Zero(4));
  EXPECT_LT((change - bearing.film->thickness_change(there)).norm(), 1e-13);  // of a thickness of 1
  EXPECT_LT(bearing.film->thickness_change(there).minCoeff(), -0.1);
}

}  // namespace
}  // namespace bumpfoil
