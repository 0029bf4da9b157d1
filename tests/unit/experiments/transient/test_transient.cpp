#include "bumpfoil/experiments/transient/transient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "experiments/transient/machine_state_file.hpp"
#include "experiments/transient/step_row.hpp"
#include "experiments/transient/transient_quantities.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/temporary_folder.hpp"
#include "support/wrong_keys.hpp"

namespace bumpfoil {
namespace {

using test_support::Keys;
using test_support::wrong_keys;

/// 1 kg on each bearing, its centre of mass 1 um from the axis along +X, with friction.
Case marched_case(std::vector<SpeedPhase> speed) {
  Case input = film_rotor_case({4, 4});
  input.friction = {.top_bump = 0.1, .bump_sleeve = 0.1};
  input.settings.get<RotorSettings>().unbalances.emplace_back().amount = 2e-6;
  input.settings.set(TransientSettings{.speed = std::move(speed), .steps_per_revolution = 30});
  return input;
}

TransientSettings& settings_of(Case& input) {
  return input.settings.get<TransientSettings>();
}

/// Some turns of the rotor at this speed.
SpeedPhase turning(double rpm, double turns) {
  return {.to = speed_of_rpm(rpm), .time = turns * 60.0 / std::abs(rpm)};
}

std::vector<double> all_rows(const TransientResult& result) {
  std::vector<double> all;
  for (std::size_t column = 0; column < result.layout.width(); ++column) {
    const std::vector<double> values = result.steps->column(column, 0, result.steps->rows());
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

TEST(Transient, EndsTurnsWithASequenceOfSteps) {
  const TransientResult result = run_transient(marched_case({turning(-12000.0, 3.0)}));
  ASSERT_EQ(result.status, Status::converged);
  EXPECT_EQ(result.steps->rows(), 91U);
  const std::vector<TransientTurn> turns = turns_of(result);
  ASSERT_EQ(turns.size(), 3U);
  EXPECT_NEAR(turns[2].time, 0.015, 1e-12);
  EXPECT_NEAR(turns[1].speed, speed_of_rpm(-12000.0), 1e-6);
  // What begins on the linear orbit stays near it: a small orbit, a little below the onset of whirl.
  EXPECT_NEAR(std::abs(turns[2].places[0].orbit.once[0]) / std::abs(turns[0].places[0].orbit.once[0]), 1.0, 0.05);
  EXPECT_LT(energy_check(turns).relative(), 0.05);
}

/// Kept states have the tilt of their journals.
TEST(Transient, KeepsTilts) {
  MachineState state;
  BearingState& bearing = state.bearings.emplace_back();
  bearing.tilt = {1e-6, -2e-6};
  bearing.speed = 5.0;
  const std::optional<MachineState> kept = machine_state_of(bytes_of(state));
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->bearings.at(0).tilt, bearing.tilt);
  EXPECT_EQ(kept->bearings[0].speed, 5.0);
}

/// Killed anywhere and gone on with, a run is the same to the last bit.
TEST(Transient, GoesOnToTheLastBit) {
  const Case input = marched_case({{.from = speed_of_rpm(-12000.0), .to = speed_of_rpm(-11000.0), .time = 0.02}});
  const TransientResult whole = run_transient(input);
  ASSERT_EQ(whole.status, Status::converged);
  const std::shared_ptr<StepTable> kept(make_step_table(whole.layout.width()));
  std::optional<std::string> bytes;
  TransientRun run{.keep = [&](const MachineState& state) { bytes = bytes_of(state); }};
  run.progress = [](double done) { return done < 0.6; };
  const TransientResult part = run_transient(input, transient_not_begun(input), kept, run);
  EXPECT_EQ(part.status, Status::interrupted);
  ASSERT_TRUE(bytes.has_value());
  run.progress = {};
  run.from = machine_state_of(*bytes);
  ASSERT_TRUE(run.from.has_value());
  const TransientResult rest = run_transient(input, transient_not_begun(input), kept, run);
  ASSERT_EQ(rest.status, Status::converged);
  EXPECT_EQ(all_rows(rest), all_rows(whole));
  EXPECT_FALSE(machine_state_of(bytes->substr(1)).has_value());
  EXPECT_FALSE(machine_state_of(*bytes + "more").has_value());
}

/// The same on disk, as in the command: a stored run is only resumed by the same case.
TEST(Transient, GoesOnFromItsFolder) {
  const ExperimentInfo& experiment = experiment_named("transient");
  const Case input = marched_case({turning(-12000.0, 2.0)});
  const auto staged = [&](const std::filesystem::path& path, bool resumes, const ProgressCallback& progress,
                          const Case& of) {
    const Provenance provenance{.command_line = "bumpfoil transient", .case_text = "case"};
    ResultFolder folder(path, Existing::replace, experiment.files);
    const Outcome outcome = experiment.staged(of, {provenance, folder, resumes}, progress);
    folder.publish();
    return outcome.status;
  };
  const test_support::TemporaryFolder scratch;
  const auto to_the_end = [](double) { return true; };
  EXPECT_EQ(staged(scratch.path() / "whole", false, to_the_end, input), RunStatus::complete);
  EXPECT_EQ(staged(
                scratch.path() / "parts", false, [](double done) { return done < 0.5; }, input),
            RunStatus::interrupted);
  int requested = 0;  // on the way to the first speed
  EXPECT_EQ(staged(
                scratch.path() / "early", false, [&](double) { return ++requested < 3; }, input),
            RunStatus::interrupted);
  Case other = input;
  other.friction.top_bump = 0.2;
  EXPECT_THROW(staged(scratch.path() / "parts", true, to_the_end, other), Error);
  EXPECT_EQ(staged(scratch.path() / "parts", true, to_the_end, input), RunStatus::complete);
  EXPECT_EQ(scratch.read("parts/transient.csv"), scratch.read("whole/transient.csv"));
  EXPECT_NE(scratch.read("whole/transient.csv").find("bearing 1"), std::string::npos);
}

/// A base that is pushed along pushes the rotor back.
TEST(Transient, BaseMotionIsAForceOnTheMass) {
  Case shaken = marched_case({turning(-12000.0, 1.0)});
  settings_of(shaken).base.push_back({.acceleration = {-4.0, 10.0}, .begin = 1e-3, .duration = 2e-3});
  Case pushed = marched_case({turning(-12000.0, 1.0)});
  settings_of(pushed).pulses.push_back({.force = {8.0, -20.0}, .begin = 1e-3, .duration = 2e-3});  // 2 kg
  const Case quiet = marched_case({turning(-12000.0, 1.0)});
  const auto end = [](const TransientResult& result) {
    const std::size_t last = result.steps->rows() - 1;
    return Eigen::Vector2d(result.steps->column(place_column(0, 0), last, 1).front(),
                           result.steps->column(place_column(0, 1), last, 1).front());
  };
  const Eigen::Vector2d of_base = end(run_transient(shaken));
  EXPECT_LT((of_base - end(run_transient(pushed))).norm(), 1e-12);
  EXPECT_GT((of_base - end(run_transient(quiet))).norm(), 1e-7);
}

/// Rows of a rotor whose axis goes round, with asperities that carry something for a while.
/// @param resting  steps before it begins to turn
TransientResult synthetic(double order, double amplitude, int resting = 0) {
  TransientResult result;
  result.settings.steps_per_revolution = 32;
  result.settings.revolutions_per_spectrum = 4;
  result.layout = {.places = 1, .bearings = 1};
  result.machine.loads = {Eigen::Vector2d(10.0, 0.0)};
  const auto filled = std::shared_ptr<StepTable>(make_step_table(result.layout.width()));
  for (int i = 0; i <= 8 * 32; ++i) {
    std::vector<double> row(result.layout.width());
    const double angle = 2.0 * std::numbers::pi * std::max(i - resting, 0) / 32.0;
    row[column_of(StepColumn::time)] = 1e-3 * i;
    row[column_of(StepColumn::angle)] = angle;
    row[column_of(StepColumn::speed)] = 1.0;
    row[place_column(0, 0)] = 3e-6 + amplitude * std::cos(order * angle);
    row[place_column(0, 1)] = amplitude * std::sin(order * angle);
    row[bearing_column(result.layout, 0, BearingColumn::asperity_load)] = i >= 40 && i < 50 ? 0.5 + 0.01 * i : 0.01;
    row[bearing_column(result.layout, 0, BearingColumn::thinnest)] = 1e-6 * (1 + i);
    filled->append(row);
  }
  result.steps = filled;
  return result;
}

TEST(Transient, TellsHarmonicsOfATurn) {
  const std::vector<TransientTurn> turns = turns_of(synthetic(1.0, 2e-6));
  ASSERT_EQ(turns.size(), 8U);
  const PlaceTurn& place = turns[3].places[0];
  EXPECT_NEAR(std::abs(place.orbit.once[0] - 2e-6), 0.0, 1e-15);
  EXPECT_NEAR(std::abs(place.orbit.once[1] - std::complex<double>(0.0, -2e-6)), 0.0, 1e-15);
  EXPECT_NEAR(place.orbit.mean[0], 3e-6, 1e-15);
  EXPECT_NEAR(place.orbit.half_peak_to_peak[1], 2e-6, 1e-15);
  ASSERT_TRUE(place.half.has_value());
  EXPECT_LT(place.orbit.twice.norm() + place.half->norm(), 1e-15);
  EXPECT_NEAR(place.at_end.x(), 5e-6, 1e-15);
  EXPECT_NEAR(turns[3].bearings[0].thinnest, 98e-6, 1e-12);
  EXPECT_FALSE(turns[0].places[0].half.has_value());
  EXPECT_FALSE(turns[7].places[0].half.has_value());
  EXPECT_NEAR(std::abs(turns[7].places[0].orbit.once[0]), 2e-6, 1e-15);
  // Whirl at half the frequency has no component at the full frequency.
  const std::vector<TransientTurn> whirling = turns_of(synthetic(0.5, 2e-6));
  ASSERT_TRUE(whirling[3].places[0].half.has_value());
  EXPECT_NEAR(std::abs((*whirling[3].places[0].half)[0]), 2e-6, 1e-15);
  EXPECT_LT(whirling[3].places[0].orbit.once.norm(), 1e-15);
}

TEST(Transient, TellsHarmonicsAfterARest) {
  const std::vector<TransientTurn> turns = turns_of(synthetic(1.0, 2e-6, 10));
  ASSERT_EQ(turns.size(), 7U);
  for (const std::size_t i : {0U, 1U, 6U}) {
    EXPECT_NEAR(std::abs(turns[i].places[0].orbit.once[0] - 2e-6), 0.0, 1e-14);
    EXPECT_NEAR(turns[i].places[0].orbit.mean[0], 3e-6, 1e-14);
  }
  const Waterfall waterfall = waterfall_of(synthetic(1.0, 2e-6, 10));
  ASSERT_EQ(waterfall.times.size(), 1U);
  EXPECT_NEAR(waterfall.amplitudes[4], 2e-6, 1e-14);
}

TEST(Transient, ShowsAWaveAtItsOrderWithItsAmplitude) {
  const Waterfall waterfall = waterfall_of(synthetic(0.5, 2e-6));
  ASSERT_EQ(waterfall.times.size(), 2U);
  ASSERT_EQ(waterfall.orders.size(), 33U);
  EXPECT_EQ(waterfall.orders[2], 0.5);
  for (std::size_t spectrum = 0; spectrum < 2; ++spectrum) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::size_t at = (2 * spectrum + axis) * 33;
      EXPECT_NEAR(waterfall.amplitudes[at + 2], 2e-6, 1e-14);
      EXPECT_NEAR(waterfall.amplitudes[at + 5], 0.0, 1e-14);
    }
  }
  EXPECT_NEAR(waterfall.speeds[0], 2.0 * std::numbers::pi / 0.032, 1e-9);
}

/// A sweep stores the last spectrum of each run, and marks runs without one.
TEST(Transient, LeavesItsLastSpectrumToASweep) {
  const TransientReading none(transient_not_begun(marched_case({turning(12000.0, 1.0)})));
  TransientResult result = synthetic(0.5, 2e-6);
  result.machine = none.result.machine;
  const TransientReading reading(std::move(result));
  const Dataset swept = swept_dataset(reading);
  const auto values = [](const Dataset& data, const std::string& name) {
    const auto found = std::find_if(data.variables.begin(), data.variables.end(),
                                    [&](const Variable& one) { return one.meaning.name == name; });
    return found->values();
  };
  const std::vector<double> last = values(swept, "last_spectrum_amplitude");
  ASSERT_EQ(last.size(), 2U * 33U);
  EXPECT_NEAR(last[33 + 2], 2e-6, 1e-14);
  EXPECT_TRUE(std::equal(last.begin(), last.end(), reading.waterfall.amplitudes.end() - 2 * 33));
  EXPECT_EQ(values(swept, "last_spectrum_speed"), std::vector<double>{reading.waterfall.speeds.back()});
  const std::vector<double> absent_ones = values(swept_dataset(none), "last_spectrum_amplitude");
  EXPECT_TRUE(std::all_of(absent_ones.begin(), absent_ones.end(), [](double one) { return std::isnan(one); }));
}

TEST(Transient, TellsRubsApart) {
  const std::vector<RubEvent> rubs = rubs_of(synthetic(1.0, 2e-6));
  ASSERT_EQ(rubs.size(), 1U);
  EXPECT_NEAR(rubs[0].begin, 0.040, 1e-12);
  EXPECT_NEAR(rubs[0].end, 0.049, 1e-12);
  EXPECT_NEAR(rubs[0].load, 0.99, 1e-12);
  const Case input = marched_case({turning(12000.0, 1.0)});
  TransientResult result = synthetic(1.0, 2e-6);
  result.machine = transient_not_begun(input).machine;
  const std::vector<std::string> lines = warning_lines(input, TransientReading(std::move(result)));
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.back(),
            "journals touch foils in 1 intervals: from 0.04 s on asperities of bearing 1 carry up to 0.99 N");
}

/// The table shows all of a few turns and some of many, from the first to the last.
TEST(Transient, ShowsTurnsAndRubsInATable) {
  TransientReading reading(synthetic(0.5, 2e-6));
  const auto lines = [&reading] {
    std::vector<std::string> found;
    std::istringstream table(transient_table(reading));
    for (std::string line; std::getline(table, line);) found.push_back(line);
    return found;
  };
  const std::vector<std::string> few = lines();
  constexpr std::size_t head = 4;  // a sentence, two lines of labels, and the units
  ASSERT_EQ(few.size(), head + 8U + 2U);
  const auto cells = [](const std::string& line) {
    std::vector<std::string> found;
    std::istringstream in(line);
    for (std::string cell; in >> cell;) found.push_back(cell);
    return found;
  };
  std::vector<std::string> fourth = cells(few[head + 3]);
  ASSERT_EQ(fourth.size(), 9U);
  fourth[3] = "";  // of the amplitude at the rotation frequency there is only round-off
  EXPECT_EQ(fourth,
            (std::vector<std::string>{"4", "128.00", "1875.0", "", "2.0000", "2.0000", "98.000", "0.010000", "0"}));
  EXPECT_EQ(few[head + 8], "rub, bearing 1: from 40 to 49 ms, 0.99 N at most");
  EXPECT_EQ(few[head + 9].find("energy of these revolutions, mJ: forces 0, films 0, "), 0U) << few[head + 9];
  // The motion at half the rotation frequency is unknown in the first turn.
  EXPECT_EQ(cells(few[head])[4], "-");
  reading.turns.insert(reading.turns.begin(), 40, reading.turns[3]);
  reading.turns.back().number = 48;
  reading.rubs.assign(12, reading.rubs.front());
  const std::vector<std::string> many = lines();
  ASSERT_EQ(many.size(), head + 24U + 10U + 3U);
  EXPECT_EQ(cells(many[head]), cells(few[head + 3]));
  EXPECT_EQ(cells(many[head + 23])[0], "48");
  EXPECT_EQ(many[head + 24], "all 48 revolutions are in the files");
  EXPECT_EQ(many[head + 35], "2 more rubs are in summary.json");
  reading.turns.clear();
  EXPECT_EQ(lines()[0], "no whole revolution");
}

/// Warnings name the bearing concerned.
TEST(Transient, WarnsOfEachBearing) {
  Case input = marched_case({turning(12000.0, 1.0)});
  RotorSettings& rotor = input.settings.get<RotorSettings>();
  rotor.bearings = {-0.05, 0.05};
  rotor.transverse_inertia = 4e-3;
  input.rotor_bearings.resize(2);
  TopFoil tight = input.top_foil;
  tight.formed_radius = {FormedTo::radius, 0.99 * input.bearing.radius};
  input.rotor_bearings[1].top_foil = tight;
  const std::vector<std::string> lines = warning_lines(input, TransientReading(transient_not_begun(input)));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].find("bearing 2: the top foil is formed tighter"), 0U) << lines[0];
}

TEST(Transient, SaysWhatIsWrongWithItsTable) {
  const auto errors = [](const std::vector<SpeedPhase>& speed) {
    return wrong_keys([&](Case& input) { input = marched_case(speed); });
  };
  EXPECT_EQ(errors({turning(12000.0, 1.0)}), Keys{});
  EXPECT_EQ(errors({}), Keys{"transient.speed"});
  EXPECT_EQ(errors({{.to = 0.0, .time = 1.0}}), (Keys{"transient.speed", "asperity"}));
  EXPECT_EQ(errors({{.to = 100.0, .time = 0.0}}), Keys{"transient.speed[1].time"});
  EXPECT_EQ(errors({{.from = 100.0, .to = -100.0, .time = 1.0}}), Keys{"transient.speed[1].to"});
  EXPECT_EQ(errors({{.to = 100.0, .time = 1.0}, {.from = 99.0, .to = 200.0, .time = 1.0}}),
            Keys{"transient.speed[2].from"});
  EXPECT_THROW(transient_not_begun(marched_case({{.from = 0.0, .to = 200.0, .time = 1.0}})), Error);
  Case input = marched_case({turning(12000.0, 1.0)});
  settings_of(input).pulses.push_back({.force = {1.0}, .begin = -1.0, .duration = 1.0});
  EXPECT_EQ(wrong_keys([&](Case& wrong) { wrong = input; }),
            (Keys{"transient.pulse[1].force", "transient.pulse[1].begin"}));
  settings_of(input).pulses = {{.force = {1.0, 0.0}, .begin = 0.0, .duration = 1.0, .at = "moon"}};
  EXPECT_THROW(transient_not_begun(input), Error);
  // Places of the rotor require a case without other errors.
  settings_of(input).pulses.push_back(settings_of(input).pulses.front());
  settings_of(input).pulses.front().at = "bearing 1";
  const std::vector<InputError> found = errors_of_run("transient", input);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "transient.pulse[2].at");
  input.bearing.axial_length = 0.0;
  EXPECT_TRUE(errors_of_run("transient", input).empty());
}

}  // namespace
}  // namespace bumpfoil
