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

Case bearing_at(const Case& input, std::size_t place) {
  Case alone;
  static_cast<BearingDesign&>(alone) = input;
  alone.title = input.title;
  alone.solver = input.solver;
  alone.gas = input.gas;
  alone.film = input.film;
  alone.width = input.width;
  alone.asperity = input.asperity;
  if (input.rotor_bearings.empty()) return alone;
  const RotorBearing& own = input.rotor_bearings.at(place);
  alone.bearing = own.bearing.value_or(alone.bearing);
  alone.bump_foil = own.bump_foil.value_or(alone.bump_foil);
  alone.top_foil = own.top_foil.value_or(alone.top_foil);
  if (!own.pads.empty()) alone.pads = own.pads;
  alone.friction = own.friction.value_or(alone.friction);
  alone.gas = own.gas.value_or(alone.gas);
  alone.film = own.film.value_or(alone.film);
  alone.width = own.width.value_or(alone.width);
  if (own.asperity) alone.asperity = own.asperity;
  return alone;
}

std::size_t strips_drawn_apart(const Case& input) {
  const bool apart = input.montecarlo->bump_height && input.lets_strips_move_apart();
  return apart ? static_cast<std::size_t>(input.bump_foil.strips) : 1;
}

}  // namespace bumpfoil
