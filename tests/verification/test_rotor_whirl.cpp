// docs/verification/rotor.md: free whirl of rotor, film and foils together, against an independent prototype, the
// critical mass, and symmetry. States of the reference bearing with the gas entering at the weld, load along +X.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/critical_mass.hpp"
#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "bumpfoil/motion/whirl.hpp"
#include "bumpfoil/rotor/unbalance.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

constexpr double gravity = 9.81;  // m/s^2

std::optional<std::vector<Whirl>> motions_of(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                             const WhirlWindow& window, bool stuck = false) {
  auto found = find_whirls(rotor, bearings, window, stuck);
  return found ? std::optional(std::move(found->whirls)) : std::nullopt;
}

/// Rate of the least stable motion of a rotor, over the speed of rotation.
Complex worst_rate(const Rotor& rotor, FilmStepper& stepper, const BearingState& state, bool stuck = false) {
  const auto whirls = motions_of(rotor, {{stepper, state}}, usual_window(state.speed), stuck);
  EXPECT_TRUE(whirls.has_value());
  if (!whirls) return {};
  EXPECT_FALSE(whirls->empty());
  if (whirls->empty()) return {};
  EXPECT_FALSE(whirls->front().is_of_foils());
  return whirls->front().rate / std::abs(state.speed);
}

/// Onsets of whirl under the weight of a point mass, f = 0.
struct OnsetReference {
  FilmResolution mesh;
  double mass, rpm, whirl_ratio;
};

TEST(RotorWhirl, BeginsAsInThePrototype) {
  for (const OnsetReference& reference : {OnsetReference{{6, 8}, 0.5, 12354.679904470366, 0.5222375954247448},
                                          OnsetReference{{6, 8}, 1.0, 13072.434026772906, 0.49078240201060497},
                                          OnsetReference{{6, 8}, 2.0, 16380.620386170356, 0.39393997800952035},
                                          OnsetReference{{12, 16}, 1.0, 13054.831034489856, 0.4913990040313403}}) {
    SCOPED_TRACE(reference.mass);
    FilmStepper stepper(film_reference_bearing(reference.mesh));
    const Rotor rotor = make_point_mass(reference.mass);
    const Eigen::Vector2d load(gravity * reference.mass, 0.0);
    const double guess = speed_of_rpm(-reference.rpm);
    BearingState state = state_under(stepper, load, 0.99 * guess);
    const auto onset = find_onset(
        [&](double speed) -> std::optional<Complex> {
          if (follow(stepper, OperatingPoint::loaded_by(load, speed), state).status != Status::converged) return {};
          return worst_rate(rotor, stepper, state) * std::abs(speed);
        },
        0.99 * guess, 1.02 * guess);
    ASSERT_TRUE(onset.has_value());
    // The prototype's onsets are accurate to 2e-8 of the growth.
    EXPECT_NEAR(onset->speed, guess, 1e-6 * std::abs(guess));
    EXPECT_NEAR(onset->whirl_ratio, reference.whirl_ratio, 1e-6);
  }
}

/// Decay of a whirl of 1e-5 c in the prototype's time steps, and from its pencil.
TEST(RotorWhirl, DecaysAsInThePrototype) {
  FilmStepper stepper(film_reference_bearing({6, 8}));
  const BearingState state = state_under(stepper, {gravity, 0.0}, speed_of_rpm(-12000.0));
  const Complex rate = worst_rate(make_point_mass(1.0), stepper, state);
  EXPECT_NEAR(rate.real(), -0.02138068, 1e-7);
  EXPECT_NEAR(rate.imag(), 0.52428258, 1e-7);
  const BearingState loaded = state_under(stepper, {50.0, 0.0}, speed_of_rpm(-45000.0));
  const Complex growing = worst_rate(make_point_mass(1.0), stepper, loaded);
  EXPECT_NEAR(growing.real(), 0.00552, 1e-5);
  EXPECT_NEAR(growing.imag(), 0.30067, 1e-5);
}

/// Rate of the rotor's whirl with coefficients at its own frequency, as from tables over speed and frequency.
Complex rate_by_tables(const Rotor& rotor, const FreeMotions& motions, double speed) {
  Complex rate = motions.whirls.front().rate;
  for (int i = 0; i < 30; ++i) {
    const double frequency = rate.imag();
    const Eigen::Matrix2cd Z = motions.bearings.front().at({0.0, frequency});
    const auto linear = linear_impedance(Z.real(), Z.imag() / frequency, frequency);
    rate = whirls_on(rotor, speed, {linear}, usual_window(speed)).front().rate;
  }
  return rate;
}

/// Tables of coefficients for a rotor of 1 kg, f = 0: over speed and frequency they are right at the onset, where the
/// growth is zero, and near it; synchronous ones predict a stable rotor at three times its onset speed.
TEST(RotorWhirl, ComesOutOfTablesOverFrequencyAndNotOutOfSynchronousOnes) {
  FilmStepper stepper(film_reference_bearing({6, 8}));
  const Rotor rotor = make_point_mass(1.0);
  const auto verdicts_at = [&](double rpm) {
    const double speed = speed_of_rpm(-rpm);
    const BearingState state = state_under(stepper, {gravity, 0.0}, speed);
    const auto motions = find_whirls(rotor, {{stepper, state}}, usual_window(speed));
    EXPECT_TRUE(motions.has_value());
    const double full = motions->whirls.front().rate.real();
    const double tables = rate_by_tables(rotor, *motions, speed).real();
    const double synchronous =
        whirls_on_coefficients(rotor, speed, motions->bearings, usual_window(speed)).front().rate.real();
    return std::array{full / std::abs(speed), tables / std::abs(speed), synchronous / std::abs(speed)};
  };
  const auto at_onset = verdicts_at(13072.434026772906);
  EXPECT_NEAR(at_onset[0], 0.0, 1e-7);
  EXPECT_NEAR(at_onset[1], 0.0, 1e-7);
  EXPECT_LT(at_onset[2], -0.08);
  const auto below = verdicts_at(12000.0);
  EXPECT_NEAR(below[0], -0.02138068, 1e-7);
  EXPECT_NEAR(below[1], below[0], 0.2 * std::abs(below[0]));
  EXPECT_LT(below[2], -0.09);
  const auto far_above = verdicts_at(40000.0);
  EXPECT_GT(far_above[0], 0.07);
  EXPECT_LT(far_above[2], -0.02);
}

/// Two bearings of different clearances carry a rigid rotor that tilts.
struct TwoBearings {
  TwoBearings() {
    for (const double clearance : {31.8e-6, 28e-6}) {
      Case input = film_reference_case({6, 8});
      input.bearing.radial_clearance = clearance;
      steppers.emplace_back(make_film_bearing(input));
    }
    const auto loads = weights_on_bearings(rotor, {gravity, 0.0});
    for (std::size_t i = 0; i < 2; ++i) states.push_back(state_under(steppers[i], loads[i], speed));
  }
  [[nodiscard]] std::vector<CarryingBearing> bearings() { return {{steppers[0], states[0]}, {steppers[1], states[1]}}; }

  double speed = speed_of_rpm(-10000.0);
  Rotor rotor = make_rigid_rotor({.mass = 2.2,
                                  .transverse_inertia = 9e-3,
                                  .polar_inertia = 1.1e-3,
                                  .bearings = {-0.07, 0.09},
                                  .planes = {-0.02, 0.05}});
  std::deque<FilmStepper> steppers;
  std::vector<BearingState> states;
};

TEST(RotorWhirl, OfARigidRotorIsAsInThePrototype) {
  TwoBearings machine;
  const auto whirls = motions_of(machine.rotor, machine.bearings(), usual_window(machine.speed));
  ASSERT_TRUE(whirls.has_value());
  for (const Complex expected :
       {Complex(-0.0856954523001663, 0.6047456469655614), Complex(-0.22673431550792483, 0.6758409745663876)}) {
    const auto found = std::min_element(whirls->begin(), whirls->end(), [&](const Whirl& a, const Whirl& b) {
      return std::abs(a.rate / std::abs(machine.speed) - expected) <
             std::abs(b.rate / std::abs(machine.speed) - expected);
    });
    ASSERT_NE(found, whirls->end());
    // States of the prototype are accurate to 1e-7.
    EXPECT_LT(std::abs(found->rate / std::abs(machine.speed) - expected), 1e-6);
    EXPECT_FALSE(found->is_of_foils());
    EXPECT_GT(found->direction, 0.0);  // in the sense of rotation, from Y to X here
  }
}

/// The same from a case file that states how the second bearing differs.
TEST(RotorWhirl, OfBearingsThatDifferIsThatOfTheirCase) {
  const Case input =
      parse_case(case_to_toml(film_reference_case({6, 8})), "two.toml",
                 {.overrides = {"rotor.mass=2.2 kg", "rotor.transverse_inertia=9e-3 kg m2",
                                "rotor.polar_inertia=1.1e-3 kg m2", "rotor.bearings=[\"-70 mm\", \"90 mm\"]",
                                "rotor.gravity=[9.81, 0]", "rotor.bearing=[{}, {bearing={radial_clearance=\"28 um\"}}]",
                                "rotor.unbalance=[{amount=1.5e-6, at=-0.02}, {amount=1e-6, at=0.05, phase=\"90 deg\"}]",
                                "stability.speeds=[\"-10000 rpm\"]", "unbalance.speeds=[\"-10000 rpm\"]"},
                  .commands = {"stability", "unbalance"}});
  TwoBearings machine;
  const StabilityResult result = run_stability(input);
  ASSERT_TRUE(result.map.points.at(0).sliding.has_value());
  const std::vector<Whirl>& whirls = result.map.points[0].sliding->whirls;
  for (const Complex expected :
       {Complex(-0.0856954523001663, 0.6047456469655614), Complex(-0.22673431550792483, 0.6758409745663876)}) {
    double nearest = 1.0;
    for (const Whirl& whirl : whirls) {
      nearest = std::min(nearest, std::abs(whirl.rate / std::abs(machine.speed) - expected));
    }
    EXPECT_LT(nearest, 1e-7);
  }
  const UnbalanceResult response = run_unbalance(input);
  ASSERT_TRUE(response.points.at(0).sliding.has_value());
  const double expected_um[2][2] = {{1.0729805518445406, 0.8285877436613249}, {1.596114559649816, 1.5667038336540233}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector2cd orbit = 1e6 * (response.machine.rotor.bearings[i].motion * *response.points[0].sliding);
    for (const int axis : {0, 1}) EXPECT_NEAR(std::abs(orbit[axis]), expected_um[i][axis], 2e-6);
  }
}

/// Linear response to two unbalances, at the bearings.
TEST(RotorWhirl, RespondsToUnbalanceAsInThePrototype) {
  TwoBearings machine;
  const Eigen::VectorXcd force =
      unbalance_force(machine.rotor.stations[0], {.amount = 1.5e-6, .phase = 0.0}, machine.speed) +
      unbalance_force(machine.rotor.stations[1], {.amount = 1e-6, .phase = 0.5 * std::numbers::pi}, machine.speed);
  const auto y = linear_response(machine.rotor, machine.bearings(), force, {0.0, std::abs(machine.speed)});
  ASSERT_TRUE(y.has_value());
  const double expected_um[2][2] = {{1.0729805518445406, 0.8285877436613249}, {1.596114559649816, 1.5667038336540233}};
  const double expected_deg[2][2] = {{-120.8398217816969, -82.58427546317324},
                                     {-164.1001185661456, -113.56623022567584}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector2cd orbit = 1e6 * (machine.rotor.bearings[i].motion * *y);
    for (const int axis : {0, 1}) {
      EXPECT_NEAR(std::abs(orbit[axis]), expected_um[i][axis], 2e-6);
      EXPECT_NEAR(std::arg(orbit[axis]) * 180.0 / std::numbers::pi, expected_deg[i][axis], 2e-4);
    }
  }
}

/// At the critical mass and its frequency, the pair is undamped: eigenvalues of Z on the real axis and eigenvalues of
/// the whole system agree.
TEST(RotorWhirl, IsUndampedAtTheCriticalMass) {
  FilmStepper stepper(film_reference_bearing({6, 8}, 0.1));
  const double speed = speed_of_rpm(-45000.0);
  const BearingState state = state_under(stepper, {20.0, 0.0}, speed);
  for (const bool stuck : {false, true}) {
    const auto Z =
        stepper.impedance(state, {Complex(0.0, 0.2 * std::abs(speed)), Complex(0.0, 1.2 * std::abs(speed))}, stuck);
    ASSERT_TRUE(Z.has_value());
    const auto critical = critical_masses(
        [&](double nu) {
          return Z->at({0.0, nu});
        },
        0.05 * std::abs(speed), 1.2 * std::abs(speed));
    ASSERT_FALSE(critical.empty());
    const Complex rate = worst_rate(make_point_mass(critical.front().mass), stepper, state, stuck);
    EXPECT_NEAR(rate.real(), 0.0, 1e-8);
    EXPECT_NEAR(rate.imag() * std::abs(speed), critical.front().frequency, 1e-7 * std::abs(speed));
    EXPECT_GT(worst_rate(make_point_mass(1.1 * critical.front().mass), stepper, state, stuck).real(), 1e-5);
    EXPECT_LT(worst_rate(make_point_mass(0.9 * critical.front().mass), stepper, state, stuck).real(), -1e-5);
  }
}

/// A rotor on two equal bearings whirls as a point mass, apart from its tilting motions.
TEST(RotorWhirl, OfTwoEqualBearingsIsThatOfAPointMass) {
  FilmStepper stepper(film_reference_bearing({4, 4}));
  const double speed = speed_of_rpm(-12000.0);
  const BearingState state = state_under(stepper, {gravity, 0.0}, speed);
  const Rotor rigid =
      make_rigid_rotor({.mass = 2.0, .transverse_inertia = 5e-3, .polar_inertia = 1e-3, .bearings = {-0.05, 0.05}});
  const auto one = motions_of(make_point_mass(1.0), {{stepper, state}}, usual_window(speed));
  const auto two = motions_of(rigid, {{stepper, state}, {stepper, state}}, usual_window(speed));
  ASSERT_TRUE(one && two);
  for (const Whirl& whirl : *one) {
    const double nearest =
        std::abs(std::min_element(two->begin(), two->end(),
                                  [&](const Whirl& a, const Whirl& b) {
                                    return std::abs(a.rate - whirl.rate) < std::abs(b.rate - whirl.rate);
                                  })
                     ->rate -
                 whirl.rate);
    EXPECT_LT(nearest, 1e-8 * std::abs(whirl.rate));
  }
}

/// Under a heavy rotor foils move as with the journal held; none of these motions is attributed to the rotor.
TEST(RotorWhirl, TellsFoilsFromTheRotor) {
  FilmStepper stepper(film_reference_bearing({6, 8}));
  const double speed = speed_of_rpm(12000.0);  // the free end is the inlet, and flutters
  const BearingState state = state_under(stepper, {gravity, 0.0}, speed);
  const auto held = stepper.held_motion(state);
  ASSERT_TRUE(held.has_value());
  // The heavier the rotor, the closer to the poles of the reduced film in either direction: each motion is listed once.
  for (const double mass : {1e4, 1e6}) {
    const auto whirls = motions_of(make_point_mass(mass), {{stepper, state}}, usual_window(speed));
    ASSERT_TRUE(whirls.has_value());
    ASSERT_FALSE(whirls->empty());
    EXPECT_LT(std::abs(whirls->front().rate - held->rate), 1e-3 * std::abs(speed));
    EXPECT_TRUE(whirls->front().is_of_foils());
    for (std::size_t i = 1; i < whirls->size(); ++i) {
      EXPECT_GT(std::abs((*whirls)[i].rate - (*whirls)[i - 1].rate), 1e-5 * std::abs(speed));
    }
  }
}

}  // namespace
}  // namespace bumpfoil
