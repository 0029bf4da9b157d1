#include "bumpfoil/film/gas.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bumpfoil {
namespace {

/// Air in a bearing with 19.05 mm radius and 31.8 um clearance at 45,000 rpm, the film moving against theta.
const FilmScales gas_scales{
    {.viscosity = 1.85e-5, .ambient_pressure = 101325.0, .mean_free_path = 64e-9}, 19.05e-3, 31.8e-6};
constexpr double speed = -45000.0 * std::numbers::pi / 30.0 * 19.05e-3;

TEST(FilmScales, AreThoseOfTheReferenceBearing) {
  EXPECT_NEAR(gas_scales.bearing_number(speed), -1.852606648, 1e-9);
  EXPECT_NEAR(gas_scales.squeeze_time(), 0.786e-3, 0.5e-6);  // printed to three digits
  EXPECT_NEAR(gas_scales.knudsen(), 64.0 / 31800.0, 1e-15);
}

TEST(FilmScales, AgreeWithEachOther) {
  // Lam = 6 mu U R / (pa c^2) is three times the ratio of the torque scales of Couette and Poiseuille flow.
  EXPECT_NEAR(3.0 * gas_scales.couette_torque(speed) / gas_scales.poiseuille_torque(), gas_scales.bearing_number(speed),
              1e-12);
  // The surface carries U c / 2 per width: Lam in units of flow().
  EXPECT_NEAR(gas_scales.flow() * gas_scales.bearing_number(speed),
              0.5 * speed * gas_scales.thickness * gas_scales.radius, 1e-18);
  // The flow() fills the volume c R^2 in T0.
  EXPECT_NEAR(gas_scales.flow() * gas_scales.squeeze_time(),
              gas_scales.thickness * gas_scales.radius * gas_scales.radius, 1e-20);
  EXPECT_NEAR(gas_scales.force(), 36.7711, 1e-4);
}

}  // namespace
}  // namespace bumpfoil
