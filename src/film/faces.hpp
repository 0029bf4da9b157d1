#pragma once

#include <array>
#include <cmath>

#include "bumpfoil/film/reynolds.hpp"

namespace bumpfoil {

/// Flux through a face from node 0 to node 1, and its derivatives with respect to P and H of both.
struct FaceFlux {
  double value{};
  std::array<double, 2> by_pressure{}, by_thickness{};
};

/// P and H of a node.
struct FilmNode {
  double pressure{}, thickness{};
};

/// G = H_f^3 P_f + 6 Kn H_f^2 at the mean of two nodes, and its derivatives with respect to P and H of either.
struct Conductance {
  double value{}, by_pressure{}, by_thickness{};

  Conductance(const FilmNode& a, const FilmNode& b, double knudsen) {
    const double h = 0.5 * (a.thickness + b.thickness);
    const double p = 0.5 * (a.pressure + b.pressure);
    value = h * h * (h * p + 6.0 * knudsen);
    by_pressure = 0.5 * h * h * h;
    by_thickness = 0.5 * h * (3.0 * h * p + 12.0 * knudsen);
  }
};

/// l(X) of reynolds_residual and X dl/dX, X >= 0.
struct UpwindWeight {
  double value{}, slope{};

  explicit UpwindWeight(double X) {
    if (X < 1.0) {
      const double sum = 1.0 + X * (1.0 + X * (1.0 + X * (1.0 + X)));
      const double fourth = X * X * X * X;
      value = fourth / sum;
      slope = fourth * (4.0 + X * (3.0 + X * (2.0 + X))) / (sum * sum);
    } else {
      const double Y = 1.0 / X;  // no overflow as a film closes
      const double sum = 1.0 + Y * (1.0 + Y * (1.0 + Y * (1.0 + Y)));
      value = 1.0 / sum;
      slope = Y * (1.0 + Y * (2.0 + Y * (3.0 + Y * 4.0))) / (sum * sum);
    }
  }
};

/// Flux along theta from column a to the next, b. Always inline: residuals need no derivatives.
[[gnu::always_inline]] inline FaceFlux column_flux(const FilmNode& a, const FilmNode& b, double bearing_number,
                                                   double knudsen, double dtheta) {
  const Conductance G(a, b, knudsen);
  const double half_speed = 0.5 * std::abs(bearing_number);
  const bool forward = bearing_number >= 0.0;
  const double downstream = forward ? b.thickness : a.thickness;
  const UpwindWeight l(half_speed * downstream * dtheta / G.value);
  const double jump = b.pressure * b.thickness - a.pressure * a.thickness;
  const double gradient = (b.pressure - a.pressure) / dtheta;
  const double from_a = 0.5 * bearing_number + half_speed * l.value;  // d flux / d psi
  const double from_b = 0.5 * bearing_number - half_speed * l.value;
  const double by_log_X = -half_speed * jump * l.slope;  // from l alone

  FaceFlux flux;
  flux.value = from_a * a.pressure * a.thickness + from_b * b.pressure * b.thickness - G.value * gradient;
  const double by_G = -gradient - by_log_X / G.value;
  flux.by_pressure = {from_a * a.thickness + G.value / dtheta + by_G * G.by_pressure,
                      from_b * b.thickness - G.value / dtheta + by_G * G.by_pressure};
  flux.by_thickness = {from_a * a.pressure + by_G * G.by_thickness, from_b * b.pressure + by_G * G.by_thickness};
  flux.by_thickness[forward ? 1 : 0] += by_log_X / downstream;
  return flux;
}

/// Flux across the rows from row j to the next.
inline FaceFlux row_flux(const FilmNode& a, const FilmNode& b, double knudsen, double dzeta) {
  const Conductance G(a, b, knudsen);
  const double gradient = (b.pressure - a.pressure) / dzeta;
  FaceFlux flux;
  flux.value = -G.value * gradient;
  flux.by_pressure = {G.value / dzeta - gradient * G.by_pressure, -G.value / dzeta - gradient * G.by_pressure};
  flux.by_thickness = {-gradient * G.by_thickness, -gradient * G.by_thickness};
  return flux;
}

inline FilmNode node_of(const FilmState& film, int j, int k) {
  return {film.pressure(j, k), film.thickness(j, k)};
}

/// Calls visit(j, a, b, width, flux) for the faces between each column a and the next, b.
template <typename Visitor>
void for_each_column_face(const ReynoldsEquation& equation, const FilmState& film, Visitor&& visit) {
  const FilmMesh& mesh = equation.mesh;
  for (int a = 0; a < mesh.columns; ++a) {
    const int b = mesh.next(a);
    for (int j = 0; j <= mesh.rows; ++j) {
      visit(j, a, b, mesh.row_weight(j) * mesh.dzeta,
            column_flux(node_of(film, j, a), node_of(film, j, b), equation.bearing_number, equation.knudsen,
                        mesh.interval(a)));
    }
  }
}

/// Calls visit(j, k, width, flux) for the faces between each row j and the next.
template <typename Visitor>
void for_each_row_face(const ReynoldsEquation& equation, const FilmState& film, Visitor&& visit) {
  const FilmMesh& mesh = equation.mesh;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j < mesh.rows; ++j) {
      visit(j, k, mesh.column_weight(k) * mesh.dtheta,
            row_flux(node_of(film, j, k), node_of(film, j + 1, k), equation.knudsen, mesh.dzeta));
    }
  }
}

}  // namespace bumpfoil
