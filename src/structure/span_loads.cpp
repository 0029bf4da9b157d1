#include "bumpfoil/structure/span_loads.hpp"

#include <cmath>

#include "bumpfoil/core/assert.hpp"
#include "structure/series.hpp"

namespace bumpfoil {
namespace {

/// (1 - cos d) (1 - d / sin d) / (2 sin d): the integral of chi over a span, where chi'' + chi = sin(t) / sin(d) and
/// chi is zero at both ends.
double end_rotation(double d) {
  const double sine = std::sin(d);
  return -std::tan(0.5 * d) * d * d * d * sine_remainder(d) / (2.0 * sine);
}

}  // namespace

Vector crest_loads(const TopFoilBeam& beam, const TopFoilMoments& form, double end_angle, const Vector& line_load) {
  const Eigen::Index n = beam.theta.size();
  const double R = beam.radius;
  const double overhang = end_angle - beam.theta[n - 1];
  BUMPFOIL_ASSERT(form.welded && form.size() == n && line_load.size() == n + 1 && overhang >= 0.0);
  Vector loads = Vector::Zero(n);
  Vector rotations = Vector::Zero(n);  // of the moments at the weld and at all crests except the last
  for (Eigen::Index k = 0; k < n; ++k) {
    const double d = beam.theta[k] - (k > 0 ? beam.theta[k - 1] : 0.0);
    const double reaction = line_load[k] * R * std::tan(0.5 * d);
    const double rotation = R * R * R / beam.bending_stiffness * line_load[k] * end_rotation(d);
    rotations[k] += rotation;
    if (k + 1 < n) rotations[k + 1] += rotation;
    if (k > 0) loads[k - 1] += reaction;
    loads[k] += reaction;
  }

  // The overhang determines the moment at the last crest.
  const double end_moment = line_load[n] * R * R * 2.0 * std::pow(std::sin(0.5 * overhang), 2);
  const double last = beam.theta[n - 1] - (n > 1 ? beam.theta[n - 2] : 0.0);
  const double flexibility = R * std::pow(last / std::sin(last), 2) * last / beam.bending_stiffness;
  rotations[n - 1] += flexibility * 0.5 * sine_moment(last) * end_moment;
  loads[n - 1] += line_load[n] * R * std::sin(overhang) + end_moment / (R * std::tan(last));
  if (n > 1) loads[n - 2] -= form.inverse_sine[n - 1] * end_moment;

  const Vector moments = solve_tridiagonal(form.compliance_diagonal, form.compliance_off, rotations);
  return loads + loads_of_moments(form, moments);
}

}  // namespace bumpfoil
