#include "bumpfoil/experiments/vibration/vibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "support/bearing_cases.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

Case vibration_case(SolverName solver = SolverName::newton) {
  Case input = case_with_given_constants();
  input.solver.name = solver;
  input.settings.set(VibrationSettings{.loads = {{0.0, -50.0}},
                                       .directions = {0.0, 0.5 * pi},
                                       .amplitudes = {1e-6},
                                       .frequencies = {2.0 * pi * 200.0},
                                       .steps = 20});
  return input;
}

/// The only one of a result.
LinearFoils only(const Case& input, const VibrationResult& result) {
  EXPECT_TRUE(result.converged());
  const std::vector<LinearFoils> all = linear_foils(input.settings.get<VibrationSettings>(), result);
  EXPECT_EQ(all.size(), 1U);
  return all.at(0);
}

/// One bump of a truss under a top foil, frictionless at its crest, with friction f at its foot: worked out by hand. A
/// crest pressed outward by v carries the force P(v) = p v, where p depends on what the foot does.
struct OneBump {
  double k1, k2, k4, c, s, f;

  /// Of P(v) while the foot slips outward (sign 1) or back (-1), N/m: e2 is the elongation of the second rod,
  /// k1 e2 (c - sign f s) + k2 u_f = 0, crest: k1 c (e1 - e2) + k4 u_c = 0.
  [[nodiscard]] double slipping(double sign) const {
    const double foot = -k1 * (c - sign * f * s) / k2;  // u_f = foot e2
    // With v = 1: e1 = u_c c - s and e2 = (u_f - u_c) c - s, so e2 (1 - foot c) = -u_c c - s.
    const double a = 1.0 - foot * c;
    // k1 c (u_c c - s + (u_c c + s)/a) + k4 u_c = 0
    const double crest = k1 * c * s * (1.0 - 1.0 / a) / (k1 * c * c * (1.0 + 1.0 / a) + k4);
    const double e1 = crest * c - s;
    const double e2 = -(crest * c + s) / a;
    return -k1 * s * (e1 + e2);
  }
  /// dP/dv while it sticks: u_f stays; k1 c (e1 - e2) + k4 u_c = 0 gives (2 k1 c^2 + k4) u_c = 0.
  [[nodiscard]] double stuck() const { return 2.0 * k1 * s * s; }
};

/// The loop of that bump between two displacements of its crest, closed form: corners of the settled loop.
std::vector<std::pair<double, double>> corners(const OneBump& bump, double top_foil, double low, double high) {
  const double up = bump.slipping(1.0) + top_foil;
  const double down = bump.slipping(-1.0) + top_foil;
  const double stuck = bump.stuck() + top_foil;
  const double turn_down = high * (stuck - up) / (stuck - down);  // where it meets the line of slipping back
  const double turn_up = low * (stuck - down) / (stuck - up);
  return {
      {high, up * high}, {turn_down, down * turn_down}, {low, down * low}, {turn_up, up * turn_up}, {high, up * high}};
}

/// Integral of F(x(tau)) cos(tau) along straight lines between corners, by Simpson's rule.
double in_phase(const std::vector<std::pair<double, double>>& corners, double middle, double amplitude) {
  double sum = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto [x0, f0] = corners[i - 1];
    const auto [x1, f1] = corners[i];
    const double sign = x1 > x0 ? -1.0 : 1.0;
    const double begin = sign * std::acos(std::clamp((x0 - middle) / amplitude, -1.0, 1.0));
    const double end = sign * std::acos(std::clamp((x1 - middle) / amplitude, -1.0, 1.0));
    const int n = 2000;
    for (int k = 0; k <= n; ++k) {
      const double tau = begin + (end - begin) * k / n;
      const double x = middle + amplitude * std::cos(tau);
      const double weight = k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
      sum += weight * (end - begin) / (3.0 * n) * (f0 + (f1 - f0) * (x - x0) / (x1 - x0)) * std::cos(tau);
    }
  }
  return sum / (pi * amplitude);
}

double area(const std::vector<std::pair<double, double>>& corners) {
  double sum = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    sum += 0.5 * (corners[i].second + corners[i - 1].second) * (corners[i].first - corners[i - 1].first);
  }
  return sum;
}

class OneBumpVibration : public testing::Test {
 protected:
  OneBumpVibration() {
    input = vibration_case(SolverName::events);
    input.bump_foil.bumps = 1;
    input.bump_foil.truss = {.k1 = 150e6, .k2 = 5.43e6, .k3 = 1.36e6, .k4 = 11.25e6, .theta_d = 15.83 * pi / 180.0};
    direction = polar_angles(input.bearing, crest_angles(input))[0];
    input.settings.get<VibrationSettings>().directions = {direction};
    set_friction(0.1);
    top_foil = 1.0 / top_foil_compliance();
  }
  void set_friction(double f) {
    input.friction = {.top_bump = 0.0, .bump_sleeve = f};
    const TrussOverrides& truss = input.bump_foil.truss;
    bump = {*truss.k1, *truss.k2, *truss.k4, std::cos(*truss.theta_d), std::sin(*truss.theta_d), f};
  }
  /// The load that the crest carries when pushed outward by v for the first time.
  void press(double v) {
    const double load = (bump.slipping(1.0) + top_foil) * v;
    input.settings.get<VibrationSettings>().loads = {load * unit_vector(direction)};
    middle = v;
  }
  /// A cantilever: [Arghir2019, Eq. 5] with i = j = 1.
  [[nodiscard]] double top_foil_compliance() const {
    const TopFoil& foil = input.top_foil;
    const double e = foil.thickness;
    const double bending = foil.youngs_modulus / (1.0 - foil.poisson_ratio * foil.poisson_ratio) *
                           input.bearing.axial_length * e * e * e / 12.0;
    const double theta = crest_angles(input)[0];
    return std::pow(input.bearing.radius, 3) / bending * (0.5 * theta - 0.5 * std::cos(theta) * std::sin(theta));
  }
  /// Along the direction.
  [[nodiscard]] double direct(const Eigen::Vector2d& part) const { return unit_vector(direction).dot(part); }

  Case input;
  OneBump bump{};
  double direction{};
  double top_foil{};
  double middle{};
};

TEST_F(OneBumpVibration, HasTheLoopOfTheClosedForm) {
  press(10e-6);
  for (const double amplitude : {0.5e-6, 2e-6, 8e-6}) {
    input.settings.get<VibrationSettings>().amplitudes = {amplitude};
    const VibrationResult result = run_vibration(input);
    ASSERT_TRUE(result.converged());
    const FirstHarmonic& harmonic = *result.vibrations[0].harmonic;
    const auto loop = corners(bump, top_foil, middle - amplitude, middle + amplitude);
    // The load is met to 1e-9 or so, and moves the middle.
    const double expected = in_phase(loop, middle, amplitude);
    EXPECT_NEAR(direct(harmonic.stiffness), expected, 1e-7 * expected) << amplitude;
    const double loss = area(loop) / (pi * amplitude * amplitude);
    ASSERT_GT(loss, 0.0);
    EXPECT_NEAR(direct(harmonic.loss), loss, 1e-7 * expected) << amplitude;
    EXPECT_NEAR(*result.vibrations[0].cycle.loop_energy, area(loop), 1e-7 * expected * amplitude * amplitude);
    EXPECT_TRUE(result.vibrations[0].cycle.settled);
  }
}

TEST_F(OneBumpVibration, ConvergesWithTheIncrements) {
  input.solver.name = SolverName::newton;
  press(10e-6);
  input.settings.get<VibrationSettings>().amplitudes = {3e-6};
  const double expected = in_phase(corners(bump, top_foil, 7e-6, 13e-6), middle, 3e-6);
  const auto error = [&](int steps) {
    input.settings.get<VibrationSettings>().steps = steps;
    const VibrationResult result = run_vibration(input);
    return std::abs(direct(result.vibrations.at(0).harmonic->stiffness) - expected) / expected;
  };
  // The increments with a corner of the loop in them alone are wrong, by the square of their length at most.
  EXPECT_LT(error(10), 3e-2);
  EXPECT_LT(error(40), 4e-3);
  EXPECT_LT(error(160), 3e-4);
}

TEST_F(OneBumpVibration, GoesFromTheStuckStiffnessToTheSlidingOneAsTheAmplitudeGrows) {
  // The part of the loop that sticks shrinks with the friction over the amplitude.
  set_friction(1e-2);
  press(10e-6);
  input.settings.get<VibrationSettings>().amplitudes = {1e-9, 1e-8, 1e-7, 1e-6, 9e-6};
  const VibrationResult result = run_vibration(input);
  ASSERT_TRUE(result.converged());
  std::vector<double> stiffness;
  for (const Vibration& one : result.vibrations) stiffness.push_back(direct(one.harmonic->stiffness));
  const double stuck = bump.stuck() + top_foil;
  const double sliding = 0.5 * (bump.slipping(1.0) + bump.slipping(-1.0)) + top_foil;
  ASSERT_GT(stuck, 2.0 * sliding);
  EXPECT_NEAR(stiffness.front(), stuck, 1e-6 * stuck);
  EXPECT_TRUE(std::is_sorted(stiffness.rbegin(), stiffness.rend()));
  EXPECT_NEAR(stiffness.back(), sliding, 0.05 * sliding);  // friction over the slope of the rods
  EXPECT_EQ(*result.vibrations.front().cycle.loop_energy, 0.0);
}

TEST(RunVibration, ToNoAmplitudeIsStuck) {
  Case input = vibration_case();
  VibrationSettings& vibration = input.settings.get<VibrationSettings>();
  vibration.loads = {{80.0, 20.0}};
  vibration.amplitudes = {1e-9};
  const VibrationResult result = run_vibration(input);
  const LinearFoils foils = only(input, result);
  const Eigen::Matrix2d stuck = *result.loads[0].tangents.unloading;
  // Contacts that slip at first come to rest in a few dozen loops. The force varies by 0.1 N, out of 80 N which are
  // known to 1e-9.
  EXPECT_LT((foils.stiffness - stuck).norm(), 1e-5 * stuck.norm());
  EXPECT_NEAR(stuck(0, 1), stuck(1, 0), 1e-9 * stuck.norm());
  EXPECT_LT(foils.loss.norm(), 1e-5 * stuck.norm());
  EXPECT_LT(foils.residual, 1e-4);
  // It differs from the tangent stiffness.
  EXPECT_GT((*result.loads[0].tangents.loading - stuck).norm(), 0.05 * stuck.norm());
}

class RunVibrationWith : public testing::TestWithParam<SolverName> {};

TEST_P(RunVibrationWith, Dissipates) {
  Case input = vibration_case(GetParam());
  VibrationSettings& vibration = input.settings.get<VibrationSettings>();
  vibration.loads = {{0.0, -50.0}, {80.0, 20.0}};
  vibration.amplitudes = {0.5e-6, 3e-6};
  vibration.steps = 10;
  const VibrationResult result = run_vibration(input);
  ASSERT_TRUE(result.converged());
  ASSERT_EQ(result.vibrations.size(), 8U);
  for (const Vibration& one : result.vibrations) {
    ASSERT_TRUE(one.harmonic && one.cycle.loop_energy && one.cycle.loss_factor);
    EXPECT_GE(*one.cycle.loop_energy, 0.0);
    const Eigen::Vector2d n = unit_vector(one.cycle.direction);
    const double X = one.cycle.amplitude;
    // Two ways to compute the same integral.
    EXPECT_NEAR(pi * X * X * n.dot(one.harmonic->loss), *one.cycle.loop_energy, 1e-6 * *one.cycle.loop_energy + 1e-15);
    EXPECT_NEAR(*one.cycle.loss_factor, *one.cycle.loop_energy / (pi * *one.cycle.loaded_stiffness * X * X), 1e-12);
    EXPECT_GT(n.dot(one.harmonic->stiffness), 0.0);
  }
  // Larger loops lose more.
  EXPECT_GT(*result.vibrations[1].cycle.loop_energy, *result.vibrations[0].cycle.loop_energy);
}

TEST_P(RunVibrationWith, HasAMirrorImage) {
  Case input = vibration_case(GetParam());
  input.settings.get<VibrationSettings>().loads = {{30.0, -50.0}};
  const LinearFoils foils = only(input, run_vibration(input));
  Case image = input;
  image.bearing.weld_angle = -input.bearing.weld_angle;
  image.bearing.wrap = Wrap::counterclockwise;
  VibrationSettings& vibration = image.settings.get<VibrationSettings>();
  vibration.loads = {{30.0, 50.0}};
  vibration.directions = {0.0, -0.5 * pi};
  const LinearFoils mirrored = only(image, run_vibration(image));
  const Eigen::DiagonalMatrix<double, 2> mirror(1.0, -1.0);
  const double size = foils.stiffness.norm();
  const double same = 1e-6 * size;  // the load is met to 1e-9 or so
  EXPECT_LT((mirrored.stiffness - mirror * foils.stiffness * mirror).norm(), same);
  EXPECT_LT((mirrored.loss - mirror * foils.loss * mirror).norm(), same);
  EXPECT_GT(std::abs(foils.stiffness(0, 1)), 1e-3 * size);  // there is something to mirror
}

INSTANTIATE_TEST_SUITE_P(Solvers, RunVibrationWith, testing::Values(SolverName::newton, SolverName::events));

TEST(RunVibration, HoldsTheCrossDisplacementAndGoesRound) {
  Case input = vibration_case();
  const VibrationResult result = run_vibration(input);
  ASSERT_TRUE(result.converged());
  const Eigen::Vector2d position = result.loads[0].position;
  for (const Vibration& one : result.vibrations) {
    const std::vector<LoopPoint>& curve = one.cycle.curve;
    ASSERT_EQ(curve.size(), 81U);
    const double middle = position.dot(unit_vector(one.cycle.direction));
    EXPECT_NEAR(curve[0].displacement, middle, 1e-18);
    EXPECT_NEAR(curve[20].displacement, middle + 1e-6, 1e-18);
    EXPECT_NEAR(curve[60].displacement, middle - 1e-6, 1e-18);
    EXPECT_NEAR(curve[80].displacement, middle, 1e-18);
    // It goes up and down by some newtons, and closes but for what has not settled yet.
    EXPECT_LT((curve[80].force - curve[0].force).norm(), 1e-2);
  }
  // The first loop begins under the load.
  EXPECT_NE(position, Eigen::Vector2d(0.0, 0.0));
}

TEST(RunVibration, AboutOneLoadKnowsNothingOfTheOthers) {
  Case input = vibration_case();
  VibrationSettings& vibration = input.settings.get<VibrationSettings>();
  vibration.loads = {{0.0, -50.0}, {60.0, 0.0}};
  vibration.amplitudes = {1e-6, 2e-6};
  const VibrationResult all = run_vibration(input);
  vibration.loads = {{60.0, 0.0}};
  vibration.directions = {0.5 * pi};
  vibration.amplitudes = {2e-6};
  const VibrationResult alone = run_vibration(input);
  ASSERT_TRUE(all.converged() && alone.converged());
  EXPECT_EQ(all.vibrations[7].harmonic->stiffness, alone.vibrations[0].harmonic->stiffness);
  EXPECT_EQ(all.vibrations[7].harmonic->loss, alone.vibrations[0].harmonic->loss);
}

TEST(LinearFoilsOf, OneDirectionAreItsColumn) {
  Case input = vibration_case();
  const LinearFoils both = only(input, run_vibration(input));
  input.settings.get<VibrationSettings>().directions = {1.5 * pi};  // -Y: the same loop, begun on its other side
  const VibrationResult down = run_vibration(input);
  const LinearFoils column = only(input, down);
  EXPECT_TRUE(std::isnan(column.stiffness(0, 0)) && std::isnan(column.loss(1, 0)));
  EXPECT_LT((column.stiffness.col(1) - both.stiffness.col(1)).norm(), 1e-3 * both.stiffness.norm());
  EXPECT_LT((column.loss.col(1) - both.loss.col(1)).norm(), 1e-3 * both.stiffness.norm());
  EXPECT_TRUE(std::isnan(column.loss_factor.x()));
  EXPECT_EQ(column.loss_factor.y(), *down.vibrations[0].cycle.loss_factor);
  EXPECT_EQ(column.damping(100.0)(1, 1), column.loss(1, 1) / 100.0);
  input.settings.get<VibrationSettings>().directions = {1.0};
  const LinearFoils skew = only(input, run_vibration(input));
  EXPECT_TRUE(skew.stiffness.array().isNaN().all() && skew.loss_factor.array().isNaN().all());
}

TEST(LinearFoilsOf, TwoDirectionsAreTheMatrix) {
  Case input = vibration_case();
  VibrationSettings& vibration = input.settings.get<VibrationSettings>();
  vibration.loads = {{80.0, 20.0}};
  vibration.amplitudes = {1e-9};  // stick: one matrix for all directions
  const LinearFoils axes = only(input, run_vibration(input));
  vibration.directions = {0.5, 0.5 - 0.5 * pi};
  const LinearFoils skew = only(input, run_vibration(input));
  // A hundred loops leave a little that still slips.
  EXPECT_LT((axes.stiffness - skew.stiffness).norm(), 1e-4 * axes.stiffness.norm());
  EXPECT_TRUE(skew.loss_factor.array().isNaN().all());
}

Case orbiting_case(double friction, double radius, int steps = 20) {
  Case input = vibration_case();
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  VibrationSettings& vibration = input.settings.get<VibrationSettings>();
  vibration.motion = Motion::orbit;
  vibration.directions.clear();
  vibration.amplitudes = {radius};
  vibration.steps = steps;
  return input;
}

TEST(RunVibration, RoundASmallCircleWithoutFrictionIsElastic) {
  const Case input = orbiting_case(0.0, 2e-9);
  const VibrationResult result = run_vibration(input);
  const LinearFoils foils = only(input, result);
  const Eigen::Matrix2d& K = *result.loads[0].tangents.loading;
  EXPECT_LT((foils.stiffness - K).norm(), 1e-6 * K.norm());  // roundings of 50 N over 2e-9 m
  EXPECT_LT(foils.loss.norm(), 1e-6 * K.norm());
  EXPECT_TRUE(std::isnan(foils.loss_factor.x()));
  EXPECT_EQ(result.vibrations[0].sense, Sense::counterclockwise);
  EXPECT_EQ(result.vibrations[1].sense, Sense::clockwise);
  for (const double radius : {2e-9, 5e-6}) {
    for (const Vibration& orbit : run_vibration(orbiting_case(0.0, radius)).vibrations) {
      EXPECT_EQ(orbit.cycle.loop_energy, 0.0) << radius;
    }
  }
}

TEST(RunVibration, RoundACircleTakesTheEnergyOfTheLoss) {
  const Case input = orbiting_case(0.2, 1e-6, 50);
  const VibrationResult result = run_vibration(input);
  const LinearFoils foils = only(input, result);
  // The energy of either sense is pi X^2 (omega c_xx + omega c_yy +- (k_yx - k_xy)).
  const double energy = 0.5 * (*result.vibrations[0].cycle.loop_energy + *result.vibrations[1].cycle.loop_energy);
  EXPECT_GT(energy, 0.0);
  EXPECT_NEAR(pi * 1e-12 * foils.loss.trace(), energy, 2e-3 * energy);  // of the chords of 200 increments
  const double difference = *result.vibrations[0].cycle.loop_energy - *result.vibrations[1].cycle.loop_energy;
  EXPECT_NEAR(2.0 * pi * 1e-12 * (foils.stiffness(1, 0) - foils.stiffness(0, 1)), difference, 2e-3 * energy);
  for (const Vibration& orbit : result.vibrations) {
    EXPECT_EQ(orbit.cycle.curve.size(), 200U);
    EXPECT_GT(orbit.harmonic->residual, 0.0);
  }
}

TEST(RunVibration, RoundACircleIsStoppedBetweenTwo) {
  const Case input = orbiting_case(0.2, 1e-6);
  int count = 0;
  const VibrationResult result = run_vibration(input, [&](double) { return ++count < 3; });
  EXPECT_EQ(result.vibrations[0].cycle.status, Status::interrupted);
  EXPECT_FALSE(result.vibrations[0].harmonic);
  EXPECT_EQ(result.vibrations[1].cycle.status, Status::interrupted);
  EXPECT_TRUE(std::isnan(linear_foils(input.settings.get<VibrationSettings>(), result)[0].stiffness(0, 0)));
}

TEST(RunVibration, GoesOnBesideALoadThatIsOutOfReach) {
  Case input = vibration_case();
  input.settings.get<VibrationSettings>().loads = {{0.0, -1e8}, {0.0, -50.0}};
  const VibrationResult result = run_vibration(input);
  EXPECT_FALSE(result.converged());
  ASSERT_EQ(result.vibrations.size(), 4U);
  EXPECT_NE(result.loads[0].status, Status::converged);
  EXPECT_EQ(result.loads[1].status, Status::converged);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(result.vibrations[i].cycle.status, result.loads[0].status);
    EXPECT_FALSE(result.vibrations[i].harmonic);
    EXPECT_TRUE(result.vibrations[i + 2].cycle.converged());
  }
  const std::vector<LinearFoils> all = linear_foils(input.settings.get<VibrationSettings>(), result);
  EXPECT_TRUE(all[0].stiffness.array().isNaN().all() && std::isnan(all[0].residual));
  EXPECT_TRUE(all[1].stiffness.allFinite());
}

TEST(RunVibration, EndsWhereItIsStopped) {
  Case input = vibration_case();
  double last = 0.0;
  const VibrationResult result = run_vibration(input, [&](double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
    return fraction <= 0.5;
  });
  EXPECT_FALSE(result.converged());
  ASSERT_EQ(result.vibrations.size(), 2U);
  EXPECT_TRUE(result.vibrations[0].cycle.converged());
  EXPECT_EQ(result.vibrations[1].cycle.status, Status::interrupted);
}

TEST(RunVibration, NeedsItsTable) {
  Case input = vibration_case();
  input.settings.remove<VibrationSettings>();
  EXPECT_THROW(run_vibration(input), Error);
}

}  // namespace
}  // namespace bumpfoil
