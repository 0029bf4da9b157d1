#include "bumpfoil/experiments/unbalance/unbalance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "bumpfoil/rotor/unbalance.hpp"
#include "experiments/unbalance/unbalance_quantities.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

/// 1 kg on each bearing, its centre of mass 1 um from the axis along +X.
Case unbalanced_case(const std::vector<double>& rpm, FilmResolution mesh = {4, 4}) {
  Case input = film_rotor_case(mesh);
  input.settings.get<RotorSettings>().unbalances.emplace_back().amount = 2e-6;
  input.settings.set(UnbalanceSettings{.speeds = speeds_of_rpm(rpm)});
  return input;
}

/// Asks for periodic orbits, too.
UnbalanceSettings with_orbits(Case& input, int steps_per_revolution) {
  UnbalanceSettings& settings = input.settings.get<UnbalanceSettings>();
  settings.orbits = true;
  settings.steps_per_revolution = steps_per_revolution;
  return settings;
}

std::string file_of(const Case& input, const Outcome& outcome, const std::string& name) {
  for (const ResultFile& file : result_files(experiment_named("unbalance"), input, outcome, {})) {
    if (file.name == name) return file.contents;
  }
  ADD_FAILURE() << name;
  return {};
}

/// The response follows the unbalance: half of that of the rotor on half of its mass, and with its phase.
TEST(Unbalance, IsThatOfItsRotor) {
  const Case input = unbalanced_case({-12000.0});
  const UnbalanceResult result = run_unbalance(input);
  ASSERT_EQ(result.points.size(), 1U);
  ASSERT_TRUE(result.points[0].sliding && result.points[0].stuck);
  // 2 kg with 2 g mm on two bearings are 1 kg with 1 g mm on each.
  const Rotor half = make_point_mass(1.0);
  FilmStepper stepper(result.machine.bearings.front());
  const double speed = result.points[0].speed;
  const auto alone =
      linear_response(half, {{stepper, result.points[0].states.front()}},
                      unbalance_force(half.bearings.front(), {.amount = 1e-6}, speed), {0.0, std::abs(speed)}, true);
  ASSERT_TRUE(alone.has_value());
  EXPECT_LT((*result.points[0].stuck - *alone).norm(), 1e-9 * alone->norm());
  Case turned = input;
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.unbalances[0].phase = 0.7;
  rotor.unbalances[0].amount = 6e-6;
  turned.settings.set(rotor);
  const UnbalanceResult other = run_unbalance(turned);
  // Omega < 0 turns Y to X: a heavy place that lies ahead from X towards Y comes later.
  const Eigen::VectorXcd expected = 3.0 * std::polar(1.0, -0.7) * *result.points[0].sliding;
  EXPECT_LT((*other.points[0].sliding - expected).norm(), 1e-9 * expected.norm());
}

/// A grade G 2.5 at 12,000 rpm is U = G m / Omega.
TEST(Unbalance, TakesAGrade) {
  const Case input = unbalanced_case({-12000.0});
  Case graded = input;
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.unbalances[0] = {};
  rotor.unbalances[0].grade = 2.5e-3;
  rotor.unbalances[0].grade_speed = speed_of_rpm(12000.0);
  graded.settings.set(rotor);
  const double amount = 2.5e-3 * 2.0 / speed_of_rpm(12000.0);
  const Eigen::VectorXcd plain = *run_unbalance(input).points[0].stuck;
  const Eigen::VectorXcd found = *run_unbalance(graded).points[0].stuck;
  EXPECT_LT((found - amount / 2e-6 * plain).norm(), 1e-9 * found.norm());
}

TEST(Unbalance, WritesALineForEachStation) {
  const Case input = unbalanced_case({-11000.0, -12000.0});
  const Outcome outcome = experiment_named("unbalance").run(input, {});
  EXPECT_EQ(outcome.status, RunStatus::complete);
  const std::string csv = file_of(input, outcome, "unbalance.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "speed_rad_per_s,station,amplitude_x_m,phase_x_deg,amplitude_y_m,phase_y_deg,half_peak_to_peak_x_m,"
            "half_peak_to_peak_y_m,h_min_m,friction_loss_J,power_W,mean_x_m,mean_y_m,amplitude_x_2x_m,phase_x_2x_deg,"
            "amplitude_y_2x_m,phase_y_2x_deg,semi_major_m,semi_minor_m,kind,status");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 2);
  EXPECT_NE(csv.find(",bearing 1,"), std::string::npos);
  EXPECT_NE(csv.find(",linear_stuck,converged\n"), std::string::npos);
  const auto summary = nlohmann::json::parse(file_of(input, outcome, "summary.json"));
  EXPECT_EQ(summary.at("speeds").at(1).at("responses").size(), 2U);
  EXPECT_EQ(summary.at("stations"), nlohmann::json::array({"bearing 1"}));
  EXPECT_NE(outcome.table().find("Small orbits, full stick"), std::string::npos);
}

/// The film of an orbit and that of the equilibrium are two variables, each with its own numbers.
TEST(Unbalance, KeepsEachVariableOnce) {
  Case input = unbalanced_case({-11000.0});
  with_orbits(input, 30);
  const UnbalanceResult result = run_unbalance(input);
  const Dataset data = unbalance_dataset(result);
  std::map<std::string, std::vector<double>> values;
  for (const Variable& variable : data.variables) {
    EXPECT_TRUE(values.try_emplace(variable.meaning.name, variable.values()).second) << variable.meaning.name;
  }
  const Orbit& orbit = *result.points[0].orbit;
  EXPECT_EQ(values.at("h_min").at(2), orbit.turn[0].thinnest);
  EXPECT_EQ(values.at("equilibrium_h_min").at(0), result.machine.thinnest_film(result.points[0].states));
  EXPECT_LT(orbit.turn[0].thinnest, values.at("equilibrium_h_min").at(0));
  EXPECT_EQ(values.at("y").at(0), result.points[0].states[0].position.y());
  EXPECT_NEAR(values.at("phase_y_2x").at(2), std::arg(orbit.bearings[0].twice.y()) * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_EQ(values.at("orbit_lasts").at(0), 1.0);
}

/// The largest orbit of the journals, where it is, and what part of the film it takes: those of the response.
TEST(Unbalance, SaysHowLargeOrbitsAreAtMost) {
  UnbalanceResult result = run_unbalance(unbalanced_case({-6000.0, -8500.0, -11000.0}));
  const auto value = [&](std::string_view name) {
    const auto all = unbalance_quantities();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    return found->value(result);
  };
  double largest = 0.0;
  double speed = 0.0;
  double ratio = 0.0;
  for (const UnbalancePoint& point : result.points) {
    const double major = elliptic_orbit(Eigen::Vector2cd(*point.stuck), point.speed).major;
    if (major > largest) speed = -point.speed;
    largest = std::max(largest, major);
    ratio = std::max(ratio, major / result.machine.thinnest_film(point.states));
  }
  EXPECT_EQ(value("status"), 0.0);
  EXPECT_NEAR(value("largest_amplitude"), largest, 1e-12 * largest);
  EXPECT_EQ(value("largest_amplitude_speed"), speed);
  EXPECT_NEAR(value("largest_amplitude_ratio"), ratio, 1e-12 * ratio);
  EXPECT_TRUE(std::isnan(value("least_h_min")));
  EXPECT_TRUE(std::isnan(value("orbits_last")));
  // Of orbits, the thinnest film; one that does not last is enough.
  for (std::size_t i = 0; i < 3; ++i) {
    Orbit& orbit = result.points[i].orbit.emplace();
    orbit.status = Status::converged;
    orbit.turn = {{.thinnest = std::vector{5e-6, 3e-6, 4e-6}[i]}};
    orbit.multipliers = {{0.9, 0.0}};
  }
  EXPECT_EQ(value("least_h_min"), 3e-6);
  EXPECT_EQ(value("orbits_last"), 1.0);
  result.points[1].orbit->multipliers.clear();
  EXPECT_TRUE(std::isnan(value("orbits_last")));
  result.points[2].orbit->multipliers = {{-1.1, 0.0}};
  EXPECT_EQ(value("orbits_last"), 0.0);
  result.points[1].orbit->status = Status::not_converged;
  EXPECT_EQ(value("status"), static_cast<double>(Status::not_converged));
  result.points[0].status = Status::touchdown;
  EXPECT_EQ(value("status"), static_cast<double>(Status::touchdown));
}

/// A sweep keeps what is over the speeds, of runs that were not begun, too.
TEST(Unbalance, IsSwept) {
  const ExperimentInfo& experiment = experiment_named("unbalance");
  const Case input = unbalanced_case({-11000.0, -12000.0});
  const Outcome outcome = experiment.sweeping->run(input, {});
  const SweptResult swept = outcome.swept(false);
  const Outcome none = experiment.sweeping->not_begun(input);
  const SweptResult empty = none.swept(false);
  ASSERT_EQ(swept.dataset.variables.size(), empty.dataset.variables.size());
  for (std::size_t i = 0; i < swept.dataset.variables.size(); ++i) {
    EXPECT_EQ(swept.dataset.variables[i].meaning.name, empty.dataset.variables[i].meaning.name);
    EXPECT_EQ(swept.dataset.variables[i].values().size(), empty.dataset.variables[i].values().size());
  }
  EXPECT_EQ(swept.dataset.dims.size(), 2U);  // speed and bearing
  const auto lists = nlohmann::json::parse(swept.lists);
  EXPECT_GT(lists.at("largest_amplitude_m"), 0.0);
  EXPECT_FALSE(lists.contains("least_h_min_m"));
  EXPECT_EQ(csv_text(swept.rows), file_of(input, outcome, "unbalance.csv"));
}

/// An orbit is stable if it was found and no multiplier exceeds 1; without multipliers it is unknown.
TEST(Unbalance, SaysWhichOrbitsLast) {
  Orbit orbit;
  orbit.status = Status::converged;
  EXPECT_EQ(lasting(orbit), std::nullopt);
  orbit.multipliers = {{0.6, 0.7}};
  EXPECT_EQ(lasting(orbit), true);
  orbit.multipliers = {{0.8, 0.7}};
  EXPECT_EQ(lasting(orbit), false);
  orbit.status = Status::not_converged;
  EXPECT_EQ(lasting(orbit), std::nullopt);
}

/// The critical speed of the rotor lies where the orbit is largest.
TEST(Unbalance, FindsThePeak) {
  std::vector<double> rpm;
  for (double one = -4000.0; one >= -16000.0; one -= 1000.0) rpm.push_back(one);
  const Case input = unbalanced_case(rpm);
  const Outcome outcome = experiment_named("unbalance").run(input, {});
  const auto summary = nlohmann::json::parse(file_of(input, outcome, "summary.json"));
  ASSERT_FALSE(summary.at("peaks").empty());
  const double peak = std::abs(summary.at("peaks").at(0).at("speed_rad_per_s").get<double>());
  double largest = 0.0;
  double at = 0.0;
  for (const auto& speed : summary.at("speeds")) {
    const double major = speed.at("responses").at(0).at("semi_major_m");
    if (major > largest) {
      largest = major;
      at = std::abs(speed.at("speed_rad_per_s").get<double>());
    }
  }
  EXPECT_NEAR(peak, at, 0.6 * speed_of_rpm(1000.0));
  EXPECT_GE(summary.at("peaks").at(0).at("semi_major_m").get<double>(), largest);
}

/// A ripple of 2 % on the way to the only maximum, and an increase up to the end, are not peaks.
TEST(Unbalance, TakesNoWiggleForAPeak) {
  UnbalanceResult result;
  result.machine.rotor = make_point_mass(1.0);
  double speed = 1000.0;
  for (const double size : {1.0, 1.5, 1.47, 2.0, 3.0, 2.0, 1.0, 0.9, 1.2}) {
    UnbalancePoint& point = result.points.emplace_back();
    point.speed = speed += 100.0;
    point.status = Status::converged;
    point.stuck = Eigen::Vector2cd(1e-6 * size, 0.0);
  }
  const std::vector<ResponsePeak> peaks = peaks_of(result);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].speed, 1500.0, 1e-9);  // its neighbours are alike
  EXPECT_NEAR(peaks[0].amplitude, 3e-6, 1e-15);
  EXPECT_EQ(peaks[0].kind, ResponseKind::linear_stuck);
  EXPECT_EQ(peaks[0].station, "bearing 1");
}

/// Above the onset of whirl there is an orbit, and the rotor leaves it.
TEST(Unbalance, WarnsOfOrbitsThatDoNotLast) {
  Case input = unbalanced_case({-15000.0});
  with_orbits(input, 40);
  const Outcome outcome = experiment_named("unbalance").run(input, {});
  EXPECT_EQ(outcome.failures, std::vector<std::string>{});
  ASSERT_FALSE(outcome.warnings.empty());
  EXPECT_NE(outcome.warnings.back().find("1 of 1 periodic orbits do not last (first at -15000 rpm"), std::string::npos)
      << outcome.warnings.back();
}

/// With friction, orbits are stable if all free motions of the rotor with full stick decay, for any previous speed:
/// differences due to friction creep are not a growing motion.
TEST(Unbalance, OrbitsLastWhereFreeMotionsDecay) {
  Case input = unbalanced_case({-15000.0, -12000.0, -9000.0});
  input.friction = {.top_bump = 0.1, .bump_sleeve = 0.1};
  const UnbalanceSettings settings = with_orbits(input, 30);
  const UnbalanceResult result = run_unbalance(input);
  input.settings.set(StabilitySettings{.speeds = settings.speeds});
  const StabilityResult free = run_stability(input);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(result.points[i].orbit.has_value());
    ASSERT_TRUE(free.map.points[i].stuck.has_value());
    const double growth = free.map.points[i].stuck->whirls.front().rate.real();
    EXPECT_GT(std::abs(growth), 10.0);  // no speed near the onset
    EXPECT_EQ(lasting(*result.points[i].orbit), growth < 0.0) << i;
  }
}

/// Friction that creeps, and steps that are solved to some accuracy, are no motions: where the differences of a search
/// have come down to these, as at 7,000 rpm, one of them would grow to 1.7 times its size in a turn.
TEST(Unbalance, NoiseIsNoMultiplier) {
  Case input =
      read_case("../examples/rotor.toml", {.overrides = {"film.columns_per_pitch=4", "film.rows=4",
                                                         "unbalance.speeds=[\"6000 rpm\", \"6500 rpm\", \"7000 rpm\"]"},
                                           .commands = {"unbalance"}});
  with_orbits(input, 60);
  const UnbalanceResult result = run_unbalance(input);
  for (const std::size_t i : {1U, 2U}) {
    ASSERT_TRUE(result.points[i].orbit && !result.points[i].orbit->multipliers.empty());
    // exp(2 pi growth) of the free motions is 0.18 and 0.24.
    EXPECT_LT(std::abs(result.points[i].orbit->multipliers.front()), 0.5) << i;
  }
}

/// At -9,000 rpm the orbit of the previous speed needs no extrapolation; a disturbance decays like the least damped
/// free motion, exp(2 pi growth) in a turn. Implicit steps, 60 in a turn, damp by up to 2 %.
TEST(Unbalance, MultipliersAreThoseOfFreeMotions) {
  Case input = unbalanced_case({-9000.0, -9001.0});
  const UnbalanceSettings settings = with_orbits(input, 60);
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.unbalances[0].amount = 2e-7;
  input.settings.set(rotor);
  const UnbalanceResult result = run_unbalance(input);
  input.settings.set(StabilitySettings{.speeds = settings.speeds});
  const StabilityResult free = run_stability(input);
  const double speed = std::abs(settings.speeds[1]);
  const double growth = free.map.points[1].stuck->whirls.front().rate.real() / speed;
  ASSERT_TRUE(result.points[1].orbit.has_value());
  ASSERT_FALSE(result.points[1].orbit->multipliers.empty());
  const double decay = std::exp(2.0 * std::numbers::pi * growth);
  EXPECT_NEAR(std::abs(result.points[1].orbit->multipliers.front()), decay, 0.02 * decay);
}

/// An orbit as large as the film is no small motion.
TEST(Unbalance, WarnsOfLargeOrbits) {
  Case input = unbalanced_case({-12000.0});
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.unbalances[0].amount = 5e-5;
  input.settings.set(rotor);
  const Outcome outcome = experiment_named("unbalance").run(input, {});
  ASSERT_FALSE(outcome.warnings.empty());
  EXPECT_NE(outcome.warnings.back().find("the motion is not small"), std::string::npos);
}

/// At -11,000 rpm, below the onset of whirl, the small unbalance leads to the orbit that the linear response has, but
/// for its square and the steps in time: 0.3 % of inertia.
TEST(Unbalance, FindsTheOrbit) {
  Case input = unbalanced_case({-11000.0});
  with_orbits(input, 60);
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.unbalances[0].amount = 2e-7;
  input.settings.set(rotor);
  const UnbalanceResult result = run_unbalance(input);
  ASSERT_TRUE(result.points[0].orbit.has_value());
  const Orbit& orbit = *result.points[0].orbit;
  ASSERT_EQ(orbit.status, Status::converged);
  const Eigen::Vector2cd linear = *result.points[0].stuck;
  EXPECT_LT((orbit.bearings.at(0).once - linear).norm(), 0.02 * linear.norm());
  ASSERT_FALSE(orbit.multipliers.empty());
  EXPECT_LT(std::abs(orbit.multipliers[0]), 1.0);
  const Outcome outcome = experiment_named("unbalance").run(input, {});
  const std::string csv = file_of(input, outcome, "unbalance.csv");
  EXPECT_NE(csv.find(",orbit,converged\n"), std::string::npos);
  const auto summary = nlohmann::json::parse(file_of(input, outcome, "summary.json"));
  EXPECT_EQ(summary.at("speeds").at(0).at("orbit_status"), "converged");
  EXPECT_NE(outcome.table().find("Periodic orbits with friction"), std::string::npos);
}

TEST(Unbalance, EndsWhereItIsStopped) {
  int requested = 0;
  const Outcome stopped =
      experiment_named("unbalance").run(unbalanced_case({-12000.0, -13500.0, -14000.0}), [&](double) {
        return ++requested < 3;
      });
  EXPECT_EQ(stopped.status, RunStatus::interrupted);
}

TEST(FindErrors, ChecksUnbalances) {
  const auto errors = [](const auto& change) {
    return wrong_keys([&](Case& input) {
      input.settings.set(UnbalanceSettings{.speeds = {1000.0}});
      RotorSettings rotor;
      rotor.mass = 2.0;
      rotor.unbalances.emplace_back().amount = 1e-6;
      change(rotor);
      input.settings.set(rotor);
    });
  };
  EXPECT_EQ(errors([](RotorSettings&) {}), Keys{});
  EXPECT_EQ(errors([](RotorSettings& r) { r.unbalances.clear(); }), Keys{"rotor.unbalance"});
  EXPECT_EQ(errors([](RotorSettings& r) { r.unbalances[0].amount.reset(); }), Keys{"rotor.unbalance[1].amount"});
  EXPECT_EQ(errors([](RotorSettings& r) { r.unbalances[0].grade = 1e-3; }),
            (Keys{"rotor.unbalance[1].amount", "rotor.unbalance[1].grade_speed"}));
  EXPECT_EQ(errors([](RotorSettings& r) { r.unbalances[0].at = 0.01; }), Keys{"rotor.unbalance[1].at"});
}

TEST(Unbalance, WantsItsTables) {
  EXPECT_THROW(static_cast<void>(run_unbalance(film_reference_case({4, 4}))), Error);
}

}  // namespace
}  // namespace bumpfoil
