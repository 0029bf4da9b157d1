#include "bumpfoil/bearing/film_fields.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/bearing/film_bearing_solver.hpp"
#include "bumpfoil/model/pads.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// The foils of a running bearing, with the loads that the film puts on them, are in balance without it, too.
TEST(FilmFields, AreThoseOfFoilsUnderTheirLoads) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
    input.bump_foil.model = model;
    const FilmBearing bearing = make_film_bearing(input);
    const SharedFoils& foils = bearing.foils;
    FilmBearingSolver solver(bearing);
    BearingState state;
    ASSERT_EQ(solver.cold_start({0.7 * bearing.clearance, 0.0}, speed_of_rpm(45000.0), state).status,
              FilmStatus::converged);
    const BearingState dry = foil_state(bearing, state);
    FoilFields fields = make_fields(*foils, 1);
    record(*foils, dry, 0, fields);
    EXPECT_EQ((fields.top_bump.normal_force.array() > 0.0).count(), film_bearing_outcome(bearing, state).loaded_bumps);
    for (Eigen::Index b = 0; b < foils->bumps(); ++b) {
      const int crest = bearing.pads.front().foil.supports[static_cast<std::size_t>(b)];
      EXPECT_NEAR(fields.top_displacement(0, b), state.film.lift[crest] * bearing.scales.thickness, 1e-15);
      EXPECT_EQ(fields.journal_top.gap(0, b), state.film.thickness(0, crest) * bearing.scales.thickness);
      EXPECT_EQ(fields.journal_top.normal_force(0, b), 0.0);
      // The moment over a crest, of the film and of the stress.
      const double moment = bearing.pads.front().foil.stiffness * bearing.pads.front().foil.pitch *
                            bearing.scales.thickness * std::abs(state.film.moment[crest]);
      EXPECT_NEAR(fields.stress.top_crest(0, b), moment / foils->stress.front().top_section_modulus,
                  1e-9 * fields.stress.top_crest.maxCoeff());
    }
    // What the bumps take from above they hand to the sleeve, but for what friction carries.
    EXPECT_NEAR(fields.bump_sleeve.normal_force.sum() / fields.top_bump.normal_force.sum(), 1.0, 0.2);
  }
}

/// What each foil of several pads does is what it does alone.
TEST(FilmFields, HaveTheBumpsOfAllPadsInARow) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
    input.bump_foil.model = model;
    input.bump_foil.bumps = 8;
    input.pads.assign(3, {.lobe = 8e-6});
    const double speed = speed_of_rpm(45000.0);
    const auto fields_of = [speed](const Case& one) {
      const FilmBearing bearing = make_film_bearing(one);
      const SharedFoils& foils = bearing.foils;
      BearingState state;
      EXPECT_EQ(FilmBearingSolver(bearing).cold_start({12e-6, -4e-6}, speed, state).status, FilmStatus::converged);
      FoilFields fields = make_fields(*foils, 1);
      record(*foils, foil_state(bearing, state), 0, fields);
      return fields;
    };
    const FoilFields all = fields_of(input);
    for (std::size_t k = 0; k < 3; ++k) {
      Case alone = place_pads(input)[k].alone;
      alone.pads.push_back({.lobe = 8e-6});
      const FoilFields one = fields_of(alone);
      const auto first = static_cast<Eigen::Index>(8 * k);
      const Eigen::Index feet = one.foot_v.cols();
      // Newton's last step is below 1e-9 of c in each.
      const double length = 1e-12;
      EXPECT_LT((all.crest_v.middleCols(first, 8) - one.crest_v).cwiseAbs().maxCoeff(), length);
      EXPECT_LT((all.top_displacement.middleCols(first, 8) - one.top_displacement).cwiseAbs().maxCoeff(), length);
      EXPECT_LT((all.foot_v.middleCols(static_cast<Eigen::Index>(k) * feet, feet) - one.foot_v).cwiseAbs().maxCoeff(),
                length);
      EXPECT_LT((all.journal_top.gap.middleCols(first, 8) - one.journal_top.gap).cwiseAbs().maxCoeff(), length);
      EXPECT_LT((all.top_bump.normal_force.middleCols(first, 8) - one.top_bump.normal_force).cwiseAbs().maxCoeff(),
                1e-5);
    }
  }
}

}  // namespace
}  // namespace bumpfoil
