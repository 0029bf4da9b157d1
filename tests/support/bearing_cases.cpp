#include "support/bearing_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "support/long_bearing.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {

Cycle run_single_cycle(Case input, double direction) {
  input.settings.get<CycleSettings>().directions = {direction};
  CycleResult result = run_cycles(input);
  BUMPFOIL_ASSERT(result.cycles.size() == 1);
  return std::move(result.cycles.front());
}

Case random_case(std::uint64_t number) {
  std::mt19937_64 generator(number);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(generator);
  };
  Case input = case_with_given_constants();
  input.title = fmt::format("random case {}", number);
  input.friction.top_bump = uniform(0.0, 0.5);
  // Every third case has one coefficient at both interfaces, as the paper does.
  input.friction.bump_sleeve = number % 3 == 0 ? input.friction.top_bump : uniform(0.0, 0.5);
  std::normal_distribution<double> scatter(0.0, uniform(0.0, 40e-6));
  for (int bump = 0; bump < input.bump_foil.bumps; ++bump) {
    input.bump_foil.height_errors.push_back(scatter(generator));
  }
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {uniform(0.0, 2.0 * std::numbers::pi)};
  cycle.steps = static_cast<int>(std::lround(25.0 * std::pow(16.0, uniform(0.0, 1.0))));
  return input;
}

Case random_foils(std::uint64_t number, BumpFoilModel model) {
  std::mt19937_64 generator(number);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(generator);
  };
  const auto decades = [&](double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); };
  Case input = reference_case();
  input.title = fmt::format("random foils {}, {}", number, model == BumpFoilModel::frame ? "frame" : "truss");
  BumpFoil& foil = input.bump_foil;
  foil.model = model;
  const int bumps = foil.bumps;
  foil.bumps = 3 + static_cast<int>(uniform(0.0, 38.0));
  input.bearing.radius *= static_cast<double>(foil.bumps) / bumps;  // the foils still cover one circumference
  foil.height_reference = HeightReference::midsurface;
  foil.height = uniform(0.3e-3, 0.7e-3);
  foil.thickness = decades(0.05e-3, 0.2e-3);
  input.top_foil.thickness = decades(0.05e-3, 0.2e-3);
  foil.youngs_modulus = input.top_foil.youngs_modulus = decades(70e9, 300e9);
  input.bearing.axial_length = decades(10e-3, 100e-3);
  input.bearing.radial_clearance = uniform(0.0, 60e-6);
  const double friction = uniform(0.0, 1.0) < 0.2 ? 0.0 : 0.5;
  input.friction.top_bump = friction * uniform(0.0, 1.0);
  input.friction.bump_sleeve = friction * uniform(0.0, 1.0);
  std::normal_distribution<double> scatter;
  const double deviation = uniform(0.0, 1.0) < 0.3 ? 0.0 : uniform(0.0, 20e-6);
  for (int bump = 0; bump < foil.bumps; ++bump) foil.height_errors.push_back(deviation * scatter(generator));
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {uniform(0.0, 2.0 * std::numbers::pi)};
  cycle.amplitude.value = input.bearing.radial_clearance + uniform(5e-6, 50e-6);
  cycle.steps = static_cast<int>(std::lround(decades(15.0, 60.0)));
  return input;
}

Case pad_alone(const Case& input, std::size_t pad) {
  Case alone = input;
  static_cast<PadDesign&>(alone) = place_pads(input)[pad].alone;
  alone.pads = {{.lobe = input.pads[pad].lobe}};
  return alone;
}

CycleResult failed_at_increment_three(CycleResult result) {
  result.cycles.resize(1);
  Cycle& cycle = result.cycles.front();
  cycle.status = Status::no_modes;
  cycle.increments.resize(4);
  Increment& last = cycle.increments.back();
  Step failed;
  failed.status = cycle.status;
  failed.state.position = {last.x, last.y};
  last = failed_increment(failed, unit_vector(cycle.direction));
  last.index = 3;
  cycle.fields.truncate(3);
  cycle.turns.clear();
  cycle.turning_point.reset();
  cycle.loop_energy.reset();
  cycle.loss_factor.reset();
  return result;
}

Case long_bearing(int bumps, int steps) {
  Case input = with_bumps(case_with_given_constants(), bumps);
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.steps = steps;
  cycle.directions = {0.0};
  return input;
}

std::string first_failure(const Cycle& cycle) {
  for (const Increment& increment : cycle.increments) {
    const ContactResiduals& r = increment.residuals;
    if (increment.converged() && r.within(1e-9, 1e-12)) continue;
    return fmt::format(
        "increment {}: converged {}, equilibrium {:.2g}, penetration {:.2g} m, slip in stick {:.2g} m, "
        "complementarity {:.2g}, cone {:.2g}",
        increment.index, increment.converged(), r.equilibrium, r.penetration, r.slip_in_stick, r.complementarity,
        r.cone);
  }
  const auto all = static_cast<std::size_t>(2 * cycle.steps + 1);
  if (cycle.increments.size() != all || !cycle.converged()) {
    return fmt::format("stopped after {} of {} increments", cycle.increments.size(), all);
  }
  return {};
}

}  // namespace bumpfoil
