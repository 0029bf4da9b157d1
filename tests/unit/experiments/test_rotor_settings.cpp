#include "bumpfoil/experiments/rotor_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/bearing_cases.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

const RotorSettings rigid{.mass = 2.0,
                          .transverse_inertia = 4e-3,
                          .polar_inertia = 5e-4,
                          .bearings = {-0.06, 0.07},
                          .shaft = {},
                          .disks = {}};

RotorSettings flexible() {
  RotorSettings rotor;
  rotor.bearings = {0.04, 0.2};
  rotor.shaft = {{0.08, 0.038, 0.02, 210e9, 0.3, 7800.0}, {0.16, 0.03, 0.0, 210e9, 0.3, 7800.0}};
  rotor.disks = {{.z = 0.23, .mass = 0.3, .transverse_inertia = 1e-4, .polar_inertia = 2e-4}};
  return rotor;
}

Keys errors_of(RotorSettings rotor, const std::function<void(RotorSettings&)>& change) {
  change(rotor);
  return wrong_keys([&](Case& input) { input.settings.set(rotor); });
}

TEST(RotorOf, IsOfTheKindThatItsKeysSay) {
  RotorSettings mass;
  mass.mass = 2.0;
  const ReducedRotor half = rotor_of(mass, 5000.0);
  EXPECT_EQ(half.rotor.size(), 2);
  EXPECT_EQ(half.rotor.total_mass(), 1.0);
  const ReducedRotor tilting = rotor_of(rigid, 5000.0);
  EXPECT_EQ(tilting.rotor.size(), 4);
  EXPECT_EQ(tilting.rotor.bearings.at(1).z, 0.07);
  EXPECT_EQ(tilting.frequency_error, 0.0);
}

/// The mass of two tubes and a disc, and an accurate reduction.
TEST(RotorOf, MakesAShaftOfItsPieces) {
  const ReducedRotor bending = rotor_of(flexible(), 5000.0);
  const double tubes = 7800.0 * M_PI / 4.0 * (0.08 * (0.038 * 0.038 - 0.02 * 0.02) + 0.16 * 0.03 * 0.03);
  EXPECT_NEAR(bending.rotor.total_mass(), tubes + 0.3, 1e-9);
  EXPECT_LT(bending.rotor.size(), 20);
  EXPECT_LT(bending.frequency_error, 1e-3);
}

TEST(FindErrors, ChecksRotors) {
  const auto same = [](RotorSettings&) {};
  EXPECT_EQ(errors_of(rigid, same), Keys{});
  EXPECT_EQ(errors_of(flexible(), same), Keys{});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.mass = 0.0; }), Keys{"rotor.mass"});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.gravity = {0.0, 0.0}; }), Keys{"rotor.gravity"});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.polar_inertia = 9e-3; }), Keys{"rotor.polar_inertia"});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.bearings = {0.01, 0.01}; }), Keys{"rotor.bearings"});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.bearings = {0.0, 0.01}; }), Keys{"rotor.bearings[2]"});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.bearings.clear(); }), Keys{"rotor.transverse_inertia"});
  EXPECT_EQ(errors_of(rigid, [](RotorSettings& r) { r.disks.emplace_back(); }), Keys{"rotor.disk"});
  EXPECT_EQ(errors_of(flexible(), [](RotorSettings& r) { r.mass = 1.0; }), Keys{"rotor.mass"});
  EXPECT_EQ(errors_of(flexible(), [](RotorSettings& r) { r.bearings[1] = 0.25; }), Keys{"rotor.bearings[2]"});
  EXPECT_EQ(errors_of(flexible(), [](RotorSettings& r) { r.disks[0].z = -0.01; }), Keys{"rotor.disk[1].at"});
  EXPECT_EQ(errors_of(flexible(), [](RotorSettings& r) { r.shaft[1].inner_diameter = 0.04; }),
            Keys{"rotor.shaft[2].inner_diameter"});
  EXPECT_EQ(errors_of(flexible(), [](RotorSettings& r) { r.shaft[0].density = 7.8; }), Keys{});
  EXPECT_EQ(errors_of(flexible(), [](RotorSettings& r) { r.shaft[0].density = 0.0; }), Keys{"rotor.shaft[1].density"});
}

/// Written cases are read back.
TEST(RotorSettings, GoThroughACaseFile) {
  for (const RotorSettings& rotor : {rigid, flexible()}) {
    Case input = reference_case();
    input.settings.set(rotor);
    const Case read = parse_case(case_to_toml(input), "", {});
    ASSERT_NE(read.settings.find<RotorSettings>(), nullptr);
    EXPECT_EQ(read.settings.get<RotorSettings>(), rotor);
  }
}

TEST(MakeMachine, HasABearingForEachPlace) {
  Case input = film_rotor_case({4, 4});
  const Machine equal = make_machine(input, {100.0}, "stability");
  EXPECT_EQ(equal.bearings.size(), 1U);  // one bearing with half the rotor
  input.settings.set(rigid);
  const Machine alike = make_machine(input, {100.0}, "stability");
  ASSERT_EQ(alike.bearings.size(), 2U);
  EXPECT_EQ(alike.bearings[0], alike.bearings[1]);  // a single shared bearing
  input.rotor_bearings.resize(2);
  input.rotor_bearings[1].bearing = input.bearing;
  EXPECT_EQ(make_machine(input, {100.0}, "stability").bearings.size(), 2U);
  input.rotor_bearings[1].bearing->radial_clearance = 20e-6;
  input.rotor_bearings[1].film = input.film;
  input.rotor_bearings[1].film->h_floor = 1e-6;
  const Machine machine = make_machine(input, {100.0}, "stability");
  EXPECT_DOUBLE_EQ(machine.bearings[0]->clearance, 31.8e-6);
  EXPECT_DOUBLE_EQ(machine.bearings[1]->clearance, 20e-6);
  EXPECT_EQ(machine.thickness_floors, (std::vector<double>{0.1e-6, 1e-6}));
  // Film thicknesses are in units of the clearance of their bearing.
  BearingState state;
  state.film.thickness = Matrix::Ones(2, 2);
  EXPECT_DOUBLE_EQ(machine.thinnest_film(1, state), machine.bearings[1]->film->scales.thickness);
  EXPECT_DOUBLE_EQ(machine.thinnest_film({state, state}), machine.bearings[1]->film->scales.thickness);
}

TEST(RotorSettingsOf, WantsATable) {
  EXPECT_THROW(static_cast<void>(reference_case().settings.get<RotorSettings>()), Error);
}

}  // namespace
}  // namespace bumpfoil
