#include "bumpfoil/model/gas_and_asperities.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(GasSettings, AreThoseOfAirInARoomWhereNothingIsSaid) {
  const GasSettings gas;
  // Air at 20 degrees Celsius: 18.2 uPa s.
  EXPECT_NEAR(viscosity(gas.preset, gas.temperature), 18.2e-6, 0.2e-6);
  EXPECT_FALSE(gas.viscosity);
  EXPECT_EQ(gas.ambient_pressure, 101325.0);  // standard atmosphere
  EXPECT_EQ(gas.mean_free_path, 0.0);
}

TEST(AsperitySettings, DifferWhereOneOfThemDoes) {
  const AsperitySettings by_peaks{.sigma = 0.3e-6, .density = 1.7e10, .radius = 10e-6, .friction = 0.2};
  AsperitySettings other = by_peaks;
  EXPECT_EQ(other, by_peaks);
  other.modulus = 100e9;
  EXPECT_NE(other, by_peaks);
}

}  // namespace
}  // namespace bumpfoil
