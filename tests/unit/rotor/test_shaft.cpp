#include "bumpfoil/rotor/shaft.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "unit/rotor/rotor_on_springs.hpp"

namespace bumpfoil {
namespace {

constexpr double pi = std::numbers::pi;

/// Short and thick, so that shear and rotary inertia matter.
constexpr ShaftSection thick{0.4, 0.08, 0.03, 210e9, 0.3, 7800.0};

struct Constants {
  explicit Constants(const ShaftSection& section)
      : area(pi / 4.0 * (std::pow(section.outer_diameter, 2) - std::pow(section.inner_diameter, 2))),
        second_moment(pi / 64.0 * (std::pow(section.outer_diameter, 4) - std::pow(section.inner_diameter, 4))),
        bending(section.youngs_modulus * second_moment),
        shear(shear_coefficient(section) * area * section.youngs_modulus / (2.0 + 2.0 * section.poisson_ratio)) {}

  double area, second_moment, bending, shear;
};

/// A shaft pinned at both ends, with this number of elements.
Rotor pinned(int elements) {
  const Rotor rotor = make_flexible_rotor({.sections = {thick}, .longest_element = thick.length / elements});
  return held_at_unknowns(rotor, {0, 1, rotor.size() - 4, rotor.size() - 3});
}

/// A spinning pinned shaft whirls in sine modes: x + i y = W sin(k z) e^{i w t}, k = m pi / L, with
///     (kappa G A k^2 - rho A w^2) (E I k^2 + kappa G A - rho I (w^2 - 2 Omega w)) = (kappa G A k)^2.
/// w > 0 is forward whirl. The residual over its derivative is the error of w.
double closed_form_error(double w, double speed, int m) {
  const Constants of(thick);
  const double k = m * pi / thick.length;
  const auto defect = [&](double frequency) {
    return (of.shear * k * k - thick.density * of.area * frequency * frequency) *
               (of.bending * k * k + of.shear -
                thick.density * of.second_moment * (frequency * frequency - 2.0 * speed * frequency)) -
           std::pow(of.shear * k, 2);
  };
  const double h = 1e-4 * std::abs(w);
  return defect(w) * 2.0 * h / (defect(w + h) - defect(w - h));
}

TEST(Shaft, WhirlsOnPinsAsInClosedForm) {
  const double speed = 3000.0;
  std::vector<double> before;
  for (const int elements : {8, 16, 32}) {
    const std::vector<double> found = whirl_frequencies(pinned(elements), speed);
    std::vector<double> errors;
    for (int m = 1; m <= 3; ++m) {
      // The slower one of each pair is backward whirl.
      const double backward = found[static_cast<std::size_t>(2 * m - 2)];
      const double forward = found[static_cast<std::size_t>(2 * m - 1)];
      EXPECT_GT(forward, 1.001 * backward);
      errors.push_back(std::abs(closed_form_error(-backward, speed, m)) / backward);
      errors.push_back(std::abs(closed_form_error(forward, speed, m)) / forward);
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      // The shear strain is constant in an element: second-order errors.
      EXPECT_NEAR(before[i] / errors[i], 4.0, 0.4) << elements << ' ' << i;
    }
    before = errors;
  }
  for (const double error : before) EXPECT_LT(error, 2e-3);
}

/// A disc at the end of a massless clamped shaft. The end compliance is that of a cantilever with shear:
///     (k11 - m w^2) (k22 - I_t w^2 + I_p Omega w) = k12^2.
TEST(Shaft, CarriesAnOverhungDisc) {
  ShaftSection section = thick;
  section.density = 1e-9;
  const ShaftDisc disc = solid_disc(section.length, 0.03, 0.3, 0.08, 7800.0);
  const Rotor whole = make_flexible_rotor({.sections = {section}, .discs = {disc}, .longest_element = section.length});
  const Rotor rotor = held_at_unknowns(whole, {0, 1, 2, 3});
  const Constants of(section);
  const double L = section.length;
  Eigen::Matrix2d compliance;
  compliance << L * L * L / (3.0 * of.bending) + L / of.shear, L * L / (2.0 * of.bending), L * L / (2.0 * of.bending),
      L / of.bending;
  const Eigen::Matrix2d k = compliance.inverse();
  for (const double speed : {0.0, 800.0, -800.0}) {
    const std::vector<double> found = whirl_frequencies(rotor, speed);
    ASSERT_EQ(found.size(), 4U);
    for (const double frequency : found) {
      const auto defect = [&](double w) {
        return (k(0, 0) - disc.mass * w * w) *
                   (k(1, 1) - disc.transverse_inertia * w * w + disc.polar_inertia * speed * w) -
               k(0, 1) * k(0, 1);
      };
      const auto error = [&](double w) {
        const double h = 1e-5 * w;
        return std::abs(defect(w) * 2.0 * h / (defect(w + h) - defect(w - h)) / w);
      };
      // One of the two, forward or backward. At zero speed the root is double, so that only half the digits are
      // significant.
      EXPECT_LT(std::min(error(frequency), error(-frequency)), 1e-9);
    }
  }
}

/// Two discs on a shaft of 1.5 m and 50 mm, of Example 5.9.1 of Friswell et al. [Friswell2010], on springs of 1.0 and
/// 0.8 MN/m along X and Y. Whirl frequencies at 0, 150 and 300 rad/s are those that the tests of ROSS expect
/// (petrobras/ross, ross/tests/test_rotor_assembly.py, test_campbell, commit 0103185c), without the axial one at
/// 650.4 rad/s. Beams with a disc's bore of 50 mm and the same six elements.
TEST(Shaft, WhirlsAsRossComputesIt) {
  ShaftDesign design{.sections = {{1.5, 0.05, 0.0, 211e9, 211e9 / (2.0 * 81.2e9) - 1.0, 7810.0}},
                     .discs = {solid_disc(0.5, 0.07, 0.28, 0.05, 7810.0), solid_disc(1.0, 0.07, 0.35, 0.05, 7810.0)},
                     .bearings = {0.0, 1.5},
                     .longest_element = 0.25};
  const Rotor rotor = make_flexible_rotor(design);
  ASSERT_EQ(rotor.size(), 28);
  struct Reference {
    double speed;
    std::array<double, 5> frequencies;
  };
  for (const Reference& reference :
       {Reference{0.0, {82.65303734, 86.65811435, 254.52047828, 274.31285391, 679.48903239}},
        Reference{150.0, {82.60929602, 86.68625235, 251.70037114, 276.87787937, 652.85679897}},
        Reference{300.0, {82.48132723, 86.76734307, 245.49092844, 282.33294699, 614.05536277}}}) {
    const auto found = whirl_frequencies(on_springs(rotor, 1.0e6, 0.8e6), reference.speed);
    for (std::size_t i = 0; i < reference.frequencies.size(); ++i) {
      EXPECT_NEAR(found[i], reference.frequencies[i], 1e-6 * reference.frequencies[i]);
    }
  }
}

TEST(Shaft, HasNodesWhereThingsAre) {
  ShaftDesign design{.sections = {{0.1, 0.02, 0.0, 210e9, 0.3, 7800.0}, {0.2, 0.03, 0.0, 210e9, 0.3, 7800.0}},
                     .discs = {{.z = 0.25, .mass = 1.0, .transverse_inertia = 1e-3, .polar_inertia = 2e-3}},
                     .bearings = {0.1, 0.3},
                     .planes = {0.07},
                     .longest_element = 0.05};
  const Rotor rotor = make_flexible_rotor(design);
  EXPECT_EQ(rotor.size(), 4 * 8);  // 0, 35, 70, 100, 150, 200, 250, 300 mm
  ASSERT_EQ(rotor.stations.size(), 4U);
  EXPECT_EQ(rotor.stations[1].name, "disc 1");
  EXPECT_EQ(rotor.stations[2].z, 0.07);
  EXPECT_NEAR((rotor.stations[2].motion * rotor.rigid)(1, 3), 0.07, 1e-15);
  EXPECT_EQ(rotor.bearings[1].motion(0, 28), 1.0);
}

/// A solid circle, and a thin tube.
TEST(ShearCoefficient, IsCowpers) {
  EXPECT_NEAR(shear_coefficient({.outer_diameter = 1.0, .poisson_ratio = 0.3}), 0.886363636363636, 1e-14);
  EXPECT_NEAR(shear_coefficient({.outer_diameter = 1.0, .inner_diameter = 1.0, .poisson_ratio = 0.3}),
              2.0 * 1.3 / (4.0 + 3.0 * 0.3), 1e-14);
}

}  // namespace
}  // namespace bumpfoil
