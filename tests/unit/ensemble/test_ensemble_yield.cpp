#include "bumpfoil/ensemble/ensemble_yield.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/core/error.hpp"
#include "support/ensemble_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

const EnsembleLayout layout = make_ensemble_layout(test_support::ensemble_case(4));

std::string limit_refusal(const std::string& limit) {
  try {
    parse_limits({limit}, layout);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(EnsembleYield, LimitsAreQuantitiesWithUnits) {
  const std::vector<EnsembleLimit> limits = parse_limits(
      {"clearance_5N > 20 um", "max_force<900", "loaded_stiffness > 10 MN/m", "loss_factor > 0.1"}, layout);
  EXPECT_EQ(layout.columns[limits[0].column].meaning.name, "clearance_5N");
  EXPECT_TRUE(limits[0].above);
  EXPECT_DOUBLE_EQ(limits[0].bound, 20e-6);
  EXPECT_FALSE(limits[1].above);
  EXPECT_EQ(limits[1].bound, 900.0);
  EXPECT_DOUBLE_EQ(limits[2].bound, 10e6);
  EXPECT_EQ(limits[3].bound, 0.1);
}

TEST(EnsembleYield, WrongLimitsAreRefused) {
  EXPECT_NE(limit_refusal("clearance_5N = 20 um").find("has no < and no >"), std::string::npos);
  EXPECT_EQ(limit_refusal("clearence_5N > 20 um"),
            "--limit = clearence_5N > 20 um: does not name a quantity of the ensemble; did you mean \"clearance_5N\"?");
  EXPECT_NE(limit_refusal("clearance_5N > 20 N"), "");
  EXPECT_NE(limit_refusal("loss_factor > 20 N").find("write a number"), std::string::npos);
  EXPECT_NE(limit_refusal("status < 1"), "");
  EXPECT_NE(limit_refusal("max_force < inf"), "");
}

TEST(EnsembleYield, BearingsPassInEveryDirection) {
  const std::vector<EnsembleLimit> limits = parse_limits({"clearance_5N > 20 um", "max_force < 900"}, layout);
  const std::size_t clearance = limits[0].column;
  const std::size_t force = limits[1].column;
  // Five bearings: good; no contact along +X; tight along -X; stiff along +X; failed along -X.
  std::vector<double> rows(5 * layout.width(), 0.0);
  const auto at = [&](std::size_t sample, std::size_t direction, std::size_t column) -> double& {
    return rows[sample * layout.width() + layout.entry(direction, column)];
  };
  for (std::size_t sample = 0; sample < 5; ++sample) {
    for (std::size_t direction = 0; direction < 2; ++direction) {
      at(sample, direction, clearance) = 25e-6;
      at(sample, direction, force) = 800.0;
    }
  }
  at(1, 0, clearance) = NAN;
  at(2, 1, clearance) = 15e-6;
  at(3, 0, force) = 1000.0;
  at(4, 1, 0) = static_cast<double>(Status::no_modes);
  const test_support::TemporaryFolder folder;
  RowLog log(folder.path() / "log", "", layout.width());
  log.append(rows);
  const EnsembleYields yields = make_yields(limits, layout, log);
  ASSERT_EQ(yields.each.size(), 2U);
  EXPECT_EQ(yields.each[0].passed, 3U);
  EXPECT_EQ(yields.each[1].passed, 3U);
  EXPECT_EQ(yields.all.passed, 2U);
  EXPECT_EQ(yields.all.samples, 5U);
  // Wilson's interval of 2 of 5, by hand: (0.4 + z^2/10 -+ z sqrt(0.048 + z^2/100)) / (1 + z^2/5) with z^2 = 3.8415.
  EXPECT_NEAR(yields.all.low, 0.1176, 5e-5);
  EXPECT_NEAR(yields.all.high, 0.7693, 5e-5);
  EXPECT_EQ(yield_text(yields), "yield: 2 of 5 bearings, 40.0 % (11.8 to 76.9 %)\n");
  EXPECT_EQ(yield_text(make_yields({}, layout, log)), "");
}

/// Limits on amplitudes and their speeds have units.
TEST(EnsembleYield, RotorsPassWhoseOrbitsAreSmallEnough) {
  const EnsembleLayout of_rotor = make_ensemble_layout(test_support::unbalance_ensemble_case(3));
  const std::vector<EnsembleLimit> limits = parse_limits(
      {"largest_amplitude < 5 um", "largest_amplitude_speed < 9000 rpm", "largest_amplitude_ratio < 0.3"}, of_rotor);
  EXPECT_EQ(limits[0].bound, 5e-6);
  EXPECT_NEAR(limits[1].bound, 300.0 * M_PI, 1e-9);
  // Small; too large for the film; no equilibrium at some speed.
  const test_support::TemporaryFolder folder;
  RowLog log(folder.path() / "log", "", of_rotor.width());
  const auto not_reached = static_cast<double>(Status::not_reached);
  log.append(std::vector{0.0, 2e-6, 900.0, 0.1, 0.0, 4e-6, 900.0, 0.4, not_reached, 2e-6, 900.0, 0.1});
  EXPECT_EQ(make_yields(limits, of_rotor, log).all.passed, 1U);
}

/// Without an onset a rotor may be stable at all speeds or at none: limits refer to the speed up to which it is stable.
TEST(EnsembleYield, RotorsPassThatAreStableUpToTheLimit) {
  const EnsembleLayout of_rotor = make_ensemble_layout(test_support::rotor_ensemble_case(4));
  for (const char* const refused : {"onset_speed > 12000 rpm", "onset_whirl_ratio < 0.5"}) {
    try {
      parse_limits({refused}, of_rotor);
      ADD_FAILURE() << refused;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("set a limit on stable_up_to"), std::string::npos) << error.what();
    }
  }
  const std::vector<EnsembleLimit> limits = parse_limits({"stable_up_to > 12000 rpm"}, of_rotor);
  EXPECT_NEAR(limits[0].bound, 400.0 * M_PI, 1e-9);
  // Stable up to 24,000 rpm; whirls above 13,000 rpm; whirls from the first speed on; no equilibrium.
  std::vector<double> rows(4 * of_rotor.width(), NAN);
  const auto at = [&](std::size_t sample, std::size_t column) -> double& {
    return rows[sample * of_rotor.width() + column];
  };
  for (std::size_t sample = 0; sample < 4; ++sample) {
    at(sample, 0) = 0.0;
    at(sample, limits[0].column) = std::vector{2513.3, 1361.4, 0.0, 2513.3}[sample];
  }
  at(3, 0) = static_cast<double>(Status::not_reached);
  const test_support::TemporaryFolder folder;
  RowLog log(folder.path() / "log", "", of_rotor.width());
  log.append(rows);
  EXPECT_EQ(make_yields(limits, of_rotor, log).all.passed, 2U);
}

}  // namespace
}  // namespace bumpfoil
