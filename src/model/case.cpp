#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

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
