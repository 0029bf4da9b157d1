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

Vector crest_positions(const BumpFoil& foil) {
  return foil.pitch * (Vector::LinSpaced(foil.bumps, 0.0, foil.bumps - 1.0).array() + 0.5);
}

Vector foot_positions(const BumpFoil& foil, bool welded) {
  const Vector crests = crest_positions(foil);
  if (foil.model != BumpFoilModel::frame) {
    const int before = welded ? 0 : 1;
    return foil.pitch * Vector::LinSpaced(foil.bumps + before, 1.0 - before, foil.bumps);
  }
  Vector feet(2 * crests.size());
  feet(Eigen::seqN(0, crests.size(), 2)) = crests.array() - 0.5 * foil.length;
  feet(Eigen::seqN(1, crests.size(), 2)) = crests.array() + 0.5 * foil.length;
  return feet;
}

Vector crest_angles(const Case& input) {
  return crest_positions(input.bump_foil) / input.bearing.radius;
}

Vector foot_angles(const Case& input) {
  return foot_positions(input.bump_foil) / input.bearing.radius;
}

Vector polar_angles(const Bearing& bearing, const Vector& theta) {
  const double sigma = bearing.wrap == Wrap::clockwise ? -1.0 : 1.0;
  return bearing.weld_angle + sigma * theta.array();
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

Eigen::Matrix2Xd outward_normals(const Vector& phi) {
  Eigen::Matrix2Xd normals(2, phi.size());
  for (Eigen::Index i = 0; i < phi.size(); ++i) normals.col(i) = unit_vector(phi[i]);
  return normals;
}

Vector journal_gaps(double clearance, const Eigen::Matrix2Xd& normals, const Eigen::Vector2d& position) {
  return clearance - (normals.transpose() * position).array();
}

Eigen::Vector2d journal_force(const Eigen::Matrix2Xd& normals, const Vector& journal_loads) {
  return normals * journal_loads;
}

}  // namespace bumpfoil
