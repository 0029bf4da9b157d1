#pragma once

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil::test_support {

/// An ensemble of the reference bearing.
inline Case ensemble_case(const MonteCarloSettings& ensemble) {
  Case input = reference_case();
  input.montecarlo = ensemble;
  return input;
}

/// A small ensemble of the reference bearing: heights and friction scatter, +X and -X, few increments.
inline Case ensemble_case(int samples) {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions.resize(2);
  cycle.steps = 4;
  MonteCarloSettings& ensemble = input.montecarlo.emplace();
  ensemble.samples = samples;
  ensemble.seed = 1;
  ensemble.bump_height.emplace(HeightScatter{Distribution{.sigma = 10e-6}, 9e-3});
  ensemble.friction_top_bump.emplace(Distribution{.sigma = 0.01});
  ensemble.sleeve_waviness.emplace(WavinessScatter{3, 2e-6});
  return input;
}

/// The same with a film: clearance and heights scatter, one speed with two loads, a coarse mesh.
inline Case running_ensemble_case(int samples) {
  Case input = reference_case();
  input.film.columns_per_pitch = 4;
  input.film.rows = 6;
  input.settings.set(EquilibriumSettings{.speeds = {4712.0}, .loads = {{20.0, 0.0}, {40.0, 0.0}}, .steps = 2});
  MonteCarloSettings& ensemble = input.montecarlo.emplace();
  ensemble.command = "equilibrium";
  ensemble.samples = samples;
  ensemble.bump_height.emplace(HeightScatter{Distribution{.sigma = 2e-6}, 0.0});
  ensemble.radial_clearance.emplace(Distribution{.sigma = 1e-6});
  return input;
}

/// A rotor of 2 kg on such bearings, at two speeds with an onset of whirl between them (near 13,200 rpm).
inline Case rotor_ensemble_case(int samples) {
  Case input = running_ensemble_case(samples);
  input.montecarlo->command = "stability";
  input.top_foil.formed_radius = {FormedTo::seated};  // its free end does not move
  RotorSettings rotor;
  rotor.mass = 2.0;
  rotor.gravity = {9.81, 0.0};
  input.settings.set(rotor);
  input.settings.set(StabilitySettings{.speeds = {-1256.6, -1570.8}});  // the gas enters at the weld
  return input;
}

/// The same rotor with an eccentricity of 1 um, near the speeds of its largest orbit.
inline Case unbalance_ensemble_case(int samples) {
  Case input = rotor_ensemble_case(samples);
  input.montecarlo->command = "unbalance";
  RotorSettings rotor = input.settings.get<RotorSettings>();
  rotor.unbalances.emplace_back().amount = 2e-6;
  input.settings.set(rotor);
  input.settings.set(UnbalanceSettings{.speeds = {-700.0, -900.0, -1100.0}});
  return input;
}

/// The same in time at constant speed, four revolutions in few steps.
inline Case transient_ensemble_case(int samples) {
  Case input = unbalance_ensemble_case(samples);
  input.montecarlo->command = "transient";
  TransientSettings settings{.steps_per_revolution = 20};
  settings.speed = {SpeedPhase{.to = -900.0, .time = 28e-3}};
  input.settings.set(settings);
  return input;
}

}  // namespace bumpfoil::test_support
