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

Case cut_to_strip(const Case& input) {
  Case cut = input;
  const auto bumps = static_cast<std::size_t>(input.bump_foil.bumps);
  for (PerBump* dimension :
       {&cut.bump_foil.pitch, &cut.bump_foil.length, &cut.bump_foil.height, &cut.bump_foil.thickness}) {
    if (dimension->law) *dimension = listed(*dimension, bumps);
  }
  cut.bump_foil.bumps = input.strip->bumps;
  for (std::vector<double>* list : {&cut.bump_foil.height_errors, &cut.bump_foil.sleeve_gaps}) {
    if (!list->empty()) list->resize(static_cast<std::size_t>(cut.bump_foil.bumps));
  }
  return cut;
}

}  // namespace bumpfoil
