#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/motion/program.hpp"

namespace bumpfoil {

/// How a cycle is taken.
struct CyclePlan {
  Program program;  ///< its first leg ends at the turning point
  double reach{};   ///< loads are not looked for beyond this displacement, m
  Recording recording{Recording::everything};
};

/// Takes foils through a cycle. Work and dissipation are counted from its start.
/// @param cycle     direction, amplitude, steps and what the assembly dissipated filled in
/// @param step      how the start was reached, with its state; receives the state where the cycle ended, unless its
///                  first increment had failed already
/// @param progress  called with the fraction of the cycle that is done; may be empty
Cycle run_cycle(FoilStepper& stepper, const CyclePlan& plan, Cycle cycle, Step& step, const ProgressCallback& progress);

}  // namespace bumpfoil
