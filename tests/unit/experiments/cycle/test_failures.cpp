#include "bumpfoil/experiments/cycle/failures.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case pushed(double direction) {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {direction};
  cycle.steps = 5;
  return input;
}

TEST(Failures, NameWhatFailedWhereAndWhy) {
  const Case input = pushed(std::numbers::pi);
  CycleResult result = failed_at_increment_three(run_cycles(input));
  result.cycles[0].increments.back().displacement = 29.44e-6;
  EXPECT_EQ(failure_lines(input, result), std::vector<std::string>{"-X, increment 3 of 10, 29.4 um: " +
                                                                   std::string(explanation(result.cycles[0].status))});
  const Failure failure = failure_of(input, result, 0).value();
  EXPECT_EQ(failure.increment, 3);
  EXPECT_EQ(failure.displacement, 29.44e-6);
}

TEST(Failures, AreNoneOfWhatConvergedAndNoLineOfWhatWasInterrupted) {
  const Case input = pushed(0.0);
  EXPECT_FALSE(failure_of(input, run_cycles(input), 0));
  const CycleResult interrupted = run_cycles(input, [](double fraction) { return fraction < 0.5; });
  const Failure failure = failure_of(input, interrupted, 0).value();
  EXPECT_FALSE(failure.increment);
  EXPECT_EQ(failure.reason, explanation(Status::interrupted));
  EXPECT_TRUE(failure_lines(input, interrupted).empty());
}

TEST(Failures, SayThatAPreloadWasNotReached) {
  Case input = reference_case();
  input.settings.set(StripSettings{
      .bumps = 3, .amplitude = {Control::displacement, 1e-6}, .preload = Target{Control::load, 1e6}, .steps = 4});
  const CycleResult result = run_strip(input);
  const Failure failure = failure_of(input, result, 0).value();
  EXPECT_EQ(failure.increment, 0);
  EXPECT_EQ(failure.reason, "the preload was not reached: " + std::string(explanation(Status::load_out_of_reach)));
  EXPECT_TRUE(failure_lines(input, result).at(0).starts_with("cycle 1, increment 0 of 16, "));
}

TEST(Failures, CyclesGoByTheirAxesOrAngles) {
  const auto name = [](double degrees) {
    CycleResult result{.cycles = {Cycle{}}};
    result.cycles[0].direction = degrees * std::numbers::pi / 180.0;
    return cycle_name(result, 0);
  };
  EXPECT_EQ(name(0.0), "+X");
  EXPECT_EQ(name(-90.0), "-Y");
  EXPECT_EQ(name(450.0), "+Y");
  EXPECT_EQ(name(37.5), "37.5 deg");
  EXPECT_EQ(cycle_name({.experiment = Experiment::strip, .cycles = {Cycle{}, Cycle{}}}, 1), "cycle 2");
}

}  // namespace
}  // namespace bumpfoil
