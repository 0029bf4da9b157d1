#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Deviations of the augmented Lagrangian solver from the exact one over the cycles of a case, and its cost.
struct UzawaDeviation {
  double max_force{};              ///< largest relative deviation at full displacement
  double loop_energy{};            ///< largest deviation relative to it or, without friction, to the work of the push
  double solves_per_increment{};   ///< linear solves
  double updates_per_increment{};  ///< of the multipliers
  int halvings{};                  ///< extra solves of increments that failed at first
  int failures{};                  ///< cycles that did not reach their end; not in the figures above
};

/// @param exact  run_cycles(input) with the exact solver
UzawaDeviation compare_uzawa(Case input, const CycleResult& exact, const UzawaParameters& parameters);

/// Worst of two: deviations and costs the larger, counts added.
UzawaDeviation worst(const UzawaDeviation& a, const UzawaDeviation& b);

/// The reference bearing with given truss constants and friction 0.1, four directions.
Case uzawa_study_case();

/// The same with 10 um of height scatter.
Case scattered_uzawa_study_case();

}  // namespace bumpfoil
