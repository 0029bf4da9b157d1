#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The one cycle of a case with one direction. Fails the running program if the case has several.
Cycle run_single_cycle(Case input, double direction);

/// Reference bearing (given truss constants) under reproducible random conditions: friction 0..0.5 at each interface,
/// normal height scatter up to 40 um, any direction, 25..400 steps.
Case random_case(std::uint64_t number);

/// Bearing with reproducible random foils: 3..40 bumps of any rise, thickness, width and elasticity, clearance 0..60
/// um, friction 0..0.5 or none, height scatter up to 20 um or none, pushed up to 50 um into the foils in 15..60 steps.
Case random_foils(std::uint64_t number, BumpFoilModel model);

/// The bearing of a case with only this pad, in its position and with its offset.
Case pad_alone(const Case& input, std::size_t pad);

/// `result` as if its first direction had failed at increment 3, and the others had never started.
CycleResult failed_at_increment_three(CycleResult result);

/// Reference bearing, friction 0.1, +X, with more bumps on a proportionally larger radius: the foils still cover one
/// circumference.
Case long_bearing(int bumps, int steps);

/// Empty if every increment of the cycle was solved within the bounds (normalised equilibrium, complementarity and cone
/// 1e-9; penetration and slip in stick 1e-12 m); otherwise the first violation and its reason.
std::string first_failure(const Cycle& cycle);

}  // namespace bumpfoil
