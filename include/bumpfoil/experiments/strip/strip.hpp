#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Compresses the strip of a case between its plate and the base, cycle after cycle; the first begins with the plate
/// where it touches nominal foils, assembled in one step from the unstressed foils. In the result
///
/// - `displacement`, `x` and `force_direct`, `force_x` are those of the plate, towards the base;
/// - increment 0 of the first cycle without a preload is the assembly, of every other cycle the state that it starts
///   from; work and dissipation count from there;
/// - a preload is approached in `steps` increments, which are not recorded;
/// - a cycle about a preload is fully reversed.
///
/// A cycle that fails is the last.
/// @throws Error (input) if the case cannot be built, or has no strip.
CycleResult run_strip(const Case& input, const ProgressCallback& progress = {},
                      Recording recording = Recording::everything);

}  // namespace bumpfoil
