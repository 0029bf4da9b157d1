#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/fit/fit.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "experiments/fit/fit_output.hpp"
#include "experiments/fit/measured_table_csv.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/rig_loops.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::few_bumps;
using test_support::fitted;
using test_support::rig_loop;

void expect_within_errors(const FittedValue& found, double truth) {
  ASSERT_TRUE(found.standard_error);
  EXPECT_NEAR(found.value, truth, 4.0 * *found.standard_error);
}

const std::vector<double> amplitudes{1e-6, 2e-6, 4e-6};
constexpr int vibration_steps = 10;
constexpr double towards_middle = 0.75 * 3.141592653589793;

/// What a rig with a soft machine reads of vibrations about 60 N, with 1 % of noise.
FitData rig_vibrations(Case truth, double machine_stiffness) {
  const Eigen::Vector2d load = 60.0 * unit_vector(towards_middle);
  truth.settings.set(VibrationSettings{.loads = {load},
                                       .directions = {towards_middle},
                                       .amplitudes = amplitudes,
                                       .frequencies = {1.0},
                                       .steps = vibration_steps});
  FitData data;
  data.experiment = FittedExperiment::vibration;
  data.direction = towards_middle;
  data.preload = PlaneTarget{Control::load, load};
  std::mt19937_64 engine(21);
  std::normal_distribution<double> normal(1.0, 0.01);
  std::size_t i = 0;
  for (const Vibration& one : run_vibration(truth).vibrations) {
    const double softer = 1.0 + *one.cycle.loaded_stiffness / machine_stiffness;
    data.column(FitColumn::amplitude).values.push_back(amplitudes.at(i++) * softer);
    data.column(FitColumn::stiffness).values.push_back(*one.cycle.loaded_stiffness / softer * normal(engine));
    data.column(FitColumn::loss_factor).values.push_back(*one.cycle.loss_factor / softer * normal(engine));
  }
  data.column(FitColumn::stiffness).std = 0.01 * data.column(FitColumn::stiffness).values.front();
  data.column(FitColumn::loss_factor).std = 0.01 * data.column(FitColumn::loss_factor).values.front();
  return data;
}

TEST(FitTables, FindFrictionAndMachineFromVibrationsBesideALoop) {
  const Case truth = few_bumps(0.15, 28e-6);
  constexpr double machine = 20e6;
  FitData loop = rig_loop(run_cycles(truth), {.machine_stiffness = machine}, 0.5, 22);
  loop.direction = towards_middle;
  Case input = few_bumps(0.1, 28e-6);
  input.settings.set(VibrationSettings{.loads = {{0.0, -50.0}},
                                       .directions = {0.0},
                                       .amplitudes = {1e-6},
                                       .frequencies = {1.0},
                                       .steps = vibration_steps});
  const FitParameter friction = fitted("friction.coefficient", 0.1, 0.0, 0.5);
  input.settings.set(FitSettings{.data = {rig_vibrations(truth, machine), loop},
                                 .parameters = {friction, fitted("fit.machine_stiffness", 30e6, 5e6, 100e6)},
                                 .starts = 1});
  const FitResult both = run_fit(input);
  ASSERT_EQ(both.status, Status::converged);
  expect_within_errors(both.parameters[0], 0.15);
  expect_within_errors(both.parameters[1], machine);
  EXPECT_NEAR(both.reduced_chi_square(), 1.0, 0.6);
  ASSERT_EQ(both.data[0].points.size(), 2 * amplitudes.size());
  EXPECT_EQ(both.data[0].series, std::vector<std::string>{"load (-42.4264, 42.4264) N, along 135 deg"});
  EXPECT_EQ(both.data[0].quantities[1].column, FitColumn::loss_factor);
  EXPECT_EQ(parse_case(fitted_case_text(both), "case.toml", {.overrides = {}, .commands = {"cycle"}}), both.fitted);

  // Alone, on a rigid rig.
  input.settings.set(FitSettings{
      .data = {rig_vibrations(truth, std::numeric_limits<double>::infinity())}, .parameters = {friction}, .starts = 1});
  const FitResult alone = run_fit(input);
  expect_within_errors(alone.parameters[0], 0.15);
  EXPECT_LT(*both.parameters[0].standard_error, *alone.parameters[0].standard_error);
}

/// Foils that slide a little lose as much as foils that nearly stick: one loss factor has two frictions. Further starts
/// find the one that a prior prefers, and both are listed.
TEST(FitTables, FindTheDeeperOfTwoMinimaFromFurtherStarts) {
  FitData data = rig_vibrations(few_bumps(0.1, 28e-6), std::numeric_limits<double>::infinity());
  data.column(FitColumn::stiffness) = {};
  data.column(FitColumn::amplitude).values.resize(1);
  data.column(FitColumn::loss_factor).values.resize(1);
  FitParameter friction = fitted("friction.coefficient", 0.6, 0.02, 0.65);
  friction.mean = 0.1;
  Case input = few_bumps(0.1, 28e-6);
  const auto fit_from = [&](int starts, double loss_std, double prior_std) {
    data.column(FitColumn::loss_factor).std = loss_std;
    friction.std = prior_std;
    input.settings.set(FitSettings{.data = {data}, .parameters = {friction}, .starts = starts});
    return run_fit(input);
  };
  EXPECT_GT(fit_from(1, 0.004, 0.3).parameters[0].value, 0.5);
  const FitResult near = fit_from(5, 0.004, 0.3);
  EXPECT_NEAR(near.parameters[0].value, 0.1, 0.02);
  ASSERT_EQ(near.minima.size(), 2U);
  EXPECT_EQ(near.minima[0].values[0], near.parameters[0].value);
  EXPECT_GT(near.minima[1].values[0], 0.5);
  EXPECT_GT(near.minima[1].cost, near.minima[0].cost + 1.0);
  const FitResult far = fit_from(5, 0.002, 0.2);  // too much higher to be listed
  EXPECT_EQ(far.minima.size(), 1U);
  // The second start is the best of the sample points, not the first, which is near the other minimum.
  friction.start = 0.05;
  friction.mean = 0.55;
  EXPECT_LT(fit_from(1, 0.004, 0.3).parameters[0].value, 0.2);
  EXPECT_GT(fit_from(2, 0.004, 0.3).parameters[0].value, 0.5);
}

/// Of a rig that reads positions from elsewhere, with noise of the standard deviations.
FitData rig_equilibria(Case truth, double x_origin) {
  const double speed = speed_of_rpm(45000.0);
  truth.settings.set(EquilibriumSettings{.speeds = {speed}, .loads = {{40.0, 0.0}, {50.0, 0.0}}, .steps = 1});
  FitData data;
  data.experiment = FittedExperiment::equilibrium;
  std::mt19937_64 engine(23);
  std::normal_distribution<double> normal;
  const auto read = [&](FitColumn column, double value, double std) {
    data.column(column).values.push_back(value + std * normal(engine));
    data.column(column).std = std;
  };
  const EquilibriumResult result = run_equilibrium(truth);
  for (const RunningState& state : result.states) {
    const auto& impedance = *state.whirls.front().impedance;
    data.column(FitColumn::speed).values.push_back(state.requested.speed);
    data.column(FitColumn::load_x).values.push_back(state.requested.journal.x());
    read(FitColumn::h_min, state.outcome->thinnest.thickness * result.bearing->film->scales.thickness, 0.2e-6);
    read(FitColumn::torque, state.outcome->torque, 0.05e-3);
    read(FitColumn::x, state.last->position.x() + x_origin, 0.2e-6);
    read(FitColumn::kxx, impedance(0, 0).real(), 0.3e6);
    read(FitColumn::cyy, impedance(1, 1).imag() / state.whirls.front().frequency, 20.0);
  }
  return data;
}

TEST(FitTables, FindClearanceAndOriginFromEquilibria) {
  const auto bearing = [](double clearance) {
    Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
    input.bearing.radial_clearance = clearance;
    return input;
  };
  const FitData data = rig_equilibria(bearing(30e-6), 5e-6);
  Case input = bearing(31e-6);
  input.settings.set(EquilibriumSettings{.speeds = {1.0}, .loads = {{1.0, 0.0}}, .steps = 1});
  input.settings.set(FitSettings{.data = {data},
                                 .parameters = {fitted("bearing.radial_clearance", 31e-6, 25e-6, 35e-6),
                                                fitted("fit.data[1].x_origin", 0.0, -20e-6, 20e-6)},
                                 .starts = 1});
  const FitResult result = run_fit(input);
  ASSERT_EQ(result.status, Status::converged);
  expect_within_errors(result.parameters[0], 30e-6);
  expect_within_errors(result.parameters[1], 5e-6);
  EXPECT_LT(result.reduced_chi_square(), 3.0);
  const FittedData& measured = result.data[0];
  EXPECT_EQ(measured.axis, "Load");
  EXPECT_EQ(measured.series, std::vector<std::string>{"45000 rpm, load towards 0 deg"});
  ASSERT_EQ(measured.points.size(), 10U);
  EXPECT_EQ(measured.points[3].at, 50.0);
  EXPECT_NE(csv_text(fitted_points(result)).find("1,0,\"45000 rpm, load towards 0 deg\",h_min,m,Load,N,1,40,"),
            std::string::npos);
  const std::string table = fit_table(result);
  const std::size_t torque = table.find("equilibrium 1, torque: residual");
  ASSERT_NE(torque, std::string::npos) << table;
  EXPECT_NE(table.substr(torque, table.find('\n', torque) - torque)
                .find(" N mm at 2 points, noise of one reading 0.050000 N mm"),
            std::string::npos)
      << table;
}

TEST(FitTables, NameTheSolversThatAreUsed) {
  FitData loop;
  FitData film;
  film.experiment = FittedExperiment::equilibrium;
  const auto solvers = [](SolverName of_case, std::vector<FitData> data) {
    Case input;
    input.solver.name = of_case;
    input.settings.set(FitSettings{.data = std::move(data)});
    return experiment_named("fit").solvers(input);
  };
  EXPECT_EQ(solvers(SolverName::events, {loop}), "events");
  EXPECT_EQ(solvers(SolverName::events, {film}), "newton");
  EXPECT_EQ(solvers(SolverName::newton, {loop, film}), "newton");
  EXPECT_EQ(solvers(SolverName::events, {loop, film}), "events, newton with films");
}

/// Damping of a running bearing in which contacts slide, over their friction.
FitData damping_at(double friction) {
  Case truth = film_reference_case({.columns_per_pitch = 4, .rows = 3}, friction);
  truth.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {{40.0, 0.0}}, .steps = 1});
  const EquilibriumResult result = run_equilibrium(truth);
  const FilmWhirl& whirl = result.states.at(0).whirls.front();
  FitData data;
  data.experiment = FittedExperiment::equilibrium;
  data.column(FitColumn::speed).values = truth.settings.get<EquilibriumSettings>().speeds;
  data.column(FitColumn::load_x).values = {40.0};
  data.column(FitColumn::cyy).values = {(*whirl.impedance)(1, 1).imag() / whirl.frequency};
  data.column(FitColumn::cyy).std = 1.0;
  return data;
}

FitResult friction_of(const FitData& damping, double start) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, start);
  input.settings.set(EquilibriumSettings{.speeds = {1.0}, .loads = {{1.0, 0.0}}, .steps = 1});
  input.settings.set(
      FitSettings{.data = {damping}, .parameters = {fitted("friction.coefficient", start, 0.09, 0.12)}, .starts = 1});
  return run_fit(input);
}

/// Damping jumps when contacts start to slide: differences across the jump do not represent the slope, and all outputs
/// say so.
TEST(FitTables, TellNoStandardErrorAtAJump) {
  const auto damping = [](double friction) { return damping_at(friction).column(FitColumn::cyy).values.front(); };
  double before = 0.095;
  double beyond = 0.1;
  const double low = damping(before);
  const double high = damping(beyond);
  ASSERT_GT(high, 1.05 * low);
  while (beyond - before > 1e-6) {
    const double middle = 0.5 * (before + beyond);
    (damping(middle) < 0.5 * (low + high) ? before : beyond) = middle;
  }
  const FitResult at_jump = friction_of(damping_at(before), before);
  ASSERT_EQ(at_jump.parameters.size(), 1U);
  EXPECT_NEAR(at_jump.parameters[0].value, before, 1e-5);
  EXPECT_TRUE(at_jump.parameters[0].at_jump);
  EXPECT_FALSE(at_jump.parameters[0].at_bound);
  EXPECT_FALSE(at_jump.parameters[0].standard_error || at_jump.parameters[0].lower_95);
  ASSERT_EQ(fit_warnings(at_jump).size(), 1U);
  EXPECT_TRUE(fit_warnings(at_jump)[0].starts_with("the model jumps near the value of friction.coefficient"));
  EXPECT_NE(fit_table(at_jump).find("at a jump"), std::string::npos);
  EXPECT_NE(fitted_case_text(at_jump).find(", at a jump\n"), std::string::npos);
  const auto told = fit_lists(at_jump).at("parameters").at(0);
  EXPECT_EQ(told.at("at_jump"), true);
  EXPECT_TRUE(told.at("standard_error").is_null());

  // At 1 % of the bounds away, the model is smooth.
  const double beside = before - 3e-4;
  const FitResult smooth = friction_of(damping_at(beside), beside);
  EXPECT_FALSE(smooth.parameters.at(0).at_jump);
  EXPECT_TRUE(smooth.parameters[0].standard_error);
  EXPECT_TRUE(fit_warnings(smooth).empty());
}

/// Message of what reading a table says is wrong; empty where nothing is.
std::string refused_table(const test_support::TemporaryFolder& folder, const std::string& table, FitData data) {
  folder.write("table.csv", table);
  try {
    read_measured_table(folder.path() / "table.csv", data);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(FitTables, AreReadByNamesAndUnits) {
  const test_support::TemporaryFolder folder;
  folder.write("table.csv",
               "Drehzahl (1/min);load_x_N;Torque [N mm];Kxx (MN/m);cxx_N_s_per_m;note\n"
               "30000;50;4,5;2,5;200;ok\n# a comment\n45000;50;5,5;3;150;ok\n");
  FitData data;
  data.experiment = FittedExperiment::equilibrium;
  data.columns = "speed=Drehzahl [rpm]";
  data.column(FitColumn::torque).std = 1e-4;
  data.column(FitColumn::kxx).std = 1e5;
  const FitData given = data;
  EXPECT_NE(refused_table(folder, "speed_rpm;load_x_N;torque_N_mm\n1;2;3\n", given).find("kxx"), std::string::npos);
  folder.write("named.csv",
               "\"Drehzahl [rpm]\";load_x_N;Torque [N mm];Kxx (MN/m);cxx_N_s_per_m;note\n"
               "30000;50;4,5;2,5;200;ok\n# a comment\n45000;50;5,5;3;150;ok\n");
  read_measured_table(folder.path() / "named.csv", data);
  EXPECT_NEAR(data.column(FitColumn::speed).values.at(1), speed_of_rpm(45000.0), 1e-9);
  EXPECT_NEAR(data.column(FitColumn::torque).values.at(0), 4.5e-3, 1e-12);
  EXPECT_EQ(data.column(FitColumn::kxx).values.at(0), 2.5e6);
  EXPECT_TRUE(data.column(FitColumn::cxx).values.empty());  // has no standard deviation

  FitData vibrations;
  vibrations.experiment = FittedExperiment::vibration;
  vibrations.column(FitColumn::stiffness).std = 1e5;
  const auto error = refused_table(folder, "amplitude_um,stiffness_um\n1,2\n", vibrations);
  EXPECT_NE(error.find("table.csv:1"), std::string::npos) << error;
  EXPECT_NE(error.find("\"um\" is not a unit for a stiffness"), std::string::npos) << error;
  EXPECT_NE(refused_table(folder, "amplitude_um,load_x,stiffness_N/m\n1,2,3\n", vibrations).find("say its unit"),
            std::string::npos);
  EXPECT_NE(refused_table(folder, "amplitude_um,stiffness_N/m\n", vibrations).find("contains no row"),
            std::string::npos);
  // Of what is missing in the header, once: not again for every row.
  const auto without = refused_table(folder, "stiffness_N/m\n-\n-\n", vibrations);
  EXPECT_NE(without.find("has no amplitude_um"), std::string::npos) << without;
  EXPECT_EQ(without.find("table.csv:2"), std::string::npos) << without;
  FitData by_other_names = vibrations;
  EXPECT_EQ(refused_table(folder, "Amp (um);K (MN/m)\n1;2\n", by_other_names), "");
  FitData running;
  running.experiment = FittedExperiment::equilibrium;
  running.column(FitColumn::torque).std = 1e-4;
  EXPECT_EQ(refused_table(folder, "Drehzahl (rpm);Reibmoment (N mm)\n1;2\n", running), "");
  EXPECT_NE(refused_table(folder, "Reibmoment (N mm)\n2\n", running).find("has no speed_rpm"), std::string::npos);
  const auto gap = refused_table(folder, "amplitude_um,stiffness_N/m\n1,2\n2,\n", vibrations);
  EXPECT_NE(gap.find("table.csv:3"), std::string::npos) << gap;
}

TEST(FitTables, AreChecked) {
  const auto refusal = [](const std::string& data,
                          const std::string& parameter = "friction.coefficient") -> std::string {
    const std::string text = case_template("gen1") + "\n[fit]\n[[fit.data]]\n" + data +
                             "\n[[fit.parameter]]\nkey = \"" + parameter + "\"\nstart = 0\nlower = 0\nupper = 1\n";
    try {
      const Case input = parse_case(text, "case.toml", {.overrides = {}, .commands = {"fit"}});
      EXPECT_EQ(parse_case(case_to_toml(input), "written"), input);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto expect_refusal = [&refusal](const std::string& data, const std::string& words,
                                         const std::string& parameter = "friction.coefficient") {
    const std::string said = refusal(data, parameter);
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  const std::string vibration = "experiment = \"vibration\"\npreload = [\"0 N\", \"-50 N\"]\n";
  const std::string readings = "readings = { amplitude = [\"1 um\", \"2 um\"], loss_factor = [0.4, 0.3] }\n";
  EXPECT_EQ(refusal(vibration + "loss_factor_std = 0.01\n" + readings), "");
  EXPECT_EQ(refusal(vibration + "loss_factor_std = 0.01\n" + readings, "fit.data[1].machine_stiffness"), "");
  expect_refusal(vibration + "loss_factor_std = 0.01\n" + readings, "no effect", "fit.data[1].force_drift");
  expect_refusal(vibration + readings, "only if its standard deviation");
  expect_refusal(vibration + "stiffness_std = \"1 MN/m\"\nloss_factor_std = 0.01\n" + readings, "without readings");
  expect_refusal(vibration + "h_min_std = \"1 um\"\nloss_factor_std = 0.01\n" + readings, "does not apply to data");
  expect_refusal(vibration + "loss_factor_std = -1\n" + readings, "must be positive");
  expect_refusal("experiment = \"vibration\"\nloss_factor_std = 0.01\n" + readings, "not a load");
  expect_refusal(
      vibration + "loss_factor_std = 0.01\nreadings = { amplitude = [\"1 um\"], loss_factor = [0.4, 0.3] }\n",
      "not as many");
  expect_refusal(
      "experiment = \"equilibrium\"\nh_min_std = \"1 um\"\nreadings = { speed = [\"9000 rpm\"], h_min = [\"9 um\"] }\n",
      "static load");
  expect_refusal("experiment = \"equilibrium\"\nh_min_std = \"1 um\"\n", "readings.speed");
  const std::string second = "[[fit.parameter]]\nkey = \"bearing.weld_angle\"\nstart = 0\nlower = -1\nupper = 1\n";
  const std::string one = vibration + "stiffness_std = 1e6\nreadings = { amplitude = [1e-6], stiffness = [1e7] }\n";
  expect_refusal(one + second, "fit.parameter = 2: are more than the measured values, 1");
  EXPECT_EQ(refusal(one + second + "mean = 0\nstd = 1\n").find("fit.parameter"), std::string::npos);
  expect_refusal(vibration + "force_origin = \"1 N\"\nloss_factor_std = 0.01\n" + readings,
                 "fit.data[1].force_origin = 1 N: has no effect on data of the experiment \"vibration\"");
  expect_refusal(
      vibration + "loss_factor_std = 0.01\nreadings = { amplitude = [1e-6, 2e-6], loss_factor = [0.4, nan] }\n",
      "fit.data[1].readings.loss_factor[2] = nan: is not finite");
}

}  // namespace
}  // namespace bumpfoil
