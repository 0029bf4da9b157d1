// docs/verification/film.md: films over rigid walls against closed forms and limits.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

/// At Lam = 1 upwinding is only a remainder of fourth order; test_film_refinement.cpp covers faster films.
TEST(FilmSmallEccentricity, MeetsTheClosedForm) {
  for (const double width : {0.5, 1.0}) {
    const SmallEccentricityCheck check = check_small_eccentricity(1.0, width, 48, 16);
    EXPECT_LT(check.load_defect, 2e-6) << width;
    EXPECT_LT(check.attitude_defect, 2e-6) << width;
    EXPECT_NEAR(check.ratio, 4.0, 0.01) << width;
  }
}

/// Printed values of the closed form (perturbation by hand), so that the function above does not check itself.
TEST(FilmSmallEccentricity, ClosedFormHasItsKnownValues) {
  EXPECT_NEAR(std::abs(load_of_small_eccentricity(1.0, 0.5)), 0.118514, 1e-6);
  EXPECT_NEAR(std::abs(load_of_small_eccentricity(1.0, 1.0)), 0.359892, 1e-6);
  EXPECT_NEAR(std::abs(load_of_small_eccentricity(5.0, 2.0)), 1.295324, 1e-6);
  EXPECT_NEAR(std::arg(load_of_small_eccentricity(1.0, 1.0)) * 180.0 / pi, 74.191, 1e-3);
}

/// A narrow bearing: P - 1 = (Lam/2) H'/H^3 (zeta^2 - (L/2R)^2), second order in the width.
TEST(FilmLimits, NarrowBearing) {
  double defect[2];
  for (const int i : {0, 1}) {
    const double half = 0.025 / (1 + i);
    const FilmMesh mesh = make_closed_mesh(720, 8, half);
    constexpr double Lam = 1.0;
    constexpr double eps = 0.5;
    const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam}, eccentric_thickness(mesh, eps));
    ASSERT_EQ(solved.report.status, Status::converged);
    double expected = 0.0;
    for (int k = 0; k < mesh.columns; ++k) {
      const double theta = k * mesh.dtheta;
      const double H = 1.0 + eps * std::cos(theta);
      // Integral of zeta^2 - half^2 over the whole width: -4/3 half^3.
      expected += mesh.dtheta * std::sin(theta) * 0.5 * Lam * eps * std::sin(theta) / (H * H * H) * 4.0 / 3.0 * half *
                  half * half;
    }
    // Eight trapezoids underestimate the area under a parabola by 1 / (4 8^2).
    const double s = film_integrals(solved.equation, solved.film).sine / (1.0 - 1.0 / 256.0);
    defect[i] = s / expected - 1.0;
  }
  EXPECT_LT(std::abs(defect[0]), 3e-3);  // L/R = 0.05
  EXPECT_LT(std::abs(defect[1]), 0.3 * std::abs(defect[0]));
}

/// Lam to infinity with a slot: P H = H at the inlet, except in edge layers of thickness Lam^-1/2.
TEST(FilmLimits, HighSpeed) {
  constexpr double eps = 0.6;
  constexpr double theta_end = 6.24;
  const FilmMesh mesh = make_slotted_mesh(312, 32, 1.0, theta_end);
  const double inlet = 1.0 + eps * std::cos(theta_end);
  double limit = 0.0;
  double highest = 0.0;
  for (int k = 0; k <= mesh.columns; ++k) {
    const double c = std::cos(k * mesh.dtheta);
    const double P = inlet / (1.0 + eps * c);
    highest = std::max(highest, P);
    limit += 2.0 * mesh.column_weight(k) * mesh.dtheta * (P - 1.0) * c;
  }
  EXPECT_NEAR(limit, -8.3746, 2e-4);
  double distance[2];
  for (const int i : {0, 1}) {
    const double Lam = i == 0 ? -200.0 : -800.0;
    const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam}, eccentric_thickness(mesh, eps));
    ASSERT_EQ(solved.report.status, Status::converged);
    distance[i] = film_integrals(solved.equation, solved.film).cosine - limit;
    EXPECT_NEAR(solved.film.pressure.maxCoeff(), highest, 2e-3 * highest);  // P H keeps its inlet value
  }
  EXPECT_NEAR(distance[0], -7.7495 + 8.3746, 0.02);
  EXPECT_NEAR(distance[0] / distance[1], 2.0, 0.2);  // layers shrink like Lam^-1/2
}

/// Low speed: the load is proportional to Lam and perpendicular to the line of centres.
TEST(FilmLimits, LowSpeed) {
  const FilmMesh mesh = make_closed_mesh(60, 8, 1.0);
  double per_speed[2];
  for (const int i : {0, 1}) {
    const double Lam = i == 0 ? 1e-3 : 1e-4;
    const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam}, eccentric_thickness(mesh, 0.5));
    const FilmIntegrals sums = film_integrals(solved.equation, solved.film);
    per_speed[i] = sums.sine / Lam;
    EXPECT_LT(std::abs(sums.cosine), Lam * std::abs(sums.sine));
  }
  EXPECT_NEAR(per_speed[0] / per_speed[1], 1.0, 1e-5);
}

/// Pressure at theta_end of a bearing without sides by Runge-Kutta: flux Lam P H - H^3 P dP/dtheta, P(0) = 1.
/// @param pressure  receives P at all steps, if given
double end_pressure(double Lam, double eps, double theta_end, double flux, int steps, Vector* pressure = nullptr) {
  const auto slope = [&](double theta, double P) {
    const double H = 1.0 + eps * std::cos(theta);
    return (Lam * P * H - flux) / (H * H * H * P);
  };
  const double d = theta_end / steps;
  double P = 1.0;
  if (pressure != nullptr) (*pressure)[0] = P;
  for (int i = 0; i < steps && P > 0.0; ++i) {
    const double theta = i * d;
    const double k1 = slope(theta, P);
    const double k2 = slope(theta + 0.5 * d, P + 0.5 * d * k1);
    const double k3 = slope(theta + 0.5 * d, P + 0.5 * d * k2);
    const double k4 = slope(theta + d, P + d * k3);
    P += d / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    if (pressure != nullptr) (*pressure)[i + 1] = P;
  }
  return P;
}

/// Far from its sides the film of a wide bearing is one-dimensional.
TEST(FilmLimits, WideBearing) {
  constexpr double Lam = 1.5;
  constexpr double eps = 0.5;
  constexpr double theta_end = 6.0;
  constexpr int columns = 800;
  double low = 0.0;   // too little flux: the pressure rises without bound
  double high = 3.0;  // too much: it falls below zero
  for (int i = 0; i < 60; ++i) {
    const double flux = 0.5 * (low + high);
    (end_pressure(Lam, eps, theta_end, flux, 4 * columns) > 1.0 ? low : high) = flux;
  }
  Vector exact(4 * columns + 1);
  end_pressure(Lam, eps, theta_end, low, 4 * columns, &exact);

  const FilmMesh mesh = make_slotted_mesh(columns, 10, 40.0, theta_end);
  const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam}, eccentric_thickness(mesh, eps));
  ASSERT_EQ(solved.report.status, Status::converged);
  double worst = 0.0;
  for (int k = 0; k <= columns; ++k) worst = std::max(worst, std::abs(solved.film.pressure(0, k) - exact[4 * k]));
  EXPECT_LT(worst, 2e-5);  // second order: dtheta^2 = 6e-5
  EXPECT_GT(exact.maxCoeff(), 1.5);
}

/// Identities of the continuum, which hold to the order of the scheme.
TEST(FilmIdentities, EnergyAndMomentsCloseToSecondOrder) {
  constexpr double Lam = -1.852606648;
  double energy[2], moments[2];
  for (const int i : {0, 1}) {
    const FilmMesh mesh = make_slotted_mesh(78 << i, 8 << i, 1.0, 6.24);
    const Matrix H = eccentric_thickness(mesh, 0.6, 0.7);
    const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam, .knudsen = 0.01}, H);
    const FilmIntegrals sums = film_integrals(solved.equation, solved.film);
    // The shear power of the pressure gradient equals the dissipation by the gradient.
    energy[i] = Lam * sums.poiseuille - sums.dissipation;
    // Integral of H dP/dtheta by parts: as H' = -eps sin(theta - 0.7), eps times the sine of the load there.
    const double across = sums.sine * std::cos(0.7) - sums.cosine * std::sin(0.7);
    moments[i] = sums.poiseuille - 0.6 * across;
    EXPECT_LT(std::abs(energy[i]), 2e-3 * sums.dissipation);
    EXPECT_LT(std::abs(moments[i]), 2e-3 * std::abs(sums.poiseuille));
  }
  EXPECT_NEAR(energy[0] / energy[1], 4.0, 0.7);
  EXPECT_NEAR(moments[0] / moments[1], 4.0, 0.7);
}

TEST(FilmIdentities, FlowsBalanceToRounding) {
  for (const double Lam : {-200.0, -1.85, 5.0}) {
    const FilmMesh mesh = make_slotted_mesh(78, 8, 1.0, 6.24);
    const SolvedFilm solved =
        solve_rigid_film({.mesh = mesh, .bearing_number = Lam}, eccentric_thickness(mesh, 0.6, 0.7));
    Matrix residual;
    reynolds_residual(solved.equation, solved.film, residual);
    const FilmFlows flows = film_flows(mesh, residual);
    EXPECT_NEAR(flows.start - flows.end - flows.sides, 0.0, 1e-14 * std::abs(Lam) + 1e-14);
    EXPECT_GT(std::abs(flows.start - flows.end), 0.01);
  }
}

TEST(FilmIdentities, MirroredSpeedGivesTheMirroredFilm) {
  const FilmMesh mesh = make_closed_mesh(60, 8, 1.0);
  const SolvedFilm there = solve_rigid_film({.mesh = mesh, .bearing_number = 3.0}, eccentric_thickness(mesh, 0.7));
  const SolvedFilm back = solve_rigid_film({.mesh = mesh, .bearing_number = -3.0}, eccentric_thickness(mesh, 0.7));
  const FilmIntegrals a = film_integrals(there.equation, there.film);
  const FilmIntegrals b = film_integrals(back.equation, back.film);
  EXPECT_NEAR(a.cosine, b.cosine, 1e-12);
  EXPECT_NEAR(a.sine, -b.sine, 1e-12);
  EXPECT_NEAR(a.torque(3.0), b.torque(-3.0), 1e-12);
}

/// Pressures stay positive, however coarse the mesh and thin the film.
TEST(FilmPositivity, HoldsFarBeyondWhatAMeshResolves) {
  for (const double Lam : {-1000.0, -30.0, 0.5, 30.0, 1000.0}) {
    for (const double eps : {0.5, 0.9, 0.99}) {
      for (const double Kn : {0.0, 0.05}) {
        for (const FilmMesh& mesh : {make_closed_mesh(24, 3, 1.0), make_slotted_mesh(24, 3, 0.3, 6.2)}) {
          const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam, .knudsen = Kn},
                                                     eccentric_thickness(mesh, eps, 2.0));
          EXPECT_EQ(solved.report.status, Status::converged) << Lam << ' ' << eps << ' ' << Kn;
          EXPECT_GT(solved.film.pressure.minCoeff(), 0.0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace bumpfoil
