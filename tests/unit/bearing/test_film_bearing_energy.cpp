#include "bumpfoil/bearing/film_bearing_energy.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/build.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

TEST(BearingEnergy, OfGasAtRestIsNone) {
  const BearingModel bearing = film_reference_bearing({4, 3});
  const BearingEnergy energy = bearing_energy(bearing, resting(bearing, Eigen::Vector2d(0.0, 0.0), 0.0));
  EXPECT_EQ(energy.total(), 0.0);
}

/// Linear foils store half the work of their final loads over the total displacement: those on the top foils D M, those
/// on the bumps the contact forces.
TEST(BearingEnergy, OfFoilsIsHalfOfLoadTimesWay) {
  FilmStepper stepper(film_reference_bearing({4, 3}, 0.1));
  const BearingModel& bearing = stepper.bearing();
  const BearingState state = state_under(stepper, {60.0, 10.0}, speed_of_rpm(-45000.0));
  const FilmPad& pad = bearing.film->pads.front();
  const double c = bearing.film->scales.thickness;
  const Eigen::Index n = pad.foil.top_foil.size();
  const Vector moments = pad.foil.stiffness * pad.foil.pitch * c * state.film.moment.row(0).head(n).transpose();
  const double top =
      0.5 * c * loads_of_moments(pad.foil.top_foil, moments).dot(state.film.deflection.row(0).tail(n).transpose());
  const double bumps = 0.5 * contact_forces(bearing.problem, state.contacts.normal_force, state.contacts.friction_force)
                                 .cwiseProduct(state.contacts.x)
                                 .sum();
  // Contacts push on the top foil too, whose places among the unknowns K leaves out.
  const BearingEnergy energy = bearing_energy(bearing, state);
  EXPECT_GT(top, 1e-5);
  double pushed = 0.0;
  const int size = bearing.problem.K.block_size();
  const Vector forces = contact_forces(bearing.problem, state.contacts.normal_force, state.contacts.friction_force);
  for (int b = 0; b < bearing.problem.K.blocks(); ++b) {
    const Eigen::Index at = Eigen::Index{b} * size + bearing.structure.dofs.top_u;
    pushed += 0.5 * forces[at] * state.contacts.x[at];
  }
  EXPECT_NEAR(energy.foils, top + bumps - pushed, 1e-6 * energy.foils);
  EXPECT_GT(energy.gas, 0.0);
  EXPECT_EQ(energy.asperities, 0.0);
}

/// In all motions of the journal: two on half the width, four where it tilts.
TEST(BearingEnergy, AsperitiesHoldWhatTheirPressuresWouldDo) {
  Case input = film_reference_case({4, 3});
  input.asperity = AsperitySettings{.sigma = 0.5e-6, .pressure_factor = 2e8};
  Case tilted = input;
  tilted.width.tilt = {1e-5, 2e-5};
  tilted.width.crowning = 0.2e-6;
  for (const Case& one : {input, tilted}) {
    const BearingModel bearing = make_film_bearing(one);
    const auto energy_at = [&](const JournalVector& journal) {
      return bearing_energy(bearing, resting(bearing, journal, 0.0)).asperities;
    };
    JournalVector journal = JournalVector::Zero(bearing.film->motions());
    journal[0] = 30.5e-6;
    if (bearing.film->tilts()) journal.tail<2>() << 0.3e-6, -0.1e-6;
    const Matrix thickness = undeformed_thickness(bearing, journal);
    const JournalVector force = asperity_force(*bearing.film, asperity_pressures(*bearing.film, thickness), 0.0);
    EXPECT_GT(force[0], 1.0);
    for (Eigen::Index i = 0; i < journal.size(); ++i) {
      const JournalVector step = 1e-10 * JournalVector::Unit(journal.size(), i);
      const double slope = (energy_at(journal + step) - energy_at(journal - step)) / 2e-10;
      EXPECT_NEAR(slope, force[i], 1e-6 * force.norm()) << i;
    }
    if (!bearing.film->tilts()) continue;
    EXPECT_GT(force[2], 0.01 * force[0]);  // the side that the journal leans to is pressed
  }
}

/// Of a state that rests, the journal entrains what the flow dissipates: the flow under gradients of pressure has all
/// of the dissipation but that by shear, up to the error of the mesh.
TEST(FilmPowers, OfABearingAreThoseOfItsFlow) {
  FilmStepper stepper(film_reference_bearing({8, 6}));
  const BearingModel& bearing = stepper.bearing();
  const BearingState state = state_under(stepper, {60.0, 10.0}, speed_of_rpm(-45000.0));
  const FilmPowers powers = film_powers(*bearing.film, state);
  const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
  const double by_pressure = outcome.dissipation - outcome.couette_dissipation;
  EXPECT_GT(by_pressure, 0.1);  // W
  EXPECT_NEAR(powers.dissipated, by_pressure, 0.02 * by_pressure);
  EXPECT_NEAR(powers.entrained + powers.supplied, powers.dissipated, 1e-6 * powers.dissipated);
}

}  // namespace
}  // namespace bumpfoil
