#include "bumpfoil/structure/corotational.hpp"

#include <algorithm>
#include <cmath>

namespace bumpfoil {
namespace {

using Natural = Eigen::Vector3d;  ///< stretch, rotation of the start, rotation of the end

/// Element in its displaced state.
struct DisplacedElement {
  DisplacedElement(const Eigen::Vector2d& chord, const ElementVector& displacements) {
    const Eigen::Vector2d relative = displacements.segment<2>(3) - displacements.segment<2>(0);
    const Eigen::Vector2d displaced = chord + relative;
    length = displaced.norm();
    tangent = displaced / length;
    // Differences of nearly equal lengths and directions, free of cancellation.
    const double turned = std::atan2(chord.x() * relative.y() - chord.y() * relative.x(), chord.dot(displaced));
    deformations = {relative.dot(chord + displaced) / (length + chord.norm()), displacements[2] - turned,
                    displacements[5] - turned};
  }

  double length;  ///< of the chord, m
  Eigen::Vector2d tangent;
  Natural deformations;
};

/// Columns: displacements of the ends of the undisplaced element under unit stretch and rotations.
Eigen::Matrix<double, 6, 3> natural_basis(const Eigen::Vector2d& chord) {
  Eigen::Matrix<double, 6, 3> basis = Eigen::Matrix<double, 6, 3>::Zero();
  basis.block<2, 1>(3, 0) = chord.normalized();
  basis(2, 1) = 1.0;
  basis(5, 2) = 1.0;
  return basis;
}

ElementVector scale_of(const ElementChain& chain) {
  return ElementVector{{1.0, 1.0, 1.0 / chain.rotation_scale, 1.0, 1.0, 1.0 / chain.rotation_scale}};
}

/// Index of unknown i of the element in the whole system; negative if clamped.
Eigen::Index place_of(const PlacedElement& placed, int i) {
  if (i >= 3) return placed.end + i - 3;
  return placed.start < 0 ? -1 : placed.start + i;
}

/// Adds one stiffness contribution of every element.
void add_stiffness(const ElementChain& chain, const Vector& x, ElementMatrix CorotationalResponse::*stiffness,
                   BlockTridiagonal& K) {
  const ElementVector scale = scale_of(chain);
  const Eigen::Index size = K.block_size();
  for (const PlacedElement& placed : chain.elements) {
    const CorotationalResponse response = corotational_response(placed.element, end_displacements(chain, placed, x));
    const ElementMatrix scaled = scale.asDiagonal() * response.*stiffness * scale.asDiagonal();
    for (int i = 0; i < 6; ++i) {
      const Eigen::Index row = place_of(placed, i);
      if (row < 0) continue;
      for (int j = i; j < 6; ++j) {
        const Eigen::Index column = place_of(placed, j);
        K.add(static_cast<int>(row / size), static_cast<int>(row % size), static_cast<int>(column / size),
              static_cast<int>(column % size), scaled(i, j));
      }
    }
  }
}

}  // namespace

ElementVector chord_deformations(const Eigen::Vector2d& chord, const ElementVector& displacements) {
  return natural_basis(chord) * DisplacedElement(chord, displacements).deformations;
}

CorotationalElement make_corotational_element(const Eigen::Vector2d& chord, const ElementMatrix& stiffness) {
  const Eigen::Matrix<double, 6, 3> basis = natural_basis(chord);
  return {.chord = chord, .stiffness = basis.transpose() * stiffness * basis};
}

CorotationalResponse corotational_response(const CorotationalElement& element, const ElementVector& displacements) {
  const DisplacedElement displaced(element.chord, displacements);
  const Natural natural = element.stiffness * displaced.deformations;

  const Eigen::Vector2d& t = displaced.tangent;
  const ElementVector stretch{{-t.x(), -t.y(), 0.0, t.x(), t.y(), 0.0}};
  const ElementVector rotation = ElementVector{{t.y(), -t.x(), 0.0, -t.y(), t.x(), 0.0}} / displaced.length;
  Eigen::Matrix<double, 3, 6> derivative;
  derivative << stretch.transpose(), -rotation.transpose(), -rotation.transpose();
  derivative(1, 2) = derivative(2, 5) = 1.0;

  const ElementMatrix material = derivative.transpose() * element.stiffness * derivative;
  const ElementMatrix turning = displaced.length * rotation * rotation.transpose();
  const ElementMatrix coupling = stretch * rotation.transpose() / displaced.length;
  return {.energy = 0.5 * natural.dot(displaced.deformations),
          .forces = derivative.transpose() * natural,
          .tangent = material + natural[0] * turning + (natural[1] + natural[2]) * (coupling + coupling.transpose()),
          .stable_tangent = material + std::max(natural[0], 0.0) * turning};
}

ElementVector end_displacements(const ElementChain& chain, const PlacedElement& placed, const Vector& x) {
  ElementVector ends;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Index place = place_of(placed, i);
    ends[i] = place < 0 ? 0.0 : x[place];
  }
  return ends.cwiseProduct(scale_of(chain));
}

double add_corotational_forces(const ElementChain& chain, const Vector& x, Vector& forces) {
  double energy = 0.0;
  for (const PlacedElement& placed : chain.elements) {
    const CorotationalResponse own = corotational_response(placed.element, end_displacements(chain, placed, x));
    energy += own.energy;
    const ElementVector scaled = own.forces.cwiseProduct(scale_of(chain));
    for (int i = 0; i < 6; ++i) {
      const Eigen::Index place = place_of(placed, i);
      if (place >= 0) forces[place] += scaled[i];
    }
  }
  return energy;
}

void add_corotational_tangent(const ElementChain& chain, const Vector& x, BlockTridiagonal& K) {
  add_stiffness(chain, x, &CorotationalResponse::tangent, K);
}

void add_stable_tangent(const ElementChain& chain, const Vector& x, BlockTridiagonal& K) {
  add_stiffness(chain, x, &CorotationalResponse::stable_tangent, K);
}

}  // namespace bumpfoil
