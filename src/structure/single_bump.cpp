#include "bumpfoil/structure/single_bump.hpp"

#include <cmath>

#include "structure/series.hpp"

namespace bumpfoil {
namespace {

/// 1 - cos(x)
double versine(double x) {
  const double s = std::sin(0.5 * x);
  return 2.0 * s * s;
}

/// Stiffness for the dimensionless compliance `flexibility` of half the bump.
double stiffness(const BumpArc& arc, const Section& section, double flexibility) {
  return 2.0 * section.bending_stiffness / (arc.radius * arc.radius * arc.radius * flexibility);
}

}  // namespace

std::optional<double> sliding_bump_stiffness(const BumpArc& arc, const Section& section, double thrust_ratio) {
  const double alpha = arc.half_angle;
  const double cubed = alpha * alpha * alpha;
  const double sine = std::sin(alpha);
  const double v = versine(alpha);
  const double load = alpha * sine * sine - 2.0 * sine * v + 2.0 * cubed * sine_remainder(2.0 * alpha);
  const double thrust = sine * cubed * sine_moment(alpha) - 0.5 * v * v;
  const double flexibility = load - thrust_ratio * thrust;
  if (flexibility <= 0.0) return std::nullopt;
  return stiffness(arc, section, flexibility);
}

double shallow_bump_stiffness(const BumpArc& arc, const Section& section) {
  return 6.0 * section.bending_stiffness / (arc.half_length * arc.half_length * arc.half_length);
}

double guided_bump_stiffness(const BumpArc& arc, const Section& section) {
  const double alpha = arc.half_angle;
  const double v = versine(alpha);
  return stiffness(arc, section, 2.0 * alpha * alpha * alpha * sine_remainder(2.0 * alpha) - v * v / alpha);
}

double bump_force_scale(const FoilDesign& foils) {
  const BumpShape& bump = foils.bumps.front();
  return bump.rise * shallow_bump_stiffness(make_bump_arc(bump), make_section(foils.youngs_modulus, foils.poisson_ratio,
                                                                              foils.bump_foil_width(), bump.thickness));
}

}  // namespace bumpfoil
