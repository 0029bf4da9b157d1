#include "bumpfoil/model/geometry.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace bumpfoil {

BumpShape nominal_bump(const BumpFoil& foil) {
  const bool overall = foil.height_reference == HeightReference::overall;
  return {.pitch = foil.pitch,
          .half_length = 0.5 * foil.length,
          .rise = overall ? foil.height - foil.thickness : foil.height,
          .thickness = foil.thickness};
}

FoilDesign make_bearing_design(const Case& input) {
  const BumpFoil& foil = input.bump_foil;
  FoilDesign foils{.model = foil.model,
                   .geometry = foil.geometry,
                   .bumps = std::vector<BumpShape>(static_cast<std::size_t>(foil.bumps), nominal_bump(foil)),
                   .youngs_modulus = foil.youngs_modulus,
                   .poisson_ratio = foil.poisson_ratio,
                   .axial_length = input.bearing.axial_length,
                   .radius = input.bearing.radius,
                   .welded = true,
                   .weld_at = foil.weld_at,
                   .truss = foil.truss,
                   .top_foil = {}};
  if (foil.stiffness_follows_height) {
    for (std::size_t n = 0; n < foil.height_errors.size(); ++n) {
      BumpFoil own = foil;
      own.height += foil.height_errors[n];
      foils.bumps[n] = nominal_bump(own);
    }
  }
  if (foil.model != BumpFoilModel::former) {
    foils.top_foil = {.thickness = input.top_foil.thickness,
                      .youngs_modulus = input.top_foil.youngs_modulus,
                      .poisson_ratio = input.top_foil.poisson_ratio};
  }
  return foils;
}

FoilDesign make_strip_design(const Case& input) {
  FoilDesign foils = make_bearing_design(cut_to_strip(input));
  foils.radius.reset();
  foils.welded = input.strip->weld == StripWeld::one_end;
  if (!input.strip->top_foil) foils.top_foil.reset();
  return foils;
}

Vector crest_angles(const Case& input) {
  return crest_positions(make_bearing_design(input)) / input.bearing.radius;
}

Vector foot_angles(const Case& input) {
  return foot_positions(make_bearing_design(input)) / input.bearing.radius;
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
