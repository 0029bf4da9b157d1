#include "bumpfoil/motion/speed_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

constexpr double g = 9.81;  // m/s^2

/// 1 kg on the reference bearing without friction, gas entering at the weld: forward whirl starts at 13,072.43 rpm,
/// found by an independent program with a secant search on its own pencil. Without friction, stuck and sliding results
/// coincide.
TEST(SpeedMap, HasTheOnsetBetweenItsSpeeds) {
  FilmStepper stepper(film_reference_bearing({6, 8}));
  const SpeedMap map =
      map_speeds(make_point_mass(1.0), {&stepper}, {g, 0.0}, speeds_of_rpm({-12000.0, -12800.0, -13600.0}));
  ASSERT_EQ(map.points.size(), 3U);
  for (const SpeedPoint& point : map.points) {
    ASSERT_EQ(point.status, Status::converged);
    ASSERT_TRUE(point.sliding && point.stuck);
    ASSERT_EQ(point.sliding->whirls.size(), point.stuck->whirls.size());
    EXPECT_EQ(point.states.front().speed, point.speed);
    const Whirl& worst = point.sliding->whirls.front();
    EXPECT_GT(worst.direction, 0.5);
    EXPECT_NEAR(std::abs(worst.rate - point.stuck->whirls.front().rate), 0.0, 1e-9 * std::abs(worst.rate));
    EXPECT_EQ(worst.rate.real() > 0.0, std::abs(point.speed) > speed_of_rpm(13072.4));
    // The same motion at all speeds.
    EXPECT_EQ(point.sliding->numbers.front(), map.points[0].sliding->numbers.front());
    EXPECT_EQ(point.stuck->numbers.front(), point.sliding->numbers.front());
  }
  ASSERT_EQ(map.onsets.size(), 2U);
  EXPECT_FALSE(map.onsets[0].stuck);
  EXPECT_TRUE(map.onsets[1].stuck);
  for (const WhirlOnset& found : map.onsets) {
    EXPECT_TRUE(found.begins);
    EXPECT_NEAR(found.onset.speed, speed_of_rpm(-13072.434026772906), 1e-6 * speed_of_rpm(13072.4));
    EXPECT_NEAR(found.onset.whirl_ratio, 0.49078240201060497, 1e-6);
  }
}

/// With friction, contact modes depend on the path, which differs in the independent program: its onset is 12,474.67
/// rpm with full stick, and 12,393.26 rpm with the sliding contacts of its path. The onset with full stick depends
/// little on the path; the one with sliding contacts lies between the onset without friction and that with full stick.
TEST(SpeedMap, TellsStuckFromSlidingContacts) {
  FilmStepper stepper(film_reference_bearing({6, 8}, 0.1));
  const SpeedMap map = map_speeds(make_point_mass(0.5), {&stepper}, {g, 0.0}, speeds_of_rpm({-12000.0, -13000.0}));
  ASSERT_EQ(map.onsets.size(), 2U);
  const double sliding = std::abs(map.onsets[0].onset.speed);
  EXPECT_GT(sliding, speed_of_rpm(12354.68 + 10.0));
  EXPECT_LT(sliding, speed_of_rpm(12474.67 - 10.0));
  EXPECT_NEAR(map.onsets[1].onset.speed, speed_of_rpm(-12474.669874491836), speed_of_rpm(8.0));
}

/// Two equal bearings share the weight of a rigid rotor equally: the onset is that of half the rotor.
TEST(SpeedMap, OfTwoEqualBearingsHasTheOnsetOfOne) {
  FilmStepper first(film_reference_bearing({4, 4}));
  FilmStepper second(film_reference_bearing({4, 4}));
  const std::vector<double> speeds = speeds_of_rpm({-12500.0, -13500.0});
  // Tilting has its own onset: light ends that are far apart shift it out of range.
  const Rotor rigid =
      make_rigid_rotor({.mass = 2.0, .transverse_inertia = 1e-4, .polar_inertia = 1e-4, .bearings = {-0.1, 0.1}});
  const SpeedMap one = map_speeds(make_point_mass(1.0), {&first}, {g, 0.0}, speeds);
  const SpeedMap two = map_speeds(rigid, {&first, &second}, {g, 0.0}, speeds);
  ASSERT_EQ(one.onsets.size(), 2U);
  ASSERT_EQ(two.onsets.size(), 2U);
  EXPECT_NEAR(two.onsets[0].onset.speed, one.onsets[0].onset.speed, 1e-8 * std::abs(one.onsets[0].onset.speed));
}

/// Onsets before the interruption are not searched for.
TEST(SpeedMap, EndsWhereItIsStopped) {
  FilmStepper stepper(film_reference_bearing({4, 4}));
  int requested = 0;
  const SpeedMap map =
      map_speeds(make_point_mass(1.0), {&stepper}, {g, 0.0}, speeds_of_rpm({-12500.0, -13500.0, -14000.0, -15000.0}),
                 [&] { return ++requested < 3; });
  ASSERT_EQ(map.points.size(), 4U);
  EXPECT_EQ(map.points[1].status, Status::converged);
  EXPECT_EQ(map.points[2].status, Status::interrupted);
  EXPECT_EQ(map.points[3].status, Status::not_reached);
  EXPECT_FALSE(map.points[2].sliding.has_value());
  EXPECT_TRUE(map.onsets.empty());
}

}  // namespace
}  // namespace bumpfoil
