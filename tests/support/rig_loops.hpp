#pragma once

#include <cmath>
#include <random>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil::test_support {

/// Reading of a bearing loop by a rig: increments of its solver, with rig errors and noise.
inline FitData rig_loop(const CycleResult& truth, const Rig& rig, double noise, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  FitData data;
  const Cycle& cycle = truth.cycles.back();
  const auto last = static_cast<double>(cycle.increments.size() - 1);
  for (const Increment& increment : cycle.increments) {
    const double tau = increment.index / last - 0.5;
    const double compliance = rig.machine_stiffness ? 1.0 / *rig.machine_stiffness : 0.0;
    data.displacements.push_back(increment.displacement + compliance * increment.force_direct +
                                 rig.displacement_origin + rig.displacement_drift * tau);
    data.forces.push_back(increment.force_direct + rig.force_origin + rig.force_drift * tau + noise * normal(engine));
  }
  return data;
}

/// A bearing of few bumps, pushed towards their middle.
inline Case few_bumps(double friction, double clearance) {
  Case input = reference_case();
  input.bump_foil.bumps = 8;
  input.friction = {friction, friction};
  input.bearing.radial_clearance = clearance;
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.75 * 3.141592653589793};
  cycle.amplitude = {Control::displacement, 60e-6};
  cycle.steps = 300;
  input.solver.name = SolverName::events;
  return input;
}

inline FitParameter fitted(const std::string& key, double start, double lower, double upper) {
  return {.key = key, .start = start, .lower = lower, .upper = upper};
}

/// A fit of the bearing to loops in its direction.
inline Case fit_of(Case input, FitData data, std::vector<FitParameter> parameters, int starts = 1) {
  data.direction = input.settings.get<CycleSettings>().directions.front();
  input.settings.set(FitSettings{.data = {std::move(data)}, .parameters = std::move(parameters), .starts = starts});
  return input;
}

}  // namespace bumpfoil::test_support
