#include "bumpfoil/structure/frame_element.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/linear_algebra.hpp"
#include "structure/series.hpp"

namespace bumpfoil {
namespace {

/// sin(x) / x
double sinc(double x) {
  return 1.0 - x * x * sine_remainder(x);
}

/// Relative displacement of the ends, each carried rigidly to the elastic centre, in the axes of the chord, and its
/// flexibilities.
struct ElasticCentre {
  Eigen::Matrix<double, 3, 6> relative;
  Eigen::Vector3d flexibility;
};

ElasticCentre elastic_centre(const Section& section, const FrameElement& element) {
  const double x = element.turning;
  const double l = element.length();
  const Eigen::Vector2d t = element.chord.normalized();
  const Eigen::Vector2d n(-t.y(), t.x());

  ElasticCentre centre;
  const double bending = l * l * l / section.bending_stiffness;
  const double stretching = l / section.axial_stiffness;
  centre.flexibility = {bending * x * x * arc_bow(x) + stretching * 0.5 * (1.0 + sinc(x)),
                        bending * 0.5 * sine_remainder(x) + stretching * 0.5 * x * x * sine_remainder(x),
                        l / section.bending_stiffness};

  // The centroid is offset from mid-chord to the outer side of the curve.
  const Eigen::Vector2d from_start = 0.5 * element.chord - 0.25 * l * x * sine_moment(0.5 * x) * n;
  const Eigen::Vector2d from_end = from_start - element.chord;
  const auto carry = [&](const Eigen::Vector2d& arm) {
    const Eigen::Vector2d turned(-arm.y(), arm.x());
    Eigen::Matrix3d rigid;
    rigid << t.x(), t.y(), t.dot(turned), n.x(), n.y(), n.dot(turned), 0.0, 0.0, 1.0;
    return rigid;
  };
  centre.relative << -carry(from_start), carry(from_end);
  return centre;
}

}  // namespace

double FrameElement::length() const {
  return chord.norm() / sinc(0.5 * turning);
}

FrameElement rising_half(const BumpArc& arc) {
  return {{arc.half_length, -arc.rise}, arc.half_angle};
}

FrameElement falling_half(const BumpArc& arc) {
  return {{arc.half_length, arc.rise}, arc.half_angle};
}

FrameElement flat_element(double length) {
  return {{length, 0.0}, 0.0};
}

ElementMatrix frame_element_stiffness(const Section& section, const FrameElement& element) {
  const ElasticCentre centre = elastic_centre(section, element);
  return centre.relative.transpose() * centre.flexibility.cwiseInverse().asDiagonal() * centre.relative;
}

ElementMatrix stiffness_in_series(const ElementMatrix& first, const ElementMatrix& second) {
  const Eigen::Matrix3d between = first.bottomRightCorner<3, 3>() + second.topLeftCorner<3, 3>();
  Eigen::Matrix<double, 3, 6> coupling;
  coupling << first.bottomLeftCorner<3, 3>(), second.topRightCorner<3, 3>();
  ElementMatrix stiffness = -transposed_product(coupling, solve_positive(between, coupling));
  stiffness.topLeftCorner<3, 3>() += first.topLeftCorner<3, 3>();
  stiffness.bottomRightCorner<3, 3>() += second.bottomRightCorner<3, 3>();
  return stiffness;
}

ElementForces element_forces(const Section& section, const FrameElement& element, const ElementVector& displacements) {
  const ElasticCentre centre = elastic_centre(section, element);
  const Eigen::Vector3d forces = (centre.relative * displacements).cwiseQuotient(centre.flexibility);
  return {forces[0], forces[1], forces[2]};
}

double bending_moment(const FrameElement& element, const ElementForces& forces, double s) {
  const double x = element.turning;
  const double l = element.length();
  // Position of the section relative to the elastic centre. With R = l / x: xi = R sin(s x), eta = R (sin(x/2) / (x/2)
  // - cos(s x)).
  const double xi = l * s * sinc(s * x);
  const double half_sinc = sinc(0.5 * s * x);
  const double eta = l * x * (0.5 * s * s * half_sinc * half_sinc - 0.25 * sine_remainder(0.5 * x));
  return forces.moment - xi * forces.across + eta * forces.along;
}

double largest_moment(const FrameElement& element, const ElementForces& forces) {
  double largest = std::max(std::abs(bending_moment(element, forces, -0.5)),  //
                            std::abs(bending_moment(element, forces, 0.5)));
  if (element.turning == 0.0) return largest;
  // dM/ds = l (along sin(s x) - across cos(s x)) has at most three zeros below a full circle.
  const double stationary = forces.along == 0.0 ? 0.5 * std::numbers::pi : std::atan(forces.across / forces.along);
  for (const double angle : {stationary - std::numbers::pi, stationary, stationary + std::numbers::pi}) {
    const double s = angle / element.turning;
    if (std::abs(s) < 0.5) largest = std::max(largest, std::abs(bending_moment(element, forces, s)));
  }
  return largest;
}

}  // namespace bumpfoil
