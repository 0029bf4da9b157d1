#include "bumpfoil/results/quantity.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(Quantity, KeysCarryTheirUnits) {
  EXPECT_EQ(key_of("force_x", "N"), "force_x_N");
  EXPECT_EQ(key_of("secant_stiffness", "N/m"), "secant_stiffness_N_per_m");
  EXPECT_EQ(key_of("loss_factor", "1"), "loss_factor");
  EXPECT_EQ(key_of("total_iterations", "1"), "iterations");
  EXPECT_EQ(key_of("increment_status", ""), "status");
  EXPECT_EQ(key_of("speed_status", ""), "status");
  EXPECT_EQ(key_of("orbit_status", ""), "orbit_status");
}

}  // namespace
}  // namespace bumpfoil
