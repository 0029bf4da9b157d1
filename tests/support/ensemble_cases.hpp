#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::test_support {

/// A small ensemble of the reference bearing: heights and friction scatter, +X and -X, few increments.
inline Case ensemble_case(int samples) {
  Case input = reference_case();
  input.cycle.directions.resize(2);
  input.cycle.steps = 4;
  MonteCarloSettings& ensemble = input.montecarlo.emplace();
  ensemble.samples = samples;
  ensemble.seed = 1;
  ensemble.bump_height.emplace(HeightScatter{Distribution{.sigma = 10e-6}, 9e-3});
  ensemble.friction_top_bump.emplace(Distribution{.sigma = 0.01});
  ensemble.sleeve_waviness.emplace(WavinessScatter{3, 2e-6});
  return input;
}

/// The same on its film: clearance and heights scatter, one speed with two loads, a coarse mesh.
inline Case running_ensemble_case(int samples) {
  Case input = reference_case();
  input.film.columns_per_pitch = 4;
  input.film.rows = 6;
  input.equilibrium.emplace(EquilibriumSettings{.speeds = {4712.0}, .loads = {{20.0, 0.0}, {40.0, 0.0}}, .steps = 2});
  MonteCarloSettings& ensemble = input.montecarlo.emplace();
  ensemble.command = EnsembleCommand::equilibrium;
  ensemble.samples = samples;
  ensemble.bump_height.emplace(HeightScatter{Distribution{.sigma = 2e-6}, 0.0});
  ensemble.radial_clearance.emplace(Distribution{.sigma = 1e-6});
  return input;
}

}  // namespace bumpfoil::test_support
