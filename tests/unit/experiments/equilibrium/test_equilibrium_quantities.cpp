#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"

#include "bumpfoil/experiments/build.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// A bearing with a prescribed state: pressure 1.5 pa in two columns, all else at rest.
struct Example {
  BearingModel bearing{film_reference_bearing({.columns_per_pitch = 4, .rows = 4})};
  RunningState state{};

  Example() {
    state.requested = OperatingPoint::loaded_by({50.0, -1.0}, 1000.0);
    state.report.status = Status::converged;
    state.last = resting(bearing, Eigen::Vector2d(10e-6, 0.0), 1000.0);
    state.last->film.pressure.block(0, 40, 4, 2).setConstant(1.5);
    state.last->contacts.normal_force[2 * 3] = 4.0;  // top_bump of bump 4
    state.outcome = film_bearing_outcome(bearing, *state.last);
    state.stiffness = (Eigen::Matrix2d() << 1.0, 2.0, 3.0, 4.0).finished();
  }

  [[nodiscard]] double value(std::string_view name) const {
    for (const RunningQuantity& quantity :
         running_quantities(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}))) {
      if (quantity.name == name) return value_of(quantity, bearing, state);
    }
    ADD_FAILURE() << "no " << name;
    return std::nan("");
  }
};

TEST(RunningQuantities, HaveNamesOfTheirOwnAndUnitsOfNetcdf) {
  std::set<std::string_view> names;
  for (const RunningQuantity& quantity :
       running_quantities(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}))) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_FALSE(quantity.long_name.empty());
    EXPECT_EQ(quantity.unit.empty(), !quantity.form.words.empty()) << quantity.name;
    EXPECT_TRUE(!quantity.label.empty() || quantity.shown.size == 0.0) << quantity.name;
  }
}

TEST(RunningQuantities, AreWhatTheyAreCalled) {
  const Example example;
  EXPECT_EQ(example.value("speed"), 1000.0);
  EXPECT_EQ(example.value("load_x"), 50.0);
  EXPECT_EQ(example.value("load_y"), -1.0);
  EXPECT_EQ(example.value("x"), 10e-6);
  EXPECT_NEAR(example.value("eccentricity_ratio"), 10.0 / 31.8, 1e-12);
  EXPECT_NEAR(example.value("h_min"), 21.8e-6, 1e-8);  // the nearest column is about a degree away
  EXPECT_NEAR(example.value("h_min_theta"), 180.0, 2.0);
  EXPECT_NEAR(example.value("p_max"), 1.5 * 101325.0, 1e-6);
  EXPECT_NEAR(example.value("p_min"), 101325.0, 1e-6);
  EXPECT_NEAR(example.value("power"), 1000.0 * example.value("torque"), 1e-12);
  EXPECT_NEAR(example.value("couette_torque") + example.value("poiseuille_torque"), example.value("torque"), 1e-15);
  EXPECT_EQ(example.value("loaded_bumps"), 1.0);
  EXPECT_EQ(example.value("first_loaded_bump"), 4.0);
  EXPECT_EQ(example.value("lifted_bumps_at_entry"), 22.0);  // gas enters at the free end
  EXPECT_EQ(example.value("highest_bump_load"), 4.0);
  EXPECT_EQ(example.value("highest_loaded_bump"), 4.0);
  EXPECT_EQ(example.value("kxy"), 2.0);
  EXPECT_EQ(example.value("kyx"), 3.0);
  EXPECT_TRUE(std::isnan(example.value("kxx_stuck")));
}

/// From the force to the displacement, positive in the sense of rotation.
TEST(RunningQuantities, AttitudeAngleTurnsWithTheJournal) {
  Example example;
  const Eigen::Vector2d force = example.state.outcome->force;
  const double angle = std::atan2(force.y(), force.x()) * 180.0 / M_PI;  // the displacement is along +X
  EXPECT_NEAR(example.value("attitude_angle"), -angle, 1e-9);
  example.state.last->speed = -1000.0;
  example.state.outcome = film_bearing_outcome(example.bearing, *example.state.last);
  EXPECT_NEAR(example.value("attitude_angle"), angle, 1e-9);
}

TEST(RunningQuantities, KnowOfFailedStatesWhatWasAskedForAlone) {
  Example example;
  example.state.report.status = Status::touchdown;
  EXPECT_EQ(example.value("speed"), 1000.0);
  EXPECT_EQ(example.value("load_x"), 50.0);
  EXPECT_TRUE(std::isnan(example.value("x")));
  EXPECT_TRUE(std::isnan(example.value("h_min")));
  const std::string failure = running_failure(example.bearing, example.state);
  EXPECT_NE(failure.find("load (50, -1) N: touchdown"), std::string::npos) << failure;
  EXPECT_NE(failure.find("; last state found: 9549.3 rpm, journal (10, 0) um"), std::string::npos) << failure;
  EXPECT_EQ(failure.find("clearance"), std::string::npos) << failure;
  example.state.last->clearance_offset = 2e-6;
  const std::string opened = running_failure(example.bearing, example.state);
  EXPECT_NE(opened.find("with the clearance at 33.8 um, closing to 31.8 um"), std::string::npos) << opened;
}

/// Gas enters at the free end of the first pad, and at the weld of the second.
TEST(RunningQuantities, LiftedBumpsAreThoseOfThePadThatHasMost) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4});
  input.bump_foil.bumps = 8;
  input.pads.resize(2);
  input.pads[1].weld_edge = WeldEdge::trailing;
  const BearingModel bearing = make_film_bearing(input);
  RunningState state;
  state.requested = OperatingPoint::loaded_by({50.0, -1.0}, 1000.0);
  state.report.status = Status::converged;
  state.last = resting(bearing, Eigen::Vector2d(10e-6, 0.0), 1000.0);
  EXPECT_EQ(lifted_bumps_at_entry(bearing, state), 0);   // neither is in contact
  state.last->contacts.normal_force[2 * 4] = 1.0;        // bump 5 of pad 1
  EXPECT_EQ(lifted_bumps_at_entry(bearing, state), 8);   // all of pad 2
  state.last->contacts.normal_force[2 * (9 + 4)] = 1.0;  // bump 5 of pad 2
  EXPECT_EQ(lifted_bumps_at_entry(bearing, state), 4);
  state.requested.speed = -1000.0;
  EXPECT_EQ(lifted_bumps_at_entry(bearing, state), 4);
  state.last->contacts.normal_force[2 * 1] = 1.0;  // bump 2 of pad 1
  EXPECT_EQ(lifted_bumps_at_entry(bearing, state), 3);
  EXPECT_EQ(running_bump_text(bearing, 8 + 4), "2.5");
}

TEST(RunningQuantities, PlaceMotionsOnTheirPad) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4});
  input.bump_foil.bumps = 8;
  input.pads.resize(2);
  const BearingModel bearing = make_film_bearing(input);
  const double column = bearing.film->pads.front().foil.mesh.dtheta;
  HeldMotion motion;
  motion.column = 32;  // the free end of pad 1
  EXPECT_EQ(held_place(bearing, motion).pad, 0U);
  EXPECT_DOUBLE_EQ(held_place(bearing, motion).theta, 32 * column);
  motion.column = 33 + 5;
  EXPECT_EQ(held_place(bearing, motion).pad, 1U);
  EXPECT_DOUBLE_EQ(held_place(bearing, motion).theta, 5 * column);
}

TEST(ColumnQuantities, IntegrateOverTheWidth) {
  const Example example;
  for (const ColumnQuantity& quantity : column_quantities()) {
    if (quantity.is(tag::of_width)) continue;  // only for foils that vary over the width
    const Vector values = quantity.value(example.bearing, *example.state.last);
    ASSERT_EQ(values.size(), 105);
    if (quantity.name == "line_load") {
      // 0.5 pa on 3.5 of 4 rows of half the width, and the same on the other half.
      EXPECT_NEAR(values[40], 0.5 * 101325.0 * 38.1e-3 * 3.5 / 4.0, 1e-6);
      EXPECT_EQ(values[0], 0.0);
    }
    if (quantity.name == "film_thickness") {
      EXPECT_NEAR(values[0], 41.8e-6, 1e-12);  // at the weld, opposite to the displacement
    }
  }
}

}  // namespace
}  // namespace bumpfoil
