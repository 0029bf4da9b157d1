#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/motion/program.hpp"

namespace bumpfoil {

/// Plan of a cycle.
struct CyclePlan {
  Program program;  ///< its first leg ends at the turning point
  double reach{};   ///< largest displacement in the search for loads, m
  Recording recording{Recording::everything};
};

/// Takes foils through a cycle. Work and dissipation count from its start.
/// @param cycle     direction, amplitude, steps and dissipation of the assembly given
/// @param step      how the start was reached, with its state; receives the state at the end of the cycle, unless its
///                  first increment failed
/// @param progress  called with the completed fraction of the cycle; may be empty
Cycle run_cycle(FoilStepper& stepper, const CyclePlan& plan, Cycle cycle, Step& step, const ProgressCallback& progress);

}  // namespace bumpfoil
