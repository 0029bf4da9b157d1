#include "bumpfoil/optimise/optimise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "optimise/optimise_output.hpp"
#include "support/rig_loops.hpp"

namespace bumpfoil {
namespace {

using test_support::few_bumps;

const OptimisedKey any_clearance{.key = "bearing.radial_clearance", .lower = 20e-6, .upper = 45e-6};

Case optimised(OptimiseSettings settings, double friction = 0.1) {
  Case input = few_bumps(friction, 30e-6);
  input.settings.get<CycleSettings>().steps = 20;
  settings.command = settings.bearing_limits.empty() ? "cycle" : "montecarlo";
  input.settings.set(std::move(settings));
  return input;
}

double force_at(double clearance) {
  Case input = few_bumps(0.1, clearance);
  input.settings.get<CycleSettings>().steps = 20;
  return run_cycles(input).cycles.front().turning_point->max_force;
}

const OptimisePoint& best_of(const OptimiseResult& result) {
  return result.points.at(result.best.value());
}

/// Force and energy of a loop fall with the clearance: the least energy is where the force is at its limit.
TEST(Optimise, EndsAtTheLimitThatBisectionFinds) {
  const double least_force = force_at(32e-6);
  double low = any_clearance.lower;
  double high = any_clearance.upper;
  while (high - low > 1e-12) (force_at(0.5 * (low + high)) > least_force ? low : high) = 0.5 * (low + high);
  const OptimiseSettings settings{.minimise = {"loop_energy"},
                                  .limits = {"max_force > " + std::to_string(least_force)},
                                  .evaluations = 60,
                                  .starts = 2,
                                  .keys = {any_clearance}};
  const OptimiseResult result = run_optimise(optimised(settings));
  EXPECT_EQ(result.status, OptimiseStatus::converged);
  EXPECT_TRUE(optimise_failures(result).empty());
  // The tolerance of the search is 1e-3 of the bounds, and its margin from the limit 1e-4: twice the tolerance.
  EXPECT_NEAR(best_of(result).values[0], low, 2e-3 * (any_clearance.upper - any_clearance.lower));
  EXPECT_LT(best_of(result).values[0], low);
  EXPECT_TRUE(result.is_feasible(best_of(result)));
  EXPECT_TRUE(result.is_active(0));
  EXPECT_EQ(result.bound_of(0), 0);
  EXPECT_LE(std::ssize(result.points), 60);
  EXPECT_EQ(result.points.front().values[0], 30e-6);
  // The written case gives the same.
  const Case again = parse_case(optimised_case_text(result), "case.toml", {.overrides = {}, .commands = {"cycle"}});
  EXPECT_EQ(again, result.optimised);
  EXPECT_EQ(run_cycles(again).cycles.front().turning_point->max_force, best_of(result).limits[0]);
  EXPECT_NE(optimise_table(result).find("active"), std::string::npos);
}

TEST(Optimise, EndsAtABoundWithoutLimits) {
  const OptimiseResult result =
      run_optimise(optimised({.maximise = {"max_force"}, .evaluations = 40, .starts = 1, .keys = {any_clearance}}));
  EXPECT_EQ(result.status, OptimiseStatus::converged);
  EXPECT_EQ(best_of(result).values[0], any_clearance.lower);
  EXPECT_EQ(result.bound_of(0), -1);
  EXPECT_NE(optimise_table(result).find("at its lower bound"), std::string::npos);
  // The search starts at a known point, which is not evaluated again.
  const auto searched = std::count_if(result.points.begin(), result.points.end(),
                                      [](const OptimisePoint& point) { return point.search == 1; });
  ASSERT_EQ(result.searches.size(), 1U);
  EXPECT_EQ(result.searches[0].evaluations, static_cast<std::size_t>(searched));
}

/// The loss factor peaks between low friction and full stick. The other key has no influence.
TEST(Optimise, FindsAnOptimumInsideTheBounds) {
  const OptimisedKey friction{.key = "friction.coefficient", .lower = 0.02, .upper = 2.0 / 3.0, .log = true};
  const OptimiseResult result =
      run_optimise(optimised({.maximise = {"loss_factor"}, .evaluations = 60, .starts = 2, .keys = {friction}}, 0.03));
  EXPECT_EQ(result.status, OptimiseStatus::converged);
  double most = 0.0;
  for (double mu = friction.lower; mu < friction.upper; mu *= 1.02) {
    Case input = few_bumps(mu, 30e-6);
    input.settings.get<CycleSettings>().steps = 20;
    most = std::max(most, *run_cycles(input).cycles.front().loss_factor);
  }
  // Points are distributed evenly about the middle of the logarithm.
  std::vector<double> places;
  for (const OptimisePoint& point : result.points) {
    if (point.search == 0 && point.values[0] != 0.03) places.push_back(point.values[0]);
  }
  const auto low = std::count_if(places.begin(), places.end(),
                                 [&](double mu) { return mu < std::sqrt(friction.lower * friction.upper); });
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(low, 2);  // 1 with linear spacing
  // The loss factor is flat near its maximum.
  EXPECT_GE(best_of(result).aims[0], most * (1.0 - 1e-4));
  EXPECT_EQ(result.optimised.friction.top_bump, best_of(result).values[0]);
}

TEST(Optimise, NamesTheLimitThatIsMissedByTheLeast) {
  const OptimiseResult result = run_optimise(optimised({.maximise = {"loss_factor"},
                                                        .limits = {"max_force > 2 kN", "max_force > 1 N"},
                                                        .evaluations = 30,
                                                        .starts = 1,
                                                        .keys = {any_clearance}}));
  EXPECT_EQ(result.status, OptimiseStatus::infeasible);
  EXPECT_FALSE(result.best);
  // The largest force is the closest.
  EXPECT_NEAR(result.points[*result.nearest].values[0], any_clearance.lower, 0.5e-6);
  const std::string failure = optimise_failures(result).front();
  EXPECT_NE(failure.find("\"max_force > 2 kN\" by"), std::string::npos) << failure;
  EXPECT_EQ(failure.find("max_force > 1 N\""), std::string::npos) << failure;
  EXPECT_NE(optimise_table(result).find("missed"), std::string::npos);
}

/// Bumps lower than the foil thickness are an invalid sample.
TEST(Optimise, KeepsPointsThatFailWhichNeverWin) {
  const OptimisedKey height{.key = "bump_foil.height", .lower = 0.05e-3, .upper = 0.3e-3};
  const OptimiseResult result = run_optimise(
      optimised({.maximise = {"max_force"}, .evaluations = 40, .starts = 2, .keys = {height, any_clearance}}));
  const auto failed = std::count_if(result.points.begin(), result.points.end(), [](const OptimisePoint& point) {
    return point.status == PointStatus::not_physical && !point.message.empty() && point.aims.empty();
  });
  EXPECT_GT(failed, 0);
  EXPECT_EQ(best_of(result).status, PointStatus::converged);
  const std::vector<std::string> warnings = optimise_warnings(result);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const std::string& line) { return line.find("are invalid") != std::string::npos; }));
  EXPECT_NE(csv_text(point_table(result)).find(",not_physical,false,"), std::string::npos);
}

TEST(Optimise, DoesNotConvergeWithoutEvaluations) {
  const OptimiseResult result =
      run_optimise(optimised({.maximise = {"loss_factor"}, .evaluations = 6, .starts = 2, .keys = {any_clearance}}));
  EXPECT_EQ(result.status, OptimiseStatus::evaluations_spent);
  EXPECT_LE(std::ssize(result.points), 6);
  EXPECT_NE(optimise_failures(result).front().find("optimise.evaluations"), std::string::npos);
}

TEST(Optimise, DoesNotDependOnThreads) {
  const OptimisedKey friction{.key = "friction.coefficient", .lower = 0.05, .upper = 0.5};
  const Case input = optimised({.maximise = {"loss_factor"},
                                .limits = {"max_force > 200 N"},
                                .evaluations = 60,
                                .starts = 3,
                                .keys = {friction, any_clearance}});
  const OptimiseResult one = run_optimise(input, {}, 1);
  const OptimiseResult two = run_optimise(input, {}, 2);
  EXPECT_EQ(csv_text(point_table(one)), csv_text(point_table(two)));
  EXPECT_EQ(optimise_lists(one), optimise_lists(two));
}

/// Limits on forces of an ensemble: for most of the bearings, or for the 5th percentile.
TEST(Optimise, TakesYieldsAndStatisticsOfEnsembles) {
  const double force = force_at(35e-6);
  const std::string least = "> " + std::to_string(force);
  OptimiseSettings settings{.minimise = {"loop_energy.mean"},
                            .limits = {"yield > 0.85"},
                            .bearing_limits = {"max_force " + least},
                            .evaluations = 30,
                            .starts = 1,
                            .keys = {any_clearance}};
  Case input = optimised(settings);
  input.montecarlo = MonteCarloSettings{.samples = 20};
  input.montecarlo->radial_clearance = Distribution{.sigma = 1e-6};
  const OptimiseResult by_yield = run_optimise(input, {}, 2);
  ASSERT_TRUE(by_yield.best);
  EXPECT_GT(best_of(by_yield).limits[0], 0.85);
  EXPECT_GT(force_at(best_of(by_yield).values[0]), force);  // of the nominal bearing, which is in the better half
  settings.command = "montecarlo";
  settings.limits = {"max_force.p5 " + least};
  input.settings.set(settings);
  const OptimiseResult by_percentile = run_optimise(input, {}, 1);
  ASSERT_TRUE(by_percentile.best);
  EXPECT_EQ(by_percentile.status, OptimiseStatus::converged);
  EXPECT_NEAR(best_of(by_percentile).limits[0], force, 0.01 * force);
  // All points use the same samples: the nominal bearing has a margin of several standard deviations.
  EXPECT_GT(force_at(best_of(by_percentile).values[0]), force);
}

/// Bumps of some samples are lower than the foil thickness: these samples are invalid.
TEST(Optimise, KnowsNoStatisticsWhereSamplesFailButTheirYield) {
  const OptimiseSettings settings{.minimise = {"loop_energy.mean"},
                                  .bearing_limits = {"max_force > 1 N"},
                                  .evaluations = 6,
                                  .keys = {any_clearance}};
  Case input = optimised(settings);
  input.montecarlo = MonteCarloSettings{.samples = 6};
  input.montecarlo->bump_height.emplace().distribution.sigma = 0.3e-3;
  const OptimiseResult by_mean = run_optimise(input);
  EXPECT_EQ(by_mean.status, OptimiseStatus::no_result);
  EXPECT_EQ(by_mean.points.front().status, PointStatus::failed);
  EXPECT_NE(by_mean.points.front().message.find("of 6 samples failed"), std::string::npos);
  OptimiseSettings by_yield = input.settings.get<OptimiseSettings>();
  by_yield.minimise.clear();
  by_yield.maximise = {"yield"};
  input.settings.set(by_yield);
  const OptimisePoint first = run_optimise(input).points.front();
  EXPECT_EQ(first.status, PointStatus::converged);
  EXPECT_LT(first.aims.at(0), 1.0);
}

/// The worst of several directions: the smallest value if it is maximised or has a lower limit.
TEST(Optimise, TakesTheWorstOfAllDirections) {
  OptimisedKey clearance = any_clearance;
  clearance.start = 33e-6;
  Case input = optimised({.maximise = {"loss_factor"},
                          .minimise = {"loop_energy"},
                          .limits = {"max_force > 1 N", "max_force < 10 kN"},
                          .evaluations = 3,
                          .starts = 1,
                          .keys = {clearance}});
  input.settings.get<CycleSettings>().directions.push_back(input.settings.get<CycleSettings>().directions.front() +
                                                           0.1);
  const OptimisePoint first = run_optimise(input).points.front();
  EXPECT_EQ(first.values[0], 33e-6);
  input.bearing.radial_clearance = 33e-6;
  const CycleResult cycles = run_cycles(input);
  const Cycle& one = cycles.cycles.at(0);
  const Cycle& other = cycles.cycles.at(1);
  ASSERT_NE(one.turning_point->max_force, other.turning_point->max_force);
  EXPECT_EQ(first.aims, (std::vector<double>{std::min(*one.loss_factor, *other.loss_factor),
                                             std::max(*one.loop_energy, *other.loop_energy)}));
  EXPECT_EQ(first.limits,
            (std::vector<double>{std::min(one.turning_point->max_force, other.turning_point->max_force),
                                 std::max(one.turning_point->max_force, other.turning_point->max_force)}));
}

/// The search of each aim must end by its tolerance. A search that ends early leaves its evaluations to the other.
TEST(Optimise, ConvergesInTwoAimsOnlyIfBothDo) {
  const OptimisedKey friction{.key = "friction.coefficient", .lower = 0.05, .upper = 0.5};
  const auto run = [&](int evaluations) {
    return run_optimise(optimised({.maximise = {"max_force", "loss_factor"},
                                   .evaluations = evaluations,
                                   .starts = 1,
                                   .front = 0,
                                   .keys = {any_clearance, friction}}));
  };
  const OptimiseResult few = run(40);
  EXPECT_EQ(few.status, OptimiseStatus::evaluations_spent);
  ASSERT_GE(few.searches.size(), 2U);
  EXPECT_TRUE(few.searches[0].by_tolerance);
  EXPECT_FALSE(few.searches[1].by_tolerance);
  EXPECT_EQ(few.searches[1].aim, 1U);
  constexpr std::size_t places = 9;
  EXPECT_GT(few.searches[1].evaluations, (40 - places) / 2);
  EXPECT_EQ(few.searches[0].evaluations + few.searches[1].evaluations, 40 - places);
  const OptimiseResult enough = run(80);
  EXPECT_EQ(enough.status, OptimiseStatus::converged);
  EXPECT_TRUE(enough.searches[0].by_tolerance);
  EXPECT_TRUE(enough.searches[1].by_tolerance);
}

/// If the second aim is constant, the optimum of the first dominates all points.
TEST(Optimise, LeavesOutOfTheFrontWhatIsWorseInAnAimAndBetterInNone) {
  const OptimiseResult result = run_optimise(optimised(
      {.maximise = {"max_force"}, .minimise = {"amplitude"}, .evaluations = 40, .starts = 1, .keys = {any_clearance}}));
  ASSERT_EQ(result.front.size(), 1U);
  EXPECT_EQ(result.points[result.front[0]].values[0], any_clearance.lower);
}

/// Both aims fall with the clearance: its whole range is the front.
TEST(Optimise, SpreadsTheFrontOfTwoAimsEvenly) {
  const OptimiseResult result = run_optimise(optimised({.maximise = {"loop_energy"},
                                                        .minimise = {"max_force"},
                                                        .evaluations = 120,
                                                        .starts = 1,
                                                        .front = 3,
                                                        .keys = {any_clearance}}));
  EXPECT_EQ(result.status, OptimiseStatus::converged);
  ASSERT_EQ(result.front.size(), 5U);
  const auto aims = [&](std::size_t k) { return result.points[result.front[k]].aims; };
  EXPECT_EQ(result.points[result.front.front()].values[0], any_clearance.lower);
  EXPECT_EQ(result.points[result.front.back()].values[0], any_clearance.upper);
  const double range = aims(0)[1] - aims(4)[1];
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_LT(aims(k)[0], aims(k - 1)[0]);
    // Tolerance of the searches.
    EXPECT_NEAR(aims(k)[1], aims(0)[1] - range * static_cast<double>(k) / 4.0, 0.01 * range);
  }
  EXPECT_NE(std::find(result.front.begin() + 1, result.front.end() - 1, *result.best), result.front.end() - 1);
}

TEST(Optimise, StopsWhenAsked) {
  const Case input = optimised({.maximise = {"loss_factor"}, .keys = {any_clearance}});
  EXPECT_EQ(run_optimise(input, [](double) { return false; }).status, OptimiseStatus::interrupted);
}

}  // namespace
}  // namespace bumpfoil
