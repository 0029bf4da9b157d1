#include "bumpfoil/model/geometry.hpp"

#include <cmath>
#include <numbers>

namespace bumpfoil {

BumpArc make_bump_arc(const BumpFoil& foil) {
  BumpArc arc;
  arc.half_length = 0.5 * foil.length;
  arc.rise = foil.height_reference == HeightReference::overall ? foil.height - foil.thickness : foil.height;
  arc.radius = (arc.half_length * arc.half_length + arc.rise * arc.rise) / (2.0 * arc.rise);
  arc.half_angle = 2.0 * std::atan2(arc.rise, arc.half_length);
  arc.flat = foil.pitch - foil.length;
  return arc;
}

Vector crest_angles(const Case& input) {
  const double pitch_angle = input.bump_foil.pitch / input.bearing.radius;
  return (Vector::LinSpaced(input.bump_foil.bumps, 0.0, input.bump_foil.bumps - 1.0).array() + 0.5) * pitch_angle;
}

Vector foot_angles(const Case& input) {
  const Vector crests = crest_angles(input);
  const double half_pitch_angle = 0.5 * input.bump_foil.pitch / input.bearing.radius;
  if (input.bump_foil.model != BumpFoilModel::frame) return crests.array() + half_pitch_angle;
  const double half_arc_angle = 0.5 * input.bump_foil.length / input.bearing.radius;
  Vector feet(2 * crests.size());
  for (Eigen::Index i = 0; i < crests.size(); ++i) {
    feet[2 * i] = crests[i] - half_arc_angle;
    feet[2 * i + 1] = crests[i] + half_arc_angle;
  }
  return feet;
}

Vector polar_angles(const Bearing& bearing, const Vector& theta) {
  const double sigma = bearing.wrap == Wrap::clockwise ? -1.0 : 1.0;
  return bearing.weld_angle + sigma * theta.array();
}

Vector journal_gaps(const Bearing& bearing, const Vector& phi, const Eigen::Vector2d& position) {
  return bearing.radial_clearance - (position.x() * phi.array().cos() + position.y() * phi.array().sin());
}

Eigen::Vector2d journal_force(const Vector& phi, const Vector& journal_loads) {
  return {journal_loads.dot(phi.array().cos().matrix()), journal_loads.dot(phi.array().sin().matrix())};
}

Eigen::Vector2d unit_vector(double direction) {
  const double quarter_turns = direction / (0.5 * std::numbers::pi);
  const double nearest = std::round(quarter_turns);
  if (std::abs(quarter_turns - nearest) < 1e-14 * (1.0 + std::abs(nearest))) {
    const double quadrant = nearest - 4.0 * std::floor(nearest / 4.0);
    if (quadrant == 0.0) return {1.0, 0.0};
    if (quadrant == 1.0) return {0.0, 1.0};
    if (quadrant == 2.0) return {-1.0, 0.0};
    return {0.0, -1.0};
  }
  return {std::cos(direction), std::sin(direction)};
}

}  // namespace bumpfoil
