#include <gtest/gtest.h>

#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Two thousand cases beyond the two hundred of every test run.
TEST(ManyRandomBearings, AreSolved) {
  for (std::uint64_t number = 1000; number < 3000; ++number) {
    const Case input = random_case(number);
    const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
    EXPECT_EQ(first_failure(cycle), "") << input.title;
    EXPECT_EQ(cycle.substeps, 0) << input.title;
  }
}

/// The same with clearances of -10 um to 50 um.
TEST(ManyRandomBearings, AreSolvedWithClearancesOfAnySign) {
  for (std::uint64_t number = 3000; number < 4000; ++number) {
    Case input = random_case(number);
    input.bearing.radial_clearance = -10e-6 + 60e-6 * static_cast<double>(number % 100) / 99.0;
    const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
    EXPECT_EQ(first_failure(cycle), "") << input.title;
    EXPECT_EQ(cycle.substeps, 0) << input.title;
  }
}

}  // namespace
}  // namespace bumpfoil
