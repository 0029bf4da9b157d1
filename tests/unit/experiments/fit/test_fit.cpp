#include "bumpfoil/experiments/fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/validation.hpp"
#include "experiments/fit/fit_output.hpp"
#include "support/rig_loops.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::few_bumps;
using test_support::fit_of;
using test_support::fitted;
using test_support::rig_loop;

const FitParameter any_friction = fitted("friction.coefficient", 0.1, 0.0, 0.5);
const FitParameter any_clearance = fitted("bearing.radial_clearance", 30e-6, 20e-6, 40e-6);

/// Within four standard errors.
void expect_found(const FittedValue& found, double truth) {
  ASSERT_TRUE(found.standard_error);
  EXPECT_NEAR(found.value, truth, 4.0 * *found.standard_error);
  EXPECT_LT(*found.lower_95, found.value);
  EXPECT_GT(*found.upper_95, found.value);
}

bool warns(const FitResult& result, const std::string& words) {
  const std::vector<std::string> lines = fit_warnings(result);
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(Fit, FindsBearingAndRigBehindNoise) {
  const Rig rig{.force_origin = 2.0, .force_drift = 3.0, .machine_stiffness = 20e6};
  const FitData data = rig_loop(run_cycles(few_bumps(0.15, 28e-6)), rig, 0.5, 1);
  const FitResult result = run_fit(fit_of(
      few_bumps(0.1, 31.8e-6), data,
      {any_friction, any_clearance, fitted("fit.machine_stiffness", 50e6, 5e6, 200e6),
       fitted("fit.data[1].force_origin", 0.0, -10.0, 10.0), fitted("fit.data[1].force_drift", 0.0, -10.0, 10.0)}));
  ASSERT_EQ(result.status, Status::converged);
  expect_found(result.parameters[0], 0.15);
  expect_found(result.parameters[1], 28e-6);
  expect_found(result.parameters[2], 20e6);
  expect_found(result.parameters[3], 2.0);
  expect_found(result.parameters[4], 3.0);
  EXPECT_LT(*result.parameters[0].standard_error, 0.01);
  EXPECT_NEAR(result.data[0].quantities[0].noise, 0.5, 0.1);
  EXPECT_NEAR(result.reduced_chi_square(), 1.0, 0.6);
  EXPECT_FALSE(warns(result, "does not explain"));
  EXPECT_EQ(result.fitted.friction.bump_sleeve, result.parameters[0].value);
  EXPECT_EQ(result.fitted.bearing.radial_clearance, result.parameters[1].value);
  EXPECT_EQ(parse_case(fitted_case_text(result), "case.toml", {.overrides = {}, .commands = {"cycle"}}), result.fitted);
}

TEST(Fit, ReadsWhereTheDisplacementIsCountedFrom) {
  const Rig rig{.displacement_origin = 3e-6, .displacement_drift = 1e-6};
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), rig, 0.2, 2);
  const FitResult result = run_fit(fit_of(few_bumps(0.1, 28e-6), data,
                                          {fitted("fit.data[1].displacement_origin", 0.0, -10e-6, 10e-6),
                                           fitted("fit.data[1].displacement_drift", 0.0, -10e-6, 10e-6)}));
  expect_found(result.parameters[0], 3e-6);
  expect_found(result.parameters[1], 1e-6);
}

TEST(Fit, ProfilesRiseAsTheStandardErrorsSay) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.15, 28e-6)), {}, 0.5, 13);
  Case input = fit_of(few_bumps(0.1, 30e-6), data, {any_friction, any_clearance});
  EXPECT_TRUE(run_fit(input).parameters[0].profile.empty());
  input.settings.get<FitSettings>().profile = true;
  const FitResult result = run_fit(input);
  for (const FittedValue& found : result.parameters) {
    const double error = *found.standard_error;
    ASSERT_EQ(found.profile.size(), 13U);
    EXPECT_NEAR(found.profile.front().value, found.value - 3.0 * error, 1e-9 * found.value);
    EXPECT_NEAR(found.profile.back().value, found.value + 3.0 * error, 1e-9 * found.value);
    EXPECT_EQ(found.profile[6].cost, 0.0);
    for (const FitProfilePoint& point : found.profile) {
      // Kinks and the step of the differences make the parabola of the standard errors a little wider or narrower.
      EXPECT_NEAR(std::sqrt(std::max(0.0, point.cost)), std::abs(point.value - found.value) / error, 0.6);
    }
    EXPECT_NEAR(*found.profile_lower_95, *found.lower_95, 0.4 * error);
    EXPECT_NEAR(*found.profile_upper_95, *found.upper_95, 0.4 * error);
  }
}

/// Bounds lie within a standard error.
TEST(Fit, ProfilesStayOpenAtBounds) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.15, 28e-6)), {}, 50.0, 13);
  Case input = fit_of(few_bumps(0.15, 28e-6), data, {fitted("friction.coefficient", 0.15, 0.145, 0.155)});
  input.settings.get<FitSettings>().profile = true;
  const FittedValue found = run_fit(input).parameters[0];
  EXPECT_GT(found.profile.size(), 6U);
  EXPECT_FALSE(found.profile_lower_95);
  EXPECT_FALSE(found.profile_upper_95);
}

TEST(Fit, ProfilesAreWideWhereHardlyMoreThanASumIsSeen) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 3);
  const FitParameter clearance = fitted("bearing.radial_clearance", 28e-6, 26e-6, 30e-6);
  // Infinite if open on a side.
  const auto width = [&](const std::vector<FitParameter>& parameters) {
    Case input = fit_of(few_bumps(0.1, 28e-6), data, parameters);
    input.settings.get<FitSettings>().profile = true;
    const FittedValue found = run_fit(input).parameters[0];
    return found.profile_upper_95.value_or(1.0) - found.profile_lower_95.value_or(-1.0);
  };
  const double alone = width({clearance});
  EXPECT_LT(alone, 0.5e-6);
  EXPECT_GT(width({clearance, fitted("fit.data[1].displacement_origin", 0.0, -10e-6, 10e-6)}), 3.0 * alone);
}

/// Noise of the displacement counts by the slope of the loop.
TEST(Fit, WeighsByTheNoiseOfTheDisplacement) {
  constexpr double noise = 0.2e-6;
  FitData data = rig_loop(run_cycles(few_bumps(0.15, 28e-6)), {}, 0.1, 14);
  std::mt19937_64 engine(15);
  std::normal_distribution<double> normal(0.0, noise);
  for (double& displacement : data.displacements) displacement += normal(engine);
  data.force_std = 0.1;
  const auto fit_with = [&](double std) {
    data.displacement_std = std;
    return run_fit(fit_of(few_bumps(0.1, 30e-6), data, {any_friction, any_clearance}));
  };
  const FitResult unweighed = fit_with(0.0);
  EXPECT_TRUE(warns(unweighed, "does not explain"));
  const FitResult result = fit_with(noise);
  EXPECT_NEAR(result.reduced_chi_square(), 1.0, 0.5);
  EXPECT_FALSE(warns(result, "does not explain"));
  expect_found(result.parameters[0], 0.15);
  expect_found(result.parameters[1], 28e-6);
  // Before the journal touches the foils there is no slope, and the noise is that of the force alone.
  const std::vector<FittedPoint>& points = result.data[0].points;
  EXPECT_NEAR(points.front().std, 0.1 / std::sqrt(points.front().readings), 1e-6);
  // Under load, well before the journal turns, where the loop is smooth.
  const std::size_t middle = points.size() * 2 / 5;
  const FittedPoint& before = points[middle - 3];
  const FittedPoint& after = points[middle + 3];
  const double slope = (after.fitted - before.fitted) / (after.at - before.at);
  EXPECT_GT(slope * noise, 0.5);
  EXPECT_NEAR(points[middle].std * std::sqrt(points[middle].readings), std::hypot(0.1, slope * noise),
              0.15 * slope * noise);
}

TEST(Fit, NamesWhatOnlyASumIsSeenOf) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 3);
  const FitResult result =
      run_fit(fit_of(few_bumps(0.1, 28e-6), data,
                     {any_friction, any_clearance, fitted("fit.data[1].displacement_origin", 0.0, -10e-6, 10e-6)}));
  EXPECT_TRUE(
      warns(result, "bearing.radial_clearance and fit.data[1].displacement_origin: only their sum can be identified"));
  EXPECT_LT(result.correlation(1, 2), -0.9);
  EXPECT_NEAR(result.correlation(1, 1), 1.0, 1e-12);
}

/// A prior is not information from the data: it resolves the ambiguity, but the remark on the data stays.
TEST(Fit, NamesWhatOnlyASumIsSeenOfBesideAPrior) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 3);
  FitParameter origin = fitted("fit.data[1].displacement_origin", 0.0, -10e-6, 10e-6);
  origin.mean = 0.0;
  origin.std = 1e-9;
  const FitResult result = run_fit(fit_of(few_bumps(0.1, 28e-6), data, {any_clearance, origin}));
  EXPECT_TRUE(
      warns(result, "bearing.radial_clearance and fit.data[1].displacement_origin: only their sum can be identified"));
  EXPECT_NEAR(*result.parameters[1].standard_error, 1e-9, 0.3e-9);
}

TEST(Fit, TellsThatInterfacesAreHardlySeparable) {
  Case truth = few_bumps(0.1, 28e-6);
  truth.friction = {.top_bump = 0.1, .bump_sleeve = 0.2};
  const FitData data = rig_loop(run_cycles(truth), {}, 0.5, 4);
  const FitResult result =
      run_fit(fit_of(few_bumps(0.1, 28e-6), data,
                     {fitted("friction.top_bump", 0.2, 0.0, 0.5), fitted("friction.bump_sleeve", 0.1, 0.0, 0.5)}));
  EXPECT_TRUE(warns(result, "friction.top_bump and friction.bump_sleeve"));
  EXPECT_LT(result.correlation(0, 1), -0.9);
}

TEST(Fit, TellsAModelThatTheDataContradict) {
  Case truth = few_bumps(0.1, 28e-6);
  truth.bump_foil.model = BumpFoilModel::frame;
  const FitData data = rig_loop(run_cycles(truth), {}, 0.2, 5);
  Case wrong = truth;
  wrong.bump_foil.model = BumpFoilModel::truss;
  const FitResult of_wrong = run_fit(fit_of(wrong, data, {any_friction, any_clearance}));
  EXPECT_TRUE(warns(of_wrong, "does not explain the data"));
  EXPECT_GT(of_wrong.reduced_chi_square(), 2.0);
  const FitResult of_right = run_fit(fit_of(truth, data, {any_friction, any_clearance}));
  EXPECT_FALSE(warns(of_right, "does not explain the data"));
}

TEST(Fit, TellsParametersAtABound) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.15, 28e-6)), {}, 0.5, 6);
  const FitResult result =
      run_fit(fit_of(few_bumps(0.1, 28e-6), data, {fitted("friction.coefficient", 0.05, 0.0, 0.12), any_clearance}));
  EXPECT_TRUE(result.parameters[0].at_bound);
  EXPECT_EQ(result.parameters[0].value, 0.12);
  EXPECT_FALSE(result.parameters[0].standard_error);
  EXPECT_TRUE(result.parameters[1].standard_error);
  EXPECT_TRUE(warns(result, "friction.coefficient lies at a bound"));
  EXPECT_EQ(result.degrees_of_freedom, std::ssize(result.data[0].points) - 1);
  const FittedValue lower =
      run_fit(fit_of(few_bumps(0.1, 28e-6), data, {fitted("friction.coefficient", 0.3, 0.2, 0.4)})).parameters[0];
  EXPECT_TRUE(lower.at_bound);
  EXPECT_EQ(lower.value, 0.2);
  EXPECT_FALSE(lower.standard_error);
}

TEST(Fit, LetsAPriorDecideWhereDataDoNot) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 7);
  FitParameter known = fitted("bearing.weld_angle", 3.1, 3.0, 3.3);
  known.mean = 3.15;
  known.std = 1e-4;
  const FitResult result = run_fit(fit_of(few_bumps(0.1, 28e-6), data, {any_friction, known}));
  EXPECT_NEAR(result.parameters[1].value, 3.15, 5e-4);
  EXPECT_LT(*result.parameters[1].standard_error, 2e-4);
}

/// What is known of a rig is given: it counts as if it had been found.
TEST(Fit, TakesWhatIsGivenOfARig) {
  const Rig rig{.force_origin = 5.0, .machine_stiffness = 20e6};
  FitData data = rig_loop(run_cycles(few_bumps(0.15, 28e-6)), rig, 0.2, 16);
  data.rig.force_origin = 5.0;
  Case input = fit_of(few_bumps(0.1, 28e-6), data, {any_friction, any_clearance});
  input.settings.get<FitSettings>().machine_stiffness = 20e6;
  const FitResult of_all = run_fit(input);
  expect_found(of_all.parameters[0], 0.15);
  expect_found(of_all.parameters[1], 28e-6);
  EXPECT_FALSE(warns(of_all, "does not explain"));
  // That of the data comes before that of all.
  FitSettings& fit = input.settings.get<FitSettings>();
  fit.machine_stiffness = 5e6;
  fit.data[0].rig.machine_stiffness = 20e6;
  EXPECT_EQ(run_fit(input).parameters[0].value, of_all.parameters[0].value);
}

/// A prior is a residual like those of the data.
TEST(Fit, CountsPriorsInChiSquare) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 7);
  FitParameter wrong = any_friction;
  wrong.mean = 0.12;
  wrong.std = 0.002;
  const FitResult result = run_fit(fit_of(few_bumps(0.1, 28e-6), data, {wrong}));
  const double prior = std::pow((result.parameters[0].value - 0.12) / 0.002, 2);
  EXPECT_GT(prior, 10.0);
  double all = prior;
  double squares = 0.0;
  const std::vector<FittedPoint>& points = result.data[0].points;
  for (const FittedPoint& point : points) {
    all += std::pow((point.fitted - point.measured) / point.std, 2);
    squares += std::pow(point.fitted - point.measured, 2);
  }
  EXPECT_NEAR(result.chi_square, all, 1e-9 * all);
  EXPECT_EQ(result.degrees_of_freedom, std::ssize(points));  // and one for the prior, less one for the parameter
  EXPECT_NEAR(result.data[0].quantities[0].residual, std::sqrt(squares / static_cast<double>(points.size())), 1e-9);
  EXPECT_GT(result.runs, 3U);
}

TEST(Fit, IsNotMisledByOutliersWithHubersLoss) {
  FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.2, 8);
  for (std::size_t i = 160; i < 190; ++i) data.forces[i] += 20.0;
  Case input = fit_of(few_bumps(0.1, 28e-6), data, {any_friction});
  const double misled = run_fit(input).parameters[0].value;
  input.settings.get<FitSettings>().huber = 1.345;
  const FitResult robust = run_fit(input);
  EXPECT_LT(std::abs(robust.parameters[0].value - 0.1), 0.3 * std::abs(misled - 0.1));
  // Outliers count by less in chi-square, and so in the standard errors.
  double plain = 0.0;
  for (const FittedPoint& point : robust.data[0].points)
    plain += std::pow((point.fitted - point.measured) / point.std, 2);
  EXPECT_LT(robust.chi_square, 0.2 * plain);
}

TEST(Fit, FitsStripsAndReversedCycles) {
  Case strip = few_bumps(0.12, 28e-6);
  strip.settings.set(StripSettings{.bumps = 6, .amplitude = {Control::displacement, 10e-6}, .steps = 150});
  FitData data = rig_loop(run_strip(strip), {}, 0.2, 9);
  data.experiment = FittedExperiment::strip;
  expect_found(run_fit(fit_of(strip, data, {any_friction})).parameters[0], 0.12);

  Case preloaded = few_bumps(0.12, 28e-6);
  CycleSettings& cycle = preloaded.settings.get<CycleSettings>();
  cycle.preload = PlaneTarget{Control::displacement, {-30e-6, 30e-6}};
  cycle.amplitude.value = 8e-6;
  cycle.cycles = 5;
  FitData swing = rig_loop(run_cycles(preloaded), {}, 0.2, 10);
  for (double& s : swing.displacements) s -= std::hypot(30e-6, 30e-6);  // rigs count from the preload
  expect_found(run_fit(fit_of(preloaded, swing, {any_friction})).parameters[0], 0.12);
}

/// Strips have neither radius nor clearance; those that `bumpfoil strip` computed are read as they are.
TEST(Fit, FitsStripsWithoutABearing) {
  const std::string strip = case_template("larsen-strip");
  const Case truth = parse_case(strip, "", {.overrides = {}, .commands = {"strip"}});
  ASSERT_TRUE(truth.bearing.is_flat());
  const test_support::TemporaryFolder folder;
  std::string csv = "cycle,displacement_um,force_direct_N\n";
  const CycleResult computed = run_strip(truth);
  for (const Increment& increment : computed.cycles.back().increments) {
    csv += "2," + std::to_string(increment.displacement * 1e6) + ',' + std::to_string(increment.force_direct) + '\n';
  }
  folder.write("strip.csv", csv);
  const auto read = [&](const std::string& experiment) {
    return parse_case(strip + "\n[[fit.data]]\nfile = \"strip.csv\"\nexperiment = \"" + experiment +
                          "\"\n\n[[fit.parameter]]\nkey = \"friction.coefficient\"\nstart = 0.3\nlower = 0.0\n"
                          "upper = 0.5\n",
                      folder.path() / "case.toml", {.overrides = {"fit.starts=1"}, .commands = {"fit"}});
  };
  const FitResult result = run_fit(read("strip"));
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_NEAR(result.parameters[0].value, truth.friction.top_bump, 1e-3);
  EXPECT_EQ(parse_case(fitted_case_text(result), "case.toml", {.overrides = {}, .commands = {"strip"}}), result.fitted);
  try {
    read("cycle");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("fit.data[1].experiment = cycle: needs a bearing"), std::string::npos)
        << error.what();
  }
}

TEST(Fit, SaysWhichColumnsToNameInTheCase) {
  const test_support::TemporaryFolder folder;
  folder.write("loop.csv", "s (um),Channel 4\n0,0\n");
  try {
    parse_case(case_template("gen1") + "\n[[fit.data]]\ncolumns = \"displacement=s\"\nfile = \"loop.csv\"\n",
               folder.path() / "case.toml", {.overrides = {}, .commands = {"fit"}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("for another name use columns = \"force=NAME [N]\""), std::string::npos)
        << error.what();
  }
}

TEST(Fit, IsReadFromCaseFiles) {
  const test_support::TemporaryFolder folder;
  folder.write(
      "loop.csv",
      "Weg (um);Kraft (N);direction\n0;0;90\n1;1,5;90\n2;3;90\n3;4;90\n4;5;90\n3;3;90\n2;1;90\n1;0;90\n0;0;90\n");
  const std::string text =
      case_template("gen1") + "\n[fit]\n[[fit.data]]\ndirection = \"90 deg\"\nfile = \"loop.csv\"\n";
  const auto read = [&](const std::string& parameter) {
    return parse_case(text + "[[fit.parameter]]\n" + parameter, folder.path() / "case.toml",
                      {.overrides = {}, .commands = {"fit"}});
  };
  const std::string clearance =
      "key = \"bearing.radial_clearance\"\nstart = \"30 um\"\nlower = 0\nupper = \"0.1 mm\"\n";
  const Case input = read(clearance);
  const FitSettings& fit = input.settings.get<FitSettings>();
  EXPECT_EQ(fit.data[0].forces[1], 1.5);
  EXPECT_NEAR(fit.data[0].displacements[4], 4e-6, 1e-18);
  EXPECT_NEAR(fit.parameters[0].start, 30e-6, 1e-18);
  EXPECT_EQ(parse_case(case_to_toml(input), "written"), input);
  const auto refusal = [&](const std::string& parameter) -> std::string {
    try {
      read(parameter);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const std::string numbers = "start = 1\nlower = 0\nupper = 2\n";
  EXPECT_NE(refusal("key = \"friction.coeficient\"\n" + numbers).find("friction.coefficient"), std::string::npos);
  EXPECT_NE(refusal("key = \"bump_foil.bumps\"\n" + numbers).find("can be fitted"), std::string::npos);
  const std::string misspelt =
      refusal("key = \"bearing.radial_clearence\"\nstart = \"30 um\"\nlower = 0\nupper = \"0.1 mm\"\n");
  EXPECT_NE(misspelt.find("bearing.radial_clearance"), std::string::npos);
  EXPECT_EQ(misspelt.find("start"), std::string::npos) << misspelt;
  EXPECT_NE(refusal("key = \"fit.data[2].force_origin\"\n" + numbers).find("missing data"), std::string::npos);
  EXPECT_NE(refusal("key = \"fit.data[1].force_origin\"\nstart = 3\nlower = 0\nupper = 2\n").find("outside"),
            std::string::npos);
  EXPECT_THROW(parse_case(text + "experiment = \"strip\"\n[[fit.parameter]]\n" + clearance, folder.path() / "case.toml",
                          {.overrides = {}, .commands = {"fit"}}),
               Error);
  EXPECT_NE(refusal("key = \"friction.coefficient\"\nstart = \"1 um\"\nlower = 0\nupper = 2\n").find("start"),
            std::string::npos);
}

/// All errors of a loop and its parameters come at once.
TEST(Fit, RefusesNumbersThatSayNothing) {
  const std::string flat =
      case_template("gen1") +
      "\n[[fit.data]]\ndisplacements = [0, 1e-6, 2e-6, 3e-6, 4e-6, 3e-6, 2e-6, 0]\nforces = [5, 5, 5, 5, 5, 5, 5, 5]\n"
      "machine_stiffness = 5e7\ntorque_origin = 1\n"
      "[[fit.data]]\ndisplacements = [0, 1e-6, 2e-6, 3e-6, 4e-6, 3e-6, nan, 0]\nforces = [0, 1, 2, 3, 4, 3, 2, 0]\n"
      "[[fit.parameter]]\nkey = \"friction.coefficient\"\nstart = 0.1\nlower = 0\nupper = inf\n";
  std::string said;
  try {
    parse_case(flat, "case.toml", {.overrides = {}, .commands = {"fit"}});
  } catch (const Error& error) {
    said = error.what();
  }
  for (const char* const part : {"fit.data[1].forces: are all the same",
                                 "fit.data[1].torque_origin = 1: has no effect on data of the experiment "
                                 "\"cycle\"",
                                 "fit.data[2].displacements[7] = nan", "fit.parameter[1].upper = inf: is not finite"}) {
    EXPECT_NE(said.find(part), std::string::npos) << part << said;
  }
  EXPECT_EQ(said.find("machine_stiffness:"), std::string::npos) << said;
}

TEST(Fit, NeedsDataAndParameters) {
  Case input = reference_case();
  input.settings.set(FitSettings{});
  std::vector<std::string> keys;
  for (const InputError& error : find_errors(input, {"fit"})) keys.push_back(error.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"fit.data", "fit.parameter"}));
}

TEST(Fit, RefusesStartsThatCannotBeRun) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 11);
  EXPECT_THROW(run_fit(fit_of(few_bumps(0.1, 28e-6), data, {fitted("bump_foil.height", 1e-6, 1e-6, 2e-6)})), Error);
}

TEST(Fit, StopsWhenAsked) {
  const FitData data = rig_loop(run_cycles(few_bumps(0.1, 28e-6)), {}, 0.5, 12);
  const FitResult result =
      run_fit(fit_of(few_bumps(0.1, 28e-6), data, {any_friction}, 3), [](double) { return false; });
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_GT(result.runs, 0U);
}

}  // namespace
}  // namespace bumpfoil
