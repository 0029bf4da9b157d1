#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::testing {

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

}  // namespace bumpfoil::testing
