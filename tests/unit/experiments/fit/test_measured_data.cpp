#include "experiments/fit/measured_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/rig_loops.hpp"

namespace bumpfoil {
namespace {

using test_support::few_bumps;

constexpr double to_middle = 0.75 * 3.141592653589793;

/// Unsorted rows, two of which have the same load and direction.
struct VibrationRow {
  Eigen::Vector2d load;
  double direction, amplitude;
};

const std::vector<VibrationRow> vibration_rows{{60.0 * unit_vector(to_middle), to_middle, 2e-6},
                                               {80.0 * unit_vector(to_middle), to_middle, 1e-6},
                                               {60.0 * unit_vector(to_middle), 2.0, 1e-6},
                                               {60.0 * unit_vector(to_middle), to_middle, 1e-6}};

FitData measured_rows(const std::vector<VibrationRow>& rows) {
  FitData data;
  data.experiment = FittedExperiment::vibration;
  for (const VibrationRow& row : rows) {
    data.column(FitColumn::amplitude).values.push_back(row.amplitude);
    data.column(FitColumn::direction).values.push_back(row.direction);
    data.column(FitColumn::load_x).values.push_back(row.load.x());
    data.column(FitColumn::load_y).values.push_back(row.load.y());
    data.column(FitColumn::loss_factor).values.push_back(0.1);
    data.column(FitColumn::stiffness).values.push_back(1e6);
  }
  data.column(FitColumn::loss_factor).std = 0.01;
  data.column(FitColumn::stiffness).std = 1e4;
  return data;
}

/// The response of foils without a machine, each row separately: stiffnesses, then loss factors, in the order of
/// columns.
std::vector<double> vibrations_alone(Case input, const std::vector<VibrationRow>& rows) {
  std::vector<double> stiffnesses;
  std::vector<double> loss_factors;
  for (const VibrationRow& row : rows) {
    input.settings.set(VibrationSettings{.loads = {row.load},
                                         .directions = {row.direction},
                                         .amplitudes = {row.amplitude},
                                         .frequencies = {1.0},
                                         .steps = 2});
    const Cycle cycle = run_vibration(input).vibrations.front().cycle;
    stiffnesses.push_back(*cycle.loaded_stiffness);
    loss_factors.push_back(*cycle.loss_factor);
  }
  stiffnesses.insert(stiffnesses.end(), loss_factors.begin(), loss_factors.end());
  return stiffnesses;
}

void expect_answers(const std::vector<double>& found, const std::vector<double>& expected, double part) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], part * std::abs(expected[i])) << i;
}

TEST(MeasuredData, VibrationsAreThoseOfTheirRows) {
  Case input = few_bumps(0.15, 28e-6);
  input.settings.set(VibrationSettings{
      .loads = {{0.0, -50.0}}, .motion = Motion::orbit, .directions = {}, .amplitudes = {5e-6}, .frequencies = {1.0}});
  const auto data = measured_vibrations(measured_rows(vibration_rows), input);
  const std::vector<double> alone = vibrations_alone(input, vibration_rows);
  const auto answer = data->answer(data->case_for(input), {});
  ASSERT_TRUE(answer);
  expect_answers(answer->fitted, alone, 1e-9);
  EXPECT_EQ(data->measured().series.size(), 3U);
  EXPECT_EQ(data->measured().points[3].series, 0U);
  EXPECT_EQ(data->measured().points[6].series, 2U);
  EXPECT_EQ(data->measured().points[3].quantity, 0U);
  EXPECT_EQ(data->measured().points[4].quantity, 1U);
}

TEST(MeasuredData, VibrationsAreAboutTheLoadOfTheirColumnsThenOfTheDataThenOfTheCase) {
  Case input = few_bumps(0.15, 28e-6);
  input.bump_foil.bumps = 26;  // bumps on all sides
  const Eigen::Vector2d of_case = 70.0 * unit_vector(to_middle);
  input.settings.set(
      VibrationSettings{.loads = {of_case}, .directions = {0.0}, .amplitudes = {1e-6}, .frequencies = {1.0}});
  const std::vector<VibrationRow> one{{of_case, to_middle, 1e-6}};
  FitData table = measured_rows(one);
  const auto answer_of = [&] {
    const auto data = measured_vibrations(table, input);
    return data->answer(data->case_for(input), {})->fitted;
  };
  table.column(FitColumn::load_y).values.clear();
  expect_answers(answer_of(), vibrations_alone(input, {{{of_case.x(), 0.0}, to_middle, 1e-6}}), 1e-9);
  table = measured_rows(one);
  table.column(FitColumn::load_x).values.clear();
  expect_answers(answer_of(), vibrations_alone(input, {{{0.0, of_case.y()}, to_middle, 1e-6}}), 1e-9);
  table.column(FitColumn::load_y).values.clear();
  table.column(FitColumn::direction).values.clear();
  table.direction = 2.0;
  expect_answers(answer_of(), vibrations_alone(input, {{of_case, 2.0, 1e-6}}), 1e-9);
  table.preload = PlaneTarget{Control::load, 50.0 * unit_vector(to_middle)};
  expect_answers(answer_of(), vibrations_alone(input, {{50.0 * unit_vector(to_middle), 2.0, 1e-6}}), 1e-9);
}

/// Foils and machine act in series: their compliances and energies add up; the machine dissipates nothing.
TEST(MeasuredData, VibrationsAreReadThroughTheMachine) {
  const Case input = few_bumps(0.15, 28e-6);
  constexpr double machine = 20e6;
  std::vector<VibrationRow> read = vibration_rows;
  const std::vector<double> alone = vibrations_alone(input, vibration_rows);
  std::vector<double> expected = alone;
  for (std::size_t row = 0; row < read.size(); ++row) {
    const double softer = 1.0 + alone[row] / machine;
    read[row].amplitude *= softer;
    expected[row] /= softer;
    expected[read.size() + row] /= softer;
  }
  const auto data = measured_vibrations(measured_rows(read), input);
  const auto answer = data->answer(data->case_for(input), {.machine_stiffness = machine});
  ASSERT_TRUE(answer);
  expect_answers(answer->fitted, expected, 1e-5);
}

/// Unsorted speeds and loads of a running bearing whose own settings differ from those of the data.
struct MeasuredPlaces {
  std::vector<double> speeds, loads, frequencies;
};

Case measured_bearing(FilmPath path) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
  input.solver.name = SolverName::events;
  input.settings.set(EquilibriumSettings{.speeds = {1.0}, .loads = {{1.0, 0.0}}, .path = path, .steps = 1});
  EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  equilibrium.positions = {{1e-6, 0.0}};
  equilibrium.frequencies = {123.0};
  equilibrium.limits = equilibrium.prefer_stable = true;
  return input;
}

const std::vector<FitColumn> running_columns{FitColumn::h_min, FitColumn::torque, FitColumn::x,
                                             FitColumn::y,     FitColumn::kxx,    FitColumn::cyx};

FitData measured_states(const MeasuredPlaces& table) {
  FitData data;
  data.experiment = FittedExperiment::equilibrium;
  data.column(FitColumn::speed).values = table.speeds;
  data.column(FitColumn::load_x).values = table.loads;
  data.column(FitColumn::frequency).values = table.frequencies;
  for (const FitColumn column : running_columns) {
    data.column(column).values.assign(table.speeds.size(), 1.0);
    data.column(column).std = 1.0;
  }
  return data;
}

/// Values of these columns for the states along one path.
std::vector<std::vector<double>> states_along(Case input, const std::vector<double>& speeds,
                                              const std::vector<double>& loads, double frequency, bool stuck) {
  input.solver.name = SolverName::newton;
  input.settings.set(EquilibriumSettings{.speeds = speeds,
                                         .path = input.settings.get<EquilibriumSettings>().path,
                                         .paths = ComparedPaths::one,
                                         .steps = 1});
  for (const double load : loads) input.settings.get<EquilibriumSettings>().loads.emplace_back(load, 0.0);
  if (frequency > 0.0) input.settings.get<EquilibriumSettings>().frequencies = {frequency};
  const EquilibriumResult result = run_equilibrium(input);
  std::vector<std::vector<double>> states;
  for (const RunningState& state : result.states) {
    const FilmWhirl& whirl = state.whirls.front();
    const auto& impedance = stuck ? *whirl.stuck_impedance : *whirl.impedance;
    states.push_back({state.outcome->thinnest.thickness * result.bearing->film->scales.thickness, state.outcome->torque,
                      state.last->position.x(), state.last->position.y(), impedance(0, 0).real(),
                      impedance(1, 0).imag() / whirl.frequency});
  }
  return states;
}

/// Values of all rows, in the order of columns. @param states  of each row
std::vector<double> by_columns(const std::vector<std::vector<double>>& states) {
  std::vector<double> all;
  for (std::size_t q = 0; q < running_columns.size(); ++q) {
    for (const std::vector<double>& state : states) all.push_back(state.at(q));
  }
  return all;
}

TEST(MeasuredData, EquilibriaAreThoseOfTheirRowsOnARampOfLoads) {
  const Case input = measured_bearing(FilmPath::load_ramp);
  const double slow = 4000.0;
  const double fast = 5000.0;
  const auto data = measured_equilibria(measured_states({{fast, slow, fast}, {40.0, 40.0, 50.0}, {}}));
  const Case own = data->case_for(input);
  EXPECT_EQ(own.solver.name, SolverName::newton);
  EXPECT_TRUE(own.settings.get<EquilibriumSettings>().positions.empty());
  EXPECT_FALSE(own.settings.get<EquilibriumSettings>().limits || own.settings.get<EquilibriumSettings>().prefer_stable);
  const auto answer = data->answer(own, {.x_origin = 1e-6, .y_origin = 2e-6, .torque_origin = 3e-3});
  ASSERT_TRUE(answer);
  const auto at_fast = states_along(input, {fast}, {40.0, 50.0}, 0.0, false);
  std::vector<std::vector<double>> states{at_fast[0], states_along(input, {slow}, {40.0}, 0.0, false)[0], at_fast[1]};
  for (std::vector<double>& state : states) {
    state[1] += 3e-3;
    state[2] += 1e-6;
    state[3] += 2e-6;
  }
  expect_answers(answer->fitted, by_columns(states), 1e-9);
  EXPECT_EQ(data->measured().axis, "Load");
  EXPECT_EQ(data->measured().series.size(), 2U);
}

/// Each frequency has its own path; contacts stick.
TEST(MeasuredData, EquilibriaAreThoseOfTheirRowsOnARampOfSpeeds) {
  const Case input = measured_bearing(FilmPath::speed_ramp);
  FitData table = measured_states({{4000.0, 5000.0, 5000.0}, {50.0, 50.0, 50.0}, {300.0, 300.0, 900.0}});
  table.contacts = FittedContacts::stuck;
  const auto data = measured_equilibria(table);
  const auto answer = data->answer(data->case_for(input), {});
  ASSERT_TRUE(answer);
  const auto ramp = states_along(input, {4000.0, 5000.0}, {50.0}, 300.0, true);
  const auto last = states_along(input, {5000.0}, {50.0}, 900.0, true);
  expect_answers(answer->fitted, by_columns({ramp[0], ramp[1], last[0]}), 1e-9);
  EXPECT_EQ(data->measured().axis, "Speed");
  EXPECT_EQ(data->measured().series,
            (std::vector<std::string>{"load (50, 0) N, 300 rad/s", "load (50, 0) N, 900 rad/s"}));
}

TEST(MeasuredData, EquilibriaAreDrawnOverWhatDiffersMost) {
  const auto data = measured_equilibria(measured_states({{5000.0, 5000.0}, {50.0, 50.0}, {300.0, 900.0}}));
  EXPECT_EQ(data->measured().axis, "Frequency");
  EXPECT_EQ(data->measured().points[1].at, 900.0);
  EXPECT_EQ(data->measured().series.size(), 1U);
}

/// If the bearing cannot carry the load, there is no state, and no values are invented.
TEST(MeasuredData, EquilibriaThatAreNotFoundAreNone) {
  Case input = measured_bearing(FilmPath::load_ramp);
  const auto data = measured_equilibria(measured_states({{5000.0}, {1e6}, {}}));
  input = data->case_for(input);
  input.settings.get<EquilibriumSettings>().steps = 1;
  EXPECT_FALSE(data->answer(input, {}));
}

}  // namespace
}  // namespace bumpfoil
