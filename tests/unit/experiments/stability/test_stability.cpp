#include "bumpfoil/experiments/stability/stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "experiments/stability/stability_quantities.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

/// 1 kg on each bearing, f = 0, gas entering at the weld: the onset of the prototype is 13,072.43 rpm.
Case rotor_case(const std::vector<double>& rpm, FilmResolution mesh = {6, 8}) {
  Case input = film_rotor_case(mesh);
  input.settings.set(StabilitySettings{.speeds = speeds_of_rpm(rpm)});
  return input;
}

const Case& outcome_case() {
  static const Case input = rotor_case({-12000.0, -12600.0, -13200.0});
  return input;
}

const Outcome& outcome() {
  static const Outcome run = experiment_named("stability").run(outcome_case(), {});
  return run;
}

double value_of(const Dataset& data, const std::string& name, std::size_t place = 0) {
  for (const Variable& variable : data.variables) {
    if (variable.meaning.name == name) return variable.values().at(place);
  }
  ADD_FAILURE() << name;
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(Stability, TellsTheOnsetOfThePrototype) {
  EXPECT_EQ(outcome().status, RunStatus::complete);
  EXPECT_EQ(outcome().failures, std::vector<std::string>{});
  const Dataset data = outcome().dataset();
  EXPECT_NEAR(value_of(data, "onset_speed"), speed_of_rpm(-13072.434026772906), 1e-6 * speed_of_rpm(13072.4));
  EXPECT_NEAR(value_of(data, "onset_whirl_ratio"), 0.49078240201060497, 1e-6);
  EXPECT_EQ(value_of(data, "onset_speed_stuck"), value_of(data, "onset_speed"));  // nothing slips
  // Synchronous coefficients have the rotor stable.
  EXPECT_TRUE(std::isnan(value_of(data, "onset_speed_by_coefficients")));
  EXPECT_NEAR(value_of(data, "growth"), -0.02138068, 1e-6);  // at 12,000 rpm
  EXPECT_NEAR(value_of(data, "whirl_ratio"), 0.52428258, 1e-6);
  EXPECT_LT(value_of(data, "growth_by_coefficients", 2), -0.05);
  EXPECT_EQ(value_of(data, "stable", 0), 1.0);
  EXPECT_EQ(value_of(data, "stable", 2), 0.0);
  EXPECT_NEAR(value_of(data, "load_x"), 9.81, 1e-12);
  const std::string table = outcome().table();
  EXPECT_NE(table.find("onset of whirl, contacts sliding: whirl begins at -13072.4 rpm, whirl ratio 0.4908"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("by synchronous coefficients, full stick: none between these speeds"), std::string::npos);
}

TEST(Stability, WritesALineForEachMotion) {
  std::string csv;
  nlohmann::json summary;
  for (const ResultFile& file : result_files(experiment_named("stability"), outcome_case(), outcome(), {})) {
    if (file.name == "stability.csv") csv = file.contents;
    if (file.name == "summary.json") summary = nlohmann::json::parse(file.contents);
  }
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "speed_rad_per_s,mode,real_rad_per_s,imag_rad_per_s,log_decrement,damping_ratio,direction,contacts,status,"
            "directivity,rotor_share,of_foils");
  std::getline(lines, line);
  EXPECT_NE(line.find(",forward,sliding,converged,"), std::string::npos) << line;
  ASSERT_EQ(summary.at("onsets").size(), 2U);
  EXPECT_EQ(summary.at("onsets").at(0).at("contacts"), "sliding");
  EXPECT_TRUE(summary.at("onsets").at(0).at("begins"));
  EXPECT_FALSE(summary.at("onsets").at(0).at("by_coefficients"));
  ASSERT_EQ(summary.at("speeds").size(), 3U);
  EXPECT_EQ(summary.at("speeds").at(1).at("status"), "converged");
  EXPECT_EQ(summary.at("speeds").at(1).at("fastest_direction"), "forward");
  EXPECT_TRUE(summary.at("speeds").at(1).at("motions").at(0).contains("residual"));  // which the table leaves out
  const auto& motion = summary.at("speeds").at(0).at("motions").at(0);
  EXPECT_EQ(motion.at("mode"), 1);
  // The decrement is that of the rate, by its definition.
  EXPECT_NEAR(motion.at("log_decrement"),
              -2.0 * M_PI * motion.at("real_rad_per_s").get<double>() / motion.at("imag_rad_per_s").get<double>(),
              1e-12);
}

/// The shape of a motion is that of the rotor's own circle: both axes move, a quarter of a turn apart.
TEST(Stability, KeepsShapesAndNumbersOfModes) {
  const Dataset data = outcome().dataset();
  const std::size_t modes = data.dimension("mode").size;
  ASSERT_GE(modes, 1U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t place = i * 2 * modes;  // sliding contacts, motion 1
    const double x = value_of(data, "shape_amplitude_x", place);
    const double y = value_of(data, "shape_amplitude_y", place);
    EXPECT_NEAR(std::max(x, y), 1.0, 1e-12);
    EXPECT_GT(std::min(x, y), 0.5);
    // Omega < 0 turns Y to X, and so does a forward whirl: y leads.
    const double lead = value_of(data, "shape_phase_y", place) - value_of(data, "shape_phase_x", place);
    EXPECT_GT(std::sin(lead * M_PI / 180.0), 0.5);
    EXPECT_NEAR(value_of(data, "imag", place) / std::abs(speed_of_rpm(12000.0 + 600.0 * static_cast<double>(i))), 0.5,
                0.03);
  }
}

/// A motion with this growth rate at each speed, or none; without contacts that slip.
StabilityResult with_growth(const std::vector<std::pair<double, std::optional<double>>>& points,
                            const std::vector<double>& onsets) {
  StabilityResult result{.machine = {}, .map = {}};
  for (const auto& [speed, growth] : points) {
    SpeedPoint& point = result.map.points.emplace_back();
    point.speed = speed;
    point.status = Status::converged;
    if (!growth) continue;
    Whirl whirl;
    whirl.rate = {*growth, 0.5 * std::abs(speed)};
    point.sliding = SpeedMotions{.whirls = {whirl}, .numbers = {0}, .by_coefficients = {}};
    point.stuck = point.sliding;
  }
  for (const double speed : onsets) {
    WhirlOnset found;
    found.begins = true;
    found.onset.speed = speed;
    result.map.onsets.push_back(found);
  }
  return result;
}

double quantity_of(const StabilityResult& result, std::string_view name) {
  const auto all = stability_quantities();
  return std::find_if(all.begin(), all.end(), [name](const auto& one) { return one.name == name; })->value(result);
}

/// Of a run one number is wanted that says how far it may go, with an onset or without.
TEST(Stability, TellsUpToWhichSpeedAllMotionsDecay) {
  struct Expected {
    StabilityResult result;
    double up_to, throughout, at_lowest;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WhirlOnset others;
  others.by_coefficients = true;
  others.onset.speed = 1010.0;
  std::vector<Expected> all{
      // stable at all speeds; from an onset on not; whose second onset is no matter
      {with_growth({{1000.0, -1.0}, {1200.0, -1.0}}, {}), 1200.0, 1.0, 0.0},
      {with_growth({{1000.0, -1.0}, {1200.0, 1.0}}, {1100.0}), 1100.0, 0.0, 0.0},
      {with_growth({{1000.0, -1.0}, {1200.0, 1.0}, {1400.0, -1.0}, {1600.0, 1.0}}, {1150.0, 1300.0, 1500.0}), 1150.0,
       0.0, 0.0},
      // of sliding and of stuck contacts, the lowest counts; one that was not found
      {with_growth({{1000.0, -1.0}, {1200.0, 1.0}}, {1100.0, 1080.0, 1120.0}), 1080.0, 0.0, 0.0},
      {with_growth({{1000.0, -1.0}, {1200.0, 1.0}}, {}), 1000.0, 0.0, 0.0},
      // backwards, and down from the highest speed
      {with_growth({{-1200.0, 1.0}, {-1000.0, -1.0}}, {-1100.0}), 1100.0, 0.0, 0.0},
      // unstable at the lowest speed, though not at all; and again from an onset on
      {with_growth({{1000.0, 1.0}, {1200.0, -1.0}, {1400.0, 1.0}}, {1100.0, 1300.0}), 0.0, 0.0, 1.0},
      // not known from some speed on; not known at the lowest
      {with_growth({{1000.0, -1.0}, {1200.0, {}}, {1400.0, -1.0}}, {}), 1000.0, nan, 0.0},
      {with_growth({{1000.0, {}}, {1200.0, -1.0}}, {}), nan, nan, nan},
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].result.map.onsets.push_back(others);  // coefficients are no measure
    const auto expect = [&](const char* name, double expected) {
      const double found = quantity_of(all[i].result, name);
      EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << i << ' ' << name << ' ' << found;
    };
    expect("stable_up_to", all[i].up_to);
    expect("stable_throughout", all[i].throughout);
    expect("unstable_at_lowest", all[i].at_lowest);
  }
}

TEST(Stability, EndsWhereItIsStopped) {
  const Case input = rotor_case({-12000.0, -13500.0, -14000.0}, {4, 4});
  const auto stopped_where = [&](const std::function<bool(double)>& progress) {
    return experiment_named("stability").run(input, progress);
  };
  const Outcome stopped = stopped_where([](double done) { return done < 0.6; });
  EXPECT_EQ(stopped.status, RunStatus::interrupted);
  EXPECT_FALSE(std::isnan(value_of(stopped.dataset(), "growth", 1)));
  EXPECT_TRUE(std::isnan(value_of(stopped.dataset(), "growth", 2)));
  // On the way to the first speed, and in the search for the last onset, where all speeds are there.
  int requested = 0;
  const Outcome early = stopped_where([&](double) { return ++requested < 3; });
  EXPECT_EQ(early.status, RunStatus::interrupted);
  EXPECT_TRUE(std::isnan(value_of(early.dataset(), "growth", 0)));
  int all = 0;
  EXPECT_EQ(stopped_where([&](double) { return ++all > 0; }).status, RunStatus::complete);
  requested = 0;
  const Outcome late = stopped_where([&](double) { return ++requested < all; });
  EXPECT_EQ(late.status, RunStatus::interrupted);
  EXPECT_FALSE(std::isnan(value_of(late.dataset(), "growth", 2)));
}

/// A film below its threshold thickness: the speed reports it, and the following speeds are named.
TEST(Stability, SaysWhatIsNotFound) {
  Case input = rotor_case({-12000.0, -13500.0}, {4, 4});
  input.film.h_floor = 1e-3;
  const Outcome failed = experiment_named("stability").run(input, {});
  EXPECT_EQ(failed.status, RunStatus::failed);
  ASSERT_EQ(failed.failures.size(), 2U);
  EXPECT_NE(failed.failures[0].find("-12000 rpm: no equilibrium found"), std::string::npos);
}

/// The default direction of rotation with a foil formed to the bearing: its free end flutters under any load.
TEST(Stability, WarnsOfFoilsThatFlutter) {
  const Outcome run = experiment_named("stability").run(rotor_case({12000.0}), {});
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_NE(run.warnings[0].find("at 1 of 1 speeds (first at 12000 rpm) the foils themselves"), std::string::npos);
  EXPECT_EQ(value_of(run.dataset(), "fastest_of_foils"), 1.0);
}

TEST(FindErrors, ChecksSpeedsOfARotor) {
  const auto speeds = [](std::vector<double> all) {
    return wrong_keys([&](Case& input) {
      RotorSettings rotor;
      rotor.mass = 2.0;
      input.settings.set(rotor);
      input.settings.set(StabilitySettings{.speeds = std::move(all)});
    });
  };
  EXPECT_EQ(speeds({1000.0, 2000.0}), Keys{});
  EXPECT_EQ(speeds({}), Keys{"stability.speeds"});
  EXPECT_EQ(speeds({0.0}), Keys{"stability.speeds[1]"});
  EXPECT_EQ(speeds({1000.0, -2000.0}), Keys{"stability.speeds[2]"});
  EXPECT_EQ(wrong_keys([](Case& input) { input.settings.set(StabilitySettings{.speeds = {1000.0}}); }), Keys{"rotor"});
}

TEST(Stability, WantsItsTables) {
  EXPECT_THROW(static_cast<void>(run_stability(film_reference_case({4, 4}))), Error);
}

}  // namespace
}  // namespace bumpfoil
