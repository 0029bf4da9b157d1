#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

Case reference_case() {
  Case reference;
  reference.title = "First-generation bearing, Arghir & Benchekroun 2019, Table 1";
  reference.bearing.radius = 19.05e-3;
  reference.bearing.axial_length = 38.1e-3;
  reference.bearing.radial_clearance = 31.8e-6;
  BumpFoil& foil = reference.bump_foil;
  foil.bumps = 26;
  foil.pitch = 4.572e-3;
  foil.length = 3.556e-3;
  foil.height = 0.508e-3;
  foil.thickness = 0.102e-3;
  foil.youngs_modulus = 214e9;
  foil.poisson_ratio = 0.29;
  reference.top_foil = {.thickness = 0.102e-3, .youngs_modulus = 214e9, .poisson_ratio = 0.29};
  reference.friction = {.top_bump = 0.1, .bump_sleeve = 0.1};
  constexpr double pi = std::numbers::pi;
  reference.cycle = {.directions = {0.0, pi, 0.5 * pi, 1.5 * pi}, .amplitude = {.value = 79.5e-6}, .steps = 100};
  return reference;
}

SolverName ensemble_solver(const Case& input) {
  const bool cycles = input.montecarlo && input.montecarlo->command == EnsembleCommand::cycle;
  return cycles && input.bump_foil.geometry == Geometry::linear ? SolverName::events : SolverName::newton;
}

}  // namespace bumpfoil
