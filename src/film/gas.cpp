#include "bumpfoil/film/gas.hpp"

namespace bumpfoil {

double FilmScales::bearing_number(double surface_speed) const {
  return 6.0 * gas.viscosity * surface_speed * radius / (gas.ambient_pressure * thickness * thickness);
}

double FilmScales::squeeze_time() const {
  return 12.0 * gas.viscosity * radius * radius / (gas.ambient_pressure * thickness * thickness);
}

double FilmScales::force() const {
  return gas.ambient_pressure * radius * radius;
}

double FilmScales::flow() const {
  return gas.ambient_pressure * thickness * thickness * thickness / (12.0 * gas.viscosity);
}

double FilmScales::couette_torque(double surface_speed) const {
  return gas.viscosity * surface_speed * radius * radius * radius / thickness;
}

double FilmScales::poiseuille_torque() const {
  return 0.5 * gas.ambient_pressure * thickness * radius * radius;
}

}  // namespace bumpfoil
