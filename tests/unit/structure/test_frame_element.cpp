#include "bumpfoil/structure/frame_element.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;
const Section element_section = make_section(214e9, 0.29, 38.1e-3, 0.102e-3);
/// Bending only: axial stiffness 1e8 times higher, which leaves errors of at most 1e-8.
const Section inextensible_section{.bending_stiffness = 1.0, .axial_stiffness = 1e8, .modulus = 1.0};

using Long = long double;
using LongMatrix3 = Eigen::Matrix<Long, 3, 3>;

/// Displacements (u, v, rotation) of the end of an element clamped at its start per unit of end forces and moment: the
/// integrals of Castigliano's theorem by a composite three-point Gauss rule.
LongMatrix3 integrated_flexibility(const Section& section, const FrameElement& element) {
  constexpr int pieces = 400;  // error (turning / pieces)^6 below 1e-15
  const Long x = element.turning;
  const Long l = element.length();
  const Long first_angle = std::atan2(Long{element.chord.y()}, Long{element.chord.x()}) - x / 2;
  LongMatrix3 flexibility = LongMatrix3::Zero();
  Eigen::Matrix<Long, 2, 1> place(0, 0);  // position along the curve
  const Eigen::Matrix<Long, 2, 1> end = element.chord.cast<Long>();
  const Long h = l / pieces;
  const Long gauss = std::sqrt(Long{3} / 5);
  const std::array rule{std::pair{-gauss, Long{5} / 18}, std::pair{Long{0}, Long{8} / 18},
                        std::pair{gauss, Long{5} / 18}};
  const auto step = [&](Long from, Long to) {  // exact chord between two arc lengths
    const Long angle = first_angle + x * (from + to) / (2 * l);
    const Long half = x * (to - from) / (2 * l);
    const Long chord = (to - from) * (std::abs(half) < 1e-6L ? 1 - half * half / 6 : std::sin(half) / half);
    return Eigen::Matrix<Long, 2, 1>(chord * std::cos(angle), chord * std::sin(angle));
  };
  for (int i = 0; i < pieces; ++i) {
    for (const auto& [point, weight] : rule) {
      const Long s = h * (i + (1 + point) / 2);
      const Eigen::Matrix<Long, 2, 1> arm = end - place - step(h * i, s);
      const Long angle = first_angle + x * s / l;
      const Eigen::Matrix<Long, 3, 1> moment(-arm.y(), arm.x(), 1);
      const Eigen::Matrix<Long, 3, 1> axial(std::cos(angle), std::sin(angle), 0);
      flexibility += h * weight *
                     (moment * moment.transpose() / Long{section.bending_stiffness} +
                      axial * axial.transpose() / Long{section.axial_stiffness});
    }
    place += step(h * i, h * (i + 1));
  }
  return flexibility;
}

TEST(FrameElement, EqualsTheInverseOfTheIntegratedFlexibility) {
  const double c = 1.778e-3;
  for (const double turning : {0.0, 1e-9, 1e-4, 0.02, 0.898, -0.898, 2.5, 4.5}) {
    for (const double direction : {0.0, -0.449, 2.0}) {
      const FrameElement element{{c * std::cos(direction), c * std::sin(direction)}, turning};
      const ElementMatrix K = frame_element_stiffness(element_section, element);
      const LongMatrix3 exact = integrated_flexibility(element_section, element).inverse();
      // Rotations times the chord length, so that all entries are N/m.
      const Eigen::Matrix<Long, 3, 1> scale(1, 1, 1 / Long{c});
      const LongMatrix3 error =
          scale.asDiagonal() * (K.bottomRightCorner<3, 3>().cast<Long>() - exact) * scale.asDiagonal();
      const LongMatrix3 reference = scale.asDiagonal() * exact * scale.asDiagonal();
      EXPECT_LT(error.norm(), 1e-12L * reference.norm()) << turning << ' ' << direction;
      // Soft directions too: loads on a foil act through the flexibility, not the stiffness.
      const LongMatrix3 product = scale.cwiseInverse().asDiagonal() * integrated_flexibility(element_section, element) *
                                  K.bottomRightCorner<3, 3>().cast<Long>() * scale.asDiagonal();
      EXPECT_LT((product - LongMatrix3::Identity()).norm(), 1e-10L) << turning << ' ' << direction;
    }
  }
}

TEST(FrameElement, IsSymmetricAndFreeOnlyOfRigidMotions) {
  for (const double turning : {0.0, 1e-6, 0.898, -2.5, 5.0}) {
    const FrameElement element{{1.2, -0.7}, turning};
    const ElementMatrix K = frame_element_stiffness({1.0, 3.0, 1.0}, element);
    EXPECT_LT((K - K.transpose()).norm(), 1e-14 * K.norm());
    ElementVector rotation;
    rotation << 0.0, 0.0, 1.0, -element.chord.y(), element.chord.x(), 1.0;
    ElementVector along;
    along << 1.0, 0.0, 0.0, 1.0, 0.0, 0.0;
    ElementVector across;
    across << 0.0, 1.0, 0.0, 0.0, 1.0, 0.0;
    for (const ElementVector& rigid : {rotation, along, across}) EXPECT_LT((K * rigid).norm(), 1e-14 * K.norm());
    const Vector modes = symmetric_eigenvalues(K);
    EXPECT_GT(modes[0], -1e-14 * K.norm());
    EXPECT_LT(modes[2], 1e-14 * K.norm());
    EXPECT_GT(modes[3], 1e-3 * K.norm());
  }
}

TEST(FrameElement, StraightOneIsTheTextbookBeam) {
  const double l = 1.7;
  const double EI = 2.3;
  const double EA = 11.0;
  ElementMatrix beam = ElementMatrix::Zero();
  beam.row(0) << EA / l, 0, 0, -EA / l, 0, 0;
  beam.row(1) << 0, 12 * EI / (l * l * l), 6 * EI / (l * l), 0, -12 * EI / (l * l * l), 6 * EI / (l * l);
  beam.row(2) << 0, 6 * EI / (l * l), 4 * EI / l, 0, -6 * EI / (l * l), 2 * EI / l;
  beam.row(3) = -beam.row(0);
  beam.row(4) = -beam.row(1);
  beam.row(5) << 0, 6 * EI / (l * l), 2 * EI / l, 0, -6 * EI / (l * l), 4 * EI / l;
  EXPECT_LT((frame_element_stiffness({EI, EA, 1.0}, flat_element(l)) - beam).norm(), 1e-14 * beam.norm());
}

TEST(FrameElement, QuarterCircleCantileverHasThePublishedDeflections) {
  // Thin quarter circle of radius R clamped at one end, force P at the free end along the tangent at the clamp: it
  // moves by pi/4 P R^3 / EI along the force, by half of P R^3 / EI across it, and turns by P R^2 / EI [Timoshenko,
  // Strength of Materials, part I].
  const FrameElement quarter{{1.0, 1.0}, pi / 2};  // starts along x, ends along y
  const Eigen::Matrix3d flexibility =
      frame_element_stiffness(inextensible_section, quarter).bottomRightCorner<3, 3>().inverse();
  constexpr double stretching_left = 2e-8;
  EXPECT_NEAR(flexibility(0, 0), pi / 4, stretching_left);
  EXPECT_NEAR(flexibility(1, 0), -0.5, stretching_left);
  EXPECT_NEAR(flexibility(2, 0), -1.0, stretching_left);
  EXPECT_NEAR(flexibility(1, 1), 3 * pi / 4 - 2, stretching_left);  // force along the free end's tangent
}

TEST(FrameElement, FixedSemicircularArchHasThePublishedThrustAndMoments) {
  // Fixed semicircular arch under a central load P: thrust H = (4 - pi) / (pi^2 - 8) P [Timoshenko]; the moments at
  // crown and springings follow from it and from zero rotation at the crown.
  const FrameElement half{{1.0, -1.0}, pi / 2};  // springing (rising along -y) to crown
  // Crown: u = 0, rotation 0 by symmetry; half the load acts on v.
  const ElementMatrix K = frame_element_stiffness(inextensible_section, half);
  ElementVector ends = ElementVector::Zero();
  ends[4] = 0.5 / K(4, 4);
  const ElementVector reactions = K * ends;
  const double thrust = (4 - pi) / (pi * pi - 8);
  EXPECT_NEAR(std::abs(reactions[0]), thrust, 1e-6);
  EXPECT_NEAR(std::abs(reactions[3]), thrust, 1e-6);
  EXPECT_NEAR(reactions[1], -0.5, 1e-12);

  const ElementForces forces = element_forces(inextensible_section, half, ends);
  // M(phi) from the crown: M_c - H (1 - cos) + (P/2) sin except for the sign, with zero mean.
  const double crown = (thrust * (pi / 2 - 1) - 0.5) / (pi / 2);
  EXPECT_NEAR(std::abs(bending_moment(half, forces, 0.5)), std::abs(crown), 1e-6);
  EXPECT_NEAR(std::abs(bending_moment(half, forces, -0.5)), std::abs(crown - thrust + 0.5), 1e-6);
  EXPECT_NEAR(std::abs(crown), 0.1514, 1e-4);                 // from tables of arches
  EXPECT_NEAR(std::abs(crown - thrust + 0.5), 0.1106, 1e-4);  // likewise
}

TEST(FrameElement, MomentsMeetTheEndLoads) {
  ElementVector ends;
  ends << 0.3, -0.2, 0.1, 0.5, 0.4, -0.6;
  for (const double turning : {0.0, 1e-7, 0.898, -2.5, 4.0}) {
    const FrameElement element{{1.2, -0.7}, turning};
    const Section section{1.0, 3.0, 1.0};
    const ElementVector loads = frame_element_stiffness(section, element) * ends;
    const ElementForces forces = element_forces(section, element, ends);
    EXPECT_NEAR(bending_moment(element, forces, 0.5), loads[5], 1e-13 * loads.norm());
    EXPECT_NEAR(bending_moment(element, forces, -0.5), -loads[2], 1e-13 * loads.norm());
    double sampled = 0.0;
    for (int i = 0; i <= 4000; ++i) {
      sampled = std::max(sampled, std::abs(bending_moment(element, forces, -0.5 + i / 4000.0)));
    }
    EXPECT_GE(largest_moment(element, forces), sampled * (1 - 1e-14));
    EXPECT_NEAR(largest_moment(element, forces), sampled, 1e-5 * sampled);  // sampling error
  }
}

TEST(FrameElement, MomentIsLargestInsideAnArcUnderPureThrust) {
  // Forces along the chord only: the moment is largest where the arc is farthest from the elastic centre; an end moment
  // shifts the maximum between the ends.
  const FrameElement element{{1.0, 0.0}, 2.0};
  const ElementForces forces{.along = 1.0, .across = 0.0, .moment = -0.1};
  EXPECT_NEAR(largest_moment(element, forces), std::abs(bending_moment(element, forces, 0.0)), 1e-15);
  EXPECT_GT(largest_moment(element, forces), std::abs(bending_moment(element, forces, 0.5)));
}

TEST(StiffnessInSeries, OfTwoHalvesIsThatOfTheWhole) {
  const ElementMatrix half = frame_element_stiffness(element_section, flat_element(0.7e-3));
  const ElementMatrix whole = frame_element_stiffness(element_section, flat_element(1.4e-3));
  const ElementVector unit{{1e-3, 1e-3, 1.0, 1e-3, 1e-3, 1.0}};  // scales of displacements and rotations
  const ElementMatrix difference = unit.asDiagonal() * (stiffness_in_series(half, half) - whole) * unit.asDiagonal();
  EXPECT_LT(difference.norm(), 1e-13 * (unit.asDiagonal() * whole * unit.asDiagonal()).norm());
}

TEST(StiffnessInSeries, BendsASteppedCantileverAsTheTextbookSays) {
  // Clamped at the start, a force at the end: the moment of each part is known, whatever its stiffness.
  const Section thick = make_section(214e9, 0.29, 38.1e-3, 0.204e-3);
  const double a = 1e-3;
  const double b = 2e-3;
  const ElementMatrix K = stiffness_in_series(frame_element_stiffness(thick, flat_element(a)),
                                              frame_element_stiffness(element_section, flat_element(b)));
  const Eigen::Matrix3d free_end = K.bottomRightCorner<3, 3>();
  const Eigen::Vector3d moved = free_end.inverse() * Eigen::Vector3d(5.0, 3.0, 0.0);
  const double stretch = 5.0 * (a / thick.axial_stiffness + b / element_section.axial_stiffness);
  const double drop = 3.0 * ((std::pow(a + b, 3) - std::pow(b, 3)) / (3.0 * thick.bending_stiffness) +
                             std::pow(b, 3) / (3.0 * element_section.bending_stiffness));
  const double slope = 3.0 * ((std::pow(a + b, 2) - b * b) / (2.0 * thick.bending_stiffness) +
                              b * b / (2.0 * element_section.bending_stiffness));
  EXPECT_NEAR(moved[0], stretch, 1e-12 * stretch);
  EXPECT_NEAR(moved[1], drop, 1e-12 * drop);
  EXPECT_NEAR(moved[2], slope, 1e-12 * slope);
}

TEST(FrameElement, HalvesOfABumpMeetAtTheCrest) {
  const BumpArc arc =
      make_bump_arc({.pitch = 4.572e-3, .half_length = 1.778e-3, .rise = 0.406e-3, .thickness = 0.102e-3});
  EXPECT_EQ(rising_half(arc).chord + falling_half(arc).chord, Eigen::Vector2d(2.0 * arc.half_length, 0.0));
  EXPECT_NEAR(rising_half(arc).length(), arc.radius * arc.half_angle, 1e-15 * arc.radius);
  // The tangent is along x at the crest: the chord is inclined by half the turning.
  EXPECT_NEAR(std::atan2(falling_half(arc).chord.y(), falling_half(arc).chord.x()), 0.5 * arc.half_angle, 1e-14);
}

}  // namespace
}  // namespace bumpfoil
