#include "bumpfoil/bearing/film_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

constexpr FilmResolution coarse{.columns_per_pitch = 4, .rows = 3};

TEST(FilmBearing, HasAColumnOverEveryCrest) {
  const BearingModel bearing = film_reference_bearing(coarse);
  const double pitch_angle = 4.572e-3 / 19.05e-3;
  ASSERT_EQ(bearing.film->pads.front().foil.supports.size(), 26U);
  for (std::size_t i = 0; i < 26; ++i) {
    EXPECT_NEAR(bearing.film->pads.front().foil.supports[i] * bearing.film->pads.front().foil.mesh.dtheta,
                (static_cast<double>(i) + 0.5) * pitch_angle, 1e-13);
  }
  EXPECT_EQ(bearing.film->pads.front().foil.mesh.columns, 104);
  EXPECT_EQ(bearing.problem.K.blocks(), 27);
  EXPECT_EQ(bearing.problem.K.block_size(), 6 + 3);
  EXPECT_EQ(bearing.problem.contacts(), 2 * bearing.problem.K.blocks());  // no journal/top foil
}

TEST(FilmBearing, TakesTheBumpFoilWithoutTheTopFoil) {
  const BearingModel bearing = film_reference_bearing(coarse);
  const BumpDofs& dofs = bearing.structure.dofs;
  for (const Matrix& block : bearing.problem.K.diagonal) {
    if (&block == &bearing.problem.K.diagonal.back()) continue;
    EXPECT_EQ(block.row(dofs.top_u).norm() + block.row(dofs.top_moment).norm(), 0.0);
    EXPECT_GT(block(dofs.crest_v, dofs.crest_v), 1e6);
  }
  EXPECT_EQ(bearing.problem.K.diagonal.back()(dofs.size, dofs.size), 0.0);  // the free end is free
}

TEST(FilmBearing, IsThinWhereTheJournalGoes) {
  const BearingModel bearing = film_reference_bearing(coarse);
  // The weld is at -X, and theta is clockwise: column 26 of 104 is near +Y, 52 near +X.
  const Matrix H = undeformed_thickness(bearing, Eigen::Vector2d(0.5 * bearing.clearance, 0.0));
  EXPECT_NEAR(H(0, 0), 1.5, 1e-12);
  EXPECT_NEAR(H.minCoeff(), 0.5, 1e-3);
  EXPECT_NEAR(undeformed_thickness(bearing, Eigen::Vector2d(0.0, 0.5 * bearing.clearance)).col(26).minCoeff(), 0.5,
              1e-3);
  Case tapered = film_reference_case(coarse);
  tapered.bearing.taper = 3.18e-6;  // a tenth of the clearance
  const Matrix wider = undeformed_thickness(make_film_bearing(tapered), Eigen::Vector2d(0.5 * bearing.clearance, 0.0));
  EXPECT_NEAR(wider(0, 0), 1.5, 1e-12);
  EXPECT_NEAR(wider(2, 104) - H(2, 104), 0.1, 1e-12);
  Case wide_ended = film_reference_case(coarse);
  wide_ended.width.crowning = 3.18e-6;
  const BearingModel crowned = make_film_bearing(wide_ended);
  EXPECT_TRUE(crowned.film->varies_over_the_width());
  EXPECT_EQ(crowned.film->assembled_clearance, bearing.film->assembled_clearance);
  const int side = crowned.film->pads.front().foil.mesh.rows;
  const Matrix widening =
      undeformed_thickness(crowned, Eigen::Vector2d::Zero()) - undeformed_thickness(bearing, Eigen::Vector2d::Zero());
  EXPECT_NEAR(widening(0, 7), 0.0, 1e-12);
  EXPECT_NEAR(widening(1, 7), 0.1 / (side * side), 1e-12);
  EXPECT_NEAR(widening(side, 7), 0.1, 1e-12);
  wide_ended.width.crowning *= -1.0;
  EXPECT_NEAR(make_film_bearing(wide_ended).film->assembled_clearance, bearing.film->assembled_clearance - 3.18e-6,
              1e-18);
  EXPECT_LT(bearing.film->surface_speed(bearing.film->pads.front(), 100.0), 0.0);
  EXPECT_NEAR(film_equation(*bearing.film, bearing.film->pads.front(), speed_of_rpm(45000.0)).bearing_number,
              -1.852606648, 1e-8);
}

/// Without friction, the force required by asperities is the slope of their energy, K' sigma 2/7 F_7/2(h / sigma) per
/// area; friction turns it by the friction angle.
TEST(FilmBearing, AsperitiesPushTheJournalBack) {
  Case rough = film_reference_case(coarse);
  rough.asperity = AsperitySettings{.sigma = 2e-6, .pressure_factor = 1e7, .friction = 0.3};
  const BearingModel bearing = make_film_bearing(rough);
  const FilmPad& pad = bearing.film->pads.front();
  const auto energy_at = [&](const Eigen::Vector2d& position) {
    const Matrix H = undeformed_thickness(bearing, position);
    double sum = 0.0;
    for (int k = 0; k < bearing.film->columns(); ++k) {
      const double u = H(0, k) * bearing.film->scales.thickness / 2e-6;
      const GreenwoodTripp peaks = greenwood_tripp(u);
      const double seven_halves = -peaks.slope - u * peaks.value;  // F_7/2 = 5/2 F_3/2 - u F_5/2
      sum += pad.foil.mesh.column_weight(k) * 1e7 * 2e-6 * 2.0 / 7.0 * seven_halves;
    }
    return sum * bearing.film->scales.radius * pad.foil.mesh.dtheta * rough.bearing.axial_length;
  };
  const Eigen::Vector2d position(0.7 * bearing.clearance, 0.6 * bearing.clearance);
  const Matrix pressures = asperity_pressures(*bearing.film, undeformed_thickness(bearing, position));
  const Eigen::Vector2d force = asperity_force(*bearing.film, pressures, 0.0);
  constexpr double d = 1e-10;
  for (const int axis : {0, 1}) {
    const Eigen::Vector2d step = d * Eigen::Vector2d::Unit(axis);
    const double slope = (energy_at(position + step) - energy_at(position - step)) / (2.0 * d);
    EXPECT_NEAR(force[axis], slope, 1e-6 * force.norm());
  }
  EXPECT_GT(force.x(), 1.0);
  const Eigen::Vector2d rubbing = asperity_force(*bearing.film, pressures, 0.3);
  EXPECT_NEAR(rubbing.dot(force) / force.squaredNorm(), 1.0, 1e-12);
  EXPECT_NEAR((force.x() * rubbing.y() - force.y() * rubbing.x()) / force.squaredNorm(), 0.3, 1e-12);
  EXPECT_EQ(sliding_friction(*bearing.film, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(sliding_friction(*bearing.film, speed_of_rpm(60.0)), 0.3);
  EXPECT_EQ(sliding_friction(*bearing.film, -1e-3), -sliding_friction(*bearing.film, 1e-3));
}

/// A prescribed pressure: forces are its integrals over the foil.
TEST(FilmBearing, HoldsTheJournalAgainstThePressure) {
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 12, .rows = 8});
  BearingState state = resting(bearing, Eigen::Vector2d::Zero(), 100.0);
  state.contacts.normal_force[4] = 3.0;  // top_bump of the third bump
  const int n = bearing.film->pads.front().foil.mesh.columns;
  for (int k = 0; k <= n; ++k) state.film.pressure.col(k).array() += 0.1 * bearing.film->column_normals(1, k);
  const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
  const double area = 101325.0 * 19.05e-3 * 38.1e-3;
  // 0.1 pa sin(phi) over the foil; 2.5 degrees are missing at the weld, where the sine is small.
  EXPECT_NEAR(outcome.force.y(), 0.1 * area * std::numbers::pi, 1e-3 * area * 0.1);
  EXPECT_NEAR(outcome.force.x(), 0.0, 1e-2 * area * 0.1);
  EXPECT_EQ(outcome.loaded_bumps, 1);
  EXPECT_NEAR(outcome.power, 100.0 * outcome.torque, 1e-15);
}

/// The displacement leads the force by 2 pi - 2.5 - pi / 2 if the journal turns from X to Y, and lags by it in the
/// other direction.
TEST(FilmBearing, HasAnAttitudeFromTheForceToTheDisplacement) {
  const BearingModel bearing = film_reference_bearing(coarse);
  const double eccentricity = 0.3 * bearing.clearance;
  for (const double speed : {-100.0, 100.0}) {
    BearingState state = resting(bearing, eccentricity * Eigen::Vector2d(std::cos(-2.5), std::sin(-2.5)), speed);
    for (int k = 0; k < bearing.film->columns(); ++k)
      state.film.pressure.col(k).array() += 0.1 * bearing.film->column_normals(1, k);
    const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
    const double of_force = std::atan2(outcome.force.y(), outcome.force.x());
    EXPECT_NEAR(of_force, 0.5 * std::numbers::pi, 0.05);
    EXPECT_NEAR(outcome.attitude_angle, std::copysign(2.0 * std::numbers::pi - 2.5 - of_force, speed), 1e-12);
    EXPECT_EQ(outcome.max_pressure, state.film.pressure.maxCoeff());
    EXPECT_EQ(outcome.min_pressure, state.film.pressure.minCoeff());
    EXPECT_LT(outcome.min_pressure, 0.95);
  }
}

/// The outflow at both sides under a pressure that is uniform between them.
TEST(FilmBearing, LeaksAtBothSides) {
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4, .width = WidthPart::whole});
  BearingState state = resting(bearing, JournalVector::Zero(4), 0.0);
  state.film.pressure.middleRows(1, state.film.pressure.rows() - 2).array() += 0.1;
  const FilmFlows flows = film_bearing_outcome(bearing, state).flows;
  EXPECT_GT(flows.sides, 0.0);
  EXPECT_NEAR(flows.right_side, 0.5 * flows.sides, 1e-12 * flows.sides);
}

/// Petroff's law: the shear torque of a centred journal without pressure is mu Omega R^3 / c over the foil.
TEST(FilmBearing, DragsByCouetteFlowAlone) {
  const BearingModel bearing = film_reference_bearing(coarse);
  for (const double speed : {-100.0, 100.0}) {
    const FilmBearingOutcome outcome = film_bearing_outcome(bearing, resting(bearing, Eigen::Vector2d::Zero(), speed));
    const double petroff = 1.85e-5 * speed * std::pow(19.05e-3, 2) / 31.8e-6 * 26 * 4.572e-3 * 38.1e-3;
    EXPECT_NEAR(outcome.torque, petroff, 1e-12 * std::abs(petroff));
    EXPECT_NEAR(outcome.dissipation, outcome.power, 1e-12 * outcome.power);
    // Couette flow U c L / 2, along theta if U is positive.
    EXPECT_NEAR(outcome.flows.end, -0.5 * speed * 19.05e-3 * 31.8e-6 * 38.1e-3, 1e-12 * std::abs(speed));
  }
}

/// Pads of 8 and 6 bumps, the second welded at its trailing edge.
TEST(FilmBearing, HasTheColumnsAndBlocksOfItsPadsInARow) {
  Case input = film_reference_case(coarse);
  input.bump_foil.bumps = 8;
  input.bearing.weld_angle = 0.0;
  input.pads = {{.weld_edge = WeldEdge::leading, .lobe = 8e-6}, {.weld_edge = WeldEdge::trailing, .lobe = 8e-6}};
  input.pads[1].bump_foil = input.bump_foil;
  input.pads[1].bump_foil->bumps = 6;
  const BearingModel bearing = make_film_bearing(input);
  ASSERT_EQ(bearing.film->pads.size(), 2U);
  const auto& [first, second] = std::tie(bearing.film->pads[0], bearing.film->pads[1]);
  EXPECT_EQ(first.first_column, 0);
  EXPECT_EQ(second.first_column, 33);
  EXPECT_EQ(second.first_block, 9);
  EXPECT_EQ(bearing.film->columns(), 33 + 25);
  EXPECT_EQ(bearing.bumps(), 14);
  EXPECT_EQ(bearing.problem.K.blocks(), 16);
  EXPECT_EQ(first.wrap_sign, -1.0);
  EXPECT_EQ(second.wrap_sign, 1.0);
  // The free end of one pad is not coupled to the weld of the other; bumps within a pad are.
  EXPECT_EQ(bearing.problem.K.upper[8].norm(), 0.0);
  EXPECT_EQ(bearing.problem.K.upper[7].norm(), 0.0);
  EXPECT_GT(bearing.problem.K.upper[6].norm(), 1e6);
  EXPECT_GT(bearing.problem.K.upper[9].norm(), 1e6);
  EXPECT_EQ(bearing.problem.K.diagonal[8](bearing.structure.dofs.size, bearing.structure.dofs.size), 0.0);
  // Clockwise from X; the second starts on the opposite side and ends at its weld.
  const double pitch_angle = 4.572e-3 / 19.05e-3;
  EXPECT_NEAR(bearing.film->column_normals(0, 0), 1.0, 1e-14);
  EXPECT_NEAR(std::atan2(bearing.film->column_normals(1, 32), bearing.film->column_normals(0, 32)), -8.0 * pitch_angle,
              1e-12);
  EXPECT_NEAR(std::atan2(bearing.film->column_normals(1, 33), bearing.film->column_normals(0, 33)),
              std::numbers::pi - 6.0 * pitch_angle, 1e-12);
  EXPECT_NEAR(bearing.film->column_normals(0, 57), -1.0, 1e-14);
  // The pad offset applies at the middle of the pad.
  const Matrix H = undeformed_thickness(bearing, Eigen::Vector2d::Zero());
  EXPECT_NEAR(H(0, 16) * bearing.clearance, 31.8e-6 - 8e-6, 1e-12);
  EXPECT_NEAR(H(0, 45) * bearing.clearance, 31.8e-6 - 8e-6, 1e-12);
  EXPECT_NEAR(H(0, 0) * bearing.clearance, 31.8e-6 - 8e-6 * std::cos(4.0 * pitch_angle), 1e-12);
}

TEST(FilmBearing, FindsTheThinnestPlaceOfAllPads) {
  Case input = film_reference_case(coarse);
  input.bump_foil.bumps = 8;
  input.bearing.weld_angle = 0.0;
  input.pads.resize(2);
  const BearingModel bearing = make_film_bearing(input);
  BearingState state = resting(bearing, Eigen::Vector2d(0.0, 0.5 * bearing.clearance), 100.0);  // to the second pad
  state.contacts.normal_force[2 * (9 + 2)] = 3.0;  // top_bump of its third bump
  const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
  EXPECT_EQ(outcome.thinnest_pad, 1);
  EXPECT_NEAR(outcome.thinnest.thickness, 0.5, 1e-2);
  EXPECT_NEAR(outcome.thinnest.column * bearing.film->pads[1].foil.mesh.dtheta, 0.5 * std::numbers::pi, 0.04);
  EXPECT_EQ(outcome.first_loaded, 8 + 2);
  EXPECT_EQ(outcome.loaded_bumps, 1);
  EXPECT_EQ(bump_loads(bearing, state)[8 + 2], 3.0);
}

/// A formed top foil bulges differently over strips of unequal height than over strips of their mean height.
TEST(FilmBearing, AssemblesFormedFoilsOnTheirStrips) {
  const Case input = parse_case(case_template("gen1"), "case.toml",
                                {.overrides = {"top_foil.formed_radius=seated", "width.modes=3", "bump_foil.strips=2",
                                               "bump_foil.strip=[{}, {height_errors=\"-5 um\"}]"},
                                 .commands = {}});
  const BearingModel foils = make_foils(input);
  const BearingModel bearing = make_film_bearing(
      foils, gas_of(input.gas), {.columns_per_pitch = 4, .rows = 3, .width_modes = 3, .width = WidthPart::whole});
  ASSERT_EQ(bearing.assembly.size(), 1U);
  EXPECT_EQ(bearing.assembly[0].load, on_strips(foils, 3, {}).assembly.at(0).load);
  EXPECT_NE(bearing.assembly[0].load, foils.assembly.at(0).load);
}

TEST(FilmBearing, HasARoundJournal) {
  Case input = film_reference_case(coarse);
  input.bearing.journal.waves = {{.harmonic = 2, .amplitude = 1e-6, .phase = 0.0}};
  EXPECT_THROW(make_film_bearing(input), Error);
}

}  // namespace
}  // namespace bumpfoil
