// docs/verification/film.md: impedance of films over a rigid wall: closed form at small eccentricity, critical mass of
// plain bearings against an independent prototype.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/film/wall_film.hpp"
#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// A closed plain bearing of L = D, with a sixth as many rows as columns, held at eps C_r along X.
struct PlainBearing {
  /// @param whirl_ratios  at which the impedance is computed
  PlainBearing(double bearing_number, double eccentricity, int bumps, const std::vector<double>& whirl_ratios = {}) {
    input = reference_case();
    input.bearing.axial_length = 2.0 * input.bearing.radius;
    input.bump_foil.bumps = bumps;
    input.bump_foil.pitch = 2.0 * std::numbers::pi * input.bearing.radius / bumps;
    input.film = {.columns_per_pitch = 6, .rows = bumps, .closed = true};
    EquilibriumSettings& equilibrium = input.settings.set(EquilibriumSettings{});
    equilibrium.path = FilmPath::position_ray;
    equilibrium.positions = {{eccentricity * input.bearing.radial_clearance, 0.0}};
    equilibrium.speeds = {1.0};
    const FilmScales scales = make_wall_bearing(input).film->scales;
    speed = bearing_number / scales.bearing_number(scales.radius);
    equilibrium.speeds = {speed};
    for (const double ratio : whirl_ratios) equilibrium.frequencies.push_back(ratio * speed);
    result = run_wall_films(input);
    EXPECT_TRUE(result.states.front().found());
  }

  [[nodiscard]] const RunningState& state() const { return result.states.front(); }
  /// Unit of forces: pa R^2.
  [[nodiscard]] double force() const {
    return input.gas.ambient_pressure * input.bearing.radius * input.bearing.radius;
  }

  Case input;
  double speed{};
  EquilibriumResult result;
};

struct PlainReference {
  double bearing_number, eccentricity, whirl_ratio, mass;  ///< m c Omega^2 / (pa R^2)
};

/// One critical pair each, on 48 x 8 and 96 x 16.
TEST(FilmPlain, CriticalMassesAreThoseOfThePrototype) {
  for (const auto& [bumps, references] :
       {std::pair{8, std::vector{PlainReference{1.0, 0.2, 0.4927786865313877, 0.35278939999706777},
                                 PlainReference{1.0, 0.4, 0.4707414452178285, 1.8941595367017408}}},
        std::pair{16, std::vector{PlainReference{1.0, 0.2, 0.4938067429759685, 0.35378633264453274},
                                  PlainReference{1.0, 0.4, 0.47158508776003266, 1.9017086005725785}}}}) {
    for (const PlainReference& reference : references) {
      SCOPED_TRACE(bumps);
      SCOPED_TRACE(reference.eccentricity);
      const PlainBearing plain(reference.bearing_number, reference.eccentricity, bumps);
      ASSERT_TRUE(plain.state().critical_mass.has_value());
      const double unit = plain.force() / (plain.input.bearing.radial_clearance * plain.speed * plain.speed);
      EXPECT_NEAR(plain.state().critical_mass->mass / unit, reference.mass, 1e-7 * reference.mass);
      EXPECT_NEAR(plain.state().critical_mass->frequency / plain.speed, reference.whirl_ratio, 1e-7);
    }
  }
}

/// Forward circular whirl x + i y ~ e^{i nu t} is steady in a frame that turns at nu, so the impedance is the conjugate
/// of the static response at Lam' = Lam (1 - 2 nu / Omega):
///
///     Z (1, -i)' = (1, -i)' z*,   z = 2 pi l [i Lam' / (1 + i Lam')] (1 - tanh(g l) / (g l)),   g^2 = 1 + i Lam'
///
/// with l = L / D, in pa R^2 / c. Values on 48 x 8 and 96 x 16, extrapolated.
TEST(FilmPlain, ImpedanceIsTheClosedFormAtSmallEccentricity) {
  const std::vector<double> ratios{0.25, 0.5, 0.75, 1.0};
  for (const auto& [Lam, tolerance] : {std::pair{1.0, 2e-5}, std::pair{3.0, 2e-4}}) {
    const PlainBearing coarse(Lam, 1e-6, 8, ratios);
    const PlainBearing fine(Lam, 1e-6, 16, ratios);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      SCOPED_TRACE(ratios[i]);
      const auto whirl = [&](const PlainBearing& plain) -> Complex {
        const Eigen::Vector2cd answer =
            plain.state().whirls[i].impedance.value() * Eigen::Vector2cd(1.0, Complex(0.0, -1.0));
        return answer[0] * plain.input.bearing.radial_clearance / plain.force();
      };
      const Complex found = (4.0 * whirl(fine) - whirl(coarse)) / 3.0;
      const Complex moving(0.0, Lam * (1.0 - 2.0 * ratios[i]));
      const Complex g = std::sqrt(1.0 + moving);
      const Complex closed_form = 2.0 * std::numbers::pi * moving / (1.0 + moving) * (1.0 - std::tanh(g) / g);
      EXPECT_LT(std::abs(found - std::conj(closed_form)), tolerance);
    }
  }
}

/// With an elastic foundation the stiffness is the derivative of the force, by central differences.
TEST(FilmPlain, StiffnessOverAFoundationIsTheDerivativeOfTheForce) {
  Case input = reference_case();
  input.film = {.columns_per_pitch = 4, .rows = 4, .wall = FilmWall::springs, .wall_stiffness = 5e9};
  EquilibriumSettings& equilibrium = input.settings.set(EquilibriumSettings{});
  equilibrium.speeds = {4000.0};
  equilibrium.path = FilmPath::position_ray;
  constexpr double step = 2e-9;
  const Eigen::Vector2d place(12e-6, 5e-6);
  equilibrium.positions = {place};
  for (const Eigen::Index axis : {0, 1}) {
    for (const double side : {1.0, -1.0}) {
      equilibrium.positions.emplace_back(place + side * step * Eigen::Vector2d::Unit(axis));
    }
  }
  const EquilibriumResult result = run_wall_films(input);
  ASSERT_TRUE(result.states.front().stiffness.has_value());
  const Eigen::Matrix2d& K = *result.states.front().stiffness;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    const Eigen::Vector2d change =
        result.states[2 * axis + 1].outcome->force - result.states[2 * axis + 2].outcome->force;
    // Error from third derivatives: (2e-9 / 2e-5)^2; the film is known to 1e-9.
    EXPECT_LT((change / (2.0 * step) - K.col(static_cast<Eigen::Index>(axis))).norm(), 1e-5 * K.norm());
  }
}

}  // namespace
}  // namespace bumpfoil
