#include "bumpfoil/analysis/film_fields.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/analysis/film_bearing_solver.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// The foils of a running bearing, with the loads that the film puts on them, are in balance without it, too.
TEST(FilmFields, AreThoseOfFoilsUnderTheirLoads) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
    input.bump_foil.model = model;
    const FilmBearing bearing = make_film_bearing(input);
    const SharedFoils foils = make_bearing_foils(input);
    FilmBearingSolver solver(bearing);
    FilmBearingState state;
    ASSERT_EQ(solver.cold_start({0.7 * bearing.clearance, 0.0}, speed_of_rpm(45000.0), state).status,
              FilmStatus::converged);
    const FoilState dry = foil_state(*foils, bearing, state);
    FoilFields fields = make_fields(*foils, 1);
    record(*foils, dry, 0, fields);
    EXPECT_EQ((fields.top_bump.normal_force.array() > 0.0).count(), film_bearing_outcome(bearing, state).loaded_bumps);
    for (Eigen::Index b = 0; b < foils->bumps(); ++b) {
      const int crest = bearing.foil.supports[static_cast<std::size_t>(b)];
      EXPECT_NEAR(fields.top_displacement(0, b), state.foil.lift[crest] * bearing.scales.thickness, 1e-15);
      EXPECT_EQ(fields.journal_top.gap(0, b), state.foil.film.thickness(0, crest) * bearing.scales.thickness);
      EXPECT_EQ(fields.journal_top.normal_force(0, b), 0.0);
      // The moment over a crest, of the film and of the stress.
      const double moment =
          bearing.foil.stiffness * bearing.foil.pitch * bearing.scales.thickness * std::abs(state.foil.moment[crest]);
      EXPECT_NEAR(fields.stress.top_crest(0, b), moment / foils->stress.front().top_section_modulus,
                  1e-9 * fields.stress.top_crest.maxCoeff());
    }
    // What the bumps take from above they hand to the sleeve, but for what friction carries.
    EXPECT_NEAR(fields.bump_sleeve.normal_force.sum() / fields.top_bump.normal_force.sum(), 1.0, 0.2);
  }
}

}  // namespace
}  // namespace bumpfoil
