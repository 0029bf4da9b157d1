#include "bumpfoil/rotor/shaft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Positions closer than this fraction of the shaft length are equal.
constexpr double same_place = 1e-9;
/// Gauss points on [0, 1] and weights, exact for polynomials of degree 7. Products of shape functions have degree 6.
constexpr std::array<std::pair<double, double>, 4> gauss_points{{{0.06943184420297371, 0.17392742256872693},
                                                                 {0.33000947820757187, 0.32607257743127307},
                                                                 {0.66999052179242813, 0.32607257743127307},
                                                                 {0.93056815579702629, 0.17392742256872693}}};
constexpr int node_unknowns = 4;

double area_of(const ShaftSection& section) {
  return std::numbers::pi / 4.0 *
         (section.outer_diameter * section.outer_diameter - section.inner_diameter * section.inner_diameter);
}

/// Second moment of the cross-section about a diameter, m^4.
double second_moment_of(const ShaftSection& section) {
  return std::numbers::pi / 64.0 * (std::pow(section.outer_diameter, 4) - std::pow(section.inner_diameter, 4));
}

/// Nodes along a shaft, and the section of each element between them.
struct ShaftMesh {
  std::vector<double> nodes;
  std::vector<const ShaftSection*> elements;
};

ShaftMesh mesh_of(const ShaftDesign& design) {
  double total = 0.0;
  for (const ShaftSection& section : design.sections) total += section.length;
  ShaftMesh mesh;
  mesh.nodes.push_back(0.0);
  double begin = 0.0;
  for (const ShaftSection& section : design.sections) {
    const double end = begin + section.length;
    std::vector<double> places{end};
    for (const ShaftDisc& disc : design.discs) places.push_back(disc.z);
    places.insert(places.end(), design.bearings.begin(), design.bearings.end());
    places.insert(places.end(), design.planes.begin(), design.planes.end());
    std::sort(places.begin(), places.end());
    for (const double place : places) {
      const double from = mesh.nodes.back();
      if (place > end + same_place * total || place < from + same_place * total) continue;
      const int count = std::max(1, static_cast<int>(std::ceil((place - from) / design.longest_element - same_place)));
      for (int i = 1; i <= count; ++i) {
        mesh.nodes.push_back(i == count ? place : from + (place - from) * i / count);
        mesh.elements.push_back(&section);
      }
    }
    begin = end;
  }
  return mesh;
}

Eigen::Index node_at(const ShaftMesh& mesh, double z) {
  const auto nearest = std::min_element(mesh.nodes.begin(), mesh.nodes.end(),
                                        [z](double a, double b) { return std::abs(a - z) < std::abs(b - z); });
  BUMPFOIL_ASSERT(std::abs(*nearest - z) <= 2.0 * same_place * mesh.nodes.back());
  return nearest - mesh.nodes.begin();
}

}  // namespace

ShaftDisc solid_disc(double z, double thickness, double outer_diameter, double inner_diameter, double density) {
  const double outer = 0.25 * outer_diameter * outer_diameter;
  const double inner = 0.25 * inner_diameter * inner_diameter;
  const double mass = density * thickness * std::numbers::pi * (outer - inner);
  return {.z = z,
          .mass = mass,
          .transverse_inertia = mass * (3.0 * (outer + inner) + thickness * thickness) / 12.0,
          .polar_inertia = 0.5 * mass * (outer + inner)};
}

double shear_coefficient(const ShaftSection& section) {
  const double nu = section.poisson_ratio;
  const double ratio = section.inner_diameter / section.outer_diameter;
  const double square = ratio * ratio;
  const double both = (1.0 + square) * (1.0 + square);
  return 6.0 * (1.0 + nu) * both / ((7.0 + 6.0 * nu) * both + (20.0 + 12.0 * nu) * square);
}

ShaftElement shaft_element(const ShaftSection& section, double length) {
  const double area = area_of(section);
  const double second_moment = second_moment_of(section);
  const double bending = section.youngs_modulus * second_moment;
  const double shear =
      shear_coefficient(section) * area * section.youngs_modulus / (2.0 * (1.0 + section.poisson_ratio));
  const double phi = 12.0 * bending / (shear * length * length);
  ShaftElement element;
  element.mass.setZero();
  element.transverse_inertia.setZero();
  element.stiffness.setZero();
  for (const auto& [x, weight] : gauss_points) {
    // Displacement, rotation of the cross-section and its derivative with respect to z, and shear strain.
    Eigen::RowVector4d displacement;
    Eigen::RowVector4d rotation;
    Eigen::RowVector4d curvature;
    displacement << 1.0 - 3.0 * x * x + 2.0 * x * x * x + phi * (1.0 - x),
        length * (x - 2.0 * x * x + x * x * x + 0.5 * phi * (x - x * x)), 3.0 * x * x - 2.0 * x * x * x + phi * x,
        length * (x * x * x - x * x - 0.5 * phi * (x - x * x));
    rotation << 6.0 * (x * x - x) / length, 1.0 - 4.0 * x + 3.0 * x * x + phi * (1.0 - x), 6.0 * (x - x * x) / length,
        3.0 * x * x - 2.0 * x + phi * x;
    curvature << 6.0 * (2.0 * x - 1.0) / length, 6.0 * x - 4.0 - phi, 6.0 * (1.0 - 2.0 * x) / length,
        6.0 * x - 2.0 + phi;
    const Eigen::RowVector4d strain = phi * Eigen::RowVector4d(-1.0 / length, -0.5, 1.0 / length, -0.5);
    const double part = weight * length / ((1.0 + phi) * (1.0 + phi));
    element.mass += part * section.density * area * displacement.transpose() * displacement;
    element.transverse_inertia += part * section.density * second_moment * rotation.transpose() * rotation;
    element.stiffness +=
        part * (bending / (length * length) * curvature.transpose() * curvature + shear * strain.transpose() * strain);
  }
  return element;
}

Rotor make_flexible_rotor(const ShaftDesign& design) {
  const ShaftMesh mesh = mesh_of(design);
  const Eigen::Index n = node_unknowns * static_cast<Eigen::Index>(mesh.nodes.size());
  Rotor rotor;
  rotor.mass = rotor.gyroscopic = rotor.damping = rotor.stiffness = Eigen::MatrixXd::Zero(n, n);
  rotor.rigid = Eigen::MatrixXd::Zero(n, 4);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ShaftElement element = shaft_element(*mesh.elements[e], mesh.nodes[e + 1] - mesh.nodes[e]);
    const Eigen::Index first = node_unknowns * static_cast<Eigen::Index>(e);
    const Eigen::Vector4i in_x(0, 2, 4, 6);
    const Eigen::Vector4i in_y(1, 3, 5, 7);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double inertia = element.mass(i, j) + element.transverse_inertia(i, j);
        rotor.mass(first + in_x[i], first + in_x[j]) += inertia;
        rotor.mass(first + in_y[i], first + in_y[j]) += inertia;
        rotor.stiffness(first + in_x[i], first + in_x[j]) += element.stiffness(i, j);
        rotor.stiffness(first + in_y[i], first + in_y[j]) += element.stiffness(i, j);
        // The polar inertia of a circular section is twice the transverse one.
        rotor.gyroscopic(first + in_x[i], first + in_y[j]) += 2.0 * element.transverse_inertia(i, j);
        rotor.gyroscopic(first + in_y[i], first + in_x[j]) -= 2.0 * element.transverse_inertia(i, j);
      }
    }
  }
  const auto station_at = [&](std::string name, double z) {
    RotorStation station{
        .name = std::move(name), .z = z, .motion = Eigen::MatrixXd::Zero(2, n), .tilt = Eigen::MatrixXd::Zero(2, n)};
    const Eigen::Index first = node_unknowns * node_at(mesh, z);
    station.motion.middleCols(first, 2).setIdentity();
    station.tilt.middleCols(first + 2, 2).setIdentity();
    return station;
  };
  for (const ShaftDisc& disc : design.discs) {
    const Eigen::Index first = node_unknowns * node_at(mesh, disc.z);
    rotor.mass.diagonal().segment<4>(first) +=
        Eigen::Vector4d(disc.mass, disc.mass, disc.transverse_inertia, disc.transverse_inertia);
    rotor.gyroscopic(first + 2, first + 3) += disc.polar_inertia;
    rotor.gyroscopic(first + 3, first + 2) -= disc.polar_inertia;
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    auto block = rotor.rigid.middleRows<4>(node_unknowns * static_cast<Eigen::Index>(node));
    block.setIdentity();
    block.topRightCorner<2, 2>() = mesh.nodes[node] * Eigen::Matrix2d::Identity();
  }
  for (std::size_t i = 0; i < design.bearings.size(); ++i) {
    rotor.bearings.push_back(station_at("bearing " + std::to_string(i + 1), design.bearings[i]));
  }
  rotor.stations.push_back(station_at("begin", mesh.nodes.front()));
  for (std::size_t i = 0; i < design.discs.size(); ++i) {
    rotor.stations.push_back(station_at("disc " + std::to_string(i + 1), design.discs[i].z));
  }
  for (std::size_t i = 0; i < design.planes.size(); ++i) {
    rotor.stations.push_back(station_at("plane " + std::to_string(i + 1), design.planes[i]));
  }
  rotor.stations.push_back(station_at("end", mesh.nodes.back()));
  return rotor;
}

}  // namespace bumpfoil
