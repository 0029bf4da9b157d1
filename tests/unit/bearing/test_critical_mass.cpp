#include "bumpfoil/bearing/critical_mass.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

/// Isotropic springs k and dampers c, cross-coupled by q: m = k / nu^2 at nu = q / c, for the forward whirl only.
TEST(CriticalMasses, AreThoseOfACrossCoupledRotor) {
  constexpr double k = 3e6;
  constexpr double q = 1e6;
  constexpr double c = 500.0;
  const auto impedance = [](double nu) {
    const std::complex<double> own(k, c * nu);
    Eigen::Matrix2cd Z;
    Z << own, q, -q, own;
    return Z;
  };
  const auto found = critical_masses(impedance, 100.0, 5000.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found.front().frequency, q / c, 1e-7);
  EXPECT_NEAR(found.front().mass, k / (2000.0 * 2000.0), 1e-10);
  EXPECT_TRUE(critical_masses(impedance, 100.0, 1900.0).empty());
  EXPECT_TRUE(critical_masses([&](double nu) { return Eigen::Matrix2cd(-impedance(nu)); }, 100.0, 5000.0).empty());
}

/// Anisotropic springs with damping that changes sign at two frequencies: two masses, the smaller one first.
TEST(CriticalMasses, AreSortedByMass) {
  const auto impedance = [](double nu) {
    Eigen::Matrix2cd Z = Eigen::Matrix2cd::Zero();
    Z(0, 0) = {2e6, nu - 300.0};
    Z(1, 1) = {1e6, nu - 800.0};
    return Z;
  };
  const auto found = critical_masses(impedance, 50.0, 1000.0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].mass, 1e6 / (800.0 * 800.0), 1e-9);
  EXPECT_NEAR(found[1].mass, 2e6 / (300.0 * 300.0), 1e-9);
  EXPECT_NEAR(found[1].frequency, 300.0, 1e-7);
}

}  // namespace
}  // namespace bumpfoil
