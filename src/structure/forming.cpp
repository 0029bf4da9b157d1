#include "bumpfoil/structure/forming.hpp"

#include <cmath>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/structure/section.hpp"
#include "structure/series.hpp"

namespace bumpfoil {
namespace {

/// Integral of (1 - cos(psi +- y)) sin(d - y) / sin(d) over a span, y from its end at psi on. @param sign  of y
double graded_part(double psi, double sign, double d) {
  const double cosine = 0.5 * (d * std::cos(psi) - sign * std::sin(psi) * d * d * d * sine_moment(d) / std::sin(d));
  return std::tan(0.5 * d) - cosine;
}

}  // namespace

Forming make_forming(const FoilDesign& foils) {
  const TopFoilDesign& top = foils.top_foil.value();
  const double R = foils.radius.value();
  return {
      .uniform = top.flattening,
      .graded = R * R * top.seat_pressure * foils.axial_length / make_top_foil_section(foils).bending_stiffness,
      .end_angle =
          (crest_positions(foils)[static_cast<Eigen::Index>(foils.bumps.size()) - 1] + top.stagger + top.overhang) / R};
}

Vector forming_rotations(const TopFoilBeam& beam, const Forming& forming) {
  const Eigen::Index n = beam.theta.size();
  BUMPFOIL_ASSERT(n > 0);
  Vector rotations = Vector::Zero(n);
  const auto add = [&](Eigen::Index node, double theta, double sign, double d) {
    rotations[node] += beam.radius * (forming.uniform * std::tan(0.5 * d) +
                                      forming.graded * graded_part(forming.end_angle - theta, sign, d));
  };
  double theta = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double d = beam.theta[k] - theta;
    add(k, theta, -1.0, d);
    theta = beam.theta[k];
    if (k + 1 < n) add(k + 1, theta, 1.0, d);
  }
  return rotations;
}

}  // namespace bumpfoil
