// docs/verification/film.md: top foils formed flatter than the bearing, their own overhang, gas feed at the free end,
// and varying pitches, under the film: against an independent prototype, closed forms and symmetry.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case formed_case(double ratio, double load, const FilmResolution& resolution = {.columns_per_pitch = 6, .rows = 8}) {
  Case input = film_reference_case(resolution);
  if (ratio != 1.0) input.top_foil.formed_radius = {FormedTo::radius, ratio * input.bearing.radius};
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{load, 0.0}}});
  return input;
}

RunningState state_of(const Case& input) {
  const EquilibriumResult result = run_equilibrium(input);
  EXPECT_TRUE(result.states.front().found());
  return result.states.front();
}

/// Ranges of loaded bumps or closed feet, as "7-21,26".
std::string numbers_text(const Vector& loads) {
  std::string text;
  for (Eigen::Index i = 0; i < loads.size(); ++i) {
    if (loads[i] <= 0.0) continue;
    const bool before = i > 0 && loads[i - 1] > 0.0;
    const bool after = i + 1 < loads.size() && loads[i + 1] > 0.0;
    if (!before) text += (text.empty() ? "" : ",") + std::to_string(i + 1);
    if (before && !after) text += "-" + std::to_string(i + 1);
  }
  return text;
}

struct FormedReference {
  double ratio, load;          ///< R_f / R; N along +X
  double growth, frequency;    ///< with the journal held, over the speed of rotation
  double h_min, torque;        ///< um, N m
  double attitude;             ///< degrees
  std::string loaded, closed;  ///< bumps, feet
};

/// At 45,000 rpm, f = 0, gas enters at the free end. The prototype reaches some of these states on other paths.
TEST(FilmFormed, RunsAsInThePrototype) {
  for (const FormedReference& reference :
       {FormedReference{1.0, 10.0, 0.1732509, 0.4813818, 24.94415, 0.004975438, 35.71315, "8-19", "7-19"},
        FormedReference{1.01, 10.0, -0.8268492, 0.7179253, 26.16649, 0.004705491, 49.4735, "7-21,26", "6-21,25-26"},
        FormedReference{1.01, 100.0, -1.248448, 0.0, 7.462639, 0.007991052, 17.07384, "8-26", "7-26"},
        FormedReference{1.02, 10.0, -0.8494348, 0.0, 25.99927, 0.004733979, 47.85276, "7-21,26", "6-20,25-26"},
        FormedReference{1.1, 10.0, -0.7689987, 0.0, 22.7128, 0.005404532, 28.32404, "9-18,26", "8-18,25-26"},
        FormedReference{1.1, 50.0, -0.7514486, 0.8928622, 13.36511, 0.006501693, 22.50515, "8-21,26", "7-21,25-26"},
        FormedReference{1.1, 100.0, -0.8978707, 0.4230911, 7.300223, 0.008268559, 14.6773, "8-22,26", "7-21,25-26"}}) {
    SCOPED_TRACE(reference.ratio);
    SCOPED_TRACE(reference.load);
    const Case input = formed_case(reference.ratio, reference.load);
    const BearingModel bearing = make_film_bearing(input);
    const RunningState state = state_of(input);
    const double speed = state.last->speed;
    ASSERT_TRUE(state.held.sliding.has_value());
    // The prototype prints seven digits; near a double root half of them are exact.
    EXPECT_NEAR(state.held.sliding->rate.real() / speed, reference.growth, 2e-6);
    EXPECT_NEAR(std::abs(state.held.sliding->rate.imag()) / speed, reference.frequency, 2e-6);
    EXPECT_NEAR(1e6 * state.outcome->thinnest.thickness * bearing.film->scales.thickness, reference.h_min, 1e-5);
    EXPECT_NEAR(state.outcome->torque, reference.torque, 1e-6 * reference.torque);
    EXPECT_NEAR(to_degrees(state.outcome->attitude_angle), reference.attitude, 1e-4);
    const Vector& forces = state.last->contacts.normal_force;
    EXPECT_EQ(numbers_text(bump_loads(bearing, *state.last)), reference.loaded);
    EXPECT_EQ(numbers_text(forces(Eigen::seqN(1, 26, Eigen::Index{bearing.contacts_per_block()}))), reference.closed);
  }
}

TEST(FilmFormed, RunsOnAFinerMeshAsInThePrototype) {
  const RunningState state = state_of(formed_case(1.02, 10.0, {.columns_per_pitch = 12, .rows = 16}));
  EXPECT_NEAR(state.held.sliding->rate.real() / state.last->speed, -0.8433085, 2e-6);
}

/// Growth with the journal held for three ways to seat the free end; the prototype gives three digits.
TEST(FilmFormed, IsSeatedByPressureFeedAndAShorterOverhang) {
  const auto growth = [](const Case& input) {
    const RunningState state = state_of(input);
    return state.held.sliding->rate.real() / state.last->speed;
  };
  Case fed = formed_case(1.0, 10.0);
  fed.film.inlet_pressure = 1.005 * fed.gas.ambient_pressure;
  EXPECT_NEAR(growth(fed), -0.945, 2e-3);
  fed.settings.get<EquilibriumSettings>().loads = {{100.0, 0.0}};
  EXPECT_NEAR(growth(fed), -1.249, 1e-3);
  Case shorter = formed_case(1.02, 50.0, {.columns_per_pitch = 8, .rows = 8});
  shorter.top_foil.overhang = 0.25 * shorter.bump_foil.pitch.values.front();
  EXPECT_NEAR(growth(shorter), -1.106, 1e-3);
  Case pressed = formed_case(1.0, 50.0);
  pressed.top_foil.seat_pressure = 300.0;
  EXPECT_LT(growth(pressed), -1.0);
}

/// A pad of 8 bumps, welded at its trailing end, with its middle at +X; the journal is held at (e, 0) C_r.
TEST(FilmFormed, PadsFlutterAwayFromTheJournalUnlessTheyAreFormed) {
  struct PadReference {
    double ratio, e, growth, hold_down;
  };
  for (const PadReference& reference :
       {PadReference{1.0, -0.6, 0.1383104, 0.0}, PadReference{1.02, -0.3, -0.8556614, 0.343531},
        PadReference{1.05, -0.1, -0.962467, 0.8519387}, PadReference{1.1, 0.0, -1.072445, 1.530568}}) {
    SCOPED_TRACE(reference.ratio);
    Case input = formed_case(reference.ratio, 1.0);
    const double arc = 8.0 * 4.572e-3 / 19.05e-3;
    input.bump_foil.bumps = 8;
    input.bearing.weld_angle = 0.5 * arc;
    EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
    equilibrium.loads.clear();
    equilibrium.positions = {{reference.e * input.bearing.radial_clearance, 0.0}};
    equilibrium.path = FilmPath::cold_start;
    const RunningState state = state_of(input);
    EXPECT_NEAR(state.held.sliding->rate.real() / state.last->speed, reference.growth, 1e-5);
    EXPECT_NEAR(bump_loads(make_film_bearing(input), *state.last)[7], reference.hold_down, 2e-6);
  }
}

/// Largest inward displacement of the assembled foil at its columns, m.
double assembled_bulge(const FilmResolution& resolution) {
  const Case input = formed_case(1.01, 10.0, resolution);
  FilmStepper stepper(make_film_bearing(input));
  const BearingState state = assembled(stepper, Eigen::Vector2d::Zero(), speed_of_rpm(45000.0));
  EXPECT_NEAR(bump_loads(stepper.bearing(), state)[25], 0.02549644, 1e-7);  // prototype, on any mesh
  return -stepper.film().scales.thickness * state.film.deflection.minCoeff();
}

/// Rigid bumps: 0.1047423 R^2 kappa_0. The bumps here are compliant, and the maximum may lie half an interval from a
/// column.
TEST(FilmFormed, AssemblesAsABeamReleasedOntoItsSupports) {
  const double kappa = (1.0 - 1.0 / 1.01) / 19.05e-3;
  const double closed_form = 0.1047423 * 19.05e-3 * 19.05e-3 * kappa;
  EXPECT_NEAR(assembled_bulge({.columns_per_pitch = 6, .rows = 8}), closed_form, 0.005 * closed_form);
  EXPECT_NEAR(assembled_bulge({.columns_per_pitch = 6, .rows = 8}), 19.66985e-6, 1e-11);  // prototype
}

/// Foils with varying pitches, on three meshes: differences of the force fall by a factor of four.
TEST(FilmFormed, VariablePitchesConvergeWithSecondOrder) {
  std::vector<double> force;
  for (const int columns : {6, 12, 24}) {
    Case input = formed_case(1.01, 1.0, {.columns_per_pitch = columns, .rows = columns + columns / 2});
    input.bump_foil.pitch = PerBump(4.2e-3, 4.944e-3, Grading::linear);
    input.top_foil.overhang = 1.5e-3;
    EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
    equilibrium.loads.clear();
    equilibrium.positions = {{15e-6, 8e-6}};
    equilibrium.path = FilmPath::cold_start;
    force.push_back(state_of(input).outcome->force.x());
  }
  const double ratio = (force[0] - force[1]) / (force[1] - force[2]);
  EXPECT_GT(ratio, 3.5);
  EXPECT_LT(ratio, 4.5);
}

/// The same bearing turned by an angle, and mirrored: same film, force turned and mirrored.
TEST(FilmFormed, TurnsAndMirrorsWithTheBearing) {
  Case input = formed_case(1.02, 40.0);
  input.bump_foil.pitch = PerBump(4.3e-3, 4.8e-3, Grading::linear);
  input.top_foil.overhang = 1.5e-3;
  input.top_foil.seat_pressure = 50.0;
  input.film.inlet_pressure = 1.002 * input.gas.ambient_pressure;
  const RunningState as_given = state_of(input);
  constexpr double angle = 0.7;
  Case turned = input;
  turned.bearing.weld_angle += angle;
  turned.settings.get<EquilibriumSettings>().loads = {40.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle))};
  Case mirrored = input;  // about the X axis
  mirrored.bearing.weld_angle = -input.bearing.weld_angle;
  mirrored.bearing.wrap = Wrap::counterclockwise;
  mirrored.settings.get<EquilibriumSettings>().speeds = {-input.settings.get<EquilibriumSettings>().speeds.front()};
  for (const auto& [other, sense] : {std::pair{turned, 1.0}, std::pair{mirrored, -1.0}}) {
    const RunningState state = state_of(other);
    EXPECT_LT((state.last->film.pressure - as_given.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(sense * state.outcome->torque, as_given.outcome->torque, 1e-9 * as_given.outcome->torque);
    EXPECT_NEAR(state.held.sliding->rate.real(), as_given.held.sliding->rate.real(),
                1e-6 * std::abs(as_given.held.sliding->rate.real()));
  }
}

}  // namespace
}  // namespace bumpfoil
