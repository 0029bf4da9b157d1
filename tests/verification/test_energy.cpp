#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/bearing_cases.hpp"
#include "support/cycle_energies.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

/// Energies of push-pull cycles: no loop without friction, energy balances with friction.
namespace bumpfoil {
namespace {

using std::numbers::pi;

struct InterfaceAt {
  const InterfaceRow& fields;
  const Vector* tangential;  ///< displacements of the nodes that friction acts on; null where frictionless
};

std::vector<InterfaceAt> interfaces(const FullIncrement& increment) {
  return {{increment.journal_top, nullptr},
          {increment.top_bump, &increment.crest_u},
          {increment.bump_sleeve, &increment.foot_u}};
}

/// Work of one increment by the exact discrete balance. Between two equilibria k-1 and k of linear foils
///
///     E_k - E_{k-1} = 1/2 (f_k + f_{k-1}).(x_k - x_{k-1})
///
/// with contact forces f. Friction contributes 1/2 (t_k + t_{k-1}) du. A normal force works on the change of the gap
/// minus that of the initial gap; the latter, summed over the journal contacts, is the work of the journal (the initial
/// gap falls by e(phi).dx). As p g = 0 at both ends, 1/2 (p_k + p_{k-1}) (g_k - g_{k-1}) is half of
/// p_{k-1} g_k - p_k g_{k-1}, also at the journal.
double balanced_work(const FullIncrement& before, const FullIncrement& now) {
  double work = now.elastic_energy - before.elastic_energy;
  const std::vector<InterfaceAt> first = interfaces(before);
  const std::vector<InterfaceAt> second = interfaces(now);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const InterfaceRow& a = first[i].fields;
    const InterfaceRow& b = second[i].fields;
    work += 0.5 * (b.normal_force.dot(a.gap) - a.normal_force.dot(b.gap));
    if (second[i].tangential != nullptr) {
      work -= 0.5 * (a.friction_force + b.friction_force).dot(*second[i].tangential - *first[i].tangential);
    }
  }
  return work;
}

class ReferenceEnergies : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] static bool has_friction() { return reference().input.friction.top_bump > 0.0; }
  [[nodiscard]] static const ReferenceCycle& reference() { return reference_cycles().at(GetParam()); }
  const Cycle cycle = run_cycles(reference().input).cycles.front();
};

TEST_P(ReferenceEnergies, ObeyTheExactDiscreteBalance) {
  ASSERT_TRUE(cycle.converged());
  const std::vector<FullIncrement> increments = full_increments(cycle);
  double sum = 0.0;
  for (std::size_t k = 1; k < increments.size(); ++k) {
    sum += balanced_work(increments[k - 1], increments[k]);
    ASSERT_NEAR(cycle.increments[k].work, sum, 1e-9 * largest_work(cycle)) << "increment " << k;
  }
}

TEST_P(ReferenceEnergies, DissipationNeverDecreases) {
  for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
    ASSERT_GE(cycle.increments[k].dissipated_energy, cycle.increments[k - 1].dissipated_energy) << "increment " << k;
  }
  if (has_friction()) {
    EXPECT_GT(*cycle.loop_energy, 0.1 * largest_work(cycle));
    // A closed loop dissipates its work; the difference is the first-order defect of the plain balance.
    EXPECT_NEAR(cycle.increments.back().dissipated_energy, *cycle.loop_energy, 0.02 * *cycle.loop_energy);
  } else {
    EXPECT_EQ(cycle.increments.back().dissipated_energy, 0.0);
  }
}

TEST_P(ReferenceEnergies, PlainBalanceHoldsToOnePerCentAtHundredSteps) {
  EXPECT_LT(plain_balance_defect(cycle), 0.01 * largest_work(cycle));
}

TEST_P(ReferenceEnergies, WithoutFrictionUnloadingRetracesLoading) {
  if (has_friction()) return;
  const double largest = cycle.turning_point->max_force;
  for (int k = 0; k < cycle.steps; ++k) {
    const Increment& loading = cycle.increments[static_cast<std::size_t>(k)];
    const Increment& unloading = cycle.increments[static_cast<std::size_t>(2 * cycle.steps - k)];
    ASSERT_NEAR(unloading.force_direct, loading.force_direct, 1e-9 * largest) << "increment " << k;
    ASSERT_NEAR(unloading.force_cross, loading.force_cross, 1e-9 * largest) << "increment " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Reference, ReferenceEnergies, testing::Range(std::size_t{0}, std::size_t{9}));

TEST(Energy, DefectOfThePlainBalanceShrinksWithTheIncrement) {
  Case input = case_with_given_constants();
  for (const double direction : input.settings.get<CycleSettings>().directions) {
    std::vector<double> defects;
    for (const int steps : {25, 100, 400}) {
      input.settings.get<CycleSettings>().steps = steps;
      const Cycle cycle = run_single_cycle(input, direction);
      defects.push_back(plain_balance_defect(cycle) / largest_work(cycle));
    }
    // First order: a quarter each time. It is not smooth where contacts open or close within an increment.
    EXPECT_LT(defects[1], 0.4 * defects[0]) << direction;
    EXPECT_LT(defects[2], 0.4 * defects[1]) << direction;
  }
}

TEST(Energy, ExactBalanceHoldsWithScatterStrongFrictionAndInterference) {
  for (std::uint64_t number = 0; number < 6; ++number) {
    Case input = random_case(number);
    input.settings.get<CycleSettings>().steps = 40;
    input.bearing.radial_clearance = number % 2 == 0 ? -5e-6 : 31.8e-6;
    const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
    ASSERT_EQ(first_failure(cycle), "") << number;
    const std::vector<FullIncrement> increments = full_increments(cycle);
    double sum = 0.0;
    for (std::size_t k = 1; k < increments.size(); ++k) {
      sum += balanced_work(increments[k - 1], increments[k]);
      ASSERT_NEAR(cycle.increments[k].work, sum, 1e-9 * largest_work(cycle)) << "case " << number << " at " << k;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
