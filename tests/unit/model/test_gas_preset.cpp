#include "bumpfoil/model/gas_preset.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

/// Viscosities at low pressure from tables of steam and gases (reference equations of NIST and IAPWS), uPa s.
TEST(GasPreset, ViscositiesAreThoseOfTables) {
  struct Entry {
    GasPreset gas;
    double temperature, micropascal_seconds;
  };
  for (const Entry& entry : {Entry{GasPreset::air, 300.0, 18.5}, Entry{GasPreset::air, 600.0, 30.6},
                             Entry{GasPreset::helium, 300.0, 19.9}, Entry{GasPreset::helium, 600.0, 32.2},
                             Entry{GasPreset::nitrogen, 300.0, 17.9}, Entry{GasPreset::nitrogen, 600.0, 29.6},
                             Entry{GasPreset::steam, 400.0, 13.3}, Entry{GasPreset::steam, 600.0, 21.4}}) {
    SCOPED_TRACE(testing::Message() << static_cast<int>(entry.gas) << ' ' << entry.temperature);
    // The laws have a stated accuracy of 2 to 5 %; here they are within 3 %.
    EXPECT_NEAR(1e6 * viscosity(entry.gas, entry.temperature), entry.micropascal_seconds,
                0.03 * entry.micropascal_seconds);
  }
}

TEST(GasPreset, LawsPassThroughTheirOwnPoint) {
  EXPECT_DOUBLE_EQ(viscosity(GasPreset::air, 273.0), 1.716e-5);
  EXPECT_DOUBLE_EQ(viscosity(GasPreset::helium, 273.0), 1.870e-5);
  EXPECT_DOUBLE_EQ(viscosity(GasPreset::nitrogen, 273.0), 1.663e-5);
  EXPECT_DOUBLE_EQ(viscosity(GasPreset::steam, 350.0), 1.12e-5);
}

TEST(GasPreset, SteamHasNoViscosityAsWater) {
  EXPECT_GT(temperature_range(GasPreset::steam).least, 350.0);
  EXPECT_LT(temperature_range(GasPreset::helium).least, temperature_range(GasPreset::air).least);
}

}  // namespace
}  // namespace bumpfoil
