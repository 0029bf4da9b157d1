#include "bumpfoil/motion/rotor_equilibria.hpp"

#include <gtest/gtest.h>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Each bearing carries its share of the weight, at every speed.
TEST(RotorEquilibria, CarryTheWeight) {
  FilmStepper first(film_reference_bearing({4, 4}));
  FilmStepper second(film_reference_bearing({4, 4}));
  const Rotor rotor =
      make_rigid_rotor({.mass = 3.0, .transverse_inertia = 5e-3, .polar_inertia = 1e-3, .bearings = {-0.05, 0.1}});
  const RotorEquilibria equilibria(rotor, {&first, &second}, {9.81, 0.0});
  EXPECT_NEAR(equilibria.loads()[0].x(), 3.0 * 9.81 * 2.0 / 3.0, 1e-12);  // lever rule
  std::vector<BearingState> states;
  for (const double rpm : {-20000.0, -22000.0}) {
    ASSERT_EQ(equilibria.go_to(speed_of_rpm(rpm), states), Status::converged);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(states[i].speed, speed_of_rpm(rpm));
      const Eigen::Vector2d force = journal_force(first.film(), states[i].film, states[i].speed);
      EXPECT_LT((force - equilibria.loads()[i]).norm(), 1e-6);
    }
  }
  EXPECT_EQ(equilibria.carrying(states).size(), 2U);
}

}  // namespace
}  // namespace bumpfoil
