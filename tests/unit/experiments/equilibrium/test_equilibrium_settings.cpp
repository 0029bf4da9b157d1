#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"

#include <gtest/gtest.h>

#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::nan;
using test_support::wrong_keys;

TEST(EquilibriumSettings, AreChecked) {
  const auto equilibrium = [](const auto& change) {
    return wrong_keys([&](Case& input) {
      change(input.settings.set(EquilibriumSettings{.speeds = {1000.0}, .loads = {{50.0, 0.0}}}));
    });
  };
  using Settings = EquilibriumSettings;
  EXPECT_EQ(equilibrium([](Settings&) {}), Keys{});
  EXPECT_EQ(equilibrium([](Settings& e) { e.speeds.clear(); }), Keys{"equilibrium.speeds"});
  EXPECT_EQ(equilibrium([](Settings& e) {
              e.speeds = {1000.0, nan, 0.0, -2e6};
            }),
            (Keys{"equilibrium.speeds[2]", "equilibrium.speeds[3]", "equilibrium.speeds[4]"}));
  EXPECT_EQ(equilibrium([](Settings& e) { e.loads[0] = {0.0, 0.0}; }), Keys{"equilibrium.loads[1]"});
  EXPECT_EQ(equilibrium([](Settings& e) { e.loads[0].y() = nan; }), Keys{"equilibrium.loads[1][2]"});
  EXPECT_EQ(equilibrium([](Settings& e) { e.positions = {{1e-6, 0.0}}; }), Keys{"equilibrium.positions"});
  EXPECT_EQ(equilibrium([](Settings& e) {
              e.loads.clear();
              e.positions = {{1e-6, 0.0}};
            }),
            Keys{"equilibrium.path"});  // a ramp of loads
  EXPECT_EQ(equilibrium([](Settings& e) { e.steps = 0; }), Keys{"equilibrium.steps"});
  EXPECT_EQ(equilibrium([](Settings& e) { e.ross_version = 1; }), Keys{"equilibrium.ross_version"});
  EXPECT_EQ(equilibrium([](Settings& e) { e.frequencies = {-1.0}; }), Keys{"equilibrium.frequencies[1]"});
}

}  // namespace
}  // namespace bumpfoil
