#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::testing {

/// A small ensemble of the reference bearing: heights and friction scatter, +X and -X, few increments.
inline Case ensemble_case(int samples) {
  Case input = reference_case();
  input.cycle.directions.resize(2);
  input.cycle.steps = 4;
  input.montecarlo = MonteCarloSettings{.samples = samples,
                                        .seed = 1,
                                        .bump_height = HeightScatter{Distribution{.sigma = 10e-6}, 9e-3},
                                        .friction_top_bump = Distribution{.sigma = 0.01},
                                        .sleeve_waviness = WavinessScatter{3, 2e-6}};
  return input;
}

}  // namespace bumpfoil::testing
