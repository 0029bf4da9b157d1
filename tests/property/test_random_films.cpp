// Random running bearings: properties of every state.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

/// A reproducible random bearing and its journal position: clearance 20 to 45 um, top foil 0.07 to 0.2 mm, friction up
/// to 0.5 or none, heights within 2 um, any direction, up to 0.7 of the clearance, 5,000 to 60,000 rpm in either
/// direction.
struct RandomFilm {
  explicit RandomFilm(std::uint64_t number) {
    std::mt19937_64 generator(number);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * std::generate_canonical<double, 53>(generator);
    };
    const double friction = number % 4 == 0 ? 0.0 : uniform(0.0, 0.5);
    input = film_reference_case({.columns_per_pitch = 4, .rows = 4}, friction);
    input.bearing.radial_clearance = uniform(20e-6, 45e-6);
    input.top_foil.thickness = uniform(0.07e-3, 0.2e-3);
    for (int b = 0; b < input.bump_foil.bumps; ++b) input.bump_foil.height_errors.push_back(uniform(-2e-6, 2e-6));
    // The tallest bumps narrow the bearing.
    const double room = 0.7 * (input.bearing.radial_clearance - 2e-6);
    // In this order with every compiler.
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    position = uniform(0.0, room) * unit_vector(angle);
    speed = speed_of_rpm(uniform(5e3, 60e3)) * (uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0);
  }

  Case input;
  Eigen::Vector2d position{Eigen::Vector2d::Zero()};
  double speed{};
};

/// Contacts encountered, by mode.
struct Met {
  int open{}, stuck{}, slipping{};
};

/// Positive pressure and thickness, non-penetration, no tension, Coulomb's cone, friction opposite to the slip since
/// the unstressed state.
void expect_lawful(const BearingModel& bearing, const BearingState& state, Met& met) {
  EXPECT_GT(state.film.pressure.minCoeff(), 0.0);
  EXPECT_GT(state.film.thickness.minCoeff(), 0.0);
  const double force = 1e-9 * std::max(1.0, state.contacts.normal_force.maxCoeff());  // N
  constexpr double length = 1e-12;                                                    // m
  for_each_contact(bearing.problem, [&](const CoulombContact& contact) {
    const double p = state.contacts.normal_force[contact.index];
    const double t = state.contacts.friction_force[contact.index];
    const double gap = bearing.assembled_gap[contact.index] + contact.gap(state.contacts.x);
    const double slip = contact.tangential(state.contacts.x);
    const ContactMode mode = state.contacts.mode[static_cast<std::size_t>(contact.index)];
    ++(mode == ContactMode::open ? met.open : slips(mode) ? met.slipping : met.stuck);
    EXPECT_GE(p, -force);
    EXPECT_GE(gap, -length);
    EXPECT_TRUE(p <= force || gap <= length) << p << " N over " << gap << " m";
    EXPECT_LE(std::abs(t), contact.f * p + force);
    EXPECT_LE(t * slip, (std::abs(t) + force) * length);
  });
}

TEST(RandomFilms, ObeyTheLawsAndLastAsTheirEigenvaluesSay) {
  Met met;
  int found = 0;
  int leaving = 0;
  constexpr int cases = 24;
  for (std::uint64_t number = 0; number < cases; ++number) {
    const RandomFilm random(number);
    SCOPED_TRACE(number);
    const BearingModel bearing = make_film_bearing(random.input);
    FilmStepper stepper(bearing);
    BearingState state;
    const FilmReport report = start_from_ambient(stepper, random.position, random.speed, state);
    // The march itself may touch down, which it reports.
    if (report.status != Status::converged) continue;
    ++found;
    expect_lawful(bearing, state, met);
    const FilmFlows flows = film_bearing_outcome(bearing, state).flows;
    EXPECT_NEAR(flows.start, flows.end + flows.sides, 1e-12 * std::abs(flows.start));

    // A film disturbed with its journal held returns, with a residue from friction, or departs, in agreement with its
    // eigenvalues.
    const std::optional<bool> lasts = stepper.held_motions(state).is_stable();
    ASSERT_TRUE(lasts.has_value());
    const BearingState disturbed = pressed(state, 1e-3);
    const BearingState later = march_on(stepper, {revolutions(held_there(state), 3, 50)}, disturbed);
    const double kept = stepper.distance(later, state) / stepper.distance(disturbed, state);
    if (*lasts) {
      EXPECT_LT(kept, 0.3);
    } else {
      ++leaving;
      EXPECT_GT(kept, 10.0);
    }
  }
  EXPECT_GE(found, cases - 4);
  EXPECT_GT(leaving, 0);
  for (const int contacts : {met.open, met.stuck, met.slipping}) EXPECT_GT(contacts, 100);
}

TEST(RandomFilms, LoseTheirFrictionWithoutAJump) {
  for (std::uint64_t number = 0; number < 24; number += 4) {  // those without friction
    RandomFilm random(number);
    SCOPED_TRACE(number);
    Eigen::Vector2d force[2];
    bool found = true;
    for (const int i : {0, 1}) {
      const double f = i == 0 ? 0.0 : 1e-6;
      random.input.friction = {.top_bump = f, .bump_sleeve = f};
      const BearingModel bearing = make_film_bearing(random.input);
      BearingState state;
      FilmStepper stepper(bearing);
      found = start_from_ambient(stepper, random.position, random.speed, state).status == Status::converged && found;
      if (found) force[i] = film_force(*bearing.film, state.film.pressure);
    }
    // Friction carries a fraction of the load of order f.
    if (found) {
      EXPECT_LT((force[1] - force[0]).norm(), 1e-4 * std::max(1.0, force[0].norm()));
    }
  }
}

}  // namespace
}  // namespace bumpfoil
