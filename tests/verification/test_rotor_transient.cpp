// docs/verification/rotor.md: rotors in time by the command transient, against an independent prototype.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "experiments/transient/step_row.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Amplitudes at the rotation frequency along X and Y, and minimum film thickness, um, at the end of every tenth turn.
struct CoastDown {
  double time;  ///< s
  double x, y, thinnest;
};
constexpr CoastDown reference_coast_down[] = {
    {0.010356959164060, 1.166706138976919, 1.0906458234209515, 8.106581252580112},
    {0.021546165339268, 1.2065977126779386, 1.1120276425095659, 7.605623286424286},
    {0.033807752295463, 1.2856459915900509, 1.1405596379568312, 7.00525392882921},
    {0.047525844807876, 1.4105338697908096, 1.1915689870532913, 6.293338175527467},
    {0.063389533555462, 1.7289745426600958, 1.2892124832426792, 5.349807535321326},
    {0.082902973528111, 3.4644611919897, 1.4761725409509543, 3.702969895558223}};

/// Amplitudes of a turn by plain sums over its steps, m.
Eigen::Vector2d plain_amplitudes(const TransientResult& result, std::size_t turns_before, std::size_t steps) {
  const std::size_t first = turns_before * steps + 1;
  const auto angles = result.steps->column(column_of(StepColumn::angle), first, steps);
  Eigen::Vector2d amplitudes;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto places = result.steps->column(place_column(0, axis), first, steps);
    std::complex<double> sum;
    for (std::size_t i = 0; i < steps; ++i) sum += std::polar(2.0 / static_cast<double>(steps), -angles[i]) * places[i];
    amplitudes[static_cast<Eigen::Index>(axis)] = std::abs(sum);
  }
  return amplitudes;
}

/// 1 kg under 100 N coasts down from 60,000 to 20,000 rpm in 0.1 s towards the lightly damped critical speed of X near
/// 21,000 rpm. Gas enters at the weld. The prototype computes the harmonics at changing speed by plain sums over a
/// turn: 1 %. Its steps follow the speed at their start, not equal angles: 2e-4 of the time. The start leaves a
/// different amount of free whirl, which affects the minimum film thickness of a turn.
TEST(RotorTransient, CoastsDownAsInThePrototype) {
  Case input = film_rotor_case({6, 8});
  RotorSettings& rotor = input.settings.get<RotorSettings>();
  rotor.gravity = {100.0, 0.0};
  rotor.unbalances.emplace_back().amount = 2e-6;
  input.settings.set(
      TransientSettings{.speed = {{.from = speed_of_rpm(-60000.0), .to = speed_of_rpm(-20000.0), .time = 0.1}},
                        .steps_per_revolution = 60});
  const TransientResult result = run_transient(input);
  ASSERT_EQ(result.status, Status::converged);
  const std::vector<TransientTurn> turns = turns_of(result);
  ASSERT_EQ(turns.size(), 66U);  // 66.7
  for (std::size_t i = 0; i < std::size(reference_coast_down); ++i) {
    const CoastDown& expected = reference_coast_down[i];
    const TransientTurn& found = turns[10 * i + 9];
    EXPECT_NEAR(found.time, expected.time, 3e-4 * expected.time);
    // At first free whirl remains, which is not synchronous; near the critical speed the mean moves, which plain sums
    // count as synchronous.
    const Eigen::Vector2d amplitudes =
        i < 4 ? Eigen::Vector2d(found.places[0].orbit.once.cwiseAbs()) : plain_amplitudes(result, 10 * i + 9, 60);
    EXPECT_NEAR(1e6 * amplitudes.x(), expected.x, 0.01 * expected.x) << i;
    EXPECT_NEAR(1e6 * amplitudes.y(), expected.y, 0.01 * expected.y) << i;
    EXPECT_LT((found.places[0].orbit.once.cwiseAbs() - amplitudes).norm(), 0.02 * amplitudes.norm()) << i;
    EXPECT_NEAR(1e6 * found.bearings[0].thinnest, expected.thinnest, 0.02 * expected.thinnest) << i;
  }
  // Time steps leave only a small error in the energy balance.
  EXPECT_LT(energy_check(turns).relative(), 0.01);
}

}  // namespace
}  // namespace bumpfoil
