#include "bumpfoil/structure/corotational.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/core/block_tridiagonal_lu.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

const Section foil_section = make_section(214e9, 0.29, 38.1e-3, 0.102e-3);

/// Half a bump, an element that bulges, and a flat.
const std::vector<FrameElement> elements{{{1.778e-3, -0.508e-3}, 0.5566}, {{0.4e-3, 0.9e-3}, 2.5}, flat_element(1e-3)};

CorotationalElement carried(const FrameElement& element, const Section& section = foil_section) {
  return make_corotational_element(element.chord, frame_element_stiffness(section, element));
}

/// Displacements of an element a few millimetres long: large translation and rotation, little bending.
ElementVector some_displacements(int number) {
  ElementVector q;
  for (int i = 0; i < 6; ++i) q[i] = std::sin(2.7 * number + 1.9 * i);
  const double turn = q[0];
  return ElementVector{{1e-3 * q[0], 1e-3 * q[1], turn + 0.05 * q[2], 1e-3 * q[3], 1e-3 * q[4], turn + 0.05 * q[5]}};
}

/// Scales that make displacements (m) and rotations comparable.
const ElementVector unit_scales{{1e-3, 1e-3, 1.0, 1e-3, 1e-3, 1.0}};

TEST(Corotational, ForcesAreTheGradientOfTheEnergy) {
  for (const FrameElement& element : elements) {
    for (int number = 0; number < 5; ++number) {
      const ElementVector q = some_displacements(number);
      const CorotationalResponse response = corotational_response(carried(element), q);
      for (int i = 0; i < 6; ++i) {
        double best = 1.0;
        double coarsest = 0.0;
        for (const double h : {1e-2, 1e-3, 1e-4, 1e-5}) {
          const ElementVector step = h * unit_scales[i] * ElementVector::Unit(i);
          const double difference = (corotational_response(carried(element), q + step).energy -
                                     corotational_response(carried(element), q - step).energy) /
                                    (2.0 * h * unit_scales[i]);
          const double scale = response.forces.cwiseProduct(unit_scales).cwiseAbs().maxCoeff() / unit_scales[i];
          const double error = std::abs(difference - response.forces[i]) / scale;
          if (coarsest == 0.0) coarsest = error;
          best = std::min(best, error);
        }
        // Central differences: the error falls with the square of the step down to round-off.
        EXPECT_LT(best, 1e-8) << "element turning " << element.turning << ", unknown " << i;
        EXPECT_LT(best, 1e-2 * coarsest + 1e-11);
      }
    }
  }
}

TEST(Corotational, TangentIsTheDerivativeOfTheForces) {
  for (const FrameElement& element : elements) {
    for (int number = 0; number < 5; ++number) {
      const ElementVector q = some_displacements(number);
      const ElementMatrix tangent = corotational_response(carried(element), q).tangent;
      const double scale = (unit_scales.asDiagonal() * tangent * unit_scales.asDiagonal()).cwiseAbs().maxCoeff();
      EXPECT_LT((unit_scales.asDiagonal() * (tangent - tangent.transpose()) * unit_scales.asDiagonal()).norm(),
                1e-14 * scale);
      for (int i = 0; i < 6; ++i) {
        double best = 1.0;
        for (const double h : {1e-3, 1e-4, 1e-5, 1e-6}) {
          const ElementVector step = h * unit_scales[i] * ElementVector::Unit(i);
          const ElementVector difference = (corotational_response(carried(element), q + step).forces -
                                            corotational_response(carried(element), q - step).forces) /
                                           (2.0 * h);
          const ElementVector exact = unit_scales[i] * tangent.col(i);
          best = std::min(best, (difference - exact).cwiseProduct(unit_scales).norm() / scale);
        }
        EXPECT_LT(best, 1e-9) << "element turning " << element.turning << ", unknown " << i;  // as above
      }
    }
  }
}

TEST(Corotational, StableTangentNeverPullsAndLacksNothingUnderTension) {
  for (const FrameElement& element : elements) {
    for (int number = 0; number < 5; ++number) {
      const CorotationalResponse response = corotational_response(carried(element), some_displacements(number));
      const ElementMatrix scaled = unit_scales.asDiagonal() * response.stable_tangent * unit_scales.asDiagonal();
      const ElementVector values = symmetric_eigenvalues(scaled);
      EXPECT_GT(values.minCoeff(), -1e-12 * values.maxCoeff());  // zero for rigid motions
    }
    // Stretched by a thousandth along its chord, with both rotations fixed: equal and opposite end moments.
    const Eigen::Vector2d stretch = 1e-3 * element.chord;
    const ElementVector q{{0.0, 0.0, 0.0, stretch.x(), stretch.y(), 0.0}};
    const CorotationalResponse stretched = corotational_response(carried(element), q);
    EXPECT_LT(
        (unit_scales.asDiagonal() * (stretched.tangent - stretched.stable_tangent) * unit_scales.asDiagonal()).norm(),
        1e-12 * (unit_scales.asDiagonal() * stretched.tangent * unit_scales.asDiagonal()).norm());
  }
}

TEST(Corotational, RigidMotionStrainsNothing) {
  for (const FrameElement& element : elements) {
    for (const double angle : {-3.0, -0.7, 1e-9, 0.4, 3.1}) {
      const Eigen::Vector2d moved = Eigen::Rotation2Dd(angle) * element.chord - element.chord;
      const ElementVector q{{5e-3, -7e-3, angle, 5e-3 + moved.x(), -7e-3 + moved.y(), angle}};
      const CorotationalResponse response = corotational_response(carried(element), q);
      const CorotationalResponse bent =
          corotational_response(carried(element), q + 1e-3 * unit_scales.cwiseProduct(ElementVector::Unit(3)));
      // Round-off of displacements of millimetres compared with a strain of a micrometre.
      EXPECT_LT(response.forces.norm(), 1e-10 * bent.forces.norm());
      EXPECT_LT(response.energy, 1e-20 * bent.energy + 1e-24);
      EXPECT_LT(chord_deformations(element.chord, q).norm(), 1e-15);
    }
  }
}

TEST(Corotational, AtRestIsTheLinearElement) {
  for (const FrameElement& element : elements) {
    const ElementMatrix linear = frame_element_stiffness(foil_section, element);
    const CorotationalResponse at_rest = corotational_response(carried(element), ElementVector::Zero());
    EXPECT_EQ(at_rest.forces.norm(), 0.0);
    EXPECT_LT((unit_scales.asDiagonal() * (at_rest.tangent - linear) * unit_scales.asDiagonal()).norm(),
              1e-13 * (unit_scales.asDiagonal() * linear * unit_scales.asDiagonal()).norm());
    // Small displacements: forces differ by second-order terms.
    const ElementVector q = 1e-3 * ElementVector{{2e-6, -1e-6, 3e-3, 1e-6, 4e-6, -2e-3}};
    for (const double factor : {1.0, 0.1}) {
      const ElementVector forces = corotational_response(carried(element), factor * q).forces;
      EXPECT_LT((forces - factor * linear * q).norm(), 1e-3 * factor * factor * (linear * q).norm());
    }
  }
}

/// A cantilever of `count` equal elements in blocks of one node, straight if turning is 0.
ElementChain cantilever(int count, double length, double turning, const Section& section) {
  ElementChain chain{.rotation_scale = 1.0, .elements = {}};
  const double each = turning / count;
  const double chord = turning == 0.0 ? length / count : 2.0 * length / turning * std::sin(0.5 * each);
  for (int i = 0; i < count; ++i) {
    const double slope = (i + 0.5) * each;
    const FrameElement element{chord * Eigen::Vector2d(std::cos(slope), std::sin(slope)), each};
    chain.elements.push_back({carried(element, section), 3 * (i - 1), 3 * i});
  }
  chain.elements.front().start = -1;
  return chain;
}

/// Displacements under a load on the last node, applied in steps, by Newton's method.
Vector equilibrium(const ElementChain& chain, const Eigen::Vector3d& end_load) {
  const auto nodes = static_cast<int>(chain.elements.size());
  Vector x = Vector::Zero(3 * Eigen::Index{nodes});
  Vector load = Vector::Zero(x.size());
  constexpr int steps = 20;
  for (int step = 1; step <= steps; ++step) {
    load.tail<3>() = end_load * step / steps;
    for (int i = 0; i < 50; ++i) {
      Vector forces = Vector::Zero(x.size());
      add_corotational_forces(chain, x, forces);
      if ((forces - load).norm() < 1e-9 * load.norm()) break;
      BlockTridiagonal K(nodes, 3);
      add_corotational_tangent(chain, x, K);
      BlockTridiagonalLU<3> lu(nodes, 3);
      for (int n = 0; n < nodes; ++n) {
        lu.diagonal(n) = K.diagonal[static_cast<std::size_t>(n)];
        if (n == 0) continue;
        lu.upper(n - 1) = K.upper[static_cast<std::size_t>(n - 1)];
        lu.lower(n) = lu.upper(n - 1).transpose();
      }
      EXPECT_TRUE(lu.factor());
      Vector correction = load - forces;
      lu.solve_in_place(correction);
      x += correction;
    }
  }
  return x;
}

/// Bends but hardly stretches: EI = 1 N m^2, EA = 1e8 N.
const Section inextensible_beam{.bending_stiffness = 1.0, .axial_stiffness = 1e8, .modulus = 1.0};

TEST(Corotational, CantileverUnderAnEndForceMeetsTheElastica) {
  // Elliptic integrals [Mattiasson1981, Table I]: drop and shortening at the end relative to the length, and its slope.
  struct Row {
    double load, drop, approach, slope;  ///< P L^2 / EI
  };
  const std::vector<Row> table{{1.0, 0.30172, 0.05643, 0.46135},
                               {2.0, 0.49346, 0.16064, 0.78175},
                               {5.0, 0.71379, 0.38763, 1.21537},
                               {10.0, 0.81061, 0.55500, 1.43029}};
  for (const Row& row : table) {
    double coarse_error = 0.0;
    for (const int count : {20, 80}) {
      const Vector x = equilibrium(cantilever(count, 1.0, 0.0, inextensible_beam), {0.0, row.load, 0.0});
      const Eigen::Vector3d end = x.tail<3>();
      const double error = (end - Eigen::Vector3d(-row.approach, row.drop, row.slope)).cwiseAbs().maxCoeff();
      // Second order in the element length: 20 elements have errors below 0.2 %, four times as many sixteen times less,
      // down to the last digit of the table.
      EXPECT_LT(error, count == 20 ? 2e-3 : coarse_error / 12.0 + 1e-5) << "load " << row.load;
      coarse_error = error;
    }
  }
}

TEST(Corotational, CantileverUnderAnEndMomentBendsToAPolygonOnACircle) {
  // Constant moment: the slope of the end is M L / EI, exact for any number of elements; every element keeps its chord
  // length, and turns by the mean of its end rotations.
  const double slope = 0.95 * std::numbers::pi;
  constexpr int count = 8;
  const Vector x = equilibrium(cantilever(count, 1.0, 0.0, inextensible_beam), {0.0, 0.0, slope});
  Eigen::Vector2d end(0.0, 0.0);
  for (int i = 0; i < count; ++i)
    end += Eigen::Vector2d(std::cos(slope * (i + 0.5) / count), std::sin(slope * (i + 0.5) / count)) / count;
  EXPECT_NEAR(x[3 * count - 1], slope, 1e-9);  // Newton tolerance on the load
  EXPECT_NEAR(x[3 * count - 3], end.x() - 1.0, 1e-9);
  EXPECT_NEAR(x[3 * count - 2], end.y(), 1e-9);
}

TEST(Corotational, CurvedBeamStraightensUnderItsMoment) {
  // A quarter circle under the moment EI * curvature, which straightens it: the end lies in the direction of the weld,
  // at a distance equal to the length. Elements are curved and assume small deformations: errors fall with their
  // subtended angle.
  const double quarter = 0.5 * std::numbers::pi;
  double coarse_error = 0.0;
  for (const int count : {4, 16}) {
    const Vector x = equilibrium(cantilever(count, 1.0, quarter, inextensible_beam), {0.0, 0.0, -quarter});
    EXPECT_NEAR(x[3 * count - 1], -quarter, 1e-9);
    const double radius = 1.0 / quarter;
    const double error = std::hypot(x[3 * count - 3] + radius - 1.0, x[3 * count - 2] + radius);
    EXPECT_LT(error, count == 4 ? 0.02 : coarse_error / 12.0);  // second order, as above
    coarse_error = error;
  }
}

TEST(Corotational, ClampedStartHasNoUnknowns) {
  const ElementChain chain = cantilever(2, 1.0, 0.0, inextensible_beam);
  const Vector x = Vector::LinSpaced(6, 0.01, 0.06);
  EXPECT_EQ(end_displacements(chain, chain.elements.front(), x).head<3>().norm(), 0.0);
  EXPECT_EQ(Vector(end_displacements(chain, chain.elements.back(), x)), x);
}

}  // namespace
}  // namespace bumpfoil
