#include "bumpfoil/motion/response.hpp"

#include <gtest/gtest.h>

#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

/// Slow forces meet the stiffness, fast ones the mass.
TEST(LinearResponse, IsThatOfStiffnessAndOfMass) {
  FilmStepper stepper(film_reference_bearing({4, 3}, 0.1));
  const BearingState state = state_under(stepper, {30.0, 0.0}, speed_of_rpm(-45000.0));
  const Rotor rotor = make_point_mass(2.0);
  const Eigen::Vector2cd force(3.0, std::complex<double>(0.0, -1.0));
  for (const bool stuck : {false, true}) {
    const auto slow = linear_response(rotor, {{stepper, state}}, force, 0.0, stuck);
    const auto stiffness = stepper.stiffness(state, stuck);
    ASSERT_TRUE(slow && stiffness);
    EXPECT_LT((*stiffness * *slow - force).norm(), 1e-9);
    const std::complex<double> rate(0.0, 1e7);
    const auto fast = linear_response(rotor, {{stepper, state}}, force, rate, stuck);
    ASSERT_TRUE(fast);
    // A film that cannot give way has some 1e8 N/m, m nu^2 is 2e14 N/m.
    EXPECT_LT((rate * rate * 2.0 * *fast - force).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace bumpfoil
