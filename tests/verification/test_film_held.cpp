// docs/verification/film.md: motions of film and foils with the journal held, against an independent prototype, a dense
// solution of all equations, and symmetry.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "core/linear_algebra.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Rate with the journal held, over the speed of rotation.
Complex held_rate(FilmStepper& stepper, const BearingState& state, bool stuck = false) {
  const std::optional<HeldMotion> motion = stepper.held_motion(state, stuck);
  EXPECT_TRUE(motion.has_value());
  if (!motion) return {};
  EXPECT_LT(motion->residual, 1e-8);
  return motion->rate / std::abs(state.speed);
}

/// Motion of film and foils with the largest real part, journal held, load along +X, f = 0; speed in rpm, load in N.
struct HeldReference {
  double rpm, load;
  Complex rate;  ///< over the speed of rotation
};

/// Gas that enters at the free end causes flutter, gas that enters at the weld does not.
TEST(FilmHeld, GrowsAndDecaysAsInThePrototype) {
  const std::vector<HeldReference> references{
      {45000.0, 9.81, {0.1727, 0.4808}},   {45000.0, 20.0, {0.1922, 0.516}},     {45000.0, 50.0, {0.2469, 0.6118}},
      {45000.0, 100.0, {0.2911, 0.6463}},  {45000.0, 200.0, {0.2992, 0.7092}},   {12000.0, 9.81, {0.50152, 0.78821}},
      {-45000.0, 9.81, {-0.8613, 0.7416}}, {-45000.0, 20.0, {-0.7257, 0.0}},     {-45000.0, 50.0, {-1.1258, 0.0}},
      {-45000.0, 100.0, {-1.2507, 0.0}},   {-45000.0, 200.0, {-0.4023, 1.3197}},
  };
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 6, .rows = 8});
  FilmStepper stepper(bearing);
  for (const HeldReference& reference : references) {
    SCOPED_TRACE(reference.rpm);
    SCOPED_TRACE(reference.load);
    const BearingState state = state_under(stepper, {reference.load, 0.0}, speed_of_rpm(reference.rpm));
    // Digits printed by the prototype.
    EXPECT_LT(std::abs(held_rate(stepper, state) - reference.rate), 2e-4);
  }
}

TEST(FilmHeld, GrowsOnAFinerMeshAsInThePrototype) {
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 12, .rows = 16}));
  const BearingState state = state_under(stepper, {9.81, 0.0}, speed_of_rpm(12000.0));
  EXPECT_LT(std::abs(held_rate(stepper, state) - Complex(0.50035, 0.78645)), 2e-5);
}

/// All equations of film, foil, bump foil and contacts, linearised about a state, J X + s T0 S X = 0, as dense
/// matrices: unknowns P, U, M, displacements of the bump foil over c, contact forces over EI' c / p^3.
class DensePencil {
 public:
  DensePencil(const BearingModel& bearing, const BearingState& state, bool stuck)
      : bearing_(bearing), pad_(bearing.film->pads.front()), mesh_(pad_.foil.mesh), size_(bearing.structure.dofs.size) {
    first_deflection_ = Eigen::Index{mesh_.unknown_rows()} * mesh_.unknown_columns();
    first_bump_ = first_deflection_ + 2 * Eigen::Index{mesh_.columns};
    first_force_ = first_bump_ + Eigen::Index{pad_.bumps()} * size_;
    const Eigen::Index n = first_force_ + Eigen::Index{pad_.bumps()} * bearing.contacts_per_block() * 2;
    J_.setZero(n, n);
    S_.setZero(n, n);
    add_film(state);
    add_foil();
    add_bumps();
    add_contacts(state, stuck);
  }

  /// Rightmost pole over the speed of rotation, of those with imaginary parts up to ten.
  [[nodiscard]] Complex rightmost(double speed) const {
    const double unit = std::abs(speed) * bearing_.film->scales.squeeze_time();
    const double shift = 0.7 * unit;
    Complex found(-1e9, 0.0);
    const Eigen::VectorXcd inverses = eigenvalues(solve(J_ + shift * S_, S_)).value();
    for (const Complex mu : inverses) {
      if (std::abs(mu) < 1e-3 / unit) continue;  // infinite: most equations have no storage term
      const Complex s = (shift - 1.0 / mu) / unit;
      if (s.real() > found.real()) found = {s.real(), std::abs(s.imag())};
    }
    return found;
  }

 private:
  [[nodiscard]] Eigen::Index pressure(int j, int k) const { return Eigen::Index{k - 1} * mesh_.rows + j; }
  [[nodiscard]] Eigen::Index deflection(int k) const { return first_deflection_ + k - 1; }
  [[nodiscard]] Eigen::Index moment(int k) const { return first_deflection_ + mesh_.columns + k; }
  /// Index of a degree of freedom of a bump. That of the moment over the crest is unused.
  [[nodiscard]] Eigen::Index displacement(int bump, int place) const {
    if (place == bearing_.structure.dofs.top_u) return deflection(pad_.foil.supports[static_cast<std::size_t>(bump)]);
    return first_bump_ + Eigen::Index{bump} * size_ + place;
  }

  void add_film(const BearingState& state) {
    const ReynoldsEquation equation = film_equation(*bearing_.film, pad_, state.speed);
    Matrix residual;
    FilmJacobian jacobian;
    linearise_reynolds(equation, state.film, residual, jacobian);
    const auto add = [&](const FilmStencil& stencil, const Matrix& change, Eigen::Index unknown) {
      const Matrix product = stencil_product(mesh_, stencil, change);
      for (int k = 1; k < mesh_.columns; ++k) {
        for (int j = 0; j < mesh_.rows; ++j) J_(pressure(j, k), unknown) += product(j, k);
      }
    };
    for (int k = 1; k < mesh_.columns; ++k) {
      for (int j = 0; j < mesh_.rows; ++j) {
        Matrix change = mesh_.field(0.0);
        change(j, k) = 1.0;
        add(jacobian.by_pressure, change, pressure(j, k));
        const double volume = mesh_.row_weight(j) * mesh_.dtheta * mesh_.dzeta;
        S_(pressure(j, k), pressure(j, k)) = volume * state.film.thickness(j, k);
        S_(pressure(j, k), deflection(k)) = volume * state.film.pressure(j, k);
      }
    }
    for (int k = 1; k <= mesh_.columns; ++k) {
      Matrix change = mesh_.field(0.0);
      change.col(k).setOnes();
      add(jacobian.by_thickness, change, deflection(k));
    }
  }

  /// Balance of columns 1 to the last, compatibility of 0 to the last but one, from unit changes of the unknowns.
  void add_foil() {
    FoilFilmState unit = undeformed(pad_.foil, {});
    FoilFilmResidual residual;
    const auto add = [&](double& value, Eigen::Index unknown) {
      value += 1.0;
      foil_residual(pad_.foil, unit, residual);
      value -= 1.0;
      for (int k = 1; k <= mesh_.columns; ++k) J_(deflection(k), unknown) += residual.balance(k);
      for (int k = 0; k < mesh_.columns; ++k) J_(moment(k), unknown) += residual.compatibility(k);
    };
    for (int k = 1; k < mesh_.columns; ++k) {
      for (int j = 0; j < mesh_.rows; ++j) add(unit.pressure(j, k), pressure(j, k));
    }
    for (int k = 1; k <= mesh_.columns; ++k) add(unit.deflection(k), deflection(k));
    for (int k = 0; k < mesh_.columns; ++k) add(unit.moment(k), moment(k));
  }

  void add_bumps() {
    const BlockTridiagonal& K = bearing_.problem.K;
    const auto is_bump = [&](int i) {
      return i != bearing_.structure.dofs.top_u && i != bearing_.structure.dofs.top_moment;
    };
    for (int b = 0; b < pad_.bumps(); ++b) {
      const auto at = static_cast<std::size_t>(b);
      for (int i = 0; i < size_; ++i) {
        if (!is_bump(i)) {
          J_(first_bump_ + b * size_ + i, first_bump_ + b * size_ + i) = 1.0;  // unused
          continue;
        }
        for (int j = 0; j < size_; ++j) {
          if (!is_bump(j)) continue;
          J_(displacement(b, i), displacement(b, j)) += K.diagonal[at](i, j) / pad_.foil.stiffness;
          if (b + 1 == pad_.bumps()) continue;
          J_(displacement(b, i), displacement(b + 1, j)) += K.upper[at](i, j) / pad_.foil.stiffness;
          J_(displacement(b + 1, j), displacement(b, i)) += K.upper[at](i, j) / pad_.foil.stiffness;
        }
      }
    }
  }

  void add_contacts(const BearingState& state, bool stuck) {
    Eigen::Index p = first_force_;
    for_each_contact(bearing_.problem, [&](const CoulombContact& contact) {
      const ContactSite& site = contact.site;
      if (site.block >= pad_.bumps()) return;
      const Eigen::Index t = p + 1;
      ContactMode mode = state.contacts.mode[static_cast<std::size_t>(contact.index)];
      if (stuck && mode != ContactMode::open) mode = ContactMode::stick;
      if (site.plus >= 0) J_(displacement(site.block, site.plus), p) -= 1.0;
      if (site.minus >= 0) J_(displacement(site.block, site.minus), p) += 1.0;
      if (site.tangential >= 0) J_(displacement(site.block, site.tangential), t) -= 1.0;
      if (mode == ContactMode::open) {
        J_(p, p) = 1.0;
      } else {
        if (site.plus >= 0) J_(p, displacement(site.block, site.plus)) += 1.0;
        if (site.minus >= 0) J_(p, displacement(site.block, site.minus)) -= 1.0;
      }
      if (mode == ContactMode::stick && !is_frictionless(site)) {
        J_(t, displacement(site.block, site.tangential)) = 1.0;
      } else {
        J_(t, t) = 1.0;
        if (slips(mode)) J_(t, p) = -friction_sign(mode) * site.friction_coefficient;
      }
      p += 2;
    });
  }

  const BearingModel& bearing_;
  const FilmPad& pad_;
  const FilmMesh& mesh_;
  int size_;
  Eigen::Index first_deflection_{}, first_bump_{}, first_force_{};
  Matrix J_, S_;
};

/// A foil over 110 degrees with eight bumps.
Case short_foil(double friction_coefficient) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4}, friction_coefficient);
  input.bump_foil.bumps = 8;
  input.bearing.weld_angle = 0.75 * std::numbers::pi;
  return input;
}

/// The journal is pushed towards +X step by step, so that bumps slip, and drawn back.
TEST(FilmHeld, IsTheRightmostPoleOfAllEquations) {
  for (const double friction_coefficient : {0.0, 0.3}) {
    const BearingModel bearing = make_film_bearing(short_foil(friction_coefficient));
    FilmStepper stepper(bearing);
    for (const double rpm : {45000.0, -45000.0, -6000.0}) {
      BearingState state;
      ASSERT_EQ(start_from_ambient(stepper, {-0.3 * bearing.clearance, 0.0}, speed_of_rpm(rpm), state).status,
                Status::converged);
      for (const double e : {-0.3, 0.2, 0.6, 0.9, 0.5}) {
        SCOPED_TRACE(testing::Message() << friction_coefficient << ' ' << rpm << ' ' << e);
        const OperatingPoint point = OperatingPoint::held_at({e * bearing.clearance, 0.0}, speed_of_rpm(rpm));
        ASSERT_EQ(stepper.advance(point, state).status, Status::converged);
        for (const bool stuck : {false, true}) {
          const Complex expected = DensePencil(bearing, state, stuck).rightmost(state.speed);
          EXPECT_LT(std::abs(held_rate(stepper, state, stuck) - expected), 1e-8) << expected;
        }
      }
    }
  }
}

/// Z has the same pole: it grows like 1 / |s - s_0| there.
TEST(FilmHeld, IsAPoleOfTheImpedance) {
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}));
  const double speed = speed_of_rpm(12000.0);
  const BearingState state = state_under(stepper, {9.81, 0.0}, speed);
  const Complex pole = held_rate(stepper, state) * speed;
  const double distance = 1e-4 * speed;
  const auto Z = stepper.impedances(state, {pole + distance, pole + 2.0 * distance, pole - 2.0 * distance});
  ASSERT_TRUE(Z.has_value());
  EXPECT_NEAR((*Z)[0].norm() / (*Z)[1].norm(), 2.0, 0.02);
  EXPECT_NEAR((*Z)[2].norm() / (*Z)[1].norm(), 1.0, 0.02);
}

/// A bearing turned with its load, or mirrored with its load and speed, is the same.
TEST(FilmHeld, IsTheSameTurnedAndMirrored) {
  const Eigen::Vector2d load(40.0, 15.0);
  const double speed = speed_of_rpm(45000.0);
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4}, 0.1);
  FilmStepper here(make_film_bearing(input));
  const BearingState state = state_under(here, load, speed);
  const Eigen::Rotation2Dd turn(0.7);
  Case turned = input;
  turned.bearing.weld_angle += turn.angle();
  FilmStepper there(make_film_bearing(turned));
  const BearingState turned_state = state_under(there, turn * load, speed);
  Case mirrored = input;
  mirrored.bearing.weld_angle = -input.bearing.weld_angle;
  mirrored.bearing.wrap = input.bearing.wrap == Wrap::clockwise ? Wrap::counterclockwise : Wrap::clockwise;
  FilmStepper image(make_film_bearing(mirrored));
  const BearingState mirrored_state = state_under(image, {load.x(), -load.y()}, -speed);
  for (const bool stuck : {false, true}) {
    const Complex rate = held_rate(here, state, stuck);
    EXPECT_LT(std::abs(held_rate(there, turned_state, stuck) - rate), 1e-6);
    EXPECT_LT(std::abs(held_rate(image, mirrored_state, stuck) - rate), 1e-6);
  }
}

TEST(FilmHeld, DiesOutWhereTheJournalIsAtRest) {
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}));
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.5 * stepper.bearing().clearance, 0.0}, 0.0, state).status,
            Status::converged);
  const std::optional<HeldMotion> motion = stepper.held_motion(state);
  ASSERT_TRUE(motion.has_value());
  EXPECT_LT(motion->rate.real(), 0.0);
  EXPECT_EQ(motion->rate.imag(), 0.0);
}

/// The free end of the default bearing, where the gas enters.
TEST(FilmHeld, MovesMostWhereTheFoilIsDetached) {
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}));
  const BearingState state = state_under(stepper, {9.81, 0.0}, speed_of_rpm(12000.0));
  const auto motion = stepper.held_motion(state);
  ASSERT_TRUE(motion.has_value());
  EXPECT_GE(motion->column, 100);  // of 104, the last of them at the free end
}

/// Onset speeds of whirl of a rigid rotor with mass m on each of two bearings and load m g along +X, found by a secant
/// over the speed on eigenvalues of rotor, film and foils together, f = 0, gas enters at the weld. There the critical
/// mass is m.
TEST(FilmHeld, CriticalMassesAreThoseAtTheOnsetOfWhirl) {
  struct Onset {
    double mass, rpm, whirl_ratio;
  };
  for (const Onset& onset :
       {Onset{0.5, 12354.679904470366, 0.5222375954247448}, Onset{1.0, 13072.434026772906, 0.49078240201060497},
        Onset{2.0, 16380.620386170356, 0.39393997800952035}}) {
    SCOPED_TRACE(onset.mass);
    Case input = film_reference_case({.columns_per_pitch = 6, .rows = 8});
    input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(-onset.rpm)}, .loads = {{9.81 * onset.mass, 0.0}}});
    const RunningState state = run_equilibrium(input).states.front();
    ASSERT_TRUE(state.critical_mass && state.stuck_critical_mass);
    // Onsets are known to 1e-7 of the growth, and the state to 1e-9.
    EXPECT_NEAR(state.critical_mass->mass, onset.mass, 1e-6 * onset.mass);
    EXPECT_NEAR(state.critical_mass->frequency, onset.whirl_ratio * std::abs(state.last->speed),
                1e-6 * std::abs(state.last->speed));
    EXPECT_NEAR(state.stuck_critical_mass->mass, onset.mass, 1e-6 * onset.mass);  // without friction no contact sticks
  }
}

/// Unstable states, here of foils whose free end is the inlet, have no critical mass.
TEST(FilmHeld, CriticalMassesAreOfStatesThatLast) {
  Case input = film_reference_case({.columns_per_pitch = 6, .rows = 8});
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{10.0, 0.0}}});
  EXPECT_FALSE(run_equilibrium(input).states.front().critical_mass.has_value());
}

}  // namespace
}  // namespace bumpfoil
